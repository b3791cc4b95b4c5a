//! The stance: one pose that brings the hand to the target, out of a few that the inverse kinematics offers.
//!
//! A target in space leaves one of four joints free. Here the wrist settles it: hand and forearm in one line, the hand
//! hooked half or all the way down, or raised. Base, shoulder and elbow then follow in closed form, and the first of these
//! four poses that the arm can take is the stance. What is left to a policy is the way there: which joint moves when.
//! That is most of what a planner knows, and must be said wherever results are shown.

use super::reach::{Goal, ReachTarget};
use crate::arm::{Arm, JOINTS, Pose};
use crate::kinematics::{Lattice, Plane, Vector};

/// Distances of the wrist from straight, ticks, in the order of preference. Raising the wrist's motor turns the hand back.
/// 948 ticks are 83°, short of the limits. Of 1,000 reachable targets 898 have a free pose with the first, 989 with one.
const WRISTS: [i16; 4] = [0, -448, -948, 948];

/// The same over the arm's back, where raising the wrist's motor hooks the hand down. Of 500 targets of the SO-101 that its base
/// cannot face, nine in ten have a free pose with one.
const WRISTS_OVER_THE_BACK: [i16; 4] = [0, 448, 728, 1000];

/// Returns a goal for every joint, ticks: the first pose for a target in mm that the arm can take, or else the one with the smallest
/// violation; a collision counts like 4,096 ticks. It depends on the target alone, so it can be kept while the target stays.
#[inline(never)] // expensive and rare: a static bound counts it once a target
pub(super) fn stance<S: Lattice>(arm: &Arm<S>, target: Vector<S>) -> [S; JOINTS] {
    let seen = ReachTarget::at(arm, target);
    // Wrapping: a home that no arm has must not panic. `Arm::check` refuses it.
    let [.., straight] = arm.home.0;
    let [first, others @ ..] = if seen.behind { WRISTS_OVER_THE_BACK } else { WRISTS };
    let mut best = candidate(arm, &seen, straight.wrapping_add(first));
    for wrist in others {
        // Nothing is better than a possible pose; for most targets the first is one.
        if best.excess == S::ZERO {
            break;
        }
        let next = candidate(arm, &seen, straight.wrapping_add(wrist));
        if next.excess < best.excess {
            best = next;
        }
    }
    best.ticks
}

/// The goal for a wrist position, with more excess if it collides.
fn candidate<S: Lattice>(arm: &Arm<S>, seen: &ReachTarget<S>, wrist: i16) -> Goal<S> {
    let Goal { ticks, excess } = seen.keeping_wrist(arm, wrist);
    // Goals lie in 0..=4096, so adding a half and truncating rounds.
    let pose = Pose(ticks.map(|ticks| (ticks + S::from_f64(0.5)).to_i32() as i16));
    let collides = Plane::at(arm, pose).collision(&arm.shapes).is_some();
    Goal { ticks, excess: excess + if collides { S::from_i32(4096) } else { S::ZERO } }
}
