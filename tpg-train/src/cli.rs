//! The command line: results on stdout, everything else on stderr.

use crate::actor::import::{ImportArgs, import};
use crate::evaluate::{EvalArgs, eval};
use crate::evolution::command::{TpgArgs, execute as execute_tpg};
use crate::evolution::presets::{ConfigArgs, print_config};
use crate::hybrid::command::{HybridArgs, execute as execute_hybrid};
use crate::hybrid::constants::{ConstantsArgs, constants};
use crate::problems::print_problems;
use crate::quantise::{QuantiseArgs, quantise};
use crate::ranks::workplace::ThisProcess;
use crate::report::{ReportArgs, report};
use crate::sac::command::{SacArgs, execute as execute_sac};
use crate::targets::{TargetsArgs, print_targets};
use clap::{Parser, Subcommand};
use std::process::ExitCode;
use tpg_graph::command::{CommandError, Verdict, exit_code};

/// Trains policies for control problems: tangled program graphs, soft actor-critics, and hybrids of both.
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
    /// List the built-in problems, with what they observe and do
    Problems,
    /// Evolve a tangled program graph
    Tpg(TpgArgs),
    /// Train a soft actor-critic
    Sac(SacArgs),
    /// Study how graphs and networks share a problem
    Hybrid(HybridArgs),
    /// Turn a hybrid.toml into Rust constants
    Constants(ConstantsArgs),
    /// Convert an actor of Stable-Baselines3 or CleanRL to a policy
    Import(ImportArgs),
    /// Quantise a soft actor-critic's network to integers
    Quantise(QuantiseArgs),
    /// Run a policy and count how its episodes end
    Eval(EvalArgs),
    /// Show runs in one HTML file
    Report(ReportArgs),
    /// Print a commented configuration
    Config(ConfigArgs),
    /// Print a set of tasks as CSV
    Targets(TargetsArgs),
}

impl Cli {
    /// Runs the command and prints errors to stderr.
    pub fn run(self) -> ExitCode {
        exit_code(match self.command {
            Command::Problems => print_problems().map(|()| Verdict::Good).map_err(CommandError::from),
            Command::Tpg(args) => execute_tpg(&args, &ThisProcess).map_err(CommandError::other),
            Command::Sac(args) => execute_sac(&args).map_err(CommandError::other),
            Command::Hybrid(args) => execute_hybrid(&args, &ThisProcess).map_err(CommandError::from),
            Command::Constants(args) => constants(&args).map(|()| Verdict::Good).map_err(CommandError::from),
            Command::Import(args) => import(&args).map(|()| Verdict::Good).map_err(CommandError::from),
            Command::Quantise(args) => quantise(&args).map(|()| Verdict::Good).map_err(CommandError::from),
            Command::Eval(args) => eval(&args).map(|()| Verdict::Good).map_err(CommandError::from),
            Command::Report(args) => report(&args).map(|()| Verdict::Good).map_err(CommandError::from),
            Command::Config(args) => print_config(&args).map(|()| Verdict::Good).map_err(CommandError::from),
            Command::Targets(args) => print_targets(&args).map(|()| Verdict::Good).map_err(CommandError::from),
        })
    }
}
