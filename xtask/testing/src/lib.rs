//! Test support: reported and counted skips, and the build of `libtpg_runtime.a` that tests and `xtask` share.
//!
//! A test that lacks a tool or data calls [`skip`] and returns. The line is always visible, even if the test harness
//! captures output, and `cargo xtask test` lists it again in its summary. If everything must be present, as in CI, a
//! missing tool is a failure instead.

pub mod book;
pub mod library;
pub mod numbers;

use Beside::*;
use std::fs::OpenOptions;
use std::io::{self, Write as _};
use std::process::{Command, ExitStatus, Stdio};
use std::{env, fs};

/// Environment variable naming the file that skips are appended to, one per line.
pub const LOG: &str = "TPG_SKIPPED_LOG";

/// Environment variable: if it is `1`, a missing tool is a failure.
pub const REQUIRE: &str = "TPG_REQUIRE_EMBEDDED";

/// True if missing tools must fail.
pub fn required() -> bool {
    env::var(REQUIRE).is_ok_and(|value| value == "1")
}

/// Reports that something was not tested, and why.
///
/// # Panics
/// If the log named by [`LOG`] cannot be written: a skip must not be lost.
pub fn skip(what: &str) {
    // Not eprintln!, which a test harness captures.
    let _ = writeln!(io::stderr().lock(), "SKIPPED: {what}");
    if let Some(path) = env::var_os(LOG) {
        let log = OpenOptions::new().create(true).append(true).open(&path);
        // A single write, so that the lines of parallel tests do not mix.
        let written = log.and_then(|mut log| log.write_all(format!("{what}\n").as_bytes()));
        assert!(written.is_ok(), "cannot note in {} that this was skipped: {what}", path.display());
    }
}

/// Returns the lines of a log of skips; empty if nothing was skipped.
pub fn skipped(log: &std::path::Path) -> Vec<String> {
    fs::read_to_string(log).map(|text| text.lines().map(str::to_owned).collect()).unwrap_or_default()
}

/// A second thing that a program needs.
enum Beside {
    /// A file that a compiler finds by itself.
    File(&'static str),
    /// Another program.
    Program(&'static str),
}

/// Programs that are of no use alone, what they need, and its package.
const BESIDE: [(&str, Beside, &str); 5] = [
    ("arm-none-eabi-gcc", File("libc.a"), "libnewlib-arm-none-eabi"),
    ("avr-gcc", File("libc.a"), "avr-libc"),
    ("avr-g++", File("libc.a"), "avr-libc"),
    ("riscv64-unknown-elf-gcc", File("picolibc.specs"), "picolibc-riscv64-unknown-elf"),
    ("cmake", Program("make"), "make"),
];

/// True if a program works, with what it needs beside it; otherwise `what` is [skipped](skip), naming the package
/// to install.
///
/// # Panics
/// If something is missing and [`REQUIRE`] is `1`.
pub fn tool(program: &str, package: &str, what: &str) -> bool {
    let mut needs = BESIDE.iter().filter(|(name, ..)| *name == program);
    let missing = match exists(program) {
        false => Some((program, package)),
        true => needs.find_map(|(_, beside, package)| match beside {
            File(file) => (!finds(program, file)).then_some((*file, *package)),
            Program(other) => (!exists(other)).then_some((*other, *package)),
        }),
    };
    let Some((missing, package)) = missing else { return true };
    let message = format!("{what}: {missing} not found (cargo xtask setup installs it from {package})");
    assert!(!required(), "{message}");
    skip(&message);
    false
}

/// Programs that know no `--version` and answer it with an error.
const WITHOUT_VERSION: [&str; 1] = ["simavr"];

/// True if a program works. For most, that it starts is not enough: rustup leaves a program for each component that is
/// not installed.
pub fn exists(program: &str) -> bool {
    status(program, &["--version"]).is_ok_and(|status| status.success() || WITHOUT_VERSION.contains(&program))
}

/// True if a program answers without an error; its toolchain is the one that it names, not the pinned one.
pub fn answers(program: &str, words: &[&str]) -> bool {
    status(program, words).is_ok_and(|status| status.success())
}

fn status(program: &str, words: &[&str]) -> io::Result<ExitStatus> {
    let mut command = Command::new(program);
    command.args(words).env_remove("RUSTUP_TOOLCHAIN");
    command.stdin(Stdio::null()).stdout(Stdio::null()).stderr(Stdio::null()).status()
}

/// True if a compiler finds a file of its libraries: it answers with the path, or with what it was asked.
fn finds(compiler: &str, file: &str) -> bool {
    let output = Command::new(compiler).arg(format!("-print-file-name={file}")).output();
    output.is_ok_and(|output| output.stdout.trim_ascii() != file.as_bytes())
}

/// Names the variable by which nothing is shortened.
pub const FULL: &str = "TPG_FULL_TESTS";

/// Returns `all` where [`FULL`] is `1`, as in CI, and `some` otherwise: the amount of work of a long test.
///
/// A shortened test covers the same code on fewer cases, so that `cargo xtask test` stays a matter of minutes.
pub fn amount<T>(some: T, all: T) -> T {
    if env::var(FULL).is_ok_and(|value| value == "1") { all } else { some }
}
