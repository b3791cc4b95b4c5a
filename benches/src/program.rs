//! A variant of a subject as a separate program that holds the states, decides all of them as often as requested, and
//! reports the CPU time. One loop in C drives C and Rust alike; the interpreter runs here.

use crate::cpu_seconds;
use crate::subject::Subject;
use crate::variant::Variant;
use askama::Template;
use std::io::{self, BufRead as _, BufReader, Write as _};
use std::path::Path;
use std::process::{Child, ChildStdout, Command, Stdio};
use std::time::Duration;
use std::{fs, hint::black_box};
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

/// The folder of a program, built and checked.
#[derive(Debug)]
pub struct Program(TempDir);

/// A running program that waits for requests.
#[derive(Debug)]
pub struct Running {
    child: Child,
    output: BufReader<ChildStdout>,
    hash: u32,
}

/// A program or the interpreter, to decide a subject's states.
#[derive(Debug)]
pub enum Decider<'a> {
    /// A program.
    Program(Running),
    /// The interpreter.
    Interpreter(&'a Subject),
}

impl Program {
    /// Builds a variant with the compilers at `-O2` and `-O`, without unusual flags; `None` for the interpreter.
    ///
    /// # Errors
    /// If a compiler is missing or reports an error.
    pub fn build(subject: &Subject, variant: Variant) -> Result<Option<Self>, Box<dyn std::error::Error>> {
        let Some((language, options)) = variant.emission() else { return Ok(None) };
        let folder = TempDir::new()?;
        let at = |name: &str| folder.path().join(name);
        fs::write(at("states"), bytes(subject))?;
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
        Ok(Some(Self(folder)))
    }

    /// Starts the program.
    ///
    /// # Errors
    /// If it does not start.
    pub fn start(&self, subject: &Subject) -> io::Result<Running> {
        let mut command = Command::new(self.folder().join("program"));
        let command = command.arg(self.folder().join("states"));
        let mut child = command.stdin(Stdio::piped()).stdout(Stdio::piped()).spawn()?;
        let output = child.stdout.take().ok_or_else(missing)?;
        Ok(Running { child, output: BufReader::new(output), hash: interpreted(subject) })
    }

    /// Returns the folder of the program.
    pub fn folder(&self) -> &Path {
        self.0.path()
    }
}

impl Decider<'_> {
    /// Returns the CPU time of `passes` passes over all states.
    ///
    /// # Errors
    /// If the program died, or takes different actions from the interpreter.
    pub fn time(&mut self, passes: u64) -> io::Result<Duration> {
        match self {
            Self::Program(running) => running.time(passes),
            Self::Interpreter(subject) => {
                let began = cpu_seconds();
                for _ in 0..passes {
                    black_box(interpreted(subject));
                }
                Ok(Duration::from_secs_f64(cpu_seconds() - began))
            }
        }
    }
}

impl Running {
    fn time(&mut self, passes: u64) -> io::Result<Duration> {
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

/// Computes FNV-1a of the interpreter's actions, one at a time.
fn interpreted(subject: &Subject) -> u32 {
    let actions = interpret::actions(&subject.graph, &subject.states).into_iter();
    actions.fold(2_166_136_261, |hash, action| (hash ^ u32::from(action.0)).wrapping_mul(16_777_619))
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
