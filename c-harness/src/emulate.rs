//! Runs an image in an emulator.

use crate::Failure;
use crate::line::Line;
use std::io::{BufRead as _, BufReader, Read};
use std::path::Path;
use std::process::{Command, Stdio};
use std::sync::mpsc::{self, Sender};
use std::thread;
use std::time::Duration;

/// Longer than any machine needs for a line; a hang must end.
const PATIENCE: Duration = Duration::from_secs(600);

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

/// Runs a program until its line `done`, and returns its lines; the machine need not end by itself.
pub(crate) fn until_done(command: &mut Command) -> Result<Vec<Line>, Failure> {
    let called = format!("{command:?}");
    let failure = |text: String| Failure::new(format!("{called}: {text}"));
    let spawned = command.stdin(Stdio::null()).stdout(Stdio::piped()).stderr(Stdio::piped()).spawn();
    let mut child = spawned.map_err(|error| failure(error.to_string()))?;
    let (sender, receiver) = mpsc::channel();
    // SYS_WRITE0 comes out on stderr, SYS_WRITE on stdout.
    forward(child.stdout.take(), sender.clone());
    forward(child.stderr.take(), sender);
    let mut lines = Vec::new();
    let mut tail = Vec::new();
    let done = loop {
        let Ok(text) = receiver.recv_timeout(PATIENCE) else { break false };
        let line = Line::parse(&text);
        let last = line.words == ["done"];
        lines.push(line);
        tail.push(text);
        if last {
            break true;
        }
    };
    // Some machines have nothing that ends them.
    let _ = child.kill();
    let status = child.wait().map_err(|error| failure(error.to_string()))?;
    let last = tail.split_off(tail.len().saturating_sub(5));
    if done { Ok(lines) } else { Err(failure(format!("{status}, without a line `done`: {last:?}"))) }
}

/// Sends what a stream says, line by line, until it ends.
fn forward(stream: Option<impl Read + Send + 'static>, sender: Sender<String>) {
    let Some(stream) = stream else { return };
    thread::spawn(move || {
        for line in BufReader::new(stream).split(b'\n').map_while(Result::ok) {
            if sender.send(plain(&String::from_utf8_lossy(&line)).to_owned()).is_err() {
                return;
            }
        }
    });
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
    fn a_machine_that_does_not_end_is_ended_and_one_that_says_nothing_is_a_failure() {
        let run = |script: &str| until_done(Command::new("sh").args(["-c", script]));
        let lines =
            run("echo one a=1; echo two >&2; printf '\\033[0m\\033[32mdone.\\n'; sleep 1000").expect("it is done");
        assert!(lines.iter().any(|line| line.number("a") == 1) && lines.len() >= 2, "{lines:?}");
        let error = run("echo half; exit 3").expect_err("it is not done").0;
        assert!(error.contains("half") && error.contains("exit status: 3"), "{error}");
    }
}
