//! The program `tpg-paper`; see [`tpg_paper::cli`].

use clap::Parser;
use std::process::ExitCode;
use tpg_paper::cli::Cli;

fn main() -> ExitCode {
    Cli::parse().run()
}
