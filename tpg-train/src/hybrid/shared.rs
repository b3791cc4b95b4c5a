//! Problems whose episodes a graph and a network can share: the built-in ones, and any other environment.

use super::trial::{Acting, HybridTrial, rises, run};
use crate::sac::network::Network;
use std::marker::PhantomData;
use tpg_engine::random::{Purpose, Stream};
use tpg_engine::{Choices, Environment, Measure, Preference};
use tpg_graph::Graph;
use tpg_graph::error::{InputError, Place};
use tpg_graph::in_arithmetic_of;
use tpg_problems::{Number, Problem};
use tpg_runtime::ops::{Maths, Own};
use tpg_runtime::scalar::Scalar;

/// Episodes drawn from a stream of their own.
#[derive(Clone, Copy, Debug)]
pub struct Episodes {
    /// [`Purpose::Selection`] for validation, [`Purpose::Evaluation`] for tests.
    pub purpose: Purpose,
    /// Number of episodes.
    pub count: usize,
    /// Their seed.
    pub seed: u64,
}

impl Episodes {
    fn tasks<S: Scalar, E: Environment<S>>(&self, environment: &E) -> Vec<E::Task> {
        let draw = |index| environment.draw(&mut Stream::new(self.seed, 0, self.purpose, index));
        (0..self.count as u64).map(draw).collect()
    }
}

/// The facts about a problem that a study and a report need.
#[derive(Clone, Copy, Debug)]
pub struct Facts {
    /// The maximum number of actions in an episode.
    pub time_limit: u32,
    /// True if the environment has keys, so that cycles can be detected.
    pub has_key: bool,
    /// The ways in which an episode can end.
    pub outcomes: &'static [&'static str],
    /// The quantity reported in addition to the score.
    pub measure: Option<Measure>,
    /// The criterion by which policies are ranked.
    pub preference: Preference,
}

impl Facts {
    fn of<S: Scalar>(environment: &impl Environment<S>) -> Self {
        let task = environment.draw(&mut Stream::new(0, 0, Purpose::Selection, 0));
        Self {
            time_limit: environment.time_limit(),
            has_key: environment.key(&environment.start(&task)).is_some(),
            outcomes: environment.outcomes(),
            measure: environment.measure(),
            preference: environment.preference(),
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
    fn trial(&self, acting: Acting<'_>, episodes: Episodes) -> Result<HybridTrial, InputError>;

    /// Returns the [`rises`] of a graph's episodes; the network is there for a graph that asks.
    ///
    /// # Errors
    /// If the graph is not one for this problem.
    fn rises(
        &self,
        graph: &(String, Graph),
        network: &(String, Network),
        episodes: Episodes,
    ) -> Result<Vec<f64>, InputError>;

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
        Facts::of(&&*self.environment::<f32>())
    }

    fn trial(&self, acting: Acting<'_>, episodes: Episodes) -> Result<HybridTrial, InputError> {
        let trial = Trial { acting, episodes };
        match acting.graph() {
            Some(graph) => in_arithmetic_of!(graph, trial.opened(self)),
            None => trial.opened::<f32, Own>(self),
        }
    }

    fn rises(
        &self,
        graph: &(String, Graph),
        network: &(String, Network),
        episodes: Episodes,
    ) -> Result<Vec<f64>, InputError> {
        let rises = Rises { graph, network, episodes };
        in_arithmetic_of!(graph.1, rises.opened(self))
    }
}

/// A job on an environment with named actions, in any arithmetic.
trait Job {
    type Output;

    /// Returns the graph that acts, if one does.
    fn graph(&self) -> Option<&Graph>;

    fn run<S: Scalar, M: Maths<S>, E: Environment<S>>(
        self,
        choices: &Choices<S, E>,
    ) -> Result<Self::Output, InputError>;

    /// Runs the job on a built-in problem.
    fn opened<S: Number, M: Maths<S>>(self, problem: &Problem) -> Result<Self::Output, InputError>
    where
        Self: Sized,
    {
        let levels = self.graph().and_then(|graph| problem.levels_for(graph));
        let environment = problem.environment::<S>();
        let choices = Choices::new(&*environment, levels)
            .map_err(|error| InputError::new("problem", Place::Whole, error.to_string(), "fewer problem.levels"))?;
        self.run::<S, M, _>(&choices)
    }
}

struct Trial<'a> {
    acting: Acting<'a>,
    episodes: Episodes,
}

impl Job for Trial<'_> {
    type Output = HybridTrial;

    fn graph(&self) -> Option<&Graph> {
        self.acting.graph()
    }

    fn run<S: Scalar, M: Maths<S>, E: Environment<S>>(
        self,
        choices: &Choices<S, E>,
    ) -> Result<HybridTrial, InputError> {
        run::<S, M, _>(choices, self.acting, &self.episodes.tasks(choices))
    }
}

struct Rises<'a> {
    graph: &'a (String, Graph),
    network: &'a (String, Network),
    episodes: Episodes,
}

impl Job for Rises<'_> {
    type Output = Vec<f64>;

    fn graph(&self) -> Option<&Graph> {
        Some(&self.graph.1)
    }

    fn run<S: Scalar, M: Maths<S>, E: Environment<S>>(self, choices: &Choices<S, E>) -> Result<Vec<f64>, InputError> {
        rises::<S, M, _>(choices, self.graph, self.network, &self.episodes.tasks(choices))
    }
}

/// An environment of your own, in one arithmetic. Graphs with outputs need `Choices` without levels.
///
/// ```
/// use tpg_engine::Choices;
/// use tpg_problems::Pendulum;
/// use tpg_runtime::ops::Own;
/// use tpg_train::hybrid::shared::{OwnProblem, Shared};
///
/// let swing = OwnProblem::<f32, Own, _>::new("swing", Choices::new(Pendulum, Some(3))?);
/// assert_eq!(swing.name(), "swing");
/// assert!(!swing.facts().has_key, "so cycles cannot be detected");
/// # Ok::<(), tpg_engine::TooManyActions>(())
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
        Facts::of(&self.choices)
    }

    fn trial(&self, acting: Acting<'_>, episodes: Episodes) -> Result<HybridTrial, InputError> {
        Trial { acting, episodes }.run::<S, M, _>(&self.choices)
    }

    fn rises(
        &self,
        graph: &(String, Graph),
        network: &(String, Network),
        episodes: Episodes,
    ) -> Result<Vec<f64>, InputError> {
        Rises { graph, network, episodes }.run::<S, M, _>(&self.choices)
    }
}
