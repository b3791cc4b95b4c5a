//! Arguments common to all training commands.

use clap::Args;
use std::path::{Path, PathBuf};
use std::time::Duration;
use tpg_graph::error::{Finding, InputError, Place};
use tpg_problems::ProblemName;

/// The arguments of a run.
#[derive(Clone, Debug, Args)]
pub struct RunArgs {
    /// The problem; `tpg-train problems` lists them. A configuration file can name it instead
    #[arg(long, value_enum)]
    pub problem: Option<ProblemName>,
    /// A configuration included with the trainer, instead of the problem's default one; `tpg-train config --list` names them
    #[arg(long, value_name = "NAME")]
    pub preset: Option<String>,
    /// A file of settings that differ from the preset's; tpg reads GEGELATI's params.json, too, for the preset gegelati
    #[arg(long, visible_alias = "params", value_name = "FILE")]
    pub config: Option<PathBuf>,
    /// A setting that differs from these, such as tpg.nb_roots=100; may be repeated
    #[arg(long, value_name = "KEY=VALUE")]
    pub set: Vec<String>,
    /// The folder of the run [default: runs/PROBLEM-SEED]
    #[arg(long, value_name = "RUN")]
    pub out: Option<PathBuf>,
    /// The seed
    #[arg(long, value_name = "S", default_value_t = 1)]
    pub seed: u64,
    /// End the run when a policy reaches this mean return on the validation episodes
    #[arg(long, value_name = "SCORE", allow_negative_numbers = true)]
    pub target: Option<f64>,
    /// End the run after N steps: of tpg after the generation in which all episodes together have N actions, of sac after N
    /// decisions, with the learning rates of the full run
    #[arg(long, value_name = "N", value_parser = clap::value_parser!(u64).range(1..))]
    pub max_steps: Option<u64>,
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
        self.out.clone().unwrap_or_else(|| PathBuf::from("runs").join(format!("{}-{seed}", problem.name())))
    }

    /// Returns the time between checkpoints; `default` seconds where none is asked for.
    pub fn checkpoint_every(&self, default: u64) -> Duration {
        Duration::from_secs(self.checkpoint_seconds.unwrap_or(default))
    }
}

/// Creates an error about the command line.
pub(crate) fn command_line(found: impl Into<String>, accepted: impl Into<String>) -> InputError {
    InputError::new("<command line>", Place::Whole, found, accepted)
}

/// Places a finding in its file.
pub(crate) fn place(path: &Path, Finding { key, found, accepted }: Finding) -> InputError {
    let place = if key.is_empty() { Place::Whole } else { Place::Path(key) };
    InputError::new(path.display().to_string(), place, found, accepted)
}
