//! Runs of evolution, which call Python for the results of episodes and after every generation.

use crate::driver::Told;
use crate::error;
use crate::graph::Graph;
use crate::native;
use crate::policy::Policy;
use crate::samples::Samples;
use crate::space::Space;
use pyo3::prelude::*;
use pyo3::types::PyDict;
use std::ops::ControlFlow;
use std::path::{Path, PathBuf};
use tpg_engine::{
    Choices, Environment, EpisodeResult, EvaluationError, Evaluator, LocalThreads, Moments, Play, Played, PolicyGraph,
    Remembering, Work,
};
use tpg_graph::ScalarType;
use tpg_problems::Number;
use tpg_runtime::ops::{Maths, Own};
use tpg_runtime::scalar::Scalar;
use tpg_train::{
    Best, Config as EvolutionConfig, Configuration as _, Goal, Layers, Naming, Progress, RunEnd, RunError, RunOptions,
    train,
};

/// The preset that a file of settings differs from.
const DEFAULT: &str = "quick";

/// A run's settings.
#[derive(FromPyObject)]
#[pyo3(from_item_all)]
pub(crate) struct Settings {
    config: String,
    seed: u64,
    folder: PathBuf,
    resume: bool,
    target: Option<f64>,
    max_steps: Option<u64>,
    /// Threads for episodes that this process runs; 0 for all.
    threads: usize,
    /// The name of an environment that is not built in.
    task: Option<String>,
    /// Names of the values of an observation that has none of its own.
    input_names: Vec<String>,
}

/// The episodes of a run.
#[derive(FromPyObject)]
pub(crate) enum Field {
    /// Python runs them.
    Outside(Space),
    /// Samples.
    Samples(Samples),
    /// A built-in problem.
    Native(String),
}

/// Evolves a graph. Returns true if the run is complete, false if `progress`, which gets the figures after every generation, said to
/// stop. The episodes in a space are Python's: `evaluate` gets policies and seeds and returns the results of each policy, one for each
/// seed; `play` gets policies, each with a seed and numbers of actions, and returns for each the result, the moments of what was seen,
/// and the state after each number of actions. An exception ends the run, which saves itself as it was after its last complete
/// generation.
#[pyfunction]
pub(crate) fn evolve(
    py: Python<'_>,
    field: Field,
    settings: Settings,
    evaluate: Py<PyAny>,
    play: Py<PyAny>,
    progress: Py<PyAny>,
) -> PyResult<bool> {
    let mut config = EvolutionConfig::from_toml("<settings>", &settings.config).map_err(error::input)?;
    let goal = Goal { target: settings.target, max_steps: settings.max_steps };
    let naming = Naming { task: settings.task, inputs: settings.input_names };
    let options =
        RunOptions { folder: settings.folder, resume: settings.resume, goal, naming, ..RunOptions::default() };
    if let Field::Native(name) = &field {
        config.problem = native::problem(name)?.to_table();
    }
    let run = Run { config, options, seed: settings.seed, threads: settings.threads, evaluate, play, progress };
    py.detach(|| match run.config.language.scalar {
        ScalarType::F32 => run.evolve::<f32>(&field),
        ScalarType::F64 => run.evolve::<f64>(&field),
    })
}

/// A run, with the functions that it calls.
struct Run {
    config: EvolutionConfig,
    options: RunOptions,
    seed: u64,
    threads: usize,
    evaluate: Py<PyAny>,
    play: Py<PyAny>,
    progress: Py<PyAny>,
}

impl Run {
    fn evolve<S: Number>(&self, field: &Field) -> PyResult<bool>
    where
        Own: Maths<S>,
    {
        match field {
            Field::Outside(space) => {
                let memory = self.config.language.memory;
                let outside = Outside { run: self, inputs: space.length() + usize::from(memory) };
                self.train::<S, _>(&Remembering::new::<S>(space.clone(), memory), &outside)
            }
            Field::Samples(samples) => self.evolve_here::<S, _>(samples.clone()),
            Field::Native(name) => {
                let problem = native::problem(name)?;
                let environment = problem.environment::<S>();
                self.evolve_here(Choices::new(&*environment, problem.levels()).map_err(error::input)?)
            }
        }
    }

