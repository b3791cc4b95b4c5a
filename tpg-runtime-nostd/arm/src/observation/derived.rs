//! The derived sources: what an observation says about the errors that matter, computed from the 13 values alone.
//!
//! Each formula is here once and takes what changes seldom (the target's own angles, the hand's elevation) as an
//! argument, so that a trainer may keep it from step to step and still get the same bits.

use crate::arm::{Arm, JOINTS, Pose, TICKS_PER_TURN};
use crate::frame::Frame;
use crate::kinematics::{Lattice, Vector};

/// Angles that follow from the target alone: constant over an episode.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Aim<S> {
    /// Base angle of the arm plane that holds the target on its front side, rad.
    pub azimuth: S,
    /// Elevation over the shoulder's horizon, rad.
    pub elevation: S,
    /// Shoulder to target, mm.
    pub reach: S,
}

impl<S: Lattice> Aim<S> {
    /// At a target in mm.
    pub fn at(arm: &Arm<S>, target: Vector<S>) -> Self {
        let [x, y, z] = target;
        let height = z - arm.links.base;
        Self {
            azimuth: (-x).atan2(y),
            elevation: height.atan2((x * x + y * y).sqrt()),
            reach: (x * x + y * y + height * height).sqrt(),
        }
    }
}

/// Ticks of an angle in radians.
pub(super) fn ticks_of<S: Lattice>(radians: S) -> S {
    radians * S::from_f64(f64::from(TICKS_PER_TURN) / core::f64::consts::TAU)
}

/// [`Source::MotorsCentred`](super::Source::MotorsCentred).
pub fn centred<S: Lattice>(pose: Pose) -> [S; JOINTS] {
    pose.0.map(|ticks| S::from_i32(i32::from(ticks) - TICKS_PER_TURN / 2))
}

/// [`Source::Polar`](super::Source::Polar); reaches are the distances of target and hand from the shoulder.
pub fn polar<S: Lattice>(frame: &Frame<'_, S>, target_reach: S, hand_reach: S) -> [S; 3] {
    let base = frame.shoulder_height();
    let (hand, target) = (frame.height() - base, frame.target()[2] - base);
    let tangential = (frame.radius() * target - hand * frame.target_radius()) / hand_reach;
    [-frame.target_lateral(), tangential, target_reach - hand_reach]
}

/// [`Source::Bearing`](super::Source::Bearing).
pub fn bearing<S: Lattice>(aim: &Aim<S>, pose: Pose, hand_elevation: S, hand_reach: S) -> [S; 3] {
    let [base, ..] = centred::<S>(pose);
    let azimuth = (ticks_of(aim.azimuth) - base) * S::from_f64(0.5);
    [azimuth, (aim.elevation - hand_elevation) * S::from_f64(250.0), aim.reach - hand_reach]
}

/// [`Source::Wrist`](super::Source::Wrist).
pub fn wrist<S: Lattice>(frame: &Frame<'_, S>) -> [S; 2] {
    let plane = frame.plane();
    // The target in the arm plane, whose first axis runs against the radius.
    let x = -frame.target_radius() - plane.wrist.x;
    let z = frame.target()[2] - plane.wrist.z;
    let distance = (x * x + z * z).sqrt();
    let along = x * plane.hand.cos + z * plane.hand.sin;
    let aside = z * plane.hand.cos - x * plane.hand.sin;
    // Raising the wrist's motor turns the hand backwards.
    [distance - frame.hand_length(), -ticks_of(aside.atan2(along))]
}
