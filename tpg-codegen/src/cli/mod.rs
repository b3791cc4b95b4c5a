//! The command line: results on stdout, everything else on stderr.

mod generate;
mod verify;

pub use generate::GenerateArgs;

use crate::error::InputError;
use crate::graph::Graph;
use crate::import;
use clap::{Args, Parser, Subcommand};
use std::path::PathBuf;
use std::process::ExitCode;

/// Compiles tangled program graphs into C and no_std Rust, and proves the result equal to the graph.
///
/// Exit status: 0 good, 1 a check failed, 2 bad input.
#[derive(Debug, Parser)]
#[command(version, args_conflicts_with_subcommands = true, subcommand_negates_reqs = true)]
pub struct Cli {
    #[command(subcommand)]
    command: Option<Command>,
    #[command(flatten)]
    generate: Option<GenerateArgs>,
}

#[derive(Debug, Subcommand)]
enum Command {
    /// Compile the generated code and compare it with the interpreter
    Verify(verify::VerifyArgs),
}

/// What a command found.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Verdict {
    /// All is well.
    Good,
    /// A check failed: differences, stale files.
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
    fn other(error: impl std::fmt::Display) -> Self {
        Self::Other(error.to_string())
    }
}

/// The graph to read, and what a `.dot` file does not say about it.
#[derive(Clone, Debug, Args)]
pub struct GraphArgs {
    /// A graph.json or a GEGELATI .dot file; - for standard input
    pub graph: PathBuf,
    /// A built-in description of what a .dot file lacks
    #[arg(long, value_name = "NAME", conflicts_with = "sidecar")]
    pub profile_of: Option<import::Profile>,
    /// A TOML file that says what a .dot file lacks
    #[arg(long, value_name = "FILE")]
    pub sidecar: Option<PathBuf>,
}

impl GraphArgs {
    /// Reads and validates the graph.
    ///
    /// # Errors
    /// Whatever is wrong with it.
    pub fn load(&self) -> Result<Graph, InputError> {
        import::load(&self.graph, self.profile_of, self.sidecar.as_deref())
    }
}

impl Cli {
    /// Does what was asked, tells people on stderr what went wrong.
    pub fn run(self) -> ExitCode {
        let result = match (self.command, self.generate) {
            (Some(Command::Verify(args)), _) => args.run(),
            (None, Some(args)) => args.run(),
            (None, None) => Err(CliError::other("no graph given; see --help")),
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
