//! The program `tpg-codegen`; see [`tpg_codegen::Cli`].

use std::process::ExitCode;
use tpg_codegen::Cli;

fn main() -> ExitCode {
    Cli::from_args(std::env::args_os()).run()
}
