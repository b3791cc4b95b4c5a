//! Inverse kinematics in closed form: poses that put the hand on a target.
//!
//! Used only by training rewards and classical baselines; no learned policy sees it.
//!
//! A pitch of the hand fixes the wrist; base, upper arm and forearm then follow from a two-link triangle: the upper arm
//! and its bracket act as one link of length √(upper² + offset²), turned by atan(offset/upper).

use std::f64::consts::{FRAC_PI_2, PI, TAU};
use tpg_arm::kinematics::{self, Plane};
use tpg_arm::{Arm, JOINTS, Pose, TICKS_PER_TURN};

/// Number of pitches of the hand that are tried, evenly spaced around the circle.
pub(crate) const PITCHES: u32 = 144;
/// Maximum distance from a goal's hand to the target, mm: rounding to ticks costs up to about 1 mm.
const TOLERANCE: f64 = 4.0;

/// Returns the free poses that put the hand on `target` (mm), for 144 pitches of the hand, both sides of the base and
/// both bends of the elbow: at most 576, none if the target is out of reach. Their order is fixed.
pub fn goals(arm: &Arm<f64>, target: [f64; 3]) -> Vec<Pose> {
    goals_of_pitches(arm, target, PITCHES)
}

/// As [`goals`], for another number of pitches: a target at the rim of the space may need one between the 144.
pub fn goals_of_pitches(arm: &Arm<f64>, target: [f64; 3], pitches: u32) -> Vec<Pose> {
    let [x, y, z] = target;
    let range = x.hypot(y);
    let front = libm::atan2(-x, y);
    let back = if front > 0.0 { front - PI } else { front + PI };
    let mut goals = Vec::new();
    // The arm plane's x is opposite to the radius: in front of the base it is negative.
    for (base, plane_x) in [(front, -range), (back, range)] {
        for pitch in 0..pitches {
            let hand = TAU * f64::from(pitch) / f64::from(pitches);
            let wrist = (plane_x - arm.links.hand * libm::cos(hand), z - arm.links.hand * libm::sin(hand));
            for (upper_arm, forearm) in two_links(arm, wrist).into_iter().flatten() {
                let pose =
                    [base + PI, upper_arm + FRAC_PI_2, upper_arm + 3.0 * FRAC_PI_2 - forearm, forearm + PI - hand];
                goals.extend(on_lattice(arm, pose).filter(|&pose| reaches(arm, pose, target)));
            }
        }
    }
    goals
}

/// Returns the angles of upper arm and forearm that bring the wrist to a point of the plane, for both bends of the
/// elbow.
fn two_links(arm: &Arm<f64>, (x, z): (f64, f64)) -> [Option<(f64, f64)>; 2] {
    let (links, shoulder) = (&arm.links, arm.shoulder());
    let (x, z) = (x - shoulder.x, z - shoulder.z);
    let first = links.upper_arm.hypot(links.elbow_offset);
    let tilt = libm::atan2(links.elbow_offset, links.upper_arm);
    let far = x.hypot(z);
    let cosine = (far * far + first * first - links.forearm * links.forearm) / (2.0 * far * first);
    [1.0, -1.0].map(|bend| {
        (cosine.abs() <= 1.0).then(|| {
            let elbow = libm::atan2(z, x) + bend * libm::acos(cosine);
            let forearm = libm::atan2(z - first * libm::sin(elbow), x - first * libm::cos(elbow));
            (elbow - tilt, forearm)
        })
    })
}

/// Returns the motor positions of four angles (rad, 0 = motor position 0), if all lie inside their ranges.
fn on_lattice(arm: &Arm<f64>, angles: [f64; 4]) -> Option<Pose> {
    let ticks = angles.map(|angle| {
        let ticks = libm::round(angle * f64::from(TICKS_PER_TURN) / TAU) as i32;
        ticks.rem_euclid(TICKS_PER_TURN) as i16
    });
    let inside = ticks.iter().zip(&arm.ranges).all(|(&ticks, range)| range.contains(ticks));
    inside.then_some(Pose(ticks))
}

/// Returns the length of a straight walk in hundredths of a tick: the steps of the joint that has furthest to go, and as little
/// for the others that it decides between equals.
#[inline]
pub(crate) fn walk_length(from: [i16; JOINTS], to: [i16; JOINTS]) -> i32 {
    // Whole numbers, which compilers put into vectors.
    let [a, b, c, d] = std::array::from_fn(|joint| i32::from(from[joint].abs_diff(to[joint])));
    100 * a.max(b).max(c.max(d)) + 2 * (a + b + c + d)
}

fn reaches(arm: &Arm<f64>, pose: Pose, target: [f64; 3]) -> bool {
    let plane = Plane::at(arm, pose);
    let hand = plane.hand_in_world(kinematics::base_direction(pose));
    kinematics::distance(hand, target) < TOLERANCE && plane.collision(&arm.shapes).is_none()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::arm::targets::{Set, Start, tasks};
    use tpg_arm::WIDOWX;

    #[test]
    fn nearly_every_target_has_goals_and_every_goal_reaches_it() {
        let targets: Vec<_> = tasks(&WIDOWX, 3, Set::Validation, Start::Fs, 300).iter().map(|t| t.target).collect();
        let mut without = 0;
        for &target in &targets {
            let goals = goals(&WIDOWX, target);
            without += u32::from(goals.is_empty());
            for pose in goals {
                let off = kinematics::distance(kinematics::hand(&WIDOWX, pose), target);
                assert!(off < TOLERANCE && Plane::at(&WIDOWX, pose).collision(&WIDOWX.shapes).is_none());
            }
        }
        // Targets at the rim of the space need one exact pitch, which may fall between two tried ones.
        assert!(without <= 6, "{without} of 300 targets without a goal");
    }

    #[test]
    fn a_target_out_of_reach_has_none() {
        assert_eq!(goals(&WIDOWX, [0.0, 600.0, 100.0]), []);
        assert_eq!(goals(&WIDOWX, [0.0, 200.0, -150.0]), []);
    }
}
