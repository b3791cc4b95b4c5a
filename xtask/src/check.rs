//! Runs the checks one after another; a failure does not stop the following ones.

use crate::book;
use crate::python::{self, PythonArgs};
use crate::summary::{Count, Summary};
use crate::venv::{environment, interpreter};
use crate::web;
use std::io::{BufRead as _, BufReader};
use std::path::{Path, PathBuf};
use std::process::{Command, Stdio};
use std::time::{Duration, Instant};
use std::{env, fs, io};
use tpg_testing::answers;
use tpg_testing::library::{cargo, target_folder, top};

/// The crate that needs a Python interpreter: `python.rs` builds and tests it.
const PYTHON: &str = "tpg-python";
/// The oldest compiler that the workspace's manifest promises.
const OLDEST: &str = concat!(env!("CARGO_PKG_RUST_VERSION"), ".0");
/// The crates that depend, together, on all that are published.
const PUBLISHED: [&str; 3] = ["tpg-train", "tpg-generated", "cortex-bound"];
/// Bare-metal targets that the runtime without its features is built for.
const NO_STD: [&str; 3] = ["thumbv7em-none-eabihf", "thumbv7em-none-eabi", "thumbv6m-none-eabi"];

/// Runs some checks and prints their summary; returns true if all passed.
pub(crate) fn run(checks: impl FnOnce(&mut Run)) -> bool {
    let log = env::temp_dir().join(format!("tpg-skipped-{}", std::process::id()));
    let mut run = Run { summary: Summary::default(), log };
    checks(&mut run);
    run.summary.skip(tpg_testing::skipped(&run.log));
    let _ = fs::remove_file(&run.log);
    run.summary.print();
    run.summary.good()
}

/// Runs a command and shows it first.
pub(crate) fn step(mut command: Command) -> io::Result<()> {
    let program = Path::new(command.get_program()).file_name().unwrap_or_default().to_string_lossy();
    let words: Vec<_> = std::iter::once(program).chain(command.get_args().map(|word| word.to_string_lossy())).collect();
    println!("{}", words.join(" "));
    match command.stdin(Stdio::null()).status()? {
        status if status.success() => Ok(()),
        status => Err(io::Error::other(format!("{}: {status}", command.get_program().display()))),
    }
}

/// Returns a command of cargo on the workspace without some crates, and without what this machine cannot build.
fn workspace(command: &str, without: &[&str], arguments: &[&str]) -> Command {
    let mut command = cargo(&[command, "--workspace"]);
    let mpi = (!has_mpi()).then_some("tpg-mpi");
    without.iter().copied().chain(mpi).for_each(|name| {
        command.args(["--exclude", name]);
    });
    command.args(arguments);
    command
}

/// Builds a program from what the tests are built from, so that nothing is compiled twice, and returns it.
pub(crate) fn program(name: &str) -> io::Result<Command> {
    // One of the tests, else the features that only tests turn on would be off.
    let arguments = ["--quiet", "--profile", "test", "--bin", name, "--test", "smoke"];
    step(workspace("build", &[PYTHON], &[&arguments, features()].concat()))?;
    Ok(Command::new(target_folder().join("debug").join(name)))
}

/// The features of tests: some add large dependencies.
fn features() -> &'static [&'static str] {
    if tpg_testing::required() { &["--all-features"] } else { &["--features", "tpg-web/page"] }
}

fn has_mpi() -> bool {
    tpg_testing::exists("mpicc")
}

/// A run of checks.
pub(crate) struct Run {
    summary: Summary,
    log: PathBuf,
}

