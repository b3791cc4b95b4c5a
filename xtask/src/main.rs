//! `cargo xtask`: everything CI runs, a person can run.

mod check;
mod setup;
mod summary;
mod worst;

use clap::{Parser, Subcommand};
use std::process::ExitCode;

/// Sets a machine up for this repository and tests it.
#[derive(Debug, Parser)]
#[command(bin_name = "cargo xtask")]
struct Cli {
    #[command(subcommand)]
    command: Task,
}

#[derive(Clone, Debug, Subcommand)]
enum Task {
    /// Install what is missing: compilers, linters and emulator (apt-get), cross targets (rustup)
    Setup,
    /// Everything: format, clippy, tests, documentation, no_std builds, lint of generated C
    Test,
    /// Only the lint of generated C: gcc, clang, clang-tidy, cppcheck with its MISRA addon
    Lint,
    /// The worst case of compiled code for a Cortex-M: instructions and stack
    Wcet(worst::WcetArgs),
}

fn main() -> ExitCode {
    let good = match Cli::parse().command {
        Task::Setup => setup::run(),
        Task::Test => check::all(),
        Task::Lint => check::lint(),
        Task::Wcet(arguments) => arguments.run(),
    };
    if good { ExitCode::SUCCESS } else { ExitCode::FAILURE }
}
