//! Any problem with one more action: *ask*, which lets a network decide one step, at a price.
//!
//! Evolution on such a problem learns when the network is worth its price. Actions must be named: outputs take levels, as
//! [`Choices`](tpg_engine::Choices) makes them, and the network answers what lies between.

use super::study::Input;
use super::trial::NETWORK;
use crate::course::Decision;
use crate::evolution::config::AskConfig;
use crate::evolution::run::RunError;
use crate::sac::network::Network;
use std::path::Path;
use tpg_codegen::policy::QuantisedPolicy;
use tpg_engine::random::Stream;
use tpg_engine::{Act, ActionSpace, End, Environment, Measure, Preference, SourceSet, Step};
use tpg_graph::SourceDocument;
use tpg_graph::error::{Finding, InputError, Place};
use tpg_problems::Problem;
use tpg_runtime::scalar::Scalar;

/// Reads the network that a configuration asks on a problem, and writes its checksum into the configuration.
///
/// # Errors
/// If the problem is the arm's; if the file cannot be read, is no network in integers, is none for the problem, or is
/// not the one that the configuration's checksum names.
pub fn read(ask: &mut AskConfig, problem: &Problem) -> Result<QuantisedPolicy, RunError> {
    let name = problem.name();
    if name.start().is_some() {
        let accepted = "a problem but the arm's, whose hybrid has rules and a guard";
        return Err(Finding::new("ask", format!("a section [ask] for {}", name.name()), accepted).into());
    }
    let refuse = |found: String, accepted: &str| InputError::new(&ask.policy, Place::Whole, found, accepted);
    let path = Path::new(&ask.policy);
    let network = Network::read(path)?;
    let environment = problem.environment::<f32>();
    network.fit(&ask.policy, &environment.sources(), &environment.actions())?;
    let Network::Fixed(policy) = network else {
        let accepted = "a policy.q.json, as `tpg-train quantise` writes it: the network that ships";
        return Err(refuse("a network in floating point".to_owned(), accepted).into());
    };
    let sha256 = Input::read(path)?.sha256;
    if let Some(known) = ask.sha256.as_ref().filter(|known| **known != sha256) {
        return Err(refuse(format!("sha256 {sha256}"), &format!("{known}, as ask.sha256 says")).into());
    }
    ask.sha256 = Some(sha256);
    Ok(*policy)
}

/// An environment with named actions, and one more that asks a network.
///
/// Policies are ranked by score, from which each ask takes its price. Asks are repeated in a cycle, so that no episode is
/// cut short by one.
///
/// ```
/// use tpg_engine::{Act, Environment};
/// use tpg_problems::CartPole;
/// use tpg_runtime::policy::ActionId;
/// use tpg_train::course::Decision;
/// use tpg_train::hybrid::asking::Asking;
///
/// // A network that pushes where the pole is falling; inputs are x, v, theta and omega.
/// let network = |state: &[f32]| Decision::Choice(ActionId((state[2] + state[3] > 0.0).into()));
/// let asking = Asking::new(CartPole, network, 0.25);
/// let task = Environment::<f32>::validation_tasks(&asking, 1).remove(0);
/// let mut episode = Environment::<f32>::start(&asking, &task);
/// // Actions: left, right, ask. A step that the pole stands earns 1.
/// let reward = |episode: &mut _, action| Environment::<f32>::step(&asking, episode, Act::Choice(ActionId(action))).reward;
/// assert_eq!((reward(&mut episode, 0), reward(&mut episode, 2)), (1.0, 0.75));
/// ```
#[derive(Clone, Debug)]
pub struct Asking<E, P> {
    environment: E,
    network: P,
    price: f64,
}

impl<E, P: Fn(&[f32]) -> Decision<f32> + Sync> Asking<E, P> {
    /// Adds asking to an environment. The network decides for the flat state, as the environment takes its actions; each
    /// ask costs `price`, in the score's unit.
    pub fn new(environment: E, network: P, price: f64) -> Self {
        Self { environment, network, price }
    }
}

impl<S: Scalar, E: Environment<S>, P: Fn(&[f32]) -> Decision<f32> + Sync> Environment<S> for Asking<E, P> {
    type Task = E::Task;
    type Episode = E::Episode;

    /// The environment's actions, then the one that asks.
    ///
    /// # Panics
    /// If the environment's actions are not named.
    fn actions(&self) -> ActionSpace {
        let space = self.environment.actions();
        assert!(space.count().is_some(), "actions are named: tpg_engine::Choices names them");
        space.with_ask(NETWORK)
    }

    fn step(&self, episode: &mut E::Episode, act: Act<'_, S>) -> Step {
        if self.environment.actions().count() != Some(act.choice()) {
            return self.environment.step(episode, act);
        }
        let mut state = vec![S::ZERO; self.sources().iter().map(|source| source.length as usize).sum()];
        self.environment.observe(episode, SourceSet::ALL, &mut state);
        let state: Vec<f32> = state.iter().map(|value| value.to_f64() as f32).collect();
        let step = self.environment.step(episode, (self.network)(&state).widened().act());
        Step { reward: step.reward - self.price, ..step }
    }

    fn preference(&self) -> Preference {
        Preference::Score
    }

    fn sources(&self) -> Vec<SourceDocument> {
        self.environment.sources()
    }
    fn time_limit(&self) -> u32 {
        self.environment.time_limit()
    }
    fn draw(&self, stream: &mut Stream) -> E::Task {
        self.environment.draw(stream)
    }
    fn start(&self, task: &E::Task) -> E::Episode {
        self.environment.start(task)
    }
    fn observe(&self, episode: &mut E::Episode, wanted: SourceSet, state: &mut [S]) {
        self.environment.observe(episode, wanted, state);
    }
    fn outcomes(&self) -> &'static [&'static str] {
        self.environment.outcomes()
    }
    fn timeout(&self, episode: &E::Episode) -> End {
        self.environment.timeout(episode)
    }
    fn measure(&self) -> Option<Measure> {
        self.environment.measure()
    }
    fn rougher(&self, task: E::Task, factor: u8) -> E::Task {
        self.environment.rougher(task, factor)
    }
    fn validation_tasks(&self, count: usize) -> Vec<E::Task> {
        self.environment.validation_tasks(count)
    }
    fn trial_tasks(&self, stream: &mut Stream, count: usize) -> Vec<E::Task> {
        self.environment.trial_tasks(stream, count)
    }
    fn task_from(&self, episode: &E::Episode) -> Option<E::Task> {
        self.environment.task_from(episode)
    }
    fn constants(&self) -> Vec<u16> {
        self.environment.constants()
    }
    fn bid_bounds(&self) -> Option<usize> {
        self.environment.bid_bounds()
    }
    fn accepts(&self, task: &E::Task) -> bool {
        self.environment.accepts(task)
    }
    fn distance(&self, episode: &E::Episode) -> Option<f64> {
        self.environment.distance(episode)
    }
}
