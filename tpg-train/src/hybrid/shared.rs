//! Problems whose episodes a graph and a network can share: the built-in ones, and any other environment.

use super::rollout::{Acting, HybridResult, run};
use serde_json::{Map, Value};
use std::marker::PhantomData;
use std::path::Path;
use tpg_engine::random::{Purpose, Stream};
use tpg_engine::{AnyEpisode, AnyTask, Choices, Environment, EpisodeResult, Measure, Preference, TaskSet, tasks};
use tpg_graph::Graph;
use tpg_graph::error::{Finding, InputError, Place};
use tpg_graph::in_arithmetic_of;
use tpg_problems::{Number, Problem};
use tpg_runtime::ops::{Maths, Own};
use tpg_runtime::scalar::Scalar;

/// A list of episodes.
#[derive(Clone, Copy, Debug)]
pub struct Episodes<'a> {
    /// Their purpose.
    pub set: TaskSet,
    /// Number of episodes.
    pub count: usize,
    /// Their seed.
    pub seed: u64,
    /// A file of a built-in problem that lists them, instead.
    pub file: Option<&'a Path>,
}

impl Episodes<'_> {
    fn draw<S: Scalar, E: Environment<S>>(&self, environment: &E) -> Vec<E::Task> {
        tasks(environment, self.set, self.seed, self.count)
    }

    /// Returns the episodes on a built-in problem.
    ///
    /// # Errors
    /// If the file cannot be read.
    pub fn in_problem(&self, problem: &Problem) -> Result<Vec<AnyTask>, InputError> {
        match self.file {
            Some(path) => problem.read_tasks(path, false),
            None => Ok(self.draw(&&*problem.environment::<f32>())),
        }
    }
}

/// The facts about a problem that a study and a report need.
#[derive(Clone, Copy, Debug)]
pub struct Facts {
    /// True if the environment has keys, so that cycles can be detected.
    pub has_key: bool,
    /// The ways in which an episode can end.
    pub outcomes: &'static [&'static str],
    /// The quantity reported in addition to the score.
    pub measure: Option<Measure>,
    /// The criterion by which policies are ranked.
    pub preference: Preference,
    /// The names of the guards; none for most problems.
    pub guards: &'static [&'static str],
}

impl Facts {
    fn new<S: Scalar>(environment: &impl Environment<S>) -> Self {
        let task = environment.draw(&mut Stream::new(0, 0, Purpose::Selection, 0));
        Self {
            has_key: environment.key(&environment.start(&task)).is_some(),
            outcomes: environment.outcomes(),
            measure: environment.measure(),
            preference: environment.preference(),
            guards: environment.guarded().map_or(&[], |guarded| guarded.guards()),
        }
    }
}

/// A problem that a graph and a network can share.
pub trait Shared: Sync {
    /// Returns the section `[problem]` that describes it, with its name.
    fn table(&self) -> toml::Table;

    /// Returns facts about the problem.
    fn facts(&self) -> Facts;

    /// Lets policies do episodes.
    ///
    /// # Errors
    /// If a policy is not one for this problem.
    fn play(&self, acting: Acting<'_>, episodes: Episodes<'_>) -> Result<HybridResult, InputError>;

    /// Returns the problem's own figures of some episodes.
    fn figures(&self, _endings: &[EpisodeResult]) -> Map<String, Value> {
        Map::new()
    }

    /// Returns the problem's name.
    fn name(&self) -> String {
        self.table().get("name").and_then(toml::Value::as_str).unwrap_or_default().to_owned()
    }
}

impl Shared for Problem {
    fn table(&self) -> toml::Table {
        self.to_table()
    }

    fn facts(&self) -> Facts {
        Facts::new(&&*self.environment::<f32>())
    }

    fn play(&self, acting: Acting<'_>, episodes: Episodes<'_>) -> Result<HybridResult, InputError> {
        match acting {
            Acting::Network((file, network)) => {
                let problem = self.clone().joined(file, &network.settings(), false, true)?;
                let environment = problem.network_environment(0);
                let tasks = match episodes.file {
                    Some(path) => problem.read_tasks(path, true)?,
                    None => episodes.draw(&&*environment),
                };
                run::<f32, Own, _>(&Choices::new(&*environment, None).expect("as they are"), acting, &tasks)
            }
            Acting::Both((_, graph), (file, network), _) => {
                let problem = self.clone().joined(file, &network.settings(), false, true)?;
                in_arithmetic_of!(graph, play_named(&problem, graph, acting, episodes))
            }
            Acting::Graph((_, graph)) => {
                in_arithmetic_of!(graph, play_named(self, graph, acting, episodes))
            }
        }
    }

    fn figures(&self, endings: &[EpisodeResult]) -> Map<String, Value> {
        Problem::figures(self, endings)
    }
}

/// Opens a problem for a graph, whose actions are levels of outputs where it computes none, and passes it to `job`.
///
/// # Errors
/// Those of `job`, or too many levels.
pub(crate) fn opened<S: Number, T>(
    problem: &Problem,
    graph: &Graph,
    job: impl FnOnce(&Choices<S, &Erased<S>>) -> Result<T, InputError>,
) -> Result<T, InputError> {
    let environment = problem.environment::<S>();
    let choices = Choices::new(&*environment, problem.levels_for(graph))
        .map_err(|Finding { key, found, accepted }| InputError::new(key, Place::Whole, found, accepted))?;
    job(&choices)
}

/// A built-in problem's environment.
pub(crate) type Erased<S> = dyn Environment<S, Task = AnyTask, Episode = AnyEpisode> + Send;

fn play_named<S: Number, M: Maths<S>>(
    problem: &Problem,
    graph: &Graph,
    acting: Acting<'_>,
    episodes: Episodes<'_>,
) -> Result<HybridResult, InputError> {
    let tasks = episodes.in_problem(problem)?;
    opened::<S, _>(problem, graph, |choices| run::<S, M, _>(choices, acting, &tasks))
}

/// An environment of your own, in one arithmetic. Graphs with outputs need `Choices` without levels.
///
/// ```
/// use tpg_engine::Choices;
/// use tpg_problems::Pendulum;
/// use tpg_runtime::ops::Own;
/// use tpg_train::{OwnProblem, Shared};
///
/// let swing = OwnProblem::<f32, Own, _>::new("swing", Choices::new(Pendulum, Some(3))?);
/// assert_eq!(swing.name(), "swing");
/// assert!(!swing.facts().has_key, "so cycles cannot be detected");
/// # Ok::<(), tpg_graph::error::Finding>(())
/// ```
#[derive(Debug)]
pub struct OwnProblem<S, M, E> {
    name: String,
    choices: Choices<S, E>,
    maths: PhantomData<fn() -> M>,
}

impl<S: Scalar, M: Maths<S>, E: Environment<S>> OwnProblem<S, M, E> {
    /// Names an environment; its graphs choose among the named actions of `choices`.
    pub fn new(name: &str, choices: Choices<S, E>) -> Self {
        Self { name: name.to_owned(), choices, maths: PhantomData }
    }
}

impl<S: Scalar, M: Maths<S>, E: Environment<S>> Shared for OwnProblem<S, M, E> {
    fn table(&self) -> toml::Table {
        toml::Table::from_iter([("name".to_owned(), self.name.clone().into())])
    }

    fn facts(&self) -> Facts {
        Facts::new(&self.choices)
    }

    fn play(&self, acting: Acting<'_>, episodes: Episodes<'_>) -> Result<HybridResult, InputError> {
        run::<S, M, _>(&self.choices, acting, &episodes.draw(&self.choices))
    }
}
