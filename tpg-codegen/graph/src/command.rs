//! Outcomes of command-line programs, shared by every program of the workspace.

use crate::error::InputError;
use std::fmt::Display;
use std::process::ExitCode;

/// The outcome of a command that ran to its end.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Verdict {
    /// Everything is in order: exit status 0.
    Good,
    /// A check failed: exit status 1.
    Failed,
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

/// Turns a command's result into its exit status; prints an error to stderr.
pub fn exit_code(result: Result<Verdict, CommandError>) -> ExitCode {
    match result {
        Ok(Verdict::Good) => ExitCode::SUCCESS,
        Ok(Verdict::Failed) => ExitCode::from(1),
        Ok(Verdict::Interrupted) => {
            eprintln!("stopped; --resume continues from the checkpoint");
            ExitCode::from(130)
        }
        Err(CommandError::Failed(reason)) => {
            eprintln!("{reason}");
            ExitCode::from(1)
        }
        Err(error) => {
            eprintln!("error: {error}");
            ExitCode::from(2)
        }
    }
}
