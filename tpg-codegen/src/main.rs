//! The program `tpg-codegen`; see [`tpg_codegen::cli`].

use clap::Parser;
use std::process::ExitCode;
use tpg_codegen::cli::Cli;

fn main() -> ExitCode {
    Cli::parse().run()
}
