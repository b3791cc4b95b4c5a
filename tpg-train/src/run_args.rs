//! Arguments common to all training commands.

use clap::Args;
use std::path::PathBuf;
use std::time::Duration;
use tpg_graph::error::{InputError, Place};
use tpg_problems::ProblemName;

/// The arguments of a run.
#[derive(Clone, Debug, Args)]
pub struct RunArgs {
    /// A configuration file (`tpg-train config` prints commented ones)
    #[arg(long, value_name = "FILE", conflicts_with = "preset")]
    pub config: Option<PathBuf>,
    /// A configuration included with the trainer, instead of the problem's default one
    #[arg(long, value_name = "NAME")]
    pub preset: Option<String>,
    /// The folder of the run [default: runs/PROBLEM-SEED]
    #[arg(long, value_name = "RUN")]
    pub out: Option<PathBuf>,
    /// Continue from the folder's checkpoint
    #[arg(long)]
    pub resume: bool,
    /// Seconds between checkpoints
    #[arg(long, value_name = "S", default_value_t = 30)]
    pub checkpoint_seconds: u64,
}

impl RunArgs {
    /// Returns the folder of the run.
    pub fn folder(&self, problem: ProblemName, seed: u64) -> PathBuf {
        let usual = || PathBuf::from("runs").join(format!("{}-{seed}", problem.name()));
        self.out.clone().unwrap_or_else(usual)
    }

    /// Returns the time between checkpoints.
    pub fn checkpoint_every(&self) -> Duration {
        Duration::from_secs(self.checkpoint_seconds)
    }
}

/// Creates an error about the command line.
pub fn command_line(found: impl Into<String>, accepted: impl Into<String>) -> InputError {
    InputError::new("<command line>", Place::Whole, found, accepted)
}
