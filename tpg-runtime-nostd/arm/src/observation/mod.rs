//! The observation of arm and target, and the data sources of a graph that it fills.

pub mod derived;
mod memo;
mod range;
mod reach;
pub(crate) mod seen;
mod source;
mod stance;
mod straight;

pub use derived::Aim;
pub use memo::TargetMemo;
pub use reach::{Reach, ReachErrors, ReachTarget};
pub use seen::Observation;
pub use source::Source;
pub use stance::Stance;
pub use straight::{STEP, Straight};

use crate::arm::{Arm, Move};
use crate::frame::Frame;
use crate::kinematics::Lattice;
use core::mem::MaybeUninit;
use tpg_runtime::policy::{ActionId, Policy};

/// Parts that several sources share. The reach is computed once, when the first of them asks; to keep a frame would cost
/// as much as to compute it.
struct Parts<'a, S: Copy> {
    arm: &'a Arm<S>,
    seen: &'a Observation<S>,
    memo: &'a TargetMemo<S>,
    reach: Option<ReachErrors<S>>,
}

impl<'a, S: Lattice> Parts<'a, S> {
    fn new(arm: &'a Arm<S>, seen: &'a Observation<S>, memo: &'a TargetMemo<S>) -> Self {
        Self { arm, seen, memo, reach: None }
    }

    #[inline(always)]
    fn frame(&self) -> Frame<'a, S> {
        Frame::new(self.arm, self.seen)
    }

    #[inline(never)] // as `bearing`
    fn reach(&mut self) -> &ReachErrors<S> {
        let (arm, seen, memo) = (self.arm, self.seen, self.memo);
        let [.., wrist] = seen.pose.0;
        self.reach.get_or_insert_with(|| memo.reach(arm, seen.target).keeping_wrist(arm, wrist).errors(arm, seen.pose))
    }

    #[inline(never)] // the sources that most policies have need far fewer registers than this
    fn bearing(&self) -> [S; 3] {
        let aim = self.memo.aim(self.arm, self.seen.target);
        let frame = self.frame();
        derived::bearing(&aim, self.seen.pose, frame.hand_elevation(), frame.hand_reach())
    }

    #[inline(never)] // as `bearing`
    fn wrist(&self) -> [S; 2] {
        derived::wrist(&self.frame())
    }

    #[inline(always)]
    fn write<W: Slot<S>>(&mut self, source: Source, values: &mut [W]) {
        let seen = self.seen;
        match source {
            Source::Target => put(values, seen.target),
            Source::Difference => put(values, seen.difference),
            Source::Hand => put(values, seen.hand),
            Source::Motors => put(values, seen.pose.0.map(ticks)),
            Source::Servos => {
                let [a, b, c, d] = seen.pose.0;
                let [e, f] = seen.fixed_servos;
                put(values, [a, b, c, d, e, f].map(ticks));
            }
            Source::MotorsCentred => put(values, derived::centred(seen.pose)),
            Source::Polar => {
                let frame = self.frame();
                put(values, derived::polar(&frame, frame.target_reach(), frame.hand_reach()));
            }
            Source::Bearing => put(values, self.bearing()),
            Source::Reach => put(values, self.reach().ticks),
            Source::ReachExcess => put(values, self.reach().excess),
            Source::ReachPitch => put(values, [self.reach().pitch]),
            Source::Wrist => put(values, self.wrist()),
            Source::Floor => put(values, [self.frame().lowest_corner()]),
            Source::Stance => put(values, self.memo.stance(self.arm, seen.target).errors(seen.pose)),
        }
    }
}

impl Source {
    /// Writes this source's values at a pose into `values`; stops where `values` is full.
    pub fn write<S: Lattice>(self, arm: &Arm<S>, seen: &Observation<S>, values: &mut [S]) {
        Self::fill(&[self], arm, seen, &TargetMemo::new(), values);
    }

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
        let mut parts = Parts::new(arm, seen, memo);
        let mut rest = state;
        for source in sources {
            parts.write(source, rest);
            let length = source.length().min(rest.len());
            rest = &mut rest[length..];
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
