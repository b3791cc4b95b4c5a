//! `tpg-train sac`: a training run in a folder of its own.
//!
//! The folder contains `config.toml` (the request), `log.jsonl` (a row for each validation), `time.json` (the
//! run's time), `checkpoint`, and, from the first validation on, `policy.safetensors`: the best candidate so far, and at
//! the end the last one.

use super::checkpoint;
use super::config::SacConfig;
use super::training::{Training, interface};
use super::weights::to_tensors;
use crate::configuration::{Chosen, Configuration as _};
use crate::evolution::command::sentence;
use crate::folder::RunFolder;
use crate::folder::frame::checksum;
use crate::interrupt;
use crate::run_args::{RunArgs, command_line};
use crate::run_time::Stopwatch;
use serde_json::{Value, json};
use std::sync::atomic::{AtomicBool, Ordering};
use std::time::Instant;
use tpg_engine::{Environment, Summary, TaskSet, tasks};
use tpg_graph::command::Verdict;
use tpg_graph::error::{Finding, InputError};
use tpg_graph::files::write_atomically;
use tpg_graph::progress::Bar;
use tpg_problems::ProblemName;

/// Seconds between checkpoints: those of a large replay buffer take a while.
const CHECKPOINT_SECONDS: u64 = 120;

/// Trains.
///
/// # Errors
/// A bad configuration, a problem without outputs, a folder with another run, files that cannot be written.
pub(crate) fn execute(args: &RunArgs) -> Result<Verdict, InputError> {
    let Chosen { preset, config, problem, .. } = Chosen::<SacConfig>::by(args)?;
    let name = preset.unwrap_or_else(|| name_by_content(&config));
    let stop = interrupt::watch();
    let environment = problem.network_environment(args.seed);
    train(args, &name, config, problem.name(), &&*environment, &stop)
}

/// Returns the name of a configuration from a file: a hash of its content, so that the policy does not depend on where
/// the file lies.
fn name_by_content(config: &SacConfig) -> String {
    format!("SHA-256 {}", &checksum(config.to_toml())[..16])
}

/// Trains in the folder of the run.
fn train<E: Environment<f32>>(
    args: &RunArgs,
    name: &str,
    config: SacConfig,
    problem: ProblemName,
    environment: &E,
    stop: &AtomicBool,
) -> Result<Verdict, InputError> {
    let seed = args.seed;
    let refused =
        |finding: Finding| command_line(format!("--problem {}: {}", problem.name(), finding.found), finding.accepted);
    interface(environment, &config).map_err(refused)?;
    let folder = RunFolder::open(&args.folder(problem, seed), args.resume)?;
    let read = |file: &str, content: &[u8]| checkpoint::from_bytes(file, content, environment, &config, seed);
    let (mut training, mut log) = match folder.load(checkpoint::FORM, read)? {
        Some(found) => found,
        None => (Training::new(environment, config, seed).map_err(refused)?, Vec::new()),
    };
    write_atomically(&folder.file("config.toml"), training.config.to_toml().as_bytes())?;
    let validation = tasks(environment, TaskSet::Validation, 0, training.config.validation.episodes);
    let (progress, stopwatch) = (Bar::begin(), Stopwatch::new(folder.path()));
    let save = |training: &Training<'_, E>, log: &[Value]| {
        folder.save(checkpoint::FORM, checkpoint::to_bytes(training, log))?;
        stopwatch.write(folder.path())
    };
    let most = args.max_steps.unwrap_or(u64::MAX).min(training.config.learning.decisions);
    let mut saved = Instant::now();
    let reached = |last: &Summary| args.target.is_some_and(|target| last.score >= target);
    while training.decisions < most && !training.last.as_ref().is_some_and(reached) {
        if training.tick_to_validation() || training.decisions >= most {
            let recent = std::mem::take(&mut training.recent);
            let result = training.validate(&validation);
            let best = training.best.as_ref().expect("there was a validation");
            let contract = training.contract(best, name, problem.name());
            to_tensors(&best.actor, &contract).write(&folder.file("policy.safetensors"))?;
            let mean = |sum: f64| sum / recent.updates.max(1) as f64;
            let mut row = json!({
                "decisions": training.decisions,
                "critic_loss": mean(recent.sums.critic_loss),
                "actor_loss": mean(recent.sums.actor_loss),
                "entropy": mean(recent.sums.entropy),
                "temperature": mean(recent.sums.temperature),
                "score": result.score,
            });
            if let Some(success) = result.success {
                row["success"] = json!(success);
            }
            if environment.measure().is_some() {
                row["measure"] = json!(result.measure);
            }
            log.push(row);
            let lines = log.iter().map(|row| format!("{row}\n"));
            write_atomically(&folder.file("log.jsonl"), lines.collect::<String>().as_bytes())?;
        }
        let scores = training.last.zip(training.best.as_ref().map(|best| best.result.score));
        let message = |(last, best): (Summary, f64)| format!("{:.2}, best {best:.2}", last.score);
        progress.show(training.decisions, most, || scores.map(message).unwrap_or_default());
        let stopped = stop.load(Ordering::Relaxed);
        if stopped || saved.elapsed() >= args.checkpoint_every(CHECKPOINT_SECONDS) {
            save(&training, &log)?;
            saved = Instant::now();
        }
        if stopped {
            return Ok(Verdict::Interrupted);
        }
    }
    save(&training, &log)?;
    if let Some(best) = &training.best {
        let result = sentence(seed, &best.result, environment.measure());
        tpg_graph::command::note(format_args!("{result}, after {} decisions", best.decisions));
    }
    Ok(Verdict::Good)
}