impl Run {
    /// Runs every check but the tests.
    pub(crate) fn all(&mut self) {
        self.check("format", cargo(&["fmt", "--all", "--check"]));
        let python = interpreter();
        let without: &[&str] = if python.is_some() { &[] } else { &[PYTHON] };
        let mut clippy = workspace("clippy", without, &["--all-targets", "--all-features", "--", "--deny", "warnings"]);
        clippy.envs(python.map(|python| ("PYO3_PYTHON", python)));
        self.check("clippy", clippy);
        let mut documentation = workspace("doc", &[PYTHON], &["--all-features", "--no-deps", "--quiet"]);
        documentation.env("RUSTDOCFLAGS", "--deny warnings");
        self.check("documentation", documentation);
        self.supply_chain();
        self.book();
        for target in NO_STD {
            self.no_std(target);
        }
        self.oldest_compiler();
        ["qemu", "cores", "lint"].into_iter().for_each(|check| self.firmware(check, &[]));
        self.lemmas();
        python::check(self, PythonArgs::default());
    }

    /// Runs the lint of generated C and of the firmwares.
    pub(crate) fn lint(&mut self) {
        let tests = ["test", "--package", "tpg-codegen", "--test", "all", "--", "c_lint::", "eva::"];
        self.tests("lint of generated C", cargo(&tests));
        self.firmware("lint", &[]);
    }

    /// Makes the book's pages from the programs.
    pub(crate) fn pages(&mut self) {
        let crates = ["--package", "tpg-train", "--package", "tpg-harness"];
        let mut command = cargo(&[&["test", "--quiet", "--lib", "--bins"], &crates[..], &["the_page_of"]].concat());
        command.env(tpg_testing::book::UPDATE, "1");
        self.check("pages made from the programs", command);
    }

    /// Runs every test of every crate.
    pub(crate) fn all_tests(&mut self) {
        if !has_mpi() {
            self.missing("runs over MPI", "an MPI with its compiler, and libclang; Debian: libopenmpi-dev, clang");
        }
        let page = web::page(self);
        let without: &[&str] = if page.is_some() { &[PYTHON] } else { &[PYTHON, "tpg-web"] };
        let features = if page.is_some() || tpg_testing::required() { features() } else { &[] };
        let mut tests = workspace("test", without, &[&["--no-fail-fast"], features].concat());
        tests.envs(page.map(|page| (web::PAGE, page)));
        self.tests("tests", tests);
    }

    /// Runs a command that counts as one check.
    pub(crate) fn check(&mut self, name: &str, command: Command) {
        self.timed(name, command, |command| Ok((command.status()?.success(), Count::default())));
    }

    /// Runs a command whose tests are counted.
    pub(crate) fn tests(&mut self, name: &str, command: Command) {
        self.timed(name, command, counted);
    }

    fn timed(&mut self, name: &str, mut command: Command, run: impl FnOnce(&mut Command) -> io::Result<(bool, Count)>) {
        let words: Vec<_> = command.get_args().map(|word| word.to_string_lossy()).collect();
        let program = Path::new(command.get_program()).file_name().unwrap_or_default().display();
        println!("\n==== {name}: {program} {}", words.join(" "));
        let began = Instant::now();
        let result = run(command.env(tpg_testing::LOG, &self.log).stdin(Stdio::null()));
        self.summary.note(name, began.elapsed(), result);
    }

    /// Records a check that could not begin.
    pub(crate) fn failed(&mut self, name: &str, error: &io::Error) {
        self.summary.note(name, Duration::ZERO, Err(io::Error::other(error.to_string())));
    }

    /// Records a check whose tools are missing.
    pub(crate) fn missing(&mut self, name: &str, remedy: &str) {
        self.summary.missing(name, remedy);
    }

    /// Records a check that is left out, even where missing tools must fail.
    fn skip(&mut self, what: &str) {
        tpg_testing::skip(what);
        self.summary.skip(vec![what.to_owned()]);
    }

    /// Runs a check of the firmwares.
    pub(crate) fn firmware(&mut self, check: &str, words: &[String]) {
        let name =
            ["firmware:", check].into_iter().chain(words.iter().map(String::as_str)).collect::<Vec<_>>().join(" ");
        match program("tpg-harness") {
            Ok(mut harness) => {
                harness.arg(check).args(words);
                self.check(&name, harness);
            }
            Err(error) => self.failed(&name, &error),
        }
    }

