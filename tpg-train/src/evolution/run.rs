//! A whole run: generations, checkpoints, logs, progress, and the best graph at the end.

use super::checkpoint;
use super::config::Config;
use super::export;
use super::generation::Evolution;
use super::logs;
use super::state::{Best, State};
use crate::files::{make_folder, remove_unfinished, write_atomically};
use indicatif::{ProgressBar, ProgressStyle};
use std::collections::BTreeMap;
use std::fmt::Write as _;
use std::path::{Path, PathBuf};
use std::sync::atomic::{AtomicBool, Ordering};
use std::time::{Duration, Instant};
use tpg_engine::{Environment, EvaluationError, Evaluator};
use tpg_graph::error::{InputError, Place};
use tpg_graph::{Graph, Provenance};
use tpg_runtime::ops::Maths;
use tpg_runtime::scalar::Scalar;

/// How a run is done; none of it changes what comes out.
#[derive(Clone, Debug)]
pub struct RunOptions {
    /// The run's own folder.
    pub folder: PathBuf,
    /// Go on from the folder's checkpoint, where there is one.
    pub resume: bool,
    /// Time between checkpoints.
    pub checkpoint_every: Duration,
}

impl Default for RunOptions {
    fn default() -> Self {
        Self { folder: PathBuf::from("."), resume: false, checkpoint_every: Duration::from_secs(30) }
    }
}

/// How a run ended.
#[derive(Clone, Debug)]
pub enum RunEnd {
    /// All generations are done.
    Finished(Box<Best>),
    /// It was asked to stop, and can be resumed.
    Interrupted,
}

/// Why a run could not go on.
#[derive(Debug, thiserror::Error)]
pub enum RunError {
    /// A file.
    #[error(transparent)]
    File(#[from] InputError),
    /// The evaluation.
    #[error(transparent)]
    Evaluation(#[from] EvaluationError),
}

/// Trains with one seed. `stop` is looked at after every generation.
///
/// # Errors
/// If the folder has another run, or files cannot be written, or roots cannot be evaluated. The last checkpoint stays.
pub fn run<S: Scalar, M: Maths<S>, E: Environment<S>, V: Evaluator<E::Task>>(
    config: &Config,
    seed: u64,
    environment: &E,
    evaluator: &V,
    options: &RunOptions,
    stop: &AtomicBool,
) -> Result<RunEnd, RunError> {
    make_folder(&options.folder)?;
    let path = options.folder.join("checkpoint.json");
    let found = checkpoint::load(&path, config, seed)?;
    if found.is_some() && !options.resume {
        let file = options.folder.display().to_string();
        return Err(InputError::new(file, Place::Whole, "a run", "--resume, or another folder").into());
    }
    remove_unfinished(&options.folder);
    write_atomically(&options.folder.join("config.toml"), config.to_toml().as_bytes())?;
    let mut state = found.unwrap_or_else(|| State::new(seed, config.demes.count, config.learning.archive_size));
    let evolution = Evolution::<S, M, E, V>::new(config, environment, evaluator);
    let mut session = Session::new(config, &state, &options.folder);
    if state.generation > 0 {
        // The run may have been killed between its checkpoint and what is made of it.
        write_results(config, &options.folder, &state, &evolution, environment)?;
    }
    let mut saved = Instant::now();
    while state.generation < config.learning.nb_generations {
        evolution.advance(&mut state)?;
        session.after_generation(&state, evaluator.steps());
        let last = state.generation == config.learning.nb_generations;
        let stopped = stop.load(Ordering::Relaxed);
        if last || stopped || saved.elapsed() >= options.checkpoint_every {
            checkpoint::save(&path, config, &state)?;
            write_results(config, &options.folder, &state, &evolution, environment)?;
            session.write(&options.folder)?;
            saved = Instant::now();
        }
        if stopped && !last {
            session.bar.abandon();
            return Ok(RunEnd::Interrupted);
        }
    }
    session.bar.finish();
    let best = state.best.expect("the last generation validates");
    Ok(RunEnd::Finished(Box::new(best)))
}

/// The logs and the best graph.
fn write_results<S: Scalar, M: Maths<S>, E: Environment<S>, V: Evaluator<E::Task>>(
    config: &Config,
    folder: &Path,
    state: &State<E::Task>,
    evolution: &Evolution<'_, S, M, E, V>,
    environment: &E,
) -> Result<(), RunError> {
    logs::write(folder, &state.rows)?;
    if let Some(best) = &state.best {
        let graph = best_graph(config, state.seed, best, evolution, environment)?;
        write_atomically(&folder.join("graph.json"), graph.to_json().as_bytes())?;
    }
    Ok(())
}

fn best_graph<S: Scalar, M: Maths<S>, E: Environment<S>, V: Evaluator<E::Task>>(
    config: &Config,
    seed: u64,
    best: &Best,
    evolution: &Evolution<'_, S, M, E, V>,
    environment: &E,
) -> Result<Graph, InputError> {
    let scores = [
        ("generation", best.generation as f64),
        ("validation_success", best.success),
        ("validation_error", best.error),
    ];
    let provenance = Provenance {
        tool: Some("tpg-train".to_owned()),
        version: Some(env!("CARGO_PKG_VERSION").to_owned()),
        seed: Some(seed),
        config: serde_json::to_value(config).ok(),
        scores: BTreeMap::from(scores.map(|(name, score)| (name.to_owned(), score))),
        note: None,
    };
    export::graph(&best.policy, evolution.vocabulary(), environment.sources(), environment.actions(), provenance)
}

/// What depends on the clock: the progress bar and `timing.csv`.
struct Session {
    bar: ProgressBar,
    began: Instant,
    cpu_before: Option<f64>,
    timing: String,
}

impl Session {
    fn new<Task>(config: &Config, state: &State<Task>, folder: &Path) -> Self {
        // indicatif draws nothing where stderr is no terminal.
        let bar = ProgressBar::new(config.learning.nb_generations);
        let style = ProgressStyle::with_template("seed {prefix} {wide_bar} {pos}/{len} {msg}, {eta} left")
            .unwrap_or_else(|_| ProgressStyle::default_bar());
        bar.set_style(style);
        bar.set_prefix(state.seed.to_string());
        bar.set_position(state.generation);
        bar.reset_eta();
        let timing = std::fs::read_to_string(folder.join("timing.csv"))
            .unwrap_or_else(|_| "generation,session_wall_s,session_cpu_s,session_steps\n".to_owned());
        Self { bar, began: Instant::now(), cpu_before: logs::cpu_seconds(), timing }
    }

    fn after_generation<Task>(&mut self, state: &State<Task>, steps: u64) {
        let Some(row) = state.rows.last() else { return };
        let best = state.best.as_ref().map(|best| format!(", {:.1} % validated", 100.0 * best.success));
        self.bar.set_message(format!(
            "best {:.1}, median {:.1}{}",
            row.best_score,
            row.median_score,
            best.unwrap_or_default()
        ));
        self.bar.set_position(state.generation);
        let wall = self.began.elapsed().as_secs_f64();
        let cpu = logs::cpu_seconds().zip(self.cpu_before).map(|(now, before)| format!("{:.2}", now - before));
        let _ = writeln!(self.timing, "{},{wall:.2},{},{steps}", row.generation, cpu.unwrap_or_default());
    }

    fn write(&self, folder: &Path) -> Result<(), InputError> {
        write_atomically(&folder.join("timing.csv"), self.timing.as_bytes())
    }
}
