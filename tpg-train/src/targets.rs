//! `tpg-train targets`: the arm's committed test tasks.

use crate::arm_of;
use crate::evaluate::graph_problem;
use crate::run_args::command_line;
use std::path::PathBuf;
use tpg_arm::WIDOWX;
use tpg_graph::error::InputError;
use tpg_problems::arm::targets::{Set, Start, TEST_SEED, tasks, to_csv};
use tpg_problems::{Problem, ProblemName, dodge};

/// Print a set of test tasks as CSV.
///
/// `tpg-train targets --problem fs > generated/test-targets/fs.csv` recreates the committed file; those of `dodge` come with
/// the plans that solve them.
#[derive(Clone, Debug, clap::Args)]
pub struct TargetsArgs {
    /// The problem: fs, rs or dodge
    #[arg(long, value_enum)]
    pub problem: ProblemName,
    /// The arm of this configuration, instead of the WidowX; for dodge, its settings
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
pub fn print_targets(args: &TargetsArgs) -> Result<(), InputError> {
    let text = match args.problem.start() {
        Some(start) => reach(args, start)?,
        None => among_balls(args)?,
    };
    let written = tpg_graph::command::print(&text);
    written.map_err(|error| InputError::io("<stdout>".as_ref(), &error, "an open pipe"))
}

fn reach(args: &TargetsArgs, start: Start) -> Result<String, InputError> {
    let config = args.config.as_deref().map(|path| arm_of::config(path, start)).transpose()?;
    let arm = config.map_or(WIDOWX, |config| config.arm());
    Ok(to_csv(&tasks(&arm, args.seed.unwrap_or(TEST_SEED), Set::Test, start, args.episodes)))
}

fn among_balls(args: &TargetsArgs) -> Result<String, InputError> {
    let Problem::Dodge(config) = graph_problem(args.problem, args.config.as_deref())? else {
        let found = format!("--problem {}", args.problem.name());
        return Err(command_line(found, "fs, rs or dodge: the problems with committed test tasks"));
    };
    let seed = args.seed.unwrap_or(dodge::draw::SEED);
    let scenes = dodge::draw::scenes(&config, seed, Set::Test, args.episodes, dodge::draw::TEST_TRIES);
    Ok(dodge::file::to_csv(&scenes))
}
