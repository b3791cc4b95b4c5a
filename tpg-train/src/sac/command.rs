//! `tpg-train sac`: a training run in a folder of its own.
//!
//! The folder holds `config.toml` (what was asked for), `log.csv` and `log.jsonl` (a row for each validation, without a
//! clock: equal runs have equal logs), `time.json` (what it cost), `checkpoint.safetensors`, and, from the first
//! validation on, `policy.safetensors`: the best candidate so far, and at the end the last one.

use super::checkpoint;
use super::config::{Config, PRESETS};
use super::training::{Recent, Training, ValidationTasks};
use super::weights::{Provenance, to_tensors};
use crate::evolution::logs::cpu_seconds;
use crate::files::{make_folder, read_text, write_atomically};
use crate::interrupt;
use clap::Args;
use indicatif::{ProgressBar, ProgressStyle};
use serde_json::{Value, json};
use std::path::{Path, PathBuf};
use std::sync::atomic::{AtomicBool, Ordering};
use std::time::{Duration, Instant};
use tpg_graph::command::Verdict;
use tpg_graph::error::{InputError, Place};
use tpg_problems::arm::targets::Start;
use tpg_problems::arm::trial::Trial;

/// Train a soft actor-critic.
#[derive(Clone, Debug, Args)]
pub struct SacArgs {
    /// The problem on which the best candidate is chosen: fixed or random start
    #[arg(long, value_enum)]
    pub problem: Start,
    /// A configuration file (a preset's text is one)
    #[arg(long, value_name = "FILE", conflicts_with = "preset")]
    pub config: Option<PathBuf>,
    /// A configuration that comes with the trainer. Default: best-fs or best-rs
    #[arg(long, value_name = "NAME")]
    pub preset: Option<String>,
    /// The folder of the run
    #[arg(long, value_name = "RUN")]
    pub out: PathBuf,
    /// Go on where the folder's checkpoint is
    #[arg(long)]
    pub resume: bool,
    /// The seed
    #[arg(long, value_name = "S", default_value_t = 1)]
    pub seed: u64,
    /// Decisions, instead of the configuration's
    #[arg(long, value_name = "N", value_parser = clap::value_parser!(u64).range(1..))]
    pub decisions: Option<u64>,
    /// Seconds between checkpoints
    #[arg(long, value_name = "S", default_value_t = 120)]
    pub checkpoint_seconds: u64,
}

/// Trains.
///
/// # Errors
/// A bad configuration, a folder with another run, files that cannot be written.
pub fn execute(args: &SacArgs) -> Result<Verdict, InputError> {
    let (name, config) = configuration(args)?;
    let stop = interrupt::watch();
    Run::begin(args, name, config)?.finish(&stop)
}

fn configuration(args: &SacArgs) -> Result<(String, Config), InputError> {
    let (name, text) = match (&args.config, &args.preset) {
        (Some(path), _) => (path.display().to_string(), read_text(path, "a configuration of `tpg-train sac`")?),
        (None, preset) => {
            let default = if args.problem == Start::Fs { "best-fs" } else { "best-rs" };
            let name = preset.as_deref().unwrap_or(default);
            let Some((_, text)) = PRESETS.iter().find(|(preset, _)| *preset == name) else {
                let accepted = PRESETS.map(|(name, _)| name).join(", ");
                return Err(InputError::new("<command line>", Place::Whole, format!("the preset {name:?}"), accepted));
            };
            (name.to_owned(), (*text).to_owned())
        }
    };
    let mut config: Config = toml::from_str(&text).map_err(|error| {
        let line = error.span().map_or(0, |span| text[..span.start].lines().count().max(1));
        InputError::new(&name, Place::Line(line), error.message(), "the keys and values of a preset")
    })?;
    config.check().map_err(|wrong| InputError::new(&name, Place::Whole, wrong, "values that can work"))?;
    if let Some(decisions) = args.decisions {
        config.learning.decisions = decisions;
    }
    Ok((name, config))
}

struct Run<'a> {
    args: &'a SacArgs,
    name: String,
    training: Training,
    validation: ValidationTasks,
    log: Vec<Value>,
    progress: ProgressBar,
    began: Instant,
}

impl<'a> Run<'a> {
    fn begin(args: &'a SacArgs, name: String, config: Config) -> Result<Self, InputError> {
        let path = args.out.join("checkpoint.safetensors");
        let validation = ValidationTasks::new(args.seed, args.problem, config.validation.episodes);
        let (training, log) = if args.resume && path.exists() {
            checkpoint::load(&path, &config, args.seed)?
        } else if args.out.join("config.toml").exists() && !args.resume {
            let accepted = "an empty folder, or --resume";
            return Err(InputError::new(args.out.display().to_string(), Place::Whole, "a run", accepted));
        } else {
            (Training::new(config, args.seed), Vec::new())
        };
        make_folder(&args.out)?;
        let text = toml::to_string(training.config()).expect("plain data");
        write_atomically(&args.out.join("config.toml"), text.as_bytes())?;
        let progress = ProgressBar::new(training.config().learning.decisions);
        let style = ProgressStyle::with_template("{bar:30} {percent:>3} %  {eta} left  {msg}");
        progress.set_style(style.expect("a template that is right"));
        progress.set_position(training.decisions());
        Ok(Self { args, name, training, validation, log, progress, began: Instant::now() })
    }

