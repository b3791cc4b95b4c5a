//! `tpg-train sac`: a training run in a folder of its own.
//!
//! The folder contains `config.toml` (the request), `log.csv` and `log.jsonl` (a row for each validation), `time.json` (the
//! run's time), `checkpoint`, and, from the first validation on, `policy.safetensors`: the best candidate so far, and at
//! the end the last one.

use super::config::SacConfig;
use super::contract::{Contract, Provenance};
use super::training::{Best, Training, interface};
use super::weights::to_tensors;
use super::{checkpoint, log, presets};
use crate::configuration::{Chosen, Configuration};
use crate::evolution::generation::Goal;
use crate::files::write_atomically;
use crate::folder::{RunFolder, Trainer};
use crate::interrupt;
use crate::run_args::{RunArgs, command_line};
use clap::Args;
use indicatif::{ProgressBar, ProgressStyle};
use serde_json::Value;
use sha2::{Digest as _, Sha256};
use std::sync::atomic::{AtomicBool, Ordering};
use std::time::{Duration, Instant};
use tpg_engine::{Environment, Summary};
use tpg_graph::command::Verdict;
use tpg_graph::error::{Finding, InputError};
use tpg_problems::{ContinuousProblem, ProblemName};

/// Seconds between checkpoints: those of a large replay buffer take a while.
const CHECKPOINT_SECONDS: u64 = 120;

/// Train a soft actor-critic.
#[derive(Clone, Debug, Args)]
pub struct SacArgs {
    /// The problem; `tpg-train problems` tells more. A configuration file can name it instead
    #[arg(long, value_enum)]
    pub problem: Option<ProblemName>,
    /// The arguments of every run.
    #[command(flatten)]
    pub run: RunArgs,
    /// The seed
    #[arg(long, value_name = "S", default_value_t = 1)]
    pub seed: u64,
    /// Decisions, instead of the configuration's
    #[arg(long, value_name = "N", value_parser = clap::value_parser!(u64).range(1..))]
    pub decisions: Option<u64>,
    /// End the run when a candidate has this mean score on the validation episodes
    #[arg(long, value_name = "SCORE", allow_negative_numbers = true)]
    pub target: Option<f64>,
    /// End the run after so many decisions, at the rates of the whole run
    #[arg(long, value_name = "N", value_parser = clap::value_parser!(u64).range(1..))]
    pub max_steps: Option<u64>,
}

/// Trains.
///
/// # Errors
/// A bad configuration, a problem without outputs, a folder with another run, files that cannot be written.
pub fn execute(args: &SacArgs) -> Result<Verdict, InputError> {
    let Chosen { preset, mut config, problem } = Chosen::<SacConfig>::by(&args.run, args.problem)?;
    if let Some(decisions) = args.decisions {
        config.learning.decisions = decisions;
    }
    let name = preset.map_or_else(|| name_by_content(&config), str::to_owned);
    let stop = interrupt::watch();
    let command = Command { args, name: &name, config, problem: problem.name() };
    let environment = problem.environment(args.seed);
    Run::begin(command, &&*environment)?.finish(&stop)
}

impl Configuration for SacConfig {
    type Problem = ContinuousProblem;
    const PRINTED_BY: &'static str = "tpg-train config --sac";

    fn presets() -> Vec<&'static str> {
        presets::PRESETS.iter().map(|preset| preset.name).collect()
    }
    fn preset(name: &str) -> Option<toml::Table> {
        presets::find(name).map(presets::Preset::table)
    }
    fn default_preset(problem: ProblemName) -> &'static str {
        presets::default_for(problem)
    }
    fn from_toml(file: &str, text: &str) -> Result<Self, InputError> {
        Self::from_toml(file, text)
    }
    fn problem(&mut self) -> &mut toml::Table {
        &mut self.problem
    }
}

/// Returns the name of a configuration from a file: a hash of its content, so that the policy does not depend on where
/// the file lies.
fn name_by_content(config: &SacConfig) -> String {
    let hash = Sha256::digest(config.to_toml());
    hash.iter().take(8).fold("SHA-256 ".to_owned(), |text, byte| format!("{text}{byte:02x}"))
}

/// The request.
struct Command<'a> {
    args: &'a SacArgs,
    name: &'a str,
    config: SacConfig,
    problem: ProblemName,
}

struct Run<'a, E: Environment<f32>> {
    environment: &'a E,
    folder: RunFolder,
    name: &'a str,
    problem: ProblemName,
    seed: u64,
    goal: Goal,
    checkpoint_every: Duration,
    training: Training<'a, E>,
    validation: Vec<E::Task>,
    log: Vec<Value>,
    progress: ProgressBar,
    began: Instant,
}

