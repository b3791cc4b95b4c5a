//! A whole run: generations, checkpoints, logs, and the best graph at the end.

use super::checkpoint;
use super::config::EvolutionConfig;
use super::export;
use super::generation::{Evolution, Goal};
use super::record::Row;
use super::scales::scales;
use super::state::{Best, State};
use crate::configuration::Configuration as _;
use crate::folder::RunFolder;
use crate::run_time::Stopwatch;
use std::collections::BTreeMap;
use std::ops::ControlFlow;
use std::path::PathBuf;
use std::time::{Duration, Instant};
use tpg_engine::{Environment, EvaluationError, Evaluator, Summary};
use tpg_graph::error::{Finding, InputError, Place};
use tpg_graph::files::write_atomically;
use tpg_graph::{Graph, Provenance, SourceDocument};
use tpg_runtime::scalar::Scalar;

/// The words of a run's graphs, which no training depends on.
#[derive(Clone, Debug, Default)]
pub struct Naming {
    /// The name of an environment of your own, which generated code says in its first line.
    pub task: Option<String>,
    /// A name for each value of the flat state, without a memory's; if there are none, those of the sources are used.
    pub inputs: Vec<String>,
}

impl Naming {
    /// Returns sources with a name for each value.
    fn named(&self, sources: Vec<SourceDocument>) -> Vec<SourceDocument> {
        let unnamed = |source: SourceDocument| {
            let one = |range| SourceDocument::new(source.name.clone(), source.unit.clone(), vec![range]);
            source.ranges.into_iter().map(one).collect::<Vec<_>>()
        };
        if self.inputs.is_empty() {
            return sources;
        }
        let mut sources: Vec<_> = sources.into_iter().flat_map(unnamed).collect();
        sources.iter_mut().zip(&self.inputs).for_each(|(source, name)| source.name.clone_from(name));
        sources
    }
}

/// Options of a run. Only the [goal](Self::goal) affects its result: it can end the run early.
#[derive(Clone, Debug)]
pub struct RunOptions {
    /// The run's own folder.
    pub folder: PathBuf,
    /// If true, continue from the folder's checkpoint if there is one; the configuration may ask for more generations
    /// than before. If false, a folder with a run is refused.
    pub resume: bool,
    /// Time between checkpoints.
    pub checkpoint_every: Duration,
    /// The conditions under which the run ends early.
    pub goal: Goal,
    /// The words of its graphs.
    pub naming: Naming,
}

impl Default for RunOptions {
    fn default() -> Self {
        let (folder, checkpoint_every) = (PathBuf::from("."), Duration::from_secs(30));
        Self { folder, resume: false, checkpoint_every, goal: Goal::default(), naming: Naming::default() }
    }
}

/// Progress of a run after a generation.
#[derive(Clone, Copy)]
pub struct Progress<'a> {
    /// Seed of the run.
    pub seed: u64,
    /// Number of finished generations.
    pub generations: u64,
    /// Number of generations of the whole run, unless it ends early.
    pub planned: u64,
    /// Number of actions of all episodes so far.
    pub steps: u64,
    /// Newest row of the logs; none before the first generation.
    pub row: Option<&'a Row>,
    /// Best root on the validation set so far.
    pub best: Option<&'a Best>,
    /// The best roots of each size.
    pub hall: &'a [Best],
    to_graph: &'a dyn Fn(&Best) -> Result<Graph, InputError>,
}

impl Progress<'_> {
    /// Returns a root as a graph, as a run writes it: with the ranges of its inputs and its provenance.
    ///
    /// # Errors
    /// If the graph is invalid, which would be a defect of the trainer.
    pub fn graph(&self, best: &Best) -> Result<Graph, InputError> {
        (self.to_graph)(best)
    }
}

/// Outcome of a run.
#[derive(Clone, Debug)]
pub enum RunEnd {
    /// The run completed all of its generations or reached its goal.
    Finished(Box<Best>),
    /// The run was asked to stop and can be resumed.
    Interrupted,
}

