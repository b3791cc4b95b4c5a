//! The command line of `tpg-paper`: results on stdout, everything else on stderr.

use crate::conformance::ConformanceArgs;
use crate::table::{Table2Args, execute as execute_table2};
use clap::{Parser, Subcommand};
use std::process::ExitCode;
use tpg_graph::command::{CommandError, Verdict, exit_code};

/// Compares the paper's policies with this project's.
///
/// Exit status: 0 good, 1 a check failed, 2 bad input.
#[derive(Debug, Parser)]
#[command(version)]
pub struct Cli {
    #[command(subcommand)]
    command: PaperCommand,
}

#[derive(Debug, Subcommand)]
enum PaperCommand {
    /// Make the folder of recorded data from a clone of the paper's artifact, gegelati/ECTA24
    Conformance(ConformanceArgs),
    /// Measure every kind of policy and write docs/results.md
    Table2(Table2Args),
}

impl Cli {
    /// Runs the command; errors go to stderr.
    pub fn run(self) -> ExitCode {
        exit_code(match self.command {
            PaperCommand::Conformance(args) => args.run(),
            PaperCommand::Table2(args) => execute_table2(&args).map(|()| Verdict::Good).map_err(CommandError::from),
        })
    }
}
