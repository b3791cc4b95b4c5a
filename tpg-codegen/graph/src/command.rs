//! Outcomes of command-line programs, shared by every program of the workspace.

use crate::error::InputError;
use std::fmt::Display;
use std::io::{self, IsTerminal as _, Write as _};
use std::process::{self, ExitCode};
use std::sync::atomic::{AtomicBool, Ordering};

/// The outcome of a command that ran to its end.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Verdict {
    /// Everything is in order: exit status 0.
    Good,
    /// A check failed: exit status 1.
    Failed,
    /// Nothing could be decided: exit status 3.
    Undecided,
    /// Ctrl-C stopped a run that can be resumed: exit status 130.
    Interrupted,
}

/// The reason why a command could not do its work: exit status 2, or 1 where a check failed.
#[derive(Debug, thiserror::Error)]
pub enum CommandError {
    /// Bad input.
    #[error(transparent)]
    Input(#[from] InputError),
    /// A check that failed before there was a result.
    #[error("{0}")]
    Failed(String),
    /// Anything else: a broken pipe.
    #[error("{0}")]
    Other(String),
}

impl CommandError {
    /// Wraps an error that is not about the input.
    pub fn other(error: impl Display) -> Self {
        Self::Other(error.to_string())
    }
}

/// The exit status of a program whose reader has gone: that of the signal SIGPIPE.
const CLOSED_PIPE: i32 = 141;

/// Writes a result to standard output, all of it. If the reader has gone, as `head` has after its lines, the program ends
/// quietly, with exit status 141.
///
/// # Errors
/// If it cannot be written for another reason.
pub fn print(text: impl AsRef<[u8]>) -> Result<(), InputError> {
    let mut out = io::stdout().lock();
    match out.write_all(text.as_ref()).and_then(|()| out.flush()) {
        Err(error) if error.kind() == io::ErrorKind::BrokenPipe => process::exit(CLOSED_PIPE),
        written => written.map_err(|error| InputError::io("<stdout>".as_ref(), &error, "an open pipe")),
    }
}

/// `--quiet`: set once, before a command runs.
static QUIET: AtomicBool = AtomicBool::new(false);

/// Suppresses [notes](note) and progress from now on.
pub fn be_quiet(quiet: bool) {
    QUIET.store(quiet, Ordering::Relaxed);
}

/// Tests for `--quiet`.
pub fn is_quiet() -> bool {
    QUIET.load(Ordering::Relaxed)
}

/// Writes a line for people to standard error, unless the program shall be quiet.
pub fn note(text: impl Display) {
    if !is_quiet() {
        let _ = writeln!(io::stderr().lock(), "{text}");
    }
}

/// The word "error", red where standard error is a terminal and the variable `NO_COLOR` is unset or empty.
fn error_word() -> &'static str {
    let plain = std::env::var_os("NO_COLOR").is_some_and(|value| !value.is_empty());
    if io::stderr().is_terminal() && !plain { "\x1b[1;31merror\x1b[0m" } else { "error" }
}

/// Turns a command's result into its exit status; prints an error to stderr.
pub fn exit_code(result: Result<Verdict, CommandError>) -> ExitCode {
    match result {
        Ok(Verdict::Good) => ExitCode::SUCCESS,
        Ok(Verdict::Failed) => ExitCode::from(1),
        Ok(Verdict::Undecided) => ExitCode::from(3),
        Ok(Verdict::Interrupted) => {
            eprintln!("stopped; --resume continues from the checkpoint");
            ExitCode::from(130)
        }
        Err(CommandError::Failed(reason)) => {
            eprintln!("{reason}");
            ExitCode::from(1)
        }
        Err(error) => {
            eprintln!("{}: {error}", error_word());
            ExitCode::from(2)
        }
    }
}
