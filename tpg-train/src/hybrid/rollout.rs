//! Episodes of a graph, a network, or both together, on any environment.

use super::setting::{Detector, Hybrid, Setting};
use crate::effort::{Effort, Meter};
use crate::sac::network::Network;
use std::cell::RefCell;
use std::marker::PhantomData;
use tpg_engine::{
    ActionSpace, Choices, DEFAULT_LANES, Decision, Environment, EpisodeResult, Lanes, Plan, Remembering, Rollout,
    Single, SourceSet, bind, state_length,
};
use tpg_graph::Graph;
use tpg_graph::error::{InputError, Place};
use tpg_graph::interpret;
use tpg_runtime::cycle::{Brent, CycleDetector, Visited};
use tpg_runtime::ops::Maths;
use tpg_runtime::policy::Policy;
use tpg_runtime::scalar::Scalar;
use tpg_runtime::switch::{Answer, AskSwitch, CAUSES, Chosen, Counts, Driver, Guard, NEVER, Pair, Patience, Switch};

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

/// Policies with their files.
#[derive(Clone, Debug)]
pub(crate) enum Policies {
    /// A graph alone.
    Graph(Box<(String, Graph)>),
    /// A network alone.
    Network((String, Network)),
    /// A graph with a network: of a study, or one that learned to ask.
    Both(Box<Hybrid>),
}

impl Policies {
    /// Lets them act.
    pub(crate) fn acting(&self) -> Acting<'_> {
        match self {
            Self::Graph(graph) => Acting::Graph(graph),
            Self::Network(network) => Acting::Network(network),
            Self::Both(hybrid) => Acting::Both(&hybrid.graph, &hybrid.network, &hybrid.setting),
        }
    }
}

/// The names of causes of a hand-over in tables, in the order of [`Counts::hand_overs`].
pub(crate) const TRIGGERS: [&str; CAUSES] = ["guard", "drift", "stall", "cycle"];

/// Results of many episodes.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct HybridResult {
    /// The ending of each episode.
    pub endings: Vec<EpisodeResult>,
    /// Fraction of all actions that the graph chose.
    pub tpg_action_ratio: f64,
    /// Actions per episode that the network chose.
    pub network_actions: f64,
    /// Hand-overs per episode, by cause, in the order of `TRIGGERS`.
    pub hand_overs: [f64; CAUSES],
    /// Number of times per episode that the network handed back.
    pub hand_backs: f64,
    /// Actions of each episode that the graph asked the network for; they count as the network's.
    pub asks: Vec<u32>,
    /// The rise of the distance above its minimum so far, after each action but the last, where two policies act.
    pub rises: Vec<f64>,
    /// Wear of actuators, where one policy acts by outputs.
    pub effort: Option<Effort>,
}

/// Lets policies do every task.
///
/// # Errors
/// If a policy reads something that the environment does not have, or answers something else than it takes.
pub(crate) fn run<S: Scalar, M: Maths<S>, E: Environment<S>>(
    environment: &Choices<S, E>,
    acting: Acting<'_>,
    tasks: &[E::Task],
) -> Result<HybridResult, InputError> {
    let space = environment.actions();
    match acting {
        Acting::Graph(graph) => {
            let remembering = Remembering::for_graph::<S>(environment, &graph.1);
            let plan = plan::<S, M, _>(graph, &remembering)?;
            // In the graph's own units, without its memory.
            let mut meter = Meter::new(&remembering.actions().outputs()[..space.outputs().len()], tasks.len());
            let mut lanes = Lanes::<S, M, _>::new(&remembering, DEFAULT_LANES);
            let endings = lanes.run_watched(&plan, tasks, |task, act| meter.act(task, act)).map_err(|error| {
                InputError::new(&graph.0, Place::Whole, error.to_string(), "episodes that can be run")
            })?;
            Ok(HybridResult { effort: meter.effort(), ..HybridResult::alone(endings, Driver::Tpg) })
        }
        Acting::Network(network) => {
            fit(network, environment)?;
            let mut meter = Meter::new(space.outputs(), tasks.len());
            let decide = network.1.deciding();
            let policy = network_policy(environment, &*decide);
            let mut episode = |(place, task)| {
                let rollout = RefCell::new(Rollout::new(environment, task));
                loop {
                    let decision = policy.decide(&rollout);
                    meter.act(place, decision.act());
                    if let Some(ending) = rollout.borrow_mut().act(decision.act()) {
                        return ending;
                    }
                }
            };
            let endings = tasks.iter().enumerate().map(&mut episode).collect();
            Ok(HybridResult { effort: meter.effort(), ..HybridResult::alone(endings, Driver::Sac) })
        }
        Acting::Both(graph, network, setting) => {
            fit(network, environment)?;
            let tpg = graph_policy::<S, M, _>(graph, environment)?;
            let decide = network.1.deciding();
            let hybrid = Pair { tpg, sac: network_policy(environment, &*decide) };
            let mut rises = Vec::new();
            let episodes = tasks.iter().map(|task| shared(environment, task, &hybrid, setting, &mut rises));
            let result = HybridResult::new(&episodes.collect::<Vec<_>>());
            Ok(HybridResult { rises, ..result })
        }
    }
}