    fn finish(mut self, stop: &AtomicBool) -> Result<Verdict, InputError> {
        let every = self.training.config().validation.every;
        let mut saved = Instant::now();
        while !self.training.finished() {
            let before = self.training.decisions() / every;
            self.training.tick();
            if self.training.decisions() / every > before || self.training.finished() {
                self.validate()?;
            }
            self.progress.set_position(self.training.decisions());
            let stopped = stop.load(Ordering::Relaxed);
            if stopped || saved.elapsed() > Duration::from_secs(self.args.checkpoint_seconds) {
                self.save()?;
                saved = Instant::now();
            }
            if stopped {
                return Ok(Verdict::Interrupted);
            }
        }
        self.save()?;
        self.progress.finish();
        let best = self.training.best().map_or(0.0, |best| best.score);
        let end = match self.training.flat() {
            true => format!("; the curve was flat after {} decisions", self.training.decisions()),
            false => String::new(),
        };
        eprintln!("seed {}: {:.1} % of the validation episodes{end}", self.args.seed, 100.0 * best);
        Ok(Verdict::Good)
    }

    fn validate(&mut self) -> Result<(), InputError> {
        let recent = self.training.take_progress();
        let trials = self.training.validate(&self.validation);
        let best = self.training.best().expect("there was a validation");
        self.progress.set_message(format!(
            "fs {:.1} % rs {:.1} %, best {:.1} %",
            100.0 * trials[0].success_rate,
            100.0 * trials[1].success_rate,
            100.0 * best.score
        ));
        let provenance = Provenance {
            tool: concat!("tpg-train ", env!("CARGO_PKG_VERSION")).to_owned(),
            config: self.name.clone(),
            problem: name(self.args.problem).to_owned(),
            seed: self.args.seed,
            decisions: best.decisions,
            validation_success: best.score,
        };
        let policy = to_tensors(&best.actor, &self.training.config().actor, provenance);
        policy.write(&self.args.out.join("policy.safetensors"))?;
        self.log.push(row(&self.training, &recent, &trials));
        self.write_logs()
    }

    fn write_logs(&self) -> Result<(), InputError> {
        let lines = self.log.iter().map(|row| format!("{row}\n"));
        write_atomically(&self.args.out.join("log.jsonl"), lines.collect::<String>().as_bytes())?;
        write_atomically(&self.args.out.join("log.csv"), csv(&self.log).as_bytes())?;
        let time =
            json!({ "cpu_seconds_of_this_process": cpu_seconds(), "seconds": self.began.elapsed().as_secs_f64() });
        write_atomically(&self.args.out.join("time.json"), format!("{time}\n").as_bytes())
    }

    fn save(&self) -> Result<(), InputError> {
        checkpoint::save(&checkpoint_path(&self.args.out), &self.training, &self.log)
    }
}

fn checkpoint_path(folder: &Path) -> PathBuf {
    folder.join("checkpoint.safetensors")
}

fn name(problem: Start) -> &'static str {
    match problem {
        Start::Fs => "fs",
        Start::Rs => "rs",
    }
}

fn row(training: &Training, recent: &Recent, trials: &[Trial]) -> Value {
    let means = recent.means();
    let mut row = json!({
        "decisions": training.decisions(),
        "updates": training.updates(),
        "steps": recent.steps,
        "reached": recent.reached,
        "invalid": recent.invalid,
        "cut": recent.cut,
        "critic_loss": means.critic_loss,
        "actor_loss": means.actor_loss,
        "entropy": means.entropy,
        "temperature": means.temperature,
    });
    for trial in trials {
        let start = name(trial.problem);
        let failures = &trial.failures;
        for (key, value) in [
            ("success", trial.success_rate),
            ("collision", trial.collision_rate),
            ("distance_mm", trial.mean_distance_mm),
            ("cycle", failures.cycle as f64),
            ("timeout", failures.timeout as f64),
        ] {
            row[format!("{start}_{key}")] = json!(value);
        }
    }
    row
}

/// The rows as CSV. serde_json keeps an object's keys sorted: the columns are in the order of the alphabet.
fn csv(rows: &[Value]) -> String {
    let objects: Vec<_> = rows.iter().filter_map(Value::as_object).collect();
    let line = |cells: Vec<String>| cells.join(",") + "\n";
    let header = objects.first().map(|row| line(row.keys().cloned().collect()));
    let body = objects.iter().map(|row| line(row.values().map(Value::to_string).collect()));
    header.into_iter().chain(body).collect()
}
