//! The paper's hybrids, replayed: the project's own hand-over logic in the artifact's environment.
//!
//! The artifact did not seed the actors' random numbers here. Everything before the first hand-over is deterministic
//! and must be exact; the rest can only be compared statistically.

use crate::support::sac::act;
use crate::support::torch_random::TorchRandom;
use serde::Deserialize;
use std::cell::RefCell;
use std::collections::HashSet;
use std::path::Path;
use tpg_arm::cycle::CycleDetector;
use tpg_arm::hybrid::{Driver, Hybrid, Switch};
use tpg_arm::observation::Observation;
use tpg_arm::{Move, Pose};
use tpg_paper::actor::RecordedActor;
use tpg_paper::chain::Chain;
use tpg_paper::data::{End, Task, rows};
use tpg_paper::episode::{EndState, Rules};
use tpg_paper::plane;
use tpg_runtime::policy::Policy;

/// A recorded end of a hybrid's episode, with the pair and the setting.
#[derive(Clone, Copy, Debug)]
pub(crate) struct HybridEnd {
    /// Seed of the graph.
    pub(crate) tpg_seed: u32,
    /// Seed of the actor.
    pub(crate) sac_seed: u32,
    /// Distance from the best so far at which the network takes over, mm; infinite: never.
    pub(crate) separation_mm: f64,
    /// Actions after which the graph drives again.
    pub(crate) hand_back_after: u32,
    /// Row of the targets file.
    pub(crate) row: u32,
    /// End, with the number of the graph's actions.
    pub(crate) end: End,
}

#[derive(Deserialize)]
struct HybridRow {
    tpg_seed: u32,
    sac_seed: u32,
    sep_mm: f64,
    nb_it: u32,
    #[serde(flatten)]
    end: End,
}

/// The recorded separation that stands for none.
const NO_SEPARATION: f64 = 10_000.0;

/// Reads the recorded ends of hybrids.
pub(crate) fn hybrid_ends(path: &Path) -> Vec<HybridEnd> {
    let end = |HybridRow { tpg_seed, sac_seed, sep_mm, nb_it, end }| {
        let separation_mm = if sep_mm == NO_SEPARATION { f64::INFINITY } else { sep_mm };
        HybridEnd { tpg_seed, sac_seed, separation_mm, hand_back_after: nb_it, row: end.row, end }
    };
    rows(path).expect("recorded ends").into_iter().map(end).collect()
}

/// The artifact's set of visited poses, which does not contain the start.
#[derive(Clone, Debug, Default)]
pub(crate) struct Memory(HashSet<Pose>);

impl CycleDetector<Pose> for Memory {
    fn reset(&mut self, _start: Pose) {
        self.0.clear();
    }

    fn repeats(&mut self, pose: Pose) -> bool {
        !self.0.insert(pose)
    }
}

/// A recorded actor that samples its actions.
#[derive(Debug)]
pub(crate) struct Sampled<'a> {
    actor: &'a RecordedActor,
    random: RefCell<TorchRandom>,
}

impl<'a> Sampled<'a> {
    /// Creates the policy of an actor with random numbers of the given seed.
    pub(crate) fn new(actor: &'a RecordedActor, seed: u64) -> Self {
        Self { actor, random: RefCell::new(TorchRandom::new(seed)) }
    }
}

impl Policy for Sampled<'_> {
    type State = Observation<f64>;
    type Action = Move;

    fn decide(&self, seen: &Observation<f64>) -> Move {
        act(self.actor, seen, &mut self.random.borrow_mut())
    }
}

/// Result of an episode.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) struct HybridDone {
    /// End state by the artifact's rules.
    pub(crate) end: EndState,
    /// Number of actions chosen by the graph.
    pub(crate) tpg_actions: u32,
}

/// The deterministic part of an episode.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Determined {
    /// The graph ended it.
    Whole(EndState),
    /// The network took over after this number of actions.
    FirstHandOver(u32),
}

/// Runs an episode to its end, or to the first hand-over.
pub(crate) fn determined<T, P>(chain: &Chain, rules: Rules, task: &Task, hybrid: &Hybrid<'_, f64, T, P>) -> Determined
where
    T: Policy<State = Observation<f64>, Action = Move>,
    P: Policy<State = Observation<f64>, Action = Move>,
{
    match go(chain, rules, task, hybrid, true) {
        (Some(end), _) => Determined::Whole(end),
        (None, actions) => Determined::FirstHandOver(actions),
    }
}

/// Runs an episode to its end.
pub(crate) fn episode<T, P>(chain: &Chain, rules: Rules, task: &Task, hybrid: &Hybrid<'_, f64, T, P>) -> HybridDone
where
    T: Policy<State = Observation<f64>, Action = Move>,
    P: Policy<State = Observation<f64>, Action = Move>,
{
    let (end, tpg_actions) = go(chain, rules, task, hybrid, false);
    HybridDone { end: end.expect("only a determined part stops early"), tpg_actions }
}

/// Returns the end state, unless the episode stopped at the first hand-over, and the number of the graph's actions.
fn go<T, P>(
    chain: &Chain,
    rules: Rules,
    task: &Task,
    hybrid: &Hybrid<'_, f64, T, P>,
    stop_at_hand_over: bool,
) -> (Option<EndState>, u32)
where
    T: Policy<State = Observation<f64>, Action = Move>,
    P: Policy<State = Observation<f64>, Action = Move>,
{
    let arm = chain.arm();
    let mut seen = Observation::new(arm, task.start, chain.hand(task.start), task.target);
    let mut switch = Switch::new(hybrid.settings, Memory::default(), &seen);
    for actions in 1.. {
        if stop_at_hand_over && switch.driver() == Driver::Sac {
            break;
        }
        let chosen = hybrid.decide(&mut switch, &seen);
        let step = arm.step_with(seen.pose, chosen.wanted, |pose| plane::collision(arm, pose));
        seen = Observation::new(arm, step.pose, chain.hand(step.pose), task.target);
        let collision = step.invalid.is_some();
        if collision || seen.distance() < rules.tolerance || actions >= rules.max_actions {
            switch.ended(chosen);
            let end = rules.end(seen.distance(), collision, actions);
            return (Some(end), switch.counts().tpg_actions);
        }
        switch.acted(chosen, &seen);
    }
    (None, switch.counts().tpg_actions)
}
