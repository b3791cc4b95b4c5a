//! `tpg-train targets`: committed test tasks of a problem.

use crate::evaluate::problem_for;
use crate::run_args::{command_line, print};
use std::path::PathBuf;
use tpg_graph::error::InputError;
use tpg_problems::ProblemName;

/// Print a set of test tasks as CSV.
///
/// `tpg-train targets --problem fs > generated/test-targets/fs.csv` recreates the committed file; those of `dodge` come with
/// the plans that solve them.
#[derive(Clone, Debug, clap::Args)]
pub(crate) struct TargetsArgs {
    /// The problem: fs, rs or dodge
    #[arg(long, value_enum)]
    pub problem: ProblemName,
    /// The problem's settings of this configuration, such as another arm
    #[arg(long, value_name = "FILE")]
    pub config: Option<PathBuf>,
    /// The number of tasks
    #[arg(long, value_name = "N", default_value_t = 1000)]
    pub episodes: usize,
    /// The seed [default: that of the committed file]
    #[arg(long, value_name = "S")]
    pub seed: Option<u64>,
}

/// Prints test tasks.
///
/// # Errors
/// If the problem has no such tasks, the configuration cannot be read, or stdout is closed.
pub(crate) fn print_targets(args: &TargetsArgs) -> Result<(), InputError> {
    let problem = problem_for(args.problem, args.config.as_deref(), &[], &[])?;
    let text = problem.print_tasks(args.seed, args.episodes).ok_or_else(|| {
        let found = format!("--problem {}", args.problem.name());
        command_line(found, "fs, rs or dodge: the problems with committed test tasks")
    })?;
    print(&text)
}
