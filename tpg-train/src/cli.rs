//! The command line: results on stdout, everything else on stderr.

use crate::conformance::command::ReplayArgs;
use crate::evaluate::{EvalArgs, eval};
use crate::evolution::command::{End, TpgArgs, execute as execute_tpg};
use crate::evolution::presets::{ConfigArgs, print_config};
use crate::hybrid::command::{HybridArgs, execute as execute_hybrid};
use crate::hybrid::setting::{ConstantsArgs, constants};
use crate::hybrid::table::{Table2Args, execute as execute_table2};
use crate::report::{ReportArgs, report};
use crate::sac::command::{SacArgs, execute as execute_sac};
use crate::sac::evaluate::{QuantiseArgs, quantise};
use crate::sac::import::{ImportArgs, import};
use crate::targets::{TargetsArgs, print_targets};
use clap::{Parser, Subcommand};
use std::process::ExitCode;
use tpg_graph::error::InputError;

/// Trains robot-arm policies, and replays the recorded episodes of the paper's own.
///
/// Exit status: 0 good, 1 a check failed, 2 bad input, 130 stopped by Ctrl-C (the run can be resumed).
#[derive(Debug, Parser)]
#[command(version)]
pub struct Cli {
    #[command(subcommand)]
    command: Command,
}

#[derive(Debug, Subcommand)]
enum Command {
    /// Evolve a tangled program graph
    Tpg(TpgArgs),
    /// Train a soft actor-critic
    Sac(SacArgs),
    /// Study how graphs and actors share the arm
    Hybrid(HybridArgs),
    /// Turn a hybrid.toml into constants of Rust
    Constants(ConstantsArgs),
    /// Measure every kind of policy and write docs/results.md
    Table2(Table2Args),
    /// Turn an actor of Stable-Baselines3 or CleanRL into a policy
    Import(ImportArgs),
    /// Put a soft actor-critic's network into integers
    Quantise(QuantiseArgs),
    /// Let a policy act and count how its episodes end
    Eval(EvalArgs),
    /// Show runs in one HTML file
    Report(ReportArgs),
    /// Print a commented configuration
    Config(ConfigArgs),
    /// Print a set of tasks as CSV
    Targets(TargetsArgs),
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
    /// Ctrl-C: the run can be resumed.
    Interrupted,
}

impl From<End> for Verdict {
    fn from(end: End) -> Self {
        match end {
            End::Finished => Self::Good,
            End::Interrupted => Self::Interrupted,
        }
    }
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
            Command::Tpg(args) => execute_tpg(&args).map(Verdict::from).map_err(CliError::other),
            Command::Sac(args) => execute_sac(&args).map(Verdict::from).map_err(CliError::other),
            Command::Hybrid(args) => execute_hybrid(&args).map(Verdict::from).map_err(CliError::from),
            Command::Constants(args) => constants(&args).map(|()| Verdict::Good).map_err(CliError::from),
            Command::Table2(args) => execute_table2(&args).map(|()| Verdict::Good).map_err(CliError::from),
            Command::Import(args) => import(&args).map(|()| Verdict::Good).map_err(CliError::from),
            Command::Quantise(args) => quantise(&args).map(|()| Verdict::Good).map_err(CliError::from),
            Command::Eval(args) => eval(&args).map(|()| Verdict::Good).map_err(CliError::from),
            Command::Report(args) => report(&args).map(|()| Verdict::Good).map_err(CliError::from),
            Command::Config(args) => print_config(&args).map(|()| Verdict::Good).map_err(CliError::from),
            Command::Targets(args) => print_targets(&args).map(|()| Verdict::Good).map_err(CliError::from),
            Command::Replay(args) => args.run(),
        };
        match result {
            Ok(Verdict::Good) => ExitCode::SUCCESS,
            Ok(Verdict::Failed) => ExitCode::from(1),
            Ok(Verdict::Interrupted) => {
                eprintln!("stopped; --resume goes on from the checkpoint");
                ExitCode::from(130)
            }
            Err(error) => {
                eprintln!("error: {error}");
                ExitCode::from(2)
            }
        }
    }
}
