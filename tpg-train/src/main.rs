//! The command line of the trainer.

use clap::Parser;
use tpg_train::sac::command;

/// Trains robot-arm policies.
#[derive(Debug, Parser)]
#[command(version)]
enum Command {
    /// Train a soft actor-critic.
    Sac(command::SacArgs),
}

fn main() {
    match Command::parse() {
        Command::Sac(args) => command::run(args),
    }
}