/// Plans a graph that acts alone.
fn plan<S: Scalar, M: Maths<S>, E: Environment<S>>(
    (file, graph): &(String, Graph),
    environment: &E,
) -> Result<Plan<S>, InputError> {
    let sources = environment.sources();
    Ok(Plan::new::<M>(&bind(file, graph, &sources, &environment.actions())?, &sources))
}

fn fit<S: Scalar, E: Environment<S>>(
    (file, network): &(String, Network),
    environment: &Choices<S, E>,
) -> Result<(), InputError> {
    let (sources, actions) = match environment.guarded() {
        Some(guarded) => (guarded.network_sources(), ActionSpace::Box(guarded.network_outputs())),
        None => (environment.sources(), environment.inner().actions()),
    };
    network.fit(file, &sources, &actions)
}

/// Lets a graph do a task alone; returns what a picture needs to know of each moment, from the start on.
///
/// # Errors
/// As [`run`].
pub(crate) fn moments<S: Scalar, M: Maths<S>, E: Environment<S>>(
    environment: &E,
    graph: &(String, Graph),
    task: &E::Task,
) -> Result<Vec<Vec<f64>>, InputError> {
    let single = Single::<S, M>::new(plan::<S, M, _>(graph, environment)?);
    let mut moments = Vec::new();
    let decide = |state: &[S]| single.answer(state).into();
    Rollout::new(environment, task).watch(decide, |episode| moments.push(environment.moment(episode)));
    Ok(moments)
}

/// An ending, the counts of the rules, and the number of asks.
type PlayedEpisode = (EpisodeResult, Counts, u32);

/// An episode that two policies look at.
type State<'e, S, E> = RefCell<Rollout<'e, S, E>>;

/// One episode of both policies; adds how far the distance rises above its least, after each action but the last.
///
/// Where the network never hands back and comes to a state again, it will for ever: that ends the episode, if the environment
/// [says so](Environment::cycle).
fn shared<'e, S: Scalar, E: Environment<S>, T, P>(
    environment: &'e E,
    task: &E::Task,
    hybrid: &Pair<T, P>,
    setting: &Setting,
    rises: &mut Vec<f64>,
) -> PlayedEpisode
where
    T: Policy<State = State<'e, S, E>, Action = Answer<Decision<S>>>,
    P: Policy<State = State<'e, S, E>, Action = Decision<S>>,
{
    let state = RefCell::new(Rollout::new(environment, task));
    // Without keys the detector is blind.
    let (key, distance) = (state.borrow().key(), state.borrow().distance());
    let rules =
        Switch::new(setting.settings::<S>(), AnyDetector::new(setting.detector), key.unwrap_or_default(), distance);
    let mut switch = AskSwitch::new(rules);
    let mut patience = Patience::new(setting.patience.0, distance);
    let mut last_turn: Option<Brent<u64>> = None;
    let mut least = distance.to_f64();
    loop {
        let turn = hybrid.decide_or_ask(&mut switch, &state, &Named(&setting.guard));
        let is_final = turn.chosen.driver == Driver::Sac && !turn.asked && setting.hand_back_after.0 == NEVER;
        let mut rollout = state.borrow_mut();
        if let (true, None, Some(key)) = (is_final, &last_turn, rollout.key()) {
            last_turn.insert(Brent::new()).reset(key);
        }
        if let Some(ending) = rollout.act(turn.chosen.wanted.act()) {
            switch.ended(&turn);
            return (ending, *switch.counts(), switch.asks());
        }
        let (key, distance) = (rollout.key().unwrap_or_default(), rollout.distance());
        least = least.min(distance.to_f64());
        rises.push(distance.to_f64() - least);
        let stalls = patience.ends(turn.driver(), distance);
        switch.acted(&turn, stalls, key, distance);
        if is_final
            && last_turn.as_mut().is_some_and(|detector| detector.repeats(key))
            && let Some(ending) = rollout.cycle(key)
        {
            return (ending, *switch.counts(), switch.asks());
        }
    }
}

/// Capacity of the exact set of visited states. A longer episode may miss a repeat.
const CAPACITY: usize = 4096;

/// The detector of a setting, if it has one.
struct AnyDetector(Option<Box<dyn CycleDetector<u64>>>);

impl AnyDetector {
    fn new(detector: Detector) -> Self {
        Self(match detector {
            Detector::None => None,
            Detector::Visited => Some(Box::new(Visited::<u64, CAPACITY>::new())),
            Detector::Brent => Some(Box::new(Brent::new())),
        })
    }
}

impl CycleDetector<u64> for AnyDetector {
    fn reset(&mut self, key: u64) {
        self.0.iter_mut().for_each(|detector| detector.reset(key));
    }

    fn repeats(&mut self, key: u64) -> bool {
        self.0.as_mut().is_some_and(|detector| detector.repeats(key))
    }
}

/// The environment's guard of that name; environments without guards refuse nothing.
struct Named<'s>(&'s str);

