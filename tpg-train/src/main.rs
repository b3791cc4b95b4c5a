//! The program `tpg-train`.

use clap::Parser;
use std::process::ExitCode;
use tpg_train::Cli;

fn main() -> ExitCode {
    Cli::parse().run()
}
