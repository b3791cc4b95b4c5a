//! The parts of sources that depend on the target alone, kept while the target stays.
//!
//! A control loop asks hundreds of times about one target. Its direction, and a stance that reaches it, take inverse
//! tangents and collision tests: on a Cortex-M4 more than a graph. Kept values are the ones that would be computed again,
//! to the bit.

use super::derived::Aim;
use super::reach::ReachTarget;
use super::stance::Stance;
use crate::arm::Arm;
use crate::kinematics::{Lattice, Vector};
use core::cell::Cell;

/// Values about one target, for one arm. Empty at first; a new target makes it forget.
#[derive(Clone, Debug)]
pub struct TargetMemo<S: Copy> {
    target: Cell<Option<Vector<S>>>,
    aim: Cell<Option<Aim<S>>>,
    reach: Cell<Option<ReachTarget<S>>>,
    stance: Cell<Option<Stance<S>>>,
}

impl<S: Lattice> TargetMemo<S> {
    /// Knows nothing yet.
    pub const fn new() -> Self {
        Self { target: Cell::new(None), aim: Cell::new(None), reach: Cell::new(None), stance: Cell::new(None) }
    }

    /// The target's angles.
    pub fn aim(&self, arm: &Arm<S>, target: Vector<S>) -> Aim<S> {
        self.recall(&self.aim, target, || Aim::at(arm, target))
    }

    /// The target as the inverse kinematics sees it.
    pub fn reach(&self, arm: &Arm<S>, target: Vector<S>) -> ReachTarget<S> {
        self.recall(&self.reach, target, || ReachTarget::at(arm, target))
    }

    /// A pose that reaches the target.
    pub fn stance(&self, arm: &Arm<S>, target: Vector<S>) -> Stance<S> {
        self.recall(&self.stance, target, || Stance::at(arm, target))
    }

    fn recall<T: Copy>(&self, kept: &Cell<Option<T>>, target: Vector<S>, compute: impl FnOnce() -> T) -> T {
        let same = |known: Vector<S>| known.into_iter().zip(target).all(|(a, b)| a.same_bits(b));
        if !self.target.get().is_some_and(same) {
            self.target.set(Some(target));
            self.aim.set(None);
            self.reach.set(None);
            self.stance.set(None);
        }
        kept.get().unwrap_or_else(|| {
            let value = compute();
            kept.set(Some(value));
            value
        })
    }
}

impl<S: Lattice> Default for TargetMemo<S> {
    fn default() -> Self {
        Self::new()
    }
}
