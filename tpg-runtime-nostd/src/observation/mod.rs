//! What a policy sees of the arm and its target, and how that fills a graph's data sources.

mod source;

pub use source::Source;

use crate::arm::{Arm, Move, Pose};
use crate::kinematics::Lattice;
use crate::kinematics::{self, Vector};
use crate::policy::{ActionId, Policy};
use crate::scalar::Scalar;

/// The paper's 13 values: four motor positions, and hand, target and their difference in mm (section 4.2).
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Observation<S> {
    /// Motor positions, ticks.
    pub pose: Pose,
    /// Positions of the servos that never move, ticks.
    pub fixed_servos: [i16; 2],
    /// The hand's tip, mm.
    pub hand: Vector<S>,
    /// The target, mm.
    pub target: Vector<S>,
    /// Target − hand, mm. (The paper prints hand − target; its artifact computed this.)
    pub difference: Vector<S>,
}

impl<S: Lattice> Observation<S> {
    /// From a pose and a hand that was computed already.
    pub fn new(arm: &Arm<S>, pose: Pose, hand: Vector<S>, target: Vector<S>) -> Self {
        let difference = kinematics::difference(target, hand);
        Self { pose, fixed_servos: arm.fixed_servos, hand, target, difference }
    }

    /// Hand to target, mm.
    pub fn distance(&self) -> S {
        kinematics::distance(self.target, self.hand)
    }

    /// What is seen at a pose.
    pub fn at(arm: &Arm<S>, pose: Pose, target: Vector<S>) -> Self {
        Self::new(arm, pose, kinematics::hand(arm, pose), target)
    }
}

impl Source {
    /// The value at `index` of this source, 0 past its [`length`](Self::length).
    pub fn value<S: Scalar>(self, observation: &Observation<S>, index: usize) -> S {
        let ticks = |positions: &[i16], index: usize| positions.get(index).map(|&t| S::from_i32(i32::from(t)));
        let value = match self {
            Self::Target => observation.target.get(index).copied(),
            Self::Difference => observation.difference.get(index).copied(),
            Self::Hand => observation.hand.get(index).copied(),
            Self::Motors => ticks(&observation.pose.0, index),
            Self::Servos => match index.checked_sub(observation.pose.0.len()) {
                None => ticks(&observation.pose.0, index),
                Some(fixed) => ticks(&observation.fixed_servos, fixed),
            },
        };
        value.unwrap_or(S::ZERO)
    }

    /// Writes the values of `sources`, one after another, into `state`; stops where `state` is full.
    pub fn fill<S: Scalar>(sources: &[Self], observation: &Observation<S>, state: &mut [S]) {
        let values =
            sources.iter().flat_map(|&source| (0..source.length()).map(move |index| source.value(observation, index)));
        for (slot, value) in state.iter_mut().zip(values) {
            *slot = value;
        }
    }
}

/// A graph's policy lifted to the arm: it sees an [`Observation`] and answers a [`Move`].
#[derive(Clone, Copy, Debug)]
pub struct ArmPolicy<'a, P> {
    /// The policy over its flat state.
    pub policy: P,
    /// The sources of that state, in order.
    pub sources: &'a [Source],
    /// What each action moves; an action past the end stops.
    pub moves: &'a [Move],
}

impl<S, P, const N: usize> Policy for ArmPolicy<'_, P>
where
    S: Scalar,
    P: Policy<State = [S; N], Action = ActionId>,
{
    type State = Observation<S>;
    type Action = Move;

    fn decide(&self, observation: &Observation<S>) -> Move {
        let mut state = [S::ZERO; N];
        Source::fill(self.sources, observation, &mut state);
        let ActionId(action) = self.policy.decide(&state);
        self.moves.get(usize::from(action)).copied().unwrap_or(Move::STOP)
    }
}
