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
    /// Seconds between checkpoints [default: 30; with sac 120]
    #[arg(long, value_name = "S")]
    pub checkpoint_seconds: Option<u64>,
}

impl RunArgs {
    /// Returns the folder of the run.
    pub fn folder(&self, problem: ProblemName, seed: u64) -> PathBuf {
        let usual = || PathBuf::from("runs").join(format!("{}-{seed}", problem.name()));
        self.out.clone().unwrap_or_else(usual)
    }

    /// The time between checkpoints; `usual` seconds where none is asked for.
    pub fn checkpoint_every(&self, usual: u64) -> Duration {
        Duration::from_secs(self.checkpoint_seconds.unwrap_or(usual))
    }
}

/// Creates an error about the command line.
pub fn command_line(found: impl Into<String>, accepted: impl Into<String>) -> InputError {
    InputError::new("<command line>", Place::Whole, found, accepted)
}
