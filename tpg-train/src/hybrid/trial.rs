//! Trials of a graph, a network, or both together, on any environment.

use super::setting::{Detector, Setting};
use crate::course::{Course, Decision};
use crate::evaluate::graph::endings_on;
use crate::sac::network::Network;
use std::cell::RefCell;
use std::marker::PhantomData;
use tpg_engine::{ActionSpace, Choices, Ending, EngineOptions, Environment, Plan, Single, bind_to};
use tpg_graph::Graph;
use tpg_graph::error::InputError;
use tpg_graph::interpret;
use tpg_runtime::cycle::{Brent, CycleDetector, Visited};
use tpg_runtime::ops::Maths;
use tpg_runtime::policy::{ActionId, Policy};
use tpg_runtime::scalar::Scalar;
use tpg_runtime::switch::{Answer, AskSwitch, CAUSES, Cause, Counts, Hybrid, Patience, Switch, Unguarded};

/// The name by which a graph asks the network beside it.
pub const NETWORK: &str = "network";

/// The policies that act, each with the name that errors show.
#[derive(Clone, Copy, Debug)]
pub enum Acting<'a> {
    /// A graph alone.
    Graph(&'a (String, Graph)),
    /// A network alone.
    Network(&'a (String, Network)),
    /// A graph that hands over to a network, or asks it.
    Both(&'a (String, Graph), &'a (String, Network), &'a Setting),
}

impl<'a> Acting<'a> {
    /// Returns the graph, if one acts.
    pub fn graph(self) -> Option<&'a Graph> {
        match self {
            Self::Graph((_, graph)) | Self::Both((_, graph), ..) => Some(graph),
            Self::Network(_) => None,
        }
    }
}

/// The causes of a hand-over, with their names in tables: no guard refuses and no action rests outside of the arm, so that
/// [`Cause::Stop`] always is a [`Patience`] at its end.
pub const TRIGGERS: [(&str, Cause); 3] = [("drift", Cause::Drift), ("stall", Cause::Stop), ("cycle", Cause::Cycle)];

/// Results of many episodes.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct HybridTrial {
    /// The ending of each episode.
    pub endings: Vec<Ending>,
    /// Fraction of all actions that the graph chose.
    pub tpg_action_ratio: f64,
    /// Actions per episode that the network chose.
    pub network_actions: f64,
    /// Hand-overs per episode, by cause, in the order of [`TRIGGERS`].
    pub hand_overs: [f64; TRIGGERS.len()],
    /// Number of times per episode that the network handed back.
    pub hand_backs: f64,
    /// Actions of each episode that the graph asked the network for; they count as the network's.
    pub asks: Vec<u32>,
}

/// Lets policies do every task.
///
/// # Errors
/// If a policy reads something that the environment does not have, or answers something else than it takes.
pub fn run<S: Scalar, M: Maths<S>, E: Environment<S>>(
    environment: &Choices<S, E>,
    acting: Acting<'_>,
    tasks: &[E::Task],
) -> Result<HybridTrial, InputError> {
    let fit =
        |(file, network): &(String, Network)| network.fit(file, &environment.sources(), &environment.inner().actions());
    let episodes: Vec<Episode> = match acting {
        Acting::Graph((file, graph)) => {
            let endings = endings_on::<S, M, _>(file, graph, environment, tasks)?;
            let counts = |tpg_actions| Counts { tpg_actions, ..Counts::default() };
            endings.into_iter().map(|ending| (ending, counts(ending.actions), 0)).collect()
        }
        Acting::Network(network) => {
            fit(network)?;
            let counts = |sac_actions| Counts { sac_actions, ..Counts::default() };
            network.1.deciding(|decide| {
                let network = NetworkPolicy::new(decide);
                let ending = |task| Course::new(environment, task).run(|state| network.decide(state));
                tasks.iter().map(ending).map(|ending| (ending, counts(ending.actions), 0)).collect()
            })
        }
        Acting::Both(graph, network, setting) => {
            fit(network)?;
            let tpg = GraphPolicy::<S, M>::new(graph, environment, environment.actions().with_ask(NETWORK))?;
            network.1.deciding(|decide| {
                let hybrid = Hybrid { tpg, sac: NetworkPolicy::new(decide) };
                tasks.iter().map(|task| together(environment, task, &hybrid, setting)).collect()
            })
        }
    };
    Ok(HybridTrial::of(&episodes))
}

/// Lets a graph do every task alone; how far the distance lies above the least one so far, after each action.
///
/// # Errors
/// As [`run`].
pub fn rises<S: Scalar, M: Maths<S>, E: Environment<S>>(
    environment: &Choices<S, E>,
    graph: &(String, Graph),
    tasks: &[E::Task],
) -> Result<Vec<f64>, InputError> {
    let graph = GraphPolicy::<S, M>::new(graph, environment, environment.actions())?;
    let mut rises = Vec::new();
    for task in tasks {
        let mut course = Course::new(environment, task);
        let mut least = course.distance().to_f64();
        loop {
            let decision = graph.decision(course.observe());
            if course.act(decision.act()).is_some() {
                break;
            }
            let distance = course.distance().to_f64();
            least = least.min(distance);
            rises.push(distance - least);
        }
    }
    Ok(rises)
}

/// An ending, the counts of the rules, and the number of asks.
type Episode = (Ending, Counts, u32);