    /// Builds the book.
    pub(crate) fn book(&mut self) {
        let began = Instant::now();
        let result = match book::mdbook() {
            Ok(Some(mdbook)) => book::build(&mdbook).map(|good| (good, Count::default())),
            Ok(None) => {
                let remedy =
                    "Python 3.10 or newer with venv (Debian: python3-venv), or mdBook (cargo install --locked mdbook)";
                return self.missing("book", remedy);
            }
            Err(error) => Err(error),
        };
        self.summary.note("book", began.elapsed(), result);
    }

    /// Has a solver prove the rules of proofs, and some proofs.
    pub(crate) fn lemmas(&mut self) {
        let Some(python) = interpreter() else {
            return self.missing("lemmas", "Python 3.10 or newer with venv; Debian: python3-venv");
        };
        let requirements = top().join("xtask/requirements-lemmas.txt");
        match environment(&python, &target_folder().join("lemmas"), &requirements) {
            Ok(venv) => {
                let words = ["test", "--package", "tpg-prove", "--lib", "--", "smt::", "--include-ignored"];
                let mut tests = cargo(&words);
                tests.env("TPG_SOLVER", venv.join("bin/python"));
                self.tests("lemmas", tests);
            }
            Err(error) => self.failed("lemmas", &error),
        }
    }

    /// Tries what no solver proves, on many operands: ten minutes and more.
    pub(crate) fn operands(&mut self) {
        for (name, package, test) in [
            ("own maths for every number", "tpg-runtime", "own_maths"),
            ("a million operands of each instruction", "tpg-prove", "all"),
        ] {
            self.tests(name, cargo(&["test", "--release", "--package", package, "--test", test, "--", "--ignored"]));
        }
    }

    /// Checks licences, sources and bans of every crate by `deny.toml`; known defects and abandoned crates where the database
    /// can be fetched.
    fn supply_chain(&mut self) {
        if !answers("cargo", &["deny", "--version"]) {
            return self.skip("supply chain: not installed (cargo install --locked cargo-deny)");
        }
        if !answers("cargo", &["deny", "fetch", "db"]) {
            self.skip("advisories: their database cannot be fetched");
        } else {
            self.check("advisories", cargo(&["deny", "check", "--disable-fetch", "advisories"]));
        }
        self.check("supply chain", cargo(&["deny", "check", "bans", "licenses", "sources"]));
    }

    /// Builds the runtime without its features for a bare-metal target.
    fn no_std(&mut self, target: &str) {
        let name = format!("no_std build for {target}");
        if !tpg_testing::library::has_target(target) {
            return self.missing(&name, &format!("rustup target add {target}"));
        }
        let packages = ["--package", "tpg-runtime", "--package", "tpg-arm"];
        self.check(&name, cargo(&[&["build"], &packages[..], &["--no-default-features", "--target", target]].concat()));
    }

    /// Checks the crates that users install with the oldest compiler that they name.
    fn oldest_compiler(&mut self) {
        let (version, crates) = (OLDEST, PUBLISHED.iter().flat_map(|name| ["--package", name]));
        if !answers("rustup", &["run", version, "rustc", "--version"]) {
            let remedy = format!("rustup toolchain install {version} --profile minimal");
            return self.skip(&format!("Rust {version}: not installed ({remedy})"));
        }
        let mut command = Command::new("rustup");
        command.args(["run", version, "cargo", "check", "--quiet", "--locked", "--all-features"]).args(crates);
        // Another compiler would throw away what the pinned one built; this variable would name that one.
        command.env("CARGO_TARGET_DIR", tpg_testing::library::target_folder().join("oldest"));
        command.env_remove("RUSTUP_TOOLCHAIN").env_remove("CARGO").env_remove("RUSTC");
        self.check(&format!("Rust {version}"), command);
    }
}

/// Forwards a command's output while counting its tests.
fn counted(command: &mut Command) -> io::Result<(bool, Count)> {
    let mut child = command.stdout(Stdio::piped()).spawn()?;
    let mut count = Count::default();
    if let Some(stdout) = child.stdout.take() {
        for line in BufReader::new(stdout).lines() {
            let line = line?;
            println!("{line}");
            count.add(&line);
        }
    }
    Ok((child.wait()?.success(), count))
}
