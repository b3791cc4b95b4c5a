//! Instruction counts by valgrind's callgrind: the same number in every run, however busy the machine is.

use crate::program::Program;
use crate::subject::Subject;
use std::io;
use std::process::{Command, Stdio};

/// Number of states that are counted: valgrind is fifty times slower than the processor.
const COUNTED: usize = 512;

/// True if valgrind is available; otherwise reports the skip.
pub fn available() -> bool {
    tpg_testing::tool("valgrind", "valgrind", "instruction counts")
}

/// Returns the instructions per state: the difference between one pass and three, which cancels everything but the
/// policy.
///
/// # Errors
/// If valgrind fails.
pub fn per_state(program: &Program, subject: &Subject) -> io::Result<f64> {
    let count = subject.count().min(COUNTED);
    let once = total(program, 1, count)?;
    let thrice = total(program, 3, count)?;
    Ok((thrice - once) as f64 / (2 * count) as f64)
}

fn total(program: &Program, passes: u32, count: usize) -> io::Result<u64> {
    let mut command = Command::new("valgrind");
    command.current_dir(program.folder()).args(["--tool=callgrind", "--callgrind-out-file=/dev/null"]);
    command
        .args(["./program", "states"])
        .args([passes.to_string(), count.to_string()])
        .stdout(Stdio::null())
        .stderr(Stdio::piped());
    let output = command.output()?;
    let text = String::from_utf8_lossy(&output.stderr);
    let collected = text.lines().find_map(|line| line.split_once("Collected :")).map(|(_, number)| number.trim());
    match collected.and_then(|number| number.parse().ok()) {
        Some(number) if output.status.success() => Ok(number),
        _ => Err(io::Error::other(format!("valgrind: {}: {text}", output.status))),
    }
}
