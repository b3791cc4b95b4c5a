//! A graph on any environment.

use super::report::EvaluationReport;
use std::path::Path;
use std::time::Instant;
use tpg_engine::random::{Purpose, Stream};
use tpg_engine::{Choices, Ending, EngineOptions, Environment, Lanes, Plan, Remembered, Remembering, bind};
use tpg_graph::error::{InputError, Place};
use tpg_graph::{Graph, in_arithmetic_of};
use tpg_problems::dodge::scene::Scene;
use tpg_problems::dodge::{self, Dodge};
use tpg_problems::{Number, Problem};
use tpg_runtime::ops::Maths;
use tpg_runtime::scalar::Scalar;

/// Runs a graph on `episodes` drawn test episodes of an environment, in the graph's own maths.
///
/// Test episodes are drawn from a stream of their own: no training and no selection reads them.
///
/// # Errors
/// If the graph reads or does what the environment does not know, or an episode fails; `file` is what the error names.
pub fn endings<S: Scalar, M: Maths<S>>(
    file: &str,
    graph: &Graph,
    environment: &impl Environment<S>,
    episodes: usize,
    seed: u64,
) -> Result<Vec<Ending>, InputError> {
    let tasks: Vec<_> = (0..episodes as u64)
        .map(|index| environment.draw(&mut Stream::new(seed, 0, Purpose::Evaluation, index)))
        .collect();
    endings_on::<S, M, _>(file, graph, environment, &tasks)
}

/// Runs a graph on tasks of an environment, in the graph's own maths.
///
/// # Errors
/// As [`endings`].
pub fn endings_on<S: Scalar, M: Maths<S>, E: Environment<S>>(
    file: &str,
    graph: &Graph,
    environment: &E,
    tasks: &[E::Task],
) -> Result<Vec<Ending>, InputError> {
    let policy = bind(file, graph, environment)?;
    let plan = Plan::new::<M>(&policy, &environment.sources(), EngineOptions::default());
    Lanes::<S, M, _>::new(environment, EngineOptions::default())
        .run(&plan, tasks)
        .map_err(|error| InputError::new(file, Place::Whole, error.to_string(), "episodes that can be run"))
}

/// Evaluates a graph on an environment of your own: see [`endings`].
///
/// ```
/// use tpg_graph::Graph;
/// use tpg_problems::CartPole;
/// use tpg_runtime::ops::Own;
/// use tpg_train::evaluate::graph::on_environment;
///
/// // Pushes to the side to which the pole is falling: `right` is bid theta + omega, `left` is bid 0.
/// let text = r#"{
///     "format": "tpg-graph", "version": 1, "scalar": "f32", "maths": "own", "registers": 1,
///     "sources": [
///         { "name": "theta", "length": 1, "unit": "rad", "ranges": [[-1, 1]] },
///         { "name": "omega", "length": 1, "unit": "rad/s", "ranges": [[-9, 9]] }
///     ],
///     "instructions": ["add"],
///     "actions": [{ "id": 0, "name": "left" }, { "id": 1, "name": "right" }],
///     "root": 0,
///     "teams": [{ "id": 0, "edges": [{ "program": 0, "action": 0 }, { "program": 1, "action": 1 }] }],
///     "programs": [
///         { "id": 0, "lines": [] },
///         { "id": 1, "lines": [{ "to": 0, "op": "add", "args": ["theta[0]", "omega[0]"] }] }
///     ]
/// }"#;
/// let graph = Graph::from_json("falling.json", text)?;
/// let report = on_environment::<f32, Own>("cartpole", "falling.json", &graph, &CartPole, 10, 1)?;
/// assert!(report.mean_score > 100.0, "{}", report.mean_score);
/// # Ok::<(), tpg_graph::error::InputError>(())
/// ```
///
/// # Errors
/// As [`endings`].
pub fn on_environment<S: Scalar, M: Maths<S>>(
    problem: &str,
    file: &str,
    graph: &Graph,
    environment: &impl Environment<S>,
    episodes: usize,
    seed: u64,
) -> Result<EvaluationReport, InputError> {
    let began = Instant::now();
    let endings = endings::<S, M>(file, graph, environment, episodes, seed)?;
    let seconds = began.elapsed().as_secs_f64();
    let measure = environment.measure();
    Ok(EvaluationReport::new(problem, file, Some(seed), &endings, environment.outcomes(), measure, seconds))
}

/// Evaluates a graph on a built-in problem.
///
/// # Errors
/// As [`endings`].
pub fn on_problem(
    problem: &Problem,
    file: &str,
    graph: &Graph,
    episodes: usize,
    seed: u64,
) -> Result<EvaluationReport, InputError> {
    let evaluation = Evaluation { problem, file, graph, episodes, seed };
    in_arithmetic_of!(graph, evaluation.run())
}

/// Evaluates a graph on scenes of a file, among balls.
///
/// # Errors
/// As [`endings`]; if the file cannot be read.
pub fn on_scenes(
    config: &dodge::Config,
    file: &str,
    graph: &Graph,
    scenes: &Path,
) -> Result<EvaluationReport, InputError> {
    let tasks: Vec<_> = dodge::file::read_csv(scenes)?.into_iter().map(|certified| certified.scene).collect();
    let environment = Dodge::new(config);
    let began = Instant::now();
    let endings = in_arithmetic_of!(graph, on_balls(file, graph, &environment, &tasks))?;
    let seconds = began.elapsed().as_secs_f64();
    let (outcomes, measure) = (&dodge::episode::OUTCOMES, Some(tpg_problems::arm::environment::DISTANCE));
    Ok(EvaluationReport::new("dodge", file, None, &endings, outcomes, measure, seconds))
}

fn on_balls<S: Scalar, M: Maths<S>>(
    file: &str,
    graph: &Graph,
    environment: &Dodge,
    scenes: &[Scene],
) -> Result<Vec<Ending>, InputError> {
    endings_on::<S, M, _>(file, graph, environment, scenes)
}

struct Evaluation<'a> {
    problem: &'a Problem,
    file: &'a str,
    graph: &'a Graph,
    episodes: usize,
    seed: u64,
}

impl Evaluation<'_> {
    fn run<S: Number, M: Maths<S>>(&self) -> Result<EvaluationReport, InputError> {
        let Self { problem, file, graph, episodes, seed } = *self;
        let environment = problem.environment::<S>();
        let choices = Choices::new(&*environment, problem.levels_for(graph))
            .map_err(|error| InputError::new(file, Place::Whole, error.to_string(), "fewer problem.levels"))?;
        let remembering = Remembering::new(choices, Remembered::of(graph));
        on_environment::<S, M>(problem.name().name(), file, graph, &remembering, episodes, seed)
    }
}
