//! The shield: those of the paper's eight actions that the arm would refuse.
//!
//! A policy that may not bid for what would be refused is another policy than one that has learned to avoid it, so a
//! shield is a part of its graph: a source like any other, whose values bound the bids for actions.

use crate::arm::{Arm, JOINTS, Joint, Move, Pose};
use crate::kinematics::{Lattice, Plane};

/// The actions that a shield speaks of: each joint in turn, first raised, then lowered.
pub const SHIELDED: usize = 2 * JOINTS;

/// Ticks by which they move their joint (the paper, section 4.2).
pub const STEP: i8 = 3;

/// The bound of an action's bid where the action is allowed; where it would be refused, the bound is the negative.
///
/// 2¹²⁷, exact in both scalars. An infinity would do the same, but JSON, and so a graph's ranges, has none. A program's
/// last line `min(shield, bid)` makes the bid its own where it is less, keeps a NaN, and lets nothing past a refusal.
pub const ALLOWED: f64 = 1.701_411_834_604_692_3e38;

/// The bounds of all actions where `allowed` says which are allowed.
fn bounds<S: Lattice>(step: i8, allowed: impl Fn(Move) -> bool) -> [S; SHIELDED] {
    let mut bounds = [S::from_f64(-ALLOWED); SHIELDED];
    for (bound, place) in bounds.iter_mut().zip(0u8..) {
        if allowed(action(place, step)) {
            *bound = S::from_f64(ALLOWED);
        }
    }
    bounds
}

/// The action at a place of the shield, of `step` ticks.
pub const fn action(place: u8, step: i8) -> Move {
    Move::single(Joint(place / 2), if place.is_multiple_of(2) { step } else { step.saturating_neg() })
}

/// Returns true if every joint stays in its range.
fn within<S: Lattice>(arm: &Arm<S>, pose: Pose, wanted: Move) -> bool {
    let joints = pose.0.into_iter().zip(wanted.0).zip(arm.ranges);
    joints.into_iter().all(|((ticks, delta), range)| range.contains(ticks.saturating_add(i16::from(delta))))
}

/// [`Source::ShieldLimits`](super::Source::ShieldLimits), for actions of `step` ticks; the source's are of [`STEP`].
#[inline(never)] // as `collision`
pub fn limits<S: Lattice>(arm: &Arm<S>, pose: Pose, step: i8) -> [S; SHIELDED] {
    bounds(step, |wanted| within(arm, pose, wanted))
}

/// [`Source::ShieldCollision`](super::Source::ShieldCollision), for actions of `step` ticks; `collides` answers whether the arm does at a pose.
///
/// It is asked once for the pose itself, for both actions of the base, and once for each other action within limits.
pub fn collision_with<S: Lattice>(
    arm: &Arm<S>,
    pose: Pose,
    step: i8,
    collides: impl Fn(Pose) -> bool,
) -> [S; SHIELDED] {
    let here = collides(pose);
    bounds(step, |wanted| {
        let [base, shoulder, elbow, wrist] = wanted.0.map(i16::from);
        let [_, at_shoulder, at_elbow, at_wrist] = pose.0;
        within(arm, pose, wanted)
            // The plane is the same for every angle of the base.
            && !if base != 0 {
                here
            } else {
                // Each is within its range, and so no sum overflows but for a joint at the end of `i16` itself.
                collides(Pose([
                    pose.0[0],
                    at_shoulder.saturating_add(shoulder),
                    at_elbow.saturating_add(elbow),
                    at_wrist.saturating_add(wrist),
                ]))
            }
    })
}

/// [`Source::ShieldCollision`](super::Source::ShieldCollision).
#[inline(never)] // expensive, and few graphs have it: a static bound can leave it out
pub fn collision<S: Lattice>(arm: &Arm<S>, pose: Pose) -> [S; SHIELDED] {
    collision_with(arm, pose, STEP, |pose| Plane::at(arm, pose).collision(&arm.shapes).is_some())
}
