//! The command line: results on stdout, everything else on stderr.

use crate::conformance::command::ReplayArgs;
use clap::{Parser, Subcommand};
use std::process::ExitCode;
use tpg_codegen::error::InputError;

/// Trains robot-arm policies, and replays the recorded episodes of the paper's own.
///
/// Exit status: 0 good, 1 a check failed, 2 bad input.
#[derive(Debug, Parser)]
#[command(version)]
pub struct Cli {
    #[command(subcommand)]
    command: Command,
}

#[derive(Debug, Subcommand)]
enum Command {
    /// Replay recorded episodes and count what is exact
    Replay(ReplayArgs),
}

/// What a command found.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Verdict {
    /// All is well.
    Good,
    /// A check failed.
    Failed,
}

/// Why a command could not do its work.
#[derive(Debug, thiserror::Error)]
pub enum CliError {
    /// The input is bad.
    #[error(transparent)]
    Input(#[from] InputError),
    /// Something else: a missing compiler, a broken pipe.
    #[error("{0}")]
    Other(String),
}

impl CliError {
    /// An error that is not the input's.
    pub fn other(error: impl std::fmt::Display) -> Self {
        Self::Other(error.to_string())
    }
}

impl Cli {
    /// Does what was asked, tells people on stderr what went wrong.
    pub fn run(self) -> ExitCode {
        let result = match self.command {
            Command::Replay(args) => args.run(),
        };
        match result {
            Ok(Verdict::Good) => ExitCode::SUCCESS,
            Ok(Verdict::Failed) => ExitCode::from(1),
            Err(error) => {
                eprintln!("error: {error}");
                ExitCode::from(2)
            }
        }
    }
}
