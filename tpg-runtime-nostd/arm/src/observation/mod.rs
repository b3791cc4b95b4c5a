//! The observation of arm and target, and the data sources of a graph that it fills.

mod memo;
mod range;
mod reach;
pub(crate) mod seen;
mod source;
mod stance;
mod straight;

pub use memo::TargetMemo;
pub use seen::Observation;
pub use source::Source;
pub use straight::{STEP, Straight};

use crate::arm::{Arm, Move};
use crate::frame::Frame;
use crate::kinematics::Lattice;
use core::hint::black_box;
use core::mem::MaybeUninit;
use tpg_runtime::policy::{ActionId, Policy};

impl Source {
    /// Writes the values of `sources`, one after another, into `state`; stops where `state` is full.
    ///
    /// `memo` belongs to this arm. What it keeps changes no value; with a new one each time everything is computed anew.
    pub fn fill<S: Lattice>(
        sources: &[Self],
        arm: &Arm<S>,
        seen: &Observation<S>,
        memo: &TargetMemo<S>,
        state: &mut [S],
    ) {
        Self::fill_each(sources.iter().copied(), arm, seen, memo, state);
    }

    /// [`fill`](Self::fill) for sources that do not lie in an array, into memory that need not be initialised.
    #[inline]
    pub fn fill_each<S: Lattice, W: Slot<S>>(
        sources: impl Iterator<Item = Self>,
        arm: &Arm<S>,
        seen: &Observation<S>,
        memo: &TargetMemo<S>,
        state: &mut [W],
    ) {
        let mut rest = state;
        for source in sources {
            // To keep a frame would cost as much as to compute it. The compiler shall not compute before the loop what only some
            // sources need.
            let (arm, seen) = black_box((arm, seen));
            source.write_with(arm, seen, memo, || Frame::new(arm, seen), rest);
            let length = source.length().min(rest.len());
            rest = &mut rest[length..];
        }
    }

    /// Writes this source's values; stops where `values` is full. The frame is known already, or computed where it is needed.
    #[inline(always)]
    pub fn write_with<'a, S: Lattice, W: Slot<S>>(
        self,
        arm: &Arm<S>,
        seen: &Observation<S>,
        memo: &TargetMemo<S>,
        frame: impl FnOnce() -> Frame<'a, S>,
        values: &mut [W],
    ) {
        match self {
            Self::Target => put(values, seen.target),
            Self::Difference => put(values, seen.difference),
            Self::Hand => put(values, seen.hand),
            Self::Motors => put(values, seen.pose.0.map(ticks)),
            Self::Servos => {
                let [a, b, c, d] = seen.pose.0;
                let [e, f] = seen.fixed_servos;
                put(values, [a, b, c, d, e, f].map(ticks));
            }
            Self::Polar => put(values, frame().polar_errors()),
            Self::Floor => put(values, [frame().lowest_corner()]),
            Self::Stance => {
                let [base, shoulder, elbow, wrist] = memo.stance(arm, seen.target);
                let [a, b, c, d] = seen.pose.0.map(ticks::<S>);
                put(values, [base - a, shoulder - b, elbow - c, wrist - d]);
            }
        }
    }
}

/// A place that a value can be written to.
pub trait Slot<S> {
    /// Writes the value.
    fn put(&mut self, value: S);
}

impl<S: Lattice> Slot<S> for S {
    #[inline(always)]
    fn put(&mut self, value: S) {
        *self = value;
    }
}

impl<S: Lattice> Slot<S> for MaybeUninit<S> {
    #[inline(always)]
    fn put(&mut self, value: S) {
        self.write(value);
    }
}

#[inline(always)]
fn put<S, W: Slot<S>, const N: usize>(slots: &mut [W], values: [S; N]) {
    for (slot, value) in slots.iter_mut().zip(values) {
        slot.put(value);
    }
}

#[inline(always)]
fn ticks<S: Lattice>(ticks: i16) -> S {
    S::from_i32(i32::from(ticks))
}

/// A graph's policy lifted to the arm: it sees an [`Observation`] and answers a [`Move`].
///
/// It keeps what it has computed about the target, so it is for one thread; a clone serves another.
#[derive(Clone, Debug)]
pub struct ArmPolicy<'a, S: Copy, P> {
    policy: P,
    arm: &'a Arm<S>,
    sources: &'a [Source],
    moves: &'a [Move],
    memo: TargetMemo<S>,
}

impl<'a, S: Lattice, P> ArmPolicy<'a, S, P> {
    /// Lifts a policy over the flat state of `sources`, in order, for an arm: derived sources depend on its lengths and
    /// limits. `moves` says what each action moves; an action past the end stops.
    pub const fn new(policy: P, arm: &'a Arm<S>, sources: &'a [Source], moves: &'a [Move]) -> Self {
        Self { policy, arm, sources, moves, memo: TargetMemo::new() }
    }
}

impl<S, P, const N: usize> Policy for ArmPolicy<'_, S, P>
where
    S: Lattice,
    P: Policy<State = [S; N], Action = ActionId>,
{
    type State = Observation<S>;
    type Action = Move;

    fn decide(&self, observation: &Observation<S>) -> Move {
        let mut state = [S::ZERO; N];
        Source::fill(self.sources, self.arm, observation, &self.memo, &mut state);
        let ActionId(action) = self.policy.decide(&state);
        self.moves.get(usize::from(action)).copied().unwrap_or(Move::STOP)
    }
}