/// One episode of both policies.
fn together<S: Scalar, E: Environment<S>, T, P>(
    environment: &E,
    task: &E::Task,
    hybrid: &Hybrid<T, P>,
    setting: &Setting,
) -> Episode
where
    T: Policy<State = [S], Action = Answer<Decision<S>>>,
    P: Policy<State = [S], Action = Decision<S>>,
{
    match setting.detector {
        Detector::None => watched(environment, task, hybrid, setting, Blind),
        Detector::Visited => watched(environment, task, hybrid, setting, Visited::<u64, CAPACITY>::new()),
        Detector::Brent => watched(environment, task, hybrid, setting, Brent::new()),
    }
}

fn watched<S: Scalar, E: Environment<S>, T, P>(
    environment: &E,
    task: &E::Task,
    hybrid: &Hybrid<T, P>,
    setting: &Setting,
    detector: impl CycleDetector<u64>,
) -> Episode
where
    T: Policy<State = [S], Action = Answer<Decision<S>>>,
    P: Policy<State = [S], Action = Decision<S>>,
{
    let mut course = Course::new(environment, task);
    // Without keys the detector is blind.
    let key = |course: &Course<'_, S, E>| course.key().unwrap_or_default();
    let rules = Switch::new(setting.settings::<S>(), detector, key(&course), course.distance());
    let mut switch = AskSwitch::new(rules);
    let mut patience = Patience::new(setting.patience.0, course.distance());
    loop {
        let turn = hybrid.decide_or_ask(&mut switch, course.observe(), &Unguarded);
        if let Some(ending) = course.act(turn.chosen.wanted.act()) {
            switch.ended(&turn);
            return (ending, *switch.counts(), switch.asks());
        }
        let distance = course.distance();
        let stalls = patience.ends(turn.driver(), distance);
        switch.acted(&turn, stalls, key(&course), distance);
    }
}

/// Capacity of the exact set of visited states. A longer episode may miss a repeat.
const CAPACITY: usize = 4096;

/// Detects no cycle.
struct Blind;

impl CycleDetector<u64> for Blind {
    fn reset(&mut self, _: u64) {}

    fn repeats(&mut self, _: u64) -> bool {
        false
    }
}

/// A graph as a policy of an environment.
struct GraphPolicy<S, M> {
    graph: Single<S, M>,
    /// The action that asks the network.
    ask: Option<ActionId>,
}

impl<S: Scalar, M: Maths<S>> GraphPolicy<S, M> {
    fn new(
        (file, graph): &(String, Graph),
        environment: &impl Environment<S>,
        actions: ActionSpace,
    ) -> Result<Self, InputError> {
        let sources = environment.sources();
        let plan = Plan::new::<M>(&bind_to(file, graph, &sources, &actions)?, &sources, EngineOptions::default());
        Ok(Self { graph: Single::new(plan), ask: actions.asking(NETWORK) })
    }

    fn decision(&self, state: &[S]) -> Decision<S> {
        match self.graph.answer(state) {
            interpret::Answer::Action(action) => Decision::Choice(action),
            interpret::Answer::Values(values) => Decision::Values(values.into_iter().map(S::from_f64).collect()),
        }
    }
}

impl<S: Scalar, M: Maths<S>> Policy for GraphPolicy<S, M> {
    type State = [S];
    type Action = Answer<Decision<S>>;

    fn decide(&self, state: &[S]) -> Answer<Decision<S>> {
        match self.decision(state) {
            Decision::Choice(action) if Some(action) == self.ask => Answer::Ask,
            decision => Answer::Act(decision),
        }
    }
}

/// A network as a policy of an environment in any precision: the state is rounded to `f32`.
struct NetworkPolicy<'a, S> {
    network: &'a dyn Fn(&[f32]) -> Decision<f32>,
    state: RefCell<Vec<f32>>,
    precision: PhantomData<S>,
}

impl<'a, S> NetworkPolicy<'a, S> {
    fn new(network: &'a dyn Fn(&[f32]) -> Decision<f32>) -> Self {
        Self { network, state: RefCell::default(), precision: PhantomData }
    }
}

impl<S: Scalar> Policy for NetworkPolicy<'_, S> {
    type State = [S];
    type Action = Decision<S>;

    fn decide(&self, state: &[S]) -> Decision<S> {
        let mut narrow = self.state.borrow_mut();
        narrow.clear();
        narrow.extend(state.iter().map(|value| value.to_f64() as f32));
        (self.network)(&narrow).widened()
    }
}

impl HybridTrial {
    fn of(episodes: &[Episode]) -> Self {
        let (mut tpg, mut sac, mut hand_backs, mut causes) = (0.0, 0.0, 0.0, [0.0; CAUSES]);
        for (_, counts, _) in episodes {
            tpg += f64::from(counts.tpg_actions);
            sac += f64::from(counts.sac_actions);
            hand_backs += f64::from(counts.hand_backs);
            causes.iter_mut().zip(counts.hand_overs).for_each(|(sum, count)| *sum += f64::from(count));
        }
        let count = episodes.len().max(1) as f64;
        Self {
            endings: episodes.iter().map(|(ending, ..)| *ending).collect(),
            tpg_action_ratio: tpg / (tpg + sac).max(1.0),
            network_actions: sac / count,
            hand_overs: TRIGGERS.map(|(_, cause)| causes[cause as usize] / count),
            hand_backs: hand_backs / count,
            asks: episodes.iter().map(|&(_, _, asks)| asks).collect(),
        }
    }
}
