//! A variant of a subject as a separate program that holds the states, decides all of them as often as requested, and
//! reports the CPU time. One loop in C drives C and Rust alike; the interpreter has the same loop in Rust.

use crate::subject::Subject;
use crate::variant::Variant;
use askama::Template;
use std::io::{self, BufRead as _, BufReader, Write as _};
use std::path::{Path, PathBuf};
use std::process::{Child, ChildStdout, Command, Stdio};
use std::time::Duration;
use std::{env, fs};
use tempfile::TempDir;
use tpg_codegen::emit::{self, Language, Options, Style};
use tpg_codegen::verify;
use tpg_graph::ScalarType;
use tpg_graph::interpret;

#[derive(Template)]
#[template(path = "main.c", escape = "none")]
struct MainC {
    scalar: &'static str,
    length: usize,
    count: usize,
    sources: Vec<(String, usize)>,
    gegelati: bool,
    rust: bool,
}

#[derive(Template)]
#[template(path = "lib.rs", escape = "none")]
struct LibRust {
    scalar: &'static str,
    length: usize,
    name: String,
}

/// A program, built and checked.
#[derive(Debug)]
pub struct Program {
    folder: TempDir,
    command: Vec<PathBuf>,
}

/// A running program that waits for requests.
#[derive(Debug)]
pub struct Running {
    child: Child,
    output: BufReader<ChildStdout>,
    hash: u32,
}

impl Program {
    /// Builds a variant with the compilers at `-O2` and `-O`, without unusual flags.
    ///
    /// # Errors
    /// If a compiler is missing or reports an error.
    pub fn build(subject: &Subject, variant: Variant) -> Result<Self, Box<dyn std::error::Error>> {
        let folder = TempDir::new()?;
        let at = |name: &str| folder.path().join(name);
        fs::write(at("states"), bytes(subject))?;
        let Some((language, options)) = variant.emission() else {
            fs::write(at("graph.json"), subject.graph.to_json())?;
            let command = vec![interpreter()?, at("states"), at("graph.json")];
            return Ok(Self { folder, command });
        };
        for file in emit::emit(&subject.graph, language, &options) {
            fs::write(at(&file.name), file.text)?;
        }
        let policy = match language {
            Language::C => "timed.c",
            Language::Rust => rust_library(folder.path(), subject, &options)?,
        };
        let main = MainC {
            scalar: if subject.graph.scalar() == ScalarType::F32 { "float" } else { "double" },
            length: subject.graph.state_length(),
            count: subject.count(),
            sources: subject.graph.sources().iter().map(|s| (s.name.clone(), s.ranges.len())).collect(),
            gegelati: options.style == Style::Gegelati,
            rust: language == Language::Rust,
        };
        fs::write(at("main.c"), main.render()?)?;
        let mut command = verify::c_command(folder.path())?;
        command.args(["-o", "program", "main.c", policy, "-lm"]);
        verify::compile("C", command)?;
        let command = vec![at("program"), at("states")];
        Ok(Self { folder, command })
    }

    /// Starts the program.
    ///
    /// # Errors
    /// If it does not start.
    pub fn start(&self, subject: &Subject) -> io::Result<Running> {
        let mut child = Command::new(&self.command[0])
            .args(&self.command[1..])
            .stdin(Stdio::piped())
            .stdout(Stdio::piped())
            .spawn()?;
        let output = child.stdout.take().ok_or_else(missing)?;
        let hash = hash_of(interpret::actions(&subject.graph, &subject.states).iter().map(|action| action.0));
        Ok(Running { child, output: BufReader::new(output), hash })
    }

    /// Returns the command that decides the first `count` states `passes` times and exits.
    pub fn once(&self, passes: u32, count: usize) -> Vec<String> {
        let words = self.command[..2].iter().map(|word| word.display().to_string());
        let graph = self.command.get(2).map(|graph| graph.display().to_string());
        words.chain([passes.to_string(), count.to_string()]).chain(graph).collect()
    }

    /// Returns the folder of the program.
    pub fn folder(&self) -> &Path {
        self.folder.path()
    }
}

impl Running {
    /// Returns the CPU time of `passes` passes over all states.
    ///
    /// # Errors
    /// If the program died, or takes different actions from the interpreter.
    pub fn time(&mut self, passes: u64) -> io::Result<Duration> {
        writeln!(self.child.stdin.as_mut().ok_or_else(missing)?, "{passes}")?;
        let mut line = String::new();
        self.output.read_line(&mut line)?;
        let mut words = line.split_whitespace();
        let time = words.next().and_then(|word| word.parse::<u64>().ok());
        let hash = words.next().and_then(|word| word.parse::<u32>().ok());
        match time.zip(hash) {
            Some((nanoseconds, hash)) if hash == self.hash => Ok(Duration::from_nanos(nanoseconds)),
            Some(_) => Err(io::Error::other("other actions than the interpreter's")),
            None => Err(io::Error::other(format!("the program answered {line:?}"))),
        }
    }
}

impl Drop for Running {
    fn drop(&mut self) {
        // This closes its input, which ends the program.
        let _ = self.child.wait();
    }
}

fn missing() -> io::Error {
    io::Error::other("the program has no pipe")
}

/// Computes FNV-1a, one action at a time.
pub fn hash_of(actions: impl Iterator<Item = u16>) -> u32 {
    actions.fold(2_166_136_261, |hash, action| (hash ^ u32::from(action)).wrapping_mul(16_777_619))
}

fn rust_library(
    folder: &Path,
    subject: &Subject,
    options: &Options,
) -> Result<&'static str, Box<dyn std::error::Error>> {
    verify::runtime_library(folder)?;
    let library = LibRust {
        scalar: subject.graph.scalar().name(),
        length: subject.graph.state_length(),
        name: options.prefix.camel(),
    };
    fs::write(folder.join("lib.rs"), library.render()?)?;
    let mut command = verify::rustc(folder);
    // Built as by a user: without the checks that verification keeps.
    command.args(["-Coverflow-checks=off", "--crate-type=staticlib", "--extern=tpg_runtime=libtpg_runtime.rlib"]);
    command.args(["-o", "libtimed.a", "lib.rs"]);
    verify::compile("Rust", command)?;
    Ok("libtimed.a")
}

/// Serialises the states for the program.
fn bytes(subject: &Subject) -> Vec<u8> {
    match subject.graph.scalar() {
        ScalarType::F32 => subject.states.iter().flat_map(|&value| (value as f32).to_ne_bytes()).collect(),
        ScalarType::F64 => subject.states.iter().flat_map(|value| value.to_ne_bytes()).collect(),
    }
}

/// Finds the interpreter program, which cargo builds alongside the benchmarks.
fn interpreter() -> io::Result<PathBuf> {
    let here = env::current_exe()?;
    let folders = here.ancestors().skip(1).take(2);
    let name = format!("interpreter{}", env::consts::EXE_SUFFIX);
    let found = folders.map(|folder| folder.join(&name)).find(|path| path.is_file());
    found.ok_or_else(|| io::Error::other("the program `interpreter` is missing: cargo build -p tpg-benches --release"))
}
