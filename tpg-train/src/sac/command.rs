//! `tpg-train sac`: a training run in a folder of its own.
//!
//! The folder contains `config.toml` (the request), `log.jsonl` (a row for each validation), `time.json` (the
//! run's time), `checkpoint`, and, from the first validation on, `policy.safetensors`: the best candidate so far, and at
//! the end the last one.

use super::config::SacConfig;
use super::training::{BestActor, Training, interface};
use super::weights::to_tensors;
use super::{checkpoint, log};
use crate::configuration::{Chosen, Configuration as _};
use crate::evolution::command::sentence;
use crate::folder::RunFolder;
use crate::folder::frame::checksum;
use crate::interrupt;
use crate::run_args::{RunArgs, command_line};
use crate::run_time::Stopwatch;
use serde_json::Value;
use std::sync::atomic::{AtomicBool, Ordering};
use std::time::Instant;
use tpg_engine::{Environment, Summary};
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
    let Chosen { preset, config, problem } = Chosen::<SacConfig>::by(args)?;
    let name = preset.unwrap_or_else(|| name_by_content(&config));
    let stop = interrupt::watch();
    let environment = problem.network_environment(args.seed);
    SacRun::begin(args, &name, config, problem.name(), &&*environment)?.finish(&stop)
}

/// Returns the name of a configuration from a file: a hash of its content, so that the policy does not depend on where
/// the file lies.
fn name_by_content(config: &SacConfig) -> String {
    format!("SHA-256 {}", &checksum(config.to_toml())[..16])
}

struct SacRun<'a, E: Environment<f32>> {
    args: &'a RunArgs,
    environment: &'a E,
    folder: RunFolder,
    name: &'a str,
    problem: ProblemName,
    training: Training<'a, E>,
    validation: Vec<E::Task>,
    log: Vec<Value>,
    progress: Bar,
    stopwatch: Stopwatch,
}

impl<'a, E: Environment<f32>> SacRun<'a, E> {
    fn begin(
        args: &'a RunArgs,
        name: &'a str,
        config: SacConfig,
        problem: ProblemName,
        environment: &'a E,
    ) -> Result<Self, InputError> {
        let (seed, folder) = (args.seed, args.folder(problem, args.seed));
        let refused = |finding: Finding| {
            command_line(format!("--problem {}: {}", problem.name(), finding.found), finding.accepted)
        };
        interface(environment, &config).map_err(refused)?;
        let folder = RunFolder::open(&folder, args.resume)?;
        let found = folder.load(checkpoint::FORM, |file, content| {
            checkpoint::from_bytes(file, content, environment, &config, seed)
        })?;
        let (training, log) = match found {
            Some(found) => found,
            None => (Training::new(environment, config, seed).map_err(refused)?, Vec::new()),
        };
        write_atomically(&folder.file("config.toml"), training.config.to_toml().as_bytes())?;
        let validation =
            tpg_engine::tasks(environment, tpg_engine::TaskSet::Validation, 0, training.config.validation.episodes);
        let (progress, stopwatch) = (Bar::begin(), Stopwatch::new(folder.path()));
        Ok(Self { args, environment, folder, name, problem, training, validation, log, progress, stopwatch })
    }

    /// True when the run has had all of its decisions.
    fn spent(&self) -> bool {
        self.training.finished() || self.args.max_steps.is_some_and(|most| self.training.decisions >= most)
    }

    /// True when the last candidate is good enough.
    fn reached(&self) -> bool {
        self.training.last.as_ref().zip(self.args.target).is_some_and(|(result, target)| result.score >= target)
    }

    fn finish(mut self, stop: &AtomicBool) -> Result<Verdict, InputError> {
        let checkpoint_every = self.args.checkpoint_every(CHECKPOINT_SECONDS);
        let mut saved = Instant::now();
        while !self.spent() && !self.reached() {
            if self.training.tick_to_validation() || self.spent() {
                self.validate()?;
            }
            let whole = self.training.config.learning.decisions;
            let whole = self.args.max_steps.map_or(whole, |most| most.min(whole));
            self.progress.show(self.training.decisions, whole, || self.message());
            let stopped = stop.load(Ordering::Relaxed);
            if stopped || saved.elapsed() >= checkpoint_every {
                self.save()?;
                saved = Instant::now();
            }
            if stopped {
                return Ok(Verdict::Interrupted);
            }
        }
        self.save()?;
        if let Some(best) = &self.training.best {
            tpg_graph::command::note(format_args!("{}", self.sentence(best)));
        }
        Ok(Verdict::Good)
    }

    fn validate(&mut self) -> Result<(), InputError> {
        let recent = self.training.take_progress();
        let result = self.training.validate(&self.validation);
        let best = self.training.best.as_ref().expect("there was a validation");
        let contract = self.training.contract(best, self.name, self.problem.name());
        to_tensors(&best.actor, &contract).write(&self.folder.file("policy.safetensors"))?;
        self.log.push(log::row(&self.training, &recent, &result, self.environment));
        let lines = self.log.iter().map(|row| format!("{row}\n"));
        write_atomically(&self.folder.file("log.jsonl"), lines.collect::<String>().as_bytes())
    }

    fn message(&self) -> String {
        let short = |result: Option<&Summary>| result.map(short).unwrap_or_default();
        format!(
            "{}, best {}",
            short(self.training.last.as_ref()),
            short(self.training.best.as_ref().map(|best| &best.result))
        )
    }

    fn save(&self) -> Result<(), InputError> {
        self.folder.save(checkpoint::FORM, checkpoint::to_bytes(&self.training, &self.log))?;
        self.stopwatch.write(self.folder.path())
    }

    fn sentence(&self, best: &BestActor) -> String {
        let result = sentence(self.training.seed, &best.result, "validation", self.environment.measure());
        format!("{result}, after {} decisions", best.decisions)
    }
}

/// A result in a few letters, for the progress bar.
fn short(result: &Summary) -> String {
    match result.success {
        Some(success) => format!("{:.1} %", 100.0 * success),
        None => format!("{:.2}", result.score),
    }
}