    /// A run whose episodes this process runs.
    fn evolve_here<S: Scalar, E: Environment<S>>(&self, environment: E) -> PyResult<bool>
    where
        Own: Maths<S>,
    {
        let environment = Remembering::new::<S>(environment, self.config.language.memory);
        let evaluator = LocalThreads::<S, Own, _>::new(&environment, self.threads).map_err(error::training)?;
        self.train::<S, _>(&environment, &evaluator)
    }

    fn train<S: Scalar, E: Environment<S>>(
        &self,
        environment: &E,
        evaluator: &dyn Evaluator<E::Task>,
    ) -> PyResult<bool> {
        let (mut shown, mut raised) = (Vec::new(), None);
        let end = train(&self.config, self.seed, environment, evaluator, &self.options, |progress| {
            let goes_on = Python::attach(|py| {
                self.progress.call1(py, (figures(py, progress, &mut shown)?,))?.extract::<bool>(py)
            });
            let goes_on = goes_on.unwrap_or_else(|error| {
                raised = Some(error);
                false
            });
            if goes_on { ControlFlow::Continue(()) } else { ControlFlow::Break(()) }
        });
        match (raised, end) {
            (Some(error), _) => Err(error),
            (None, Ok(end)) => Ok(matches!(end, RunEnd::Finished(_))),
            (None, Err(RunError::Evaluation(failed))) => match failed.into_inner().downcast::<PyErr>() {
                Ok(raised) => Err(*raised),
                Err(failed) => Err(error::training(EvaluationError::new(failed))),
            },
            // The library speaks of its command line.
            (None, Err(failed)) => Err(error::input(failed.to_string().replace("--resume", "resume=True"))),
        }
    }
}

/// Episodes that Python runs.
struct Outside<'r> {
    run: &'r Run,
    inputs: usize,
}

impl Outside<'_> {
    fn policy(&self, policy: &PolicyGraph) -> Policy {
        Policy::new(policy.clone(), self.inputs, self.run.config.language.scalar)
    }

    fn played(&self, (told, seen, mut states): (Told, String, Vec<Vec<f64>>)) -> PyResult<Played> {
        let seen = serde_json::from_str(&seen).ok().filter(|seen: &Moments| seen.length() == self.inputs);
        let refused = || error::input(format!("{told:?}; accepted: moments of {} values", self.inputs));
        // What the policy read: the bench may tell more digits.
        let scalar = self.run.config.language.scalar;
        states.iter_mut().flatten().for_each(|value| *value = scalar.round(*value));
        Ok(Played { ending: ending(told), seen: seen.ok_or_else(refused)?, states })
    }
}

impl Evaluator<u64> for Outside<'_> {
    fn evaluate(&self, work: &Work<u64>) -> Result<Vec<Vec<EpisodeResult>>, EvaluationError> {
        if work.policies.is_empty() || work.tasks.is_empty() {
            return Ok(vec![Vec::new(); work.policies.len()]);
        }
        let policies: Vec<Policy> = work.policies.iter().map(|policy| self.policy(policy)).collect();
        let told = Python::attach(|py| -> PyResult<Vec<Vec<Told>>> {
            self.run.evaluate.call1(py, (policies, &work.tasks))?.extract(py)
        });
        let told = told.map_err(EvaluationError::new)?;
        if told.len() != work.policies.len() || told.iter().any(|told| told.len() != work.tasks.len()) {
            let (policies, seeds) = (work.policies.len(), work.tasks.len());
            let found = format!("results of another number; accepted: {policies} policies, {seeds} results of each");
            return Err(EvaluationError::new(error::input(found)));
        }
        Ok(told.into_iter().map(|told| told.into_iter().map(ending).collect()).collect())
    }

    fn play(&self, plays: &[Play<u64>]) -> Result<Vec<Played>, EvaluationError> {
        if plays.is_empty() {
            return Ok(Vec::new());
        }
        let asked: Vec<(Policy, u64, &[u32])> =
            plays.iter().map(|play| (self.policy(&play.policy), play.task, &play.after[..])).collect();
        let played = Python::attach(|py| {
            let told: Vec<(Told, String, Vec<Vec<f64>>)> = self.run.play.call1(py, (asked,))?.extract(py)?;
            if told.len() != plays.len() {
                return Err(error::input(format!("{} results; accepted: {}", told.len(), plays.len())));
            }
            told.into_iter().map(|told| self.played(told)).collect::<PyResult<_>>()
        });
        played.map_err(EvaluationError::new)
    }
}

