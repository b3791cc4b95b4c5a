//! `tpg-train`: trains robot-arm policies.

use clap::{Parser, Subcommand};
use std::process::ExitCode;
use tpg_train::evaluate::{EvalArgs, eval};
use tpg_train::evolution::command::{End, TpgArgs, execute};
use tpg_train::evolution::presets::{ConfigArgs, print_config};
use tpg_train::sac::command::{SacArgs, execute as execute_sac};
use tpg_train::targets::{TargetsArgs, print_targets};

/// Trains robot-arm policies.
///
/// Exit status: 0 good, 2 bad input, 130 stopped by Ctrl-C (the run can be resumed).
#[derive(Debug, Parser)]
#[command(version)]
struct Cli {
    #[command(subcommand)]
    command: Command,
}

#[derive(Debug, Subcommand)]
enum Command {
    /// Evolve a tangled program graph
    Tpg(TpgArgs),
    /// Train a soft actor-critic
    Sac(SacArgs),
    /// Print a set of tasks as CSV
    Targets(TargetsArgs),
    /// Let a policy act and count how its episodes end
    Eval(EvalArgs),
    /// Print a commented configuration
    Config(ConfigArgs),
}

fn main() -> ExitCode {
    let refused = |error: &dyn std::fmt::Display| {
        eprintln!("error: {error}");
        ExitCode::from(2)
    };
    let ended = |end: End| match end {
        End::Finished => ExitCode::SUCCESS,
        End::Interrupted => {
            eprintln!("stopped; --resume goes on from the checkpoint");
            ExitCode::from(130)
        }
    };
    match Cli::parse().command {
        Command::Sac(args) => execute_sac(&args).map_or_else(|error| refused(&error), ended),
        Command::Targets(args) => print_targets(&args).map_or_else(|error| refused(&error), |()| ExitCode::SUCCESS),
        Command::Tpg(args) => match execute(&args) {
            Ok(end) => ended(end),
            Err(error) => refused(&error),
        },
        Command::Eval(args) => eval(&args).map_or_else(|error| refused(&error), |()| ExitCode::SUCCESS),
        Command::Config(args) => print_config(&args).map_or_else(|error| refused(&error), |()| ExitCode::SUCCESS),
    }
}
