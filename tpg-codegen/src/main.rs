//! The program `tpg-codegen`; see [`tpg_codegen::cli`].

use std::process::ExitCode;
use tpg_codegen::cli::Cli;

fn main() -> ExitCode {
    Cli::from_args(std::env::args_os()).run()
}
