//! The derived source: what an observation says about the errors that matter, computed from the 13 values alone.

use crate::arm::TICKS_PER_TURN;
use crate::frame::Frame;
use crate::kinematics::Lattice;

/// Ticks of an angle in radians.
pub(super) fn ticks_of<S: Lattice>(radians: S) -> S {
    radians * S::from_f64(f64::from(TICKS_PER_TURN) / core::f64::consts::TAU)
}

/// [`Source::Polar`](super::Source::Polar); reaches are the distances of target and hand from the shoulder.
pub fn polar<S: Lattice>(frame: &Frame<'_, S>) -> [S; 3] {
    let base = frame.shoulder_height();
    let (target_reach, hand_reach) = (frame.target_reach(), frame.hand_reach());
    let (hand, target) = (frame.height() - base, frame.target()[2] - base);
    let tangential = (frame.radius() * target - hand * frame.target_radius()) / hand_reach;
    [-frame.target_lateral(), tangential, target_reach - hand_reach]
}
