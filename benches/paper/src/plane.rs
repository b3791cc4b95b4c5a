//! The arm plane as computed by the artifact's collision test (`armlearn-wrapper`, `ArmLearnWrapper.cpp`, lines
//! 1026–1101).
//!
//! Only the angles and their sines follow the artifact; links and collision rules are the runtime's own code, whose
//! order of operations is the same as the artifact's.

use std::f64::consts::{FRAC_PI_2, PI};
use tpg_arm::kinematics::{Direction, Directions, Plane};
use tpg_arm::{Arm, Collision, Pose};

/// Returns the directions of the links in a pose, from sums of angles in radians.
pub fn directions(pose: Pose) -> Directions<f64> {
    let [_, shoulder, elbow, wrist] = pose.0.map(|ticks| (f64::from(ticks) - 1024.0) / 2048.0 * 180.0);
    let upper_arm = shoulder / 180.0 * PI;
    let bend = PI - elbow / 180.0 * PI;
    let forearm = upper_arm + bend;
    let hand = forearm + (FRAC_PI_2 - wrist / 180.0 * PI);
    Directions {
        upper_arm: direction(upper_arm),
        bracket: direction(upper_arm + FRAC_PI_2),
        forearm: direction(forearm),
        forearm_across: direction(forearm - FRAC_PI_2),
        hand: direction(hand),
        hand_across: direction(hand - FRAC_PI_2),
    }
}

/// Returns the arm plane of a pose.
pub fn at(arm: &Arm<f64>, pose: Pose) -> Plane<f64> {
    Plane::new(arm, directions(pose))
}

/// Returns the collision in a pose.
pub fn collision(arm: &Arm<f64>, pose: Pose) -> Option<Collision> {
    at(arm, pose).collision(&arm.shapes)
}

fn direction(radians: f64) -> Direction<f64> {
    Direction { cos: radians.cos(), sin: radians.sin() }
}

#[cfg(test)]
mod tests {
    use super::collision;
    use tpg_arm::WIDOWX;

    #[test]
    fn home_is_free() {
        assert_eq!(collision(&WIDOWX, WIDOWX.home), None);
    }
}
