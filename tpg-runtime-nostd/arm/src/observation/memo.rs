//! The part of sources that depends on the target alone, kept while the target stays.
//!
//! A control loop asks hundreds of times about one target. A stance that reaches it takes inverse tangents and collision
//! tests: on a Cortex-M4 more than a graph. The kept value is the one that would be computed again, to the bit.

use super::stance::stance;
use crate::arm::{Arm, JOINTS};
use crate::kinematics::{Lattice, Vector};
use core::cell::Cell;

/// The stance for a target of one arm. Empty at first; a new target makes it forget.
#[derive(Clone, Debug)]
pub struct TargetMemo<S: Copy>(Cell<Option<(Vector<S>, [S; JOINTS])>>);

impl<S: Lattice> TargetMemo<S> {
    /// Knows nothing yet.
    pub const fn new() -> Self {
        Self(Cell::new(None))
    }

    /// A pose that reaches the target, ticks.
    pub(super) fn stance(&self, arm: &Arm<S>, target: Vector<S>) -> [S; JOINTS] {
        let same = |known: Vector<S>| known.into_iter().zip(target).all(|(a, b)| a.same_bits(b));
        match self.0.get() {
            Some((known, stance)) if same(known) => stance,
            _ => {
                let stance = stance(arm, target);
                self.0.set(Some((target, stance)));
                stance
            }
        }
    }
}

impl<S: Lattice> Default for TargetMemo<S> {
    fn default() -> Self {
        Self::new()
    }
}
