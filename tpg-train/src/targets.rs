//! `tpg-train targets`: the arm's committed test tasks.

use crate::evaluate::arm::arm_config;
use std::path::PathBuf;
use tpg_arm::WIDOWX;
use tpg_graph::error::InputError;
use tpg_problems::arm::targets::{Set, Start, TEST_SEED, tasks, to_csv};

/// Print a set of test tasks as CSV.
///
/// `tpg-train targets --problem fs > generated/test-targets/fs.csv` recreates the committed file.
#[derive(Clone, Debug, clap::Args)]
pub struct TargetsArgs {
    /// The problem: fixed or random start
    #[arg(long, value_enum)]
    pub problem: Start,
    /// The arm of this configuration, instead of the WidowX
    #[arg(long, value_name = "FILE")]
    pub config: Option<PathBuf>,
    /// The number of tasks
    #[arg(long, value_name = "N", default_value_t = 1000)]
    pub episodes: usize,
    /// The seed
    #[arg(long, value_name = "S", default_value_t = TEST_SEED)]
    pub seed: u64,
}

/// Prints test tasks.
///
/// # Errors
/// If the configuration cannot be read, or stdout is closed.
pub fn print_targets(args: &TargetsArgs) -> Result<(), InputError> {
    let arm = args
        .config
        .as_deref()
        .map(|path| arm_config(path, args.problem))
        .transpose()?
        .map_or(WIDOWX, |config| config.arm());
    let text = to_csv(&tasks(&arm, args.seed, Set::Test, args.problem, args.episodes));
    let written = tpg_graph::command::print(&text);
    written.map_err(|error| InputError::io("<stdout>".as_ref(), &error, "an open pipe"))
}
