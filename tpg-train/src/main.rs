//! `tpg-train`: trains robot-arm policies.

use clap::{Parser, Subcommand};
use std::process::ExitCode;
use tpg_train::evaluate::{EvalArgs, eval};
use tpg_train::evolution::command::{End, TpgArgs, execute};
use tpg_train::evolution::presets::{ConfigArgs, print_config};

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
    match Cli::parse().command {
        Command::Tpg(args) => match execute(&args) {
            Ok(End::Finished) => ExitCode::SUCCESS,
            Ok(End::Interrupted) => {
                eprintln!("stopped; --resume goes on from the checkpoint");
                ExitCode::from(130)
            }
            Err(error) => refused(&error),
        },
        Command::Eval(args) => eval(&args).map_or_else(|error| refused(&error), |()| ExitCode::SUCCESS),
        Command::Config(args) => print_config(&args).map_or_else(|error| refused(&error), |()| ExitCode::SUCCESS),
    }
}
