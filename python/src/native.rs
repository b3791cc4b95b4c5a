//! The built-in problems: by name, and as environments that Python steps.

use crate::error;
use crate::graph::{Graph, in_python};
use numpy::{PyArray1, PyReadonlyArray1, PyReadonlyArray2};
use pyo3::prelude::*;
use serde_json::json;
use std::sync::{Mutex, MutexGuard};
use tpg_engine::random::{Purpose, Stream};
use tpg_engine::{Act, ActionSpace, AnyEnvironment, AnyEpisode, AnyTask, SourceSet, TaskSet, state_length};
use tpg_problems::{PolicyKind, Problem, ProblemName};
use tpg_runtime::policy::ActionId;
use tpg_train::{Acting, Config as EvolutionConfig, Configuration as _, Episodes, evaluate, in_integers};

/// Finds a built-in problem with its default settings.
pub(crate) fn problem(name: &str) -> PyResult<Problem> {
    Ok(Problem::new(problem_name(name)?))
}

fn problem_name(name: &str) -> PyResult<ProblemName> {
    ProblemName::from_name(name)
        .ok_or_else(|| error::input(format!("the problem {name:?}; accepted: {}", ProblemName::names())))
}

/// Returns the names of the built-in problems, each with its default preset.
#[pyfunction]
pub(crate) fn problems() -> Vec<(&'static str, &'static str)> {
    ProblemName::ALL.map(|name| (name.name(), EvolutionConfig::default_preset(name))).to_vec()
}

/// Runs a graph on test episodes of a built-in problem, and returns the figures as JSON.
#[pyfunction]
pub(crate) fn evaluate_native(
    py: Python<'_>,
    problem_name: &str,
    graph: &Graph,
    episodes: usize,
    seed: u64,
) -> PyResult<String> {
    let problem = problem(problem_name)?;
    let graph = ("<graph>".to_owned(), graph.0.clone());
    let episodes = Episodes { set: TaskSet::Test, count: episodes, seed, file: None };
    let report = py.detach(|| evaluate(&problem, &graph.0, Acting::Graph(&graph), episodes));
    let report = report.map_err(error::input)?;
    serde_json::to_string(&report).map_err(error::input)
}

/// Returns a graph in integers that keep its return on a built-in problem, and a report: see [`in_integers`].
#[pyfunction]
pub(crate) fn quantise_native(
    py: Python<'_>,
    problem_name: &str,
    graph: &Graph,
    bits: Option<u32>,
    states: Option<PyReadonlyArray2<'_, f64>>,
    episodes: usize,
) -> PyResult<(Graph, String)> {
    let (problem, given) = (problem(problem_name)?, graph.given(states)?);
    let graph = ("graph".to_owned(), graph.0.clone());
    let whole = py.detach(|| in_integers(&problem, &graph, bits, given, episodes, 1));
    whole.map(in_python).map_err(error::input)
}

/// A step as Python sees it: observation, reward, terminated, truncated, and success where the problem defines it.
type Stepped<'py> = (Bound<'py, PyArray1<f32>>, f64, bool, bool, Option<bool>);

/// A built-in problem that is stepped from outside.
#[pyclass(frozen, module = "tpg_train._tpg")]
pub(crate) struct NativeEnv {
    environment: AnyEnvironment<f32>,
    /// The episode, and the number of its actions.
    running: Mutex<Option<(AnyEpisode, u32)>>,
}

#[pymethods]
impl NativeEnv {
    /// Opens a problem; `continuous` asks for the arm by its motors.
    #[new]
    #[pyo3(signature = (name, continuous = false))]
    fn new(name: &str, continuous: bool) -> PyResult<Self> {
        let name = problem_name(name)?;
        let environment = match continuous {
            true => Problem::new_for(name, PolicyKind::Network).network_environment(1),
            false => Problem::new(name).environment(),
        };
        Ok(Self { environment, running: Mutex::new(None) })
    }

