//! Any problem with one more action: *ask*, which lets a network decide one step, at a price.
//!
//! Evolution on such a problem learns when the network is worth its price. Actions must be named: outputs take levels, as
//! [`Choices`](tpg_engine::Choices) makes them, and the network answers what lies between.

use crate::evolution::config::AskConfig;
use crate::evolution::run::RunError;
use crate::folder::frame::checksum;
use crate::sac::network::Network;
use std::fs;
use std::path::Path;
use tpg_codegen::policy::QuantisedPolicy;
use tpg_engine::{Act, ActionSpace, Decision, Environment, Preference, SourceSet, Step, state_length};
use tpg_graph::error::{Finding, InputError, Place};
use tpg_problems::Problem;
use tpg_runtime::scalar::Scalar;

/// Reads the network that a configuration asks on a problem, and writes its checksum into the configuration.
///
/// # Errors
/// If the problem has a guard; if the file cannot be read, is no network in integers, is none for the problem, or is not the one
/// that the configuration's checksum names.
pub(crate) fn read(ask: &mut AskConfig, problem: &Problem) -> Result<QuantisedPolicy, RunError> {
    let refuse = |found: String, accepted: &str| InputError::new(&ask.policy, Place::Whole, found, accepted);
    let path = Path::new(&ask.policy);
    let environment = problem.environment::<f32>();
    if environment.guarded().is_some() {
        let found = format!("a section [ask] for {}", problem.name().name());
        return Err(Finding::new("ask", found, "a problem whose hybrid has no guard").into());
    }
    let network = Network::read(path)?;
    network.fit(&ask.policy, &environment.sources(), &environment.actions())?;
    let Network::Fixed(policy) = network else {
        let accepted = "a policy.q.json, as `tpg-train quantise` writes it: the network that ships";
        return Err(refuse("a network in floating point".to_owned(), accepted).into());
    };
    let sha256 = checksum(fs::read(path).map_err(|error| InputError::io(path, &error, "a network"))?);
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
/// use tpg_engine::{Act, Decision, Environment};
/// use tpg_problems::CartPole;
/// use tpg_runtime::policy::ActionId;
/// use tpg_train::Asking;
///
/// // A network that pushes where the pole is falling; inputs are x, v, theta and omega.
/// let network = |state: &[f32]| Decision::Choice(ActionId((state[2] + state[3] > 0.0).into()));
/// let asking = Asking::new::<f32>(CartPole, network, 0.25);
/// let task = tpg_engine::tasks::<f32, _>(&asking, tpg_engine::TaskSet::Validation, 0, 1).remove(0);
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
    /// The number of the action that asks, behind the environment's own.
    ask: usize,
    /// The number of values of the environment's flat state: what the network sees.
    length: usize,
}

impl<E, P: Fn(&[f32]) -> Decision<f32> + Sync> Asking<E, P> {
    /// Adds asking to an environment. The network decides for the flat state, as the environment takes its actions; each
    /// ask costs `price`, in the score's unit.
    ///
    /// # Panics
    /// If the environment's actions are not named: [`Choices`](tpg_engine::Choices) names them.
    pub fn new<S: Scalar>(environment: E, network: P, price: f64) -> Self
    where
        E: Environment<S>,
    {
        let ask = environment.actions().count().expect("actions are named: tpg_engine::Choices names them");
        let length = state_length(&environment.sources());
        Self { environment, network, price, ask, length }
    }
}

impl<S: Scalar, E: Environment<S>, P: Fn(&[f32]) -> Decision<f32> + Sync> Environment<S> for Asking<E, P> {
    type Task = E::Task;
    type Episode = E::Episode;

    tpg_engine::forward!(this => this.environment;
        time_limit draw outcomes measure accepts sources start observe timeout training task_from distance);

    /// The environment's actions, then the one that asks.
    fn actions(&self) -> ActionSpace {
        self.environment.actions().with_ask()
    }

    fn step(&self, episode: &mut E::Episode, act: Act<'_, S>) -> Step {
        if act.choice() != self.ask {
            return self.environment.step(episode, act);
        }
        let mut state = vec![S::ZERO; self.length];
        self.environment.observe(episode, SourceSet::ALL, &mut state);
        let state: Vec<f32> = state.iter().map(|value| value.to_f64() as f32).collect();
        let step = self.environment.step(episode, (self.network)(&state).widened().act());
        Step { reward: step.reward - self.price, ..step }
    }

    fn preference(&self) -> Preference {
        Preference::Score
    }
}