fn ending((score, actions, success, final_reward): Told) -> EpisodeResult {
    EpisodeResult { outcome: 0, success, score, final_reward, measure: 0.0, actions }
}

/// Returns the figures of a run, with the best graph and the hall of fame (of each policy size, score and graph) if these are others
/// than those that were `shown`.
fn figures<'py>(py: Python<'py>, progress: &Progress<'_>, shown: &mut Vec<u64>) -> PyResult<Bound<'py, PyDict>> {
    let says = PyDict::new(py);
    says.set_item("generations", progress.generations)?;
    says.set_item("steps", progress.steps)?;
    says.set_item("best_validated", progress.best.map(|best| best.result.score))?;
    if let Some(row) = progress.row {
        says.set_item("best_score", row.best_score)?;
        says.set_item("median_score", row.median_score)?;
        says.set_item("roots", row.roots)?;
        says.set_item("teams", row.teams)?;
        says.set_item("programs", row.programs)?;
        says.set_item("validation_score", row.validation.as_ref().map(|result| result.score))?;
    }
    let Some(best) = progress.best else { return Ok(says) };
    let now: Vec<u64> = std::iter::once(best).chain(progress.hall).map(|best| best.generation).collect();
    if now != *shown {
        *shown = now;
        let graph = |best: &Best| progress.graph(best).map(Graph).map_err(error::input);
        says.set_item("graph", graph(best)?)?;
        let entry = |best: &Best| Ok((best.policy.size(), best.result.score, graph(best)?));
        says.set_item("hall", progress.hall.iter().map(entry).collect::<PyResult<Vec<_>>>()?)?;
    }
    Ok(says)
}

/// Returns a preset, or a file of settings, with other values of some settings, as TOML: `settings` is a JSON object from keys such
/// as `tpg.nb_roots` to values.
#[pyfunction]
pub(crate) fn configuration(preset: &str, settings: &str) -> PyResult<String> {
    let path = Path::new(preset);
    let file = Some(path).filter(|path| path.is_file() && EvolutionConfig::table(preset).is_err());
    let preset = Some(preset).filter(|_| file.is_none());
    let layers = Layers::of::<EvolutionConfig>(preset, file, |_| Ok(DEFAULT));
    let mut layers = layers.map_err(|error| match preset {
        Some(_) => error::input(format!("{}; accepted: {}, or a file", error.found, error.accepted)),
        None => error::input(error),
    })?;
    set_all(&mut layers, settings)?;
    let mut config = layers.read(EvolutionConfig::from_toml).map_err(error::input)?;
    // The environment is the problem.
    config.problem = toml::Table::new();
    Ok(config.to_toml())
}

/// Sets the values of a JSON object from keys such as `tpg.nb_roots`.
pub(crate) fn set_all(layers: &mut Layers, settings: &str) -> PyResult<()> {
    let settings: toml::Table = serde_json::from_str(settings).map_err(error::input)?;
    settings.into_iter().for_each(|(key, value)| layers.set(&key, value));
    Ok(())
}
