//! The readings that an arm can give at all.

use super::Fault;
use super::lanes::{self, Ranges, TOP};
use crate::arm::{Arm, JointRange, Pose, TICKS_PER_TURN};
use crate::kinematics::{Lattice, Vector};
use crate::observation::Observation;

/// Added to an arm's reach, mm: the hand of a stretched arm must not be out of reach by a rounding.
const SLACK: f64 = 1.0;

/// An arm's joint ranges and reach, as a control step compares readings with them: some thirty instructions.
///
/// Positions outside 0..=4095 are never accepted, whatever the arm's ranges say.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Limits<S> {
    pub(super) ranges: Ranges,
    /// Height of the shoulder over the table, mm.
    shoulder: S,
    /// The square of the greatest distance from the base's axis at that height, mm².
    reach_squared: S,
}

impl<S: Lattice> Limits<S> {
    /// The limits of an arm.
    pub fn new(arm: &Arm<S>) -> Self {
        let end = |pick: fn(JointRange) -> i16| {
            lanes::from_pose(Pose(arm.ranges.map(|range| pick(range).clamp(0, (TICKS_PER_TURN - 1) as i16))))
        };
        // Of an empty range one position is left: `Ranges` needs ends in order.
        let ranges = Ranges::new(end(|range| range.min), end(|range| range.max.max(range.min)));
        let reach = arm.reach() + S::from_f64(SLACK);
        Self { ranges, shoulder: arm.links.base, reach_squared: reach * reach }
    }

    /// Returns true if a target, mm, is a point that the stretched arm could reach: no farther from the base's axis, at the
    /// shoulder's height, than its hand comes, with 1 mm to spare.
    ///
    /// Nearer targets may still be out of reach: in the table, or inside the arm. The guard holds the arm back there.
    #[inline(always)]
    pub fn reaches(&self, &[x, y, z]: &Vector<S>) -> bool {
        let height = z - self.shoulder;
        // False for a NaN, and for what overflows to infinity.
        x * x + y * y + height * height <= self.reach_squared
    }

    /// Returns true if every motor is within its joint's range.
    pub fn hold(&self, motors: Pose) -> bool {
        self.ranges.hold(lanes::from_pose(motors)) & TOP == TOP
    }

    /// Checks an observation.
    ///
    /// # Errors
    /// [`Fault::Target`] or [`Fault::Sensor`].
    pub fn check(&self, seen: &Observation<S>) -> Result<(), Fault> {
        if !self.reaches(&seen.target) {
            Err(Fault::Target)
        } else if !self.hold(seen.pose) || !seen.is_consistent() {
            Err(Fault::Sensor)
        } else {
            Ok(())
        }
    }
}