/// Reason why a run could not continue.
#[derive(Debug, thiserror::Error)]
pub enum RunError {
    /// A file could not be read or written.
    #[error(transparent)]
    File(#[from] InputError),
    /// A parameter does not fit the environment.
    #[error(transparent)]
    Setting(#[from] Finding),
    /// The evaluation failed.
    #[error(transparent)]
    Evaluation(#[from] EvaluationError),
}

/// Trains with one seed. `watch` is called at the beginning and after every generation; if it returns `Break`, the run
/// is saved and stops. If roots cannot be evaluated, the run is saved as it was before that generation, and can be resumed.
///
/// ```
/// use std::ops::ControlFlow;
/// use tpg_engine::LocalThreads;
/// use tpg_problems::CartPole;
/// use tpg_runtime::ops::Own;
/// use tpg_train::{Config, RunEnd, RunOptions, train};
///
/// let mut config = Config::default();
/// config.tpg.nb_roots = 20;
/// config.learning.nb_generations = 2;
/// config.selection.validation_episodes = 20;
///
/// let folder = tempfile::tempdir()?;
/// let options = RunOptions { folder: folder.path().to_owned(), ..RunOptions::default() };
/// let evaluator = LocalThreads::<f32, Own, _>::new(&CartPole, 1)?;
/// let end = train::<f32, _>(&config, 1, &CartPole, &evaluator, &options, |_| ControlFlow::Continue(()))?;
/// let RunEnd::Finished(best) = end else { panic!("nothing stopped the run") };
/// assert_eq!(best.result.episodes, 20);
/// assert!(folder.path().join("graph.json").exists());
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
///
/// # Errors
/// If the folder contains another run or another process uses it, its checkpoints are damaged, files cannot be written,
/// or roots cannot be evaluated.
pub fn train<S: Scalar, E: Environment<S>>(
    config: &EvolutionConfig,
    seed: u64,
    environment: &E,
    evaluator: &dyn Evaluator<E::Task>,
    options: &RunOptions,
    mut watch: impl FnMut(&Progress<'_>) -> ControlFlow<()>,
) -> Result<RunEnd, RunError> {
    config.check_environment(environment)?;
    let asked = config.start.share;
    let config = &config.fitted(environment);
    if asked > 0.0 && config.start.share == 0.0 {
        tpg_graph::command::note(
            "a sum of all inputs is too long for a program: no search for weights, the run starts at random",
        );
    }
    let folder = RunFolder::open(&options.folder, options.resume)?;
    let found = folder
        .load(checkpoint::FORM, |file, content| checkpoint::from_bytes(file, content, config, seed, environment))?;
    write_atomically(&options.folder.join("config.toml"), config.to_toml().as_bytes())?;
    let mut state = match found {
        Some(state) => state,
        None => State { scales: scales(config, environment, evaluator, seed)?, ..State::new(seed) },
    };
    let evolution = Evolution::new(config, environment, evaluator, state.scales.clone(), options.goal);
    let stopwatch = Stopwatch::new(&options.folder);
    let to_graph = |best: &Best| graph_of(config, seed, best, environment, &options.naming);
    // The log has no times, so that equal runs have equal logs; the hall of fame has a graph a line, smallest first.
    let write_results = |state: &State<E::Task>| -> Result<(), RunError> {
        let write = |name: &str, text: &str| write_atomically(&options.folder.join(name), text.as_bytes());
        let row = |row: &Row| serde_json::to_string(row).expect("a row is plain data") + "\n";
        write("generations.jsonl", &state.rows.iter().map(row).collect::<String>())?;
        if let Some(best) = &state.best {
            write("graph.json", &to_graph(best)?.to_json())?;
        }
        let mut hall = String::new();
        for best in &state.hall {
            hall.extend(to_graph(best)?.to_json().lines().map(str::trim));
            hall.push('\n');
        }
        Ok(write("hall.jsonl", &hall)?)
    };
    if state.generation > 0 {
        // The run may have been killed between writing its checkpoint and its results.
        write_results(&state)?;
    }
    let save = |state: &State<E::Task>| -> Result<(), RunError> {
        let file = folder.path().display().to_string();
        folder.save(checkpoint::FORM, checkpoint::to_bytes(&file, config, state, environment)?)?;
        write_results(state)?;
        Ok(stopwatch.write(&options.folder)?)
    };
    let mut stopped = watch(&progress(config, &state, &to_graph)).is_break();
    let mut saved = Instant::now();
    while !evolution.finished(&state) {
        if !stopped {
            let before = state.clone();
            if let Err(error) = evolution.advance(&mut state) {
                if before.generation > 0 {
                    save(&before)?;
                }
                return Err(error.into());
            }
            stopped = watch(&progress(config, &state, &to_graph)).is_break();
        }
        let last = evolution.finished(&state);
        if last || stopped || saved.elapsed() >= options.checkpoint_every {
            save(&state)?;
            saved = Instant::now();
        }
        if stopped && !last {
            return Ok(RunEnd::Interrupted);
        }
    }
    // A run that is resumed with fewer generations or steps than it has had may never have validated.
    let Some(best) = state.best else {
        let found = format!("a run of {} generations without a validation", state.generation);
        let accepted = "more generations or steps than the run has had";
        return Err(InputError::new(folder.path().display().to_string(), Place::Whole, found, accepted).into());
    };
    Ok(RunEnd::Finished(Box::new(best)))
}

fn progress<'a, Task>(
    config: &EvolutionConfig,
    state: &'a State<Task>,
    to_graph: &'a dyn Fn(&Best) -> Result<Graph, InputError>,
) -> Progress<'a> {
    Progress {
        seed: state.seed,
        generations: state.generation,
        planned: config.learning.nb_generations,
        steps: state.steps,
        row: state.rows.last(),
        best: state.best.as_ref(),
        hall: &state.hall,
        to_graph,
    }
}

/// Returns a validated root as a graph, as a run writes it: with the ranges of its inputs and its provenance.
///
/// # Errors
/// If the environment's actions are not named, or the graph is invalid, which would be a defect of the trainer.
pub(crate) fn graph_of<S: Scalar, E: Environment<S>>(
    config: &EvolutionConfig,
    seed: u64,
    best: &Best,
    environment: &E,
    naming: &Naming,
) -> Result<Graph, InputError> {
    let Summary { score, success, measure, .. } = best.result;
    let named = environment.measure().map(|of| (format!("validation_{}", of.name), measure));
    let scores = [("generation".to_owned(), best.generation as f64), ("validation_score".to_owned(), score)];
    let success = success.map(|success| ("validation_success".to_owned(), success));
    let provenance = Provenance {
        tool: Some("tpg-train".to_owned()),
        version: Some(env!("CARGO_PKG_VERSION").to_owned()),
        seed: Some(seed),
        config: serde_json::to_value(config.fitted(environment)).ok(),
        scores: BTreeMap::from_iter(scores.into_iter().chain(success).chain(named)),
        note: naming.task.clone(),
    };
    let mut sources = environment.sources();
    if let Some(ranges) = &best.ranges {
        let mut ranges = ranges.iter();
        sources.iter_mut().flat_map(|source| &mut source.ranges).zip(&mut ranges).for_each(|(to, from)| *to = *from);
    }
    // The units of literals matter only where literals are drawn.
    let vocabulary = config.vocabulary(environment, Vec::new());
    let memory = tpg_engine::remembered(&sources, &environment.actions());
    let sources = naming.named(sources);
    export::graph(&best.policy, &vocabulary, sources, environment.actions(), memory, provenance)
        .map(Graph::without_unread_features)
}
