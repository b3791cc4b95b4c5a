//! The program `cortex-bound`; see [`cortex_bound::cli`].

use clap::Parser;
use cortex_bound::cli::WcetArgs;
use std::process::ExitCode;

/// Bounds the worst case of compiled code for a Cortex-M.
#[derive(Debug, Parser)]
#[command(version)]
struct Cli {
    #[command(flatten)]
    arguments: WcetArgs,
}

fn main() -> ExitCode {
    if Cli::parse().arguments.run() { ExitCode::SUCCESS } else { ExitCode::FAILURE }
}
