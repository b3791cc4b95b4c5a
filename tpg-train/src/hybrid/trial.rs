//! Trials of a graph, a network, or both together, on any environment.

use super::setting::{Detector, Setting};
use crate::course::{Course, Decision};
use crate::evaluate::graph::endings_on;
use crate::sac::network::Network;
use std::cell::RefCell;
use std::marker::PhantomData;
use tpg_engine::random::{Purpose, Stream};
use tpg_engine::{ActionSpace, Choices, Ending, EngineOptions, Environment, Plan, Single, SourceDocument, bind_to};
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
    /// A graph, and a network in a share of the actions, 0 to 1, that are drawn: what every switch must beat.
    Mixture(&'a (String, Graph), &'a (String, Network), f64),
}

impl<'a> Acting<'a> {
    /// Returns the graph, if one acts.
    pub fn graph(self) -> Option<&'a Graph> {
        match self {
            Self::Graph((_, graph)) | Self::Both((_, graph), ..) | Self::Mixture((_, graph), ..) => Some(graph),
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
                let network = NetworkPolicy::of(environment, decide);
                let ending = |task| Course::new(environment, task).run(|state| network.decide(state));
                tasks.iter().map(ending).map(|ending| (ending, counts(ending.actions), 0)).collect()
            })
        }
        Acting::Both(graph, network, setting) => {
            fit(network)?;
            let tpg = GraphPolicy::<S, M>::asking(graph, environment)?;
            network.1.deciding(|decide| {
                let hybrid = Hybrid { tpg, sac: NetworkPolicy::of(environment, decide) };
                tasks.iter().map(|task| together(environment, task, &hybrid, setting)).collect()
            })
        }
        Acting::Mixture(graph, network, share) => {
            fit(network)?;
            let graph = GraphPolicy::<S, M>::alone(graph, environment)?;
            network.1.deciding(|decide| {
                let network = NetworkPolicy::of(environment, decide);
                let drawn = |index| Stream::new(0, 0, Purpose::Mixture, index);
                let episode = |(index, task)| mixed(environment, task, &graph, &network, share, drawn(index));
                (0..).zip(tasks).map(episode).collect()
            })
        }
    };
    Ok(HybridTrial::of(&episodes))
}

/// Lets a graph do every task, by itself or with a network that it asks; how far the distance lies above the least one so
/// far, after each action.
///
/// # Errors
/// As [`run`].
pub fn rises<S: Scalar, M: Maths<S>, E: Environment<S>>(
    environment: &Choices<S, E>,
    graph: &(String, Graph),
    network: &(String, Network),
    tasks: &[E::Task],
) -> Result<Vec<f64>, InputError> {
    let graph = GraphPolicy::<S, M>::asking(graph, environment)?;
    Ok(network.1.deciding(|decide| {
        let hybrid = Hybrid { tpg: graph, sac: NetworkPolicy::of(environment, decide) };
        let mut rises = Vec::new();
        for task in tasks {
            let mut least: Option<f64> = None;
            watched(environment, task, &hybrid, &Setting::ONLY_ASKS, Blind, |distance| {
                let known = least.map(|least| least.min(distance));
                rises.extend(known.map(|least| distance - least));
                least = known.or(Some(distance));
            });
        }
        rises
    }))
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
        Detector::None => watched(environment, task, hybrid, setting, Blind, |_| ()),
        Detector::Visited => watched(environment, task, hybrid, setting, Visited::<u64, CAPACITY>::new(), |_| ()),
        Detector::Brent => watched(environment, task, hybrid, setting, Brent::new(), |_| ()),
    }
}

/// One episode in which a draw decides who acts.
fn mixed<S: Scalar, M: Maths<S>, E: Environment<S>>(
    environment: &E,
    task: &E::Task,
    graph: &GraphPolicy<S, M>,
    network: &NetworkPolicy<'_, S>,
    share: f64,
    mut draw: Stream,
) -> Episode {
    let mut counts = Counts::default();
    let ending = Course::new(environment, task).run(|state| {
        if draw.unit() < share {
            counts.sac_actions += 1;
            network.decide(state)
        } else {
            counts.tpg_actions += 1;
            graph.decision(state)
        }
    });
    (ending, counts, 0)
}

/// One episode of both policies; `seen` is told the distance at the start and behind each action but the last.
fn watched<S: Scalar, E: Environment<S>, T, P>(
    environment: &E,
    task: &E::Task,
    hybrid: &Hybrid<T, P>,
    setting: &Setting,
    detector: impl CycleDetector<u64>,
    mut seen: impl FnMut(f64),
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
    seen(course.distance().to_f64());
    let mut state = Vec::new();
    loop {
        state.clear();
        state.extend_from_slice(course.observe());
        let turn = hybrid.decide_or_ask(&mut switch, &state, &Unguarded);
        if let Some(ending) = course.act(turn.chosen.wanted.act()) {
            switch.ended(&turn);
            return (ending, *switch.counts(), switch.asks());
        }
        let distance = course.distance();
        seen(distance.to_f64());
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

/// A graph as a policy of an environment, of its flat state.
struct GraphPolicy<S, M> {
    graph: Single<S, M>,
    /// The action that asks the network.
    ask: Option<ActionId>,
}

impl<S: Scalar, M: Maths<S>> GraphPolicy<S, M> {
    /// A graph that acts alone.
    fn alone(graph: &(String, Graph), environment: &impl Environment<S>) -> Result<Self, InputError> {
        Self::new(graph, &environment.sources(), &environment.actions())
    }

    /// A graph with a network beside it, which it may ask.
    fn asking(graph: &(String, Graph), environment: &impl Environment<S>) -> Result<Self, InputError> {
        Self::new(graph, &environment.sources(), &environment.actions().with_ask(NETWORK))
    }

    fn new(
        (file, graph): &(String, Graph),
        sources: &[SourceDocument],
        actions: &ActionSpace,
    ) -> Result<Self, InputError> {
        let plan = Plan::new::<M>(&bind_to(file, graph, sources, actions)?, sources, EngineOptions::default());
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

/// A network as a policy of an environment in any precision: the state is rounded to `f32`. It reads no further than its
/// inputs.
struct NetworkPolicy<'a, S> {
    network: &'a dyn Fn(&[f32]) -> Decision<f32>,
    inputs: usize,
    state: RefCell<Vec<f32>>,
    precision: PhantomData<S>,
}

impl<'a, S: Scalar> NetworkPolicy<'a, S> {
    fn of(environment: &impl Environment<S>, network: &'a dyn Fn(&[f32]) -> Decision<f32>) -> Self {
        let inputs = environment.sources().iter().map(|source| source.length as usize).sum();
        Self { network, inputs, state: RefCell::default(), precision: PhantomData }
    }
}

impl<S: Scalar> Policy for NetworkPolicy<'_, S> {
    type State = [S];
    type Action = Decision<S>;

    fn decide(&self, state: &[S]) -> Decision<S> {
        let mut narrow = self.state.borrow_mut();
        narrow.clear();
        narrow.extend(state[..self.inputs].iter().map(|value| value.to_f64() as f32));
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
