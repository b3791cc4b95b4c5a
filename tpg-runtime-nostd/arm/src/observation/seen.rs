//! The observation itself: the arm and its target as a policy sees them.

use crate::arm::{Arm, Pose};
use crate::kinematics::{self, Lattice, Vector};

/// The paper's 13 values: four motor positions, and hand, target and their difference in mm (section 4.2).
///
/// Its memory is laid out as in C: a C interface may hand in its own structure.
#[derive(Clone, Copy, Debug, PartialEq)]
#[repr(C)]
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

    /// Returns the observation at a pose.
    #[inline(never)] // once in flash
    pub fn at(arm: &Arm<S>, pose: Pose, target: Vector<S>) -> Self {
        Self::new(arm, pose, kinematics::hand(arm, pose), target)
    }
}