    /// The environment's observations and actions as JSON: sources, actions, outputs and the time limit.
    #[getter]
    fn description(&self) -> String {
        let sources = self.environment.sources();
        let sources: Vec<_> =
            sources.iter().map(|item| json!({"name": item.name, "unit": item.unit, "ranges": item.ranges})).collect();
        let (actions, outputs) = match self.environment.actions() {
            ActionSpace::Discrete(actions) => (actions.into_iter().map(|item| item.name).collect(), Vec::new()),
            ActionSpace::Box(outputs) => {
                (Vec::new(), outputs.iter().map(|item| json!([item.name, item.min, item.max])).collect())
            }
        };
        let limit = self.environment.time_limit();
        json!({"sources": sources, "actions": actions, "outputs": outputs, "time_limit": limit}).to_string()
    }

    /// Starts an episode and returns its first observation; the seed decides its task.
    fn reset<'py>(&self, py: Python<'py>, seed: u64) -> PyResult<Bound<'py, PyArray1<f32>>> {
        self.begin(py, &self.environment.draw(&mut Stream::new(seed, 0, Purpose::Episode, 0)))
    }

    /// Starts the episode of a task, given as JSON.
    fn reset_to<'py>(&self, py: Python<'py>, task: &str) -> PyResult<Bound<'py, PyArray1<f32>>> {
        let task: AnyTask = serde_json::from_str(task).map_err(error::input)?;
        match self.environment.accepts(&task) {
            true => self.begin(py, &task),
            false => Err(error::input(format!("{task:?}; accepted: a task of the problem"))),
        }
    }

    /// Takes an action by its number.
    fn choose<'py>(&self, py: Python<'py>, action: u16) -> PyResult<Stepped<'py>> {
        self.step(py, Act::Choice(ActionId(action)))
    }

    /// Takes an action of values.
    fn act<'py>(&self, py: Python<'py>, values: PyReadonlyArray1<'py, f32>) -> PyResult<Stepped<'py>> {
        let values: Vec<f32> = values.as_array().iter().copied().collect();
        self.step(py, Act::Values(&values))
    }
}

impl NativeEnv {
    fn running(&self) -> PyResult<MutexGuard<'_, Option<(AnyEpisode, u32)>>> {
        self.running.lock().map_err(|_| error::training("an earlier step failed"))
    }

    fn begin<'py>(&self, py: Python<'py>, task: &AnyTask) -> PyResult<Bound<'py, PyArray1<f32>>> {
        let mut running = self.running()?;
        let (episode, _) = running.insert((self.environment.start(task), 0));
        Ok(self.observe(py, episode))
    }

    fn observe<'py>(&self, py: Python<'py>, episode: &mut AnyEpisode) -> Bound<'py, PyArray1<f32>> {
        let mut state = vec![0.0; state_length(&self.environment.sources())];
        self.environment.observe(episode, SourceSet::ALL, &mut state);
        PyArray1::from_vec(py, state)
    }

    /// Compares an action with the action space.
    fn check(&self, act: Act<'_, f32>) -> Result<(), String> {
        match (self.environment.actions(), act) {
            (ActionSpace::Discrete(actions), Act::Choice(action)) if usize::from(action.0) < actions.len() => Ok(()),
            (ActionSpace::Box(outputs), Act::Values(values)) if outputs.len() == values.len() => {
                match values.iter().position(|value| !value.is_finite()) {
                    Some(place) => Err(format!("action[{place}] = {}; accepted: finite values", values[place])),
                    None => Ok(()),
                }
            }
            (ActionSpace::Box(outputs), _) => Err(format!("another action; accepted: {} values", outputs.len())),
            (space, _) => Err(format!("another action; accepted: 0 to {}", space.count().unwrap_or(1) - 1)),
        }
    }

    fn step<'py>(&self, py: Python<'py>, act: Act<'_, f32>) -> PyResult<Stepped<'py>> {
        self.check(act).map_err(error::input)?;
        let mut running = self.running()?;
        let before = || error::input("a step before reset(); accepted: reset() first");
        let (episode, actions) = running.as_mut().ok_or_else(before)?;
        let step = self.environment.step(episode, act);
        *actions += 1;
        let late = *actions >= self.environment.time_limit();
        let end = step.end.or_else(|| late.then(|| self.environment.timeout(episode)));
        let (truncated, success) = (end.is_some_and(|end| end.truncated), end.and_then(|end| end.success));
        Ok((self.observe(py, episode), step.reward, end.is_some() && !truncated, truncated, success))
    }
}