impl<'e, S: Scalar, E: Environment<S>> Guard<State<'e, S, E>, Decision<S>> for Named<'_> {
    fn refuses(&self, state: &State<'e, S, E>, wanted: &Decision<S>) -> bool {
        let rollout = state.borrow();
        rollout.environment().guarded().is_some_and(|guarded| guarded.refuses(self.0, rollout.episode(), wanted.act()))
    }

    fn mend(
        &self,
        state: &State<'e, S, E>,
        mut wanted: Decision<S>,
        again: impl FnOnce() -> Option<Decision<S>>,
    ) -> Chosen<Decision<S>> {
        let is_possible = {
            let rollout = state.borrow();
            match (rollout.environment().guarded(), &mut wanted) {
                (Some(guarded), Decision::Values(values)) => guarded.mend(self.0, rollout.episode(), values),
                _ => true,
            }
        };
        match if is_possible { None } else { again() } {
            Some(wanted) => Chosen { driver: Driver::Tpg, wanted },
            None => Chosen { driver: Driver::Sac, wanted },
        }
    }
}

/// A function as a policy.
struct Deciding<F, State>(F, PhantomData<fn(&State)>);

impl<State, A, F: Fn(&State) -> A> Policy for Deciding<F, State> {
    type State = State;
    type Action = A;

    fn decide(&self, state: &State) -> A {
        (self.0)(state)
    }
}

/// Returns a graph with a network beside it, which it may ask.
fn graph_policy<'e, S: Scalar, M: Maths<S>, E: Environment<S> + 'e>(
    (file, graph): &(String, Graph),
    environment: &E,
) -> Result<impl Policy<State = State<'e, S, E>, Action = Answer<Decision<S>>> + use<'e, S, M, E>, InputError> {
    let (sources, actions) = (environment.sources(), environment.actions().with_ask());
    let plan = Plan::new::<M>(&bind(file, graph, &sources, &actions)?, &sources);
    let (wanted, ask) = (plan.wanted(), actions.asking());
    let single = Single::<S, M>::new(plan);
    let decide = move |state: &State<'e, S, E>| match single.answer(state.borrow_mut().observe(wanted)) {
        interpret::Answer::Action(action) if Some(action) == ask => Answer::Ask,
        answer => Answer::Act(answer.into()),
    };
    Ok(Deciding(decide, PhantomData))
}

/// Returns a network as a policy in any precision: what it sees is rounded to `f32`.
fn network_policy<'e, 'n, S: Scalar, E: Environment<S> + 'e>(
    environment: &E,
    network: &'n dyn Fn(&[f32]) -> Decision<f32>,
) -> impl Policy<State = State<'e, S, E>, Action = Decision<S>> + use<'e, 'n, S, E> {
    let own = environment.guarded().map(|guarded| state_length(&guarded.network_sources()));
    let narrow = RefCell::new(vec![0.0; own.unwrap_or_else(|| state_length(&environment.sources()))]);
    let decide = move |state: &State<'e, S, E>| {
        let (mut rollout, mut narrow) = (state.borrow_mut(), narrow.borrow_mut());
        match rollout.environment().guarded() {
            Some(guarded) => guarded.network_observe(rollout.episode_mut(), &mut narrow),
            None => {
                let seen = rollout.observe(SourceSet::ALL);
                narrow.iter_mut().zip(seen).for_each(|(slot, value)| *slot = value.to_f64() as f32);
            }
        }
        network(&narrow).widened()
    };
    Deciding(decide, PhantomData)
}

impl HybridResult {
    /// Counts what a policy did that acted alone.
    pub fn alone(endings: Vec<EpisodeResult>, driver: Driver) -> Self {
        let counts = |actions| match driver {
            Driver::Tpg => Counts { tpg_actions: actions, ..Counts::default() },
            Driver::Sac => Counts { sac_actions: actions, ..Counts::default() },
        };
        Self::new(&endings.into_iter().map(|ending| (ending, counts(ending.actions), 0)).collect::<Vec<_>>())
    }

    fn new(episodes: &[PlayedEpisode]) -> Self {
        let (mut tpg, mut sac, mut hand_backs, mut hand_overs) = (0.0, 0.0, 0.0, [0.0; CAUSES]);
        for (_, counts, _) in episodes {
            tpg += f64::from(counts.tpg_actions);
            sac += f64::from(counts.sac_actions);
            hand_backs += f64::from(counts.hand_backs);
            hand_overs.iter_mut().zip(counts.hand_overs).for_each(|(sum, count)| *sum += f64::from(count));
        }
        let count = episodes.len().max(1) as f64;
        Self {
            endings: episodes.iter().map(|(ending, ..)| *ending).collect(),
            tpg_action_ratio: tpg / (tpg + sac).max(1.0),
            network_actions: sac / count,
            hand_overs: hand_overs.map(|sum| sum / count),
            hand_backs: hand_backs / count,
            asks: episodes.iter().map(|&(_, _, asks)| asks).collect(),
            ..Self::default()
        }
    }
}
