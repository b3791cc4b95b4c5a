//! The parts of sources that depend on the target alone, kept while the target stays.
//!
//! A control loop asks hundreds of times about one target. Its direction, and a stance that reaches it, take inverse
//! tangents and collision tests: on a Cortex-M4 more than a graph. Kept values are the ones that would be computed again,
//! to the bit.

use super::stance::Stance;
use crate::arm::Arm;
use crate::kinematics::{Lattice, Vector};
use core::cell::Cell;

/// Values about one target, for one arm. Empty at first; a new target makes it forget.
#[derive(Clone, Debug)]
pub struct TargetMemo<S: Copy> {
    target: Cell<Option<Vector<S>>>,
    stance: Cell<Option<Stance<S>>>,
}

impl<S: Lattice> TargetMemo<S> {
    /// Knows nothing yet.
    pub const fn new() -> Self {
        Self { target: Cell::new(None), stance: Cell::new(None) }
    }

    /// Returns the stance at a target.
    pub fn stance(&self, arm: &Arm<S>, target: Vector<S>) -> Stance<S> {
        let same = |known: Vector<S>| known.into_iter().zip(target).all(|(a, b)| a.same_bits(b));
        if let Some(stance) = self.stance.get().filter(|_| self.target.get().is_some_and(same)) {
            return stance;
        }
        let stance = Stance::at(arm, target);
        self.target.set(Some(target));
        self.stance.set(Some(stance));
        stance
    }
}

impl<S: Lattice> Default for TargetMemo<S> {
    fn default() -> Self {
        Self::new()
    }
}
