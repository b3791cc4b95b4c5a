//! The program `tpg-train`; see [`tpg_train::cli`].

use clap::Parser;
use std::process::ExitCode;
use tpg_train::cli::Cli;

fn main() -> ExitCode {
    Cli::parse().run()
}
