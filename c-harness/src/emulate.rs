//! Runs an image in an emulator.

use crate::Failure;
use crate::line::Line;
use std::path::Path;
use std::process::{Command, Output, Stdio};

/// Longer than any machine needs, seconds; a hang must end.
const PATIENCE: &str = "1200";

/// Runs an image on a board and returns the lines that it prints.
pub(crate) fn run(board: &str, image: &Path) -> Result<Vec<Line>, Failure> {
    until_done(qemu("qemu-system-arm", board).arg(image).args(["-icount", "shift=10,align=off,sleep=off"]))
}

/// A QEMU of a machine; an image is to follow.
pub(crate) fn qemu(program: &str, machine: &str) -> Command {
    let mut qemu = Command::new(program);
    qemu.args(["-machine", machine, "-nographic", "-monitor", "none", "-serial", "none"]);
    qemu.args(["-semihosting-config", "enable=on,target=native", "-kernel"]);
    qemu
}

/// Runs a program that ends with a line `done`, and returns its lines.
pub(crate) fn until_done(command: &mut Command) -> Result<Vec<Line>, Failure> {
    let mut timed = Command::new("timeout");
    timed.arg(PATIENCE).arg(command.get_program()).args(command.get_args()).stdin(Stdio::null());
    let Output { status, stdout, stderr } = timed.output()?;
    // SYS_WRITE0 comes out on stderr, SYS_WRITE on stdout.
    let text = [stdout, stderr].map(|text| String::from_utf8_lossy(&text).into_owned()).concat();
    let lines: Vec<Line> = text.lines().map(|line| Line::parse(plain(line))).collect();
    if lines.iter().any(|line| line.words == ["done"]) {
        return Ok(lines);
    }
    let last = &lines[lines.len().saturating_sub(5)..];
    Err(Failure(format!("{command:?}: {status}, without a line `done`: {last:?}")))
}

/// Takes off what simavr puts around a line: colours, and a dot for its end.
fn plain(line: &str) -> &str {
    match line.rsplit_once("\u{1b}[32m") {
        Some((_, coloured)) => coloured.strip_suffix('.').unwrap_or(coloured),
        None => line,
    }
}

#[cfg(test)]
mod tests {
    use super::until_done;
    use std::process::Command;

    #[test]
    fn both_streams_are_read_and_a_machine_without_the_last_line_is_a_failure() {
        let run = |script: &str| until_done(Command::new("sh").args(["-c", script]));
        let lines = run("echo one a=1; echo two >&2; printf '\\033[0m\\033[32mdone.\\n'").expect("it is done");
        assert!(lines.iter().any(|line| line.number("a") == 1) && lines.len() == 3, "{lines:?}");
        let error = run("echo half; exit 3").expect_err("it is not done").0;
        assert!(error.contains("half") && error.contains("exit status: 3"), "{error}");
    }
}