impl<'a, E: Environment<f32>> Run<'a, E> {
    fn begin(command: Command<'a>, environment: &'a E) -> Result<Self, InputError> {
        let Command { args, name, config, problem } = command;
        let (seed, folder) = (args.seed, args.run.folder(problem, args.seed));
        let refused = |finding: Finding| {
            command_line(format!("--problem {}: {}", problem.name(), finding.found), finding.accepted)
        };
        interface(environment, &config).map_err(refused)?;
        let folder = RunFolder::open(&folder, Trainer::Sac, args.run.resume)?;
        let found = folder.load(checkpoint::VERSION, |file, content| {
            checkpoint::from_bytes(file, content, environment, &config, seed)
        })?;
        let (training, log) = match found {
            Some(found) => found,
            None => (Training::new(environment, config, seed).map_err(refused)?, Vec::new()),
        };
        write_atomically(&folder.file("config.toml"), training.config().to_toml().as_bytes())?;
        let goal = Goal { target: args.target, max_steps: args.max_steps };
        let whole = training.config().learning.decisions;
        let progress = crate::progress::bar(goal.max_steps.map_or(whole, |most| most.min(whole)));
        let style = ProgressStyle::with_template("{bar:30} {percent:>3} %  {eta} left  {msg}");
        progress.set_style(style.unwrap_or_else(|_| ProgressStyle::default_bar()));
        progress.set_position(training.decisions());
        let validation =
            tpg_engine::tasks(environment, tpg_engine::TaskSet::Validation, 0, training.config().validation.episodes);
        let checkpoint_every = args.run.checkpoint_every(CHECKPOINT_SECONDS);
        let began = Instant::now();
        Ok(Self {
            environment,
            folder,
            name,
            problem,
            seed,
            goal,
            checkpoint_every,
            training,
            validation,
            log,
            progress,
            began,
        })
    }

    /// True when the run has had all of its decisions.
    fn spent(&self) -> bool {
        self.training.finished() || self.goal.max_steps.is_some_and(|most| self.training.decisions() >= most)
    }

    /// True when the last candidate is good enough.
    fn reached(&self) -> bool {
        self.training.last().zip(self.goal.target).is_some_and(|(result, target)| result.score >= target)
    }

    fn finish(mut self, stop: &AtomicBool) -> Result<Verdict, InputError> {
        let every = self.training.config().validation.every;
        let mut saved = Instant::now();
        while !self.spent() && !self.reached() {
            let before = self.training.decisions() / every;
            self.training.tick();
            if self.training.decisions() / every > before || self.spent() {
                self.validate()?;
            }
            self.progress.set_position(self.training.decisions());
            let stopped = stop.load(Ordering::Relaxed);
            if stopped || saved.elapsed() >= self.checkpoint_every {
                self.save()?;
                saved = Instant::now();
            }
            if stopped {
                return Ok(Verdict::Interrupted);
            }
        }
        self.save()?;
        self.progress.finish();
        let end = match (self.training.best(), self.training.flat()) {
            (None, _) => return Ok(Verdict::Good),
            (Some(best), true) => format!("{}; the curve was flat", self.sentence(best)),
            (Some(best), false) => self.sentence(best),
        };
        tpg_graph::command::note(format_args!("{end}"));
        Ok(Verdict::Good)
    }

    fn validate(&mut self) -> Result<(), InputError> {
        let recent = self.training.take_progress();
        let result = self.training.validate(&self.validation);
        let best = self.training.best().expect("there was a validation");
        self.progress.set_message(format!("{}, best {}", short(&result), short(&best.result)));
        let provenance = Provenance {
            tool: concat!("tpg-train ", env!("CARGO_PKG_VERSION")).to_owned(),
            config: self.name.to_owned(),
            problem: self.problem.name().to_owned(),
            seed: self.seed,
            decisions: best.decisions,
            validation: Some(best.result),
        };
        let config = self.training.config();
        let (interface, actor) = (self.training.interface(), config.actor.clone());
        let contract = Contract::new(config.problem.clone(), interface, actor, provenance);
        to_tensors(&best.actor, &contract).write(&self.folder.file("policy.safetensors"))?;
        self.log.push(log::row(&self.training, &recent, &result, self.environment));
        log::write(self.folder.path(), &self.log, self.began)
    }

    fn save(&self) -> Result<(), InputError> {
        self.folder.save(checkpoint::VERSION, checkpoint::to_bytes(&self.training, &self.log))
    }

    fn sentence(&self, best: &Best) -> String {
        let Summary { score, success, measure, episodes, .. } = best.result;
        let success = success.map(|success| format!(", {:.1} % solved", 100.0 * success)).unwrap_or_default();
        let measure = self
            .environment
            .measure()
            .map(|of| format!(", mean {} {measure:.1} {}", of.name, of.unit))
            .unwrap_or_default();
        format!(
            "seed {}: mean score {score:.2} on {episodes} validation episodes{success}{measure}, after {} decisions",
            self.seed, best.decisions
        )
    }
}

/// A result in a few letters, for the progress bar.
fn short(result: &Summary) -> String {
    match result.success {
        Some(success) => format!("{:.1} %", 100.0 * success),
        None => format!("{:.2}", result.score),
    }
}
