//! `tpg-train sac`: a training run in a directory.

use super::config::Config;
use super::training::{Training, ValidationTasks};
use crate::targets::Start;
use clap::Args;
use std::path::PathBuf;

/// Train a soft actor-critic.
#[derive(Debug, Args)]
pub struct SacArgs {
    /// The problem that the best candidate is chosen on.
    #[arg(long)]
    pub problem: Start,
    /// A preset's name or a TOML file. Default: best-fs or best-rs.
    #[arg(long)]
    pub config: Option<String>,
    /// The run's directory.
    #[arg(long)]
    pub out: PathBuf,
    /// The seed.
    #[arg(long, default_value_t = 1)]
    pub seed: u64,
}

/// Runs.
pub fn run(args: SacArgs) {
    let name = args.config.unwrap_or_else(|| "best-rs".into());
    let config =
        Config::preset(&name).unwrap_or_else(|| toml::from_str(&std::fs::read_to_string(&name).unwrap()).unwrap());
    let validation = ValidationTasks::new(args.seed, args.problem, config.validation.episodes);
    let every = config.validation.every;
    let mut training = Training::new(config, args.seed);
    let began = std::time::Instant::now();
    let mut next = every;
    while !training.finished() {
        training.tick();
        if training.decisions() >= next {
            next += every;
            let r = training.take_progress();
            let t = began.elapsed().as_secs_f64();
            let trials = training.validate(&validation);
            let m = r.means();
            println!(
                "{:.0}s d {} u {} steps {} reached {} invalid {} cut {} | closs {:.3} ent {:.2} alpha {:.4} | FS {:.4} RS {:.4} {:?} {:?} ({:.1}s)",
                t,
                training.decisions(),
                training.updates(),
                r.steps,
                r.reached,
                r.invalid,
                r.cut,
                m.critic_loss,
                m.entropy,
                m.temperature,
                trials[0].success_rate,
                trials[1].success_rate,
                trials[0].failures,
                trials[1].failures,
                began.elapsed().as_secs_f64() - t
            );
        }
    }
}
