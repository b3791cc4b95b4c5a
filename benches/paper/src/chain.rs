//! Forward kinematics as computed by the paper's artifact: a chain of six rotations, in the order of
//! `KDL::ChainFkSolverPos_recursive` (`ggendro/armlearn`, `src/physics/converter.cpp`,
//! `src/builder/widowxbuilder.cpp`).
//!
//! Every matrix product is a row-times-column sum from left to right, zeros included, and the constant tips keep the
//! rounding residue of sin π and cos π/2. In the home pose this gives x = 4.2e-14 instead of 0, and the recorded
//! programs read that value.

use std::f64::consts::{FRAC_PI_2, PI};
use tpg_arm::kinematics::Vector;
use tpg_arm::{Arm, Pose};

/// The artifact's segments of the hand: wrist angle, wrist rotation and gripper, mm.
const HAND_SEGMENTS: [f64; 3] = [74.0, 41.0, 40.0];

type Matrix = [[f64; 3]; 3];

/// Cosine and sine of a motor's angle.
#[derive(Clone, Copy, Debug)]
struct ChainTurn {
    cos: f64,
    sin: f64,
}

#[derive(Clone, Copy, Debug)]
enum ChainAxis {
    X,
    Z,
}

/// One link: a joint, then a fixed tip.
#[derive(Clone, Copy, Debug)]
struct ChainSegment {
    axis: ChainAxis,
    tip: Vector<f64>,
    tip_rotation: Matrix,
}

/// The kinematic chain of an arm.
#[derive(Clone, Debug)]
pub struct Chain {
    arm: Arm<f64>,
    segments: [ChainSegment; 6],
}

impl Chain {
    /// Creates the chain of an arm whose hand is as long as the WidowX's.
    pub fn new(arm: Arm<f64>) -> Self {
        let links = &arm.links;
        let straight = |axis, length| ChainSegment { axis, tip: [0.0, 0.0, length], tip_rotation: IDENTITY };
        let [wrist, rotation, gripper] = HAND_SEGMENTS;
        let half_turn = ChainTurn::new(PI).about(ChainAxis::Z);
        let segments = [
            ChainSegment { tip_rotation: half_turn, ..straight(ChainAxis::Z, links.base) },
            ChainSegment {
                axis: ChainAxis::X,
                tip: [0.0, -links.elbow_offset, links.upper_arm],
                tip_rotation: product(&ChainTurn::new(FRAC_PI_2).about(ChainAxis::X), &half_turn),
            },
            straight(ChainAxis::X, links.forearm),
            straight(ChainAxis::X, wrist),
            straight(ChainAxis::Z, rotation),
            straight(ChainAxis::Z, gripper),
        ];
        Self { arm, segments }
    }

    /// Returns the arm.
    pub fn arm(&self) -> &Arm<f64> {
        &self.arm
    }

    /// Returns the position of the hand's tip in a pose, mm.
    pub fn hand(&self, pose: Pose) -> Vector<f64> {
        let motors = pose.0.iter().chain(&self.arm.fixed_servos);
        let mut rotation = IDENTITY;
        let mut position = [0.0; 3];
        for (segment, &ticks) in self.segments.iter().zip(motors) {
            let joint = ChainTurn::at(ticks).about(segment.axis);
            let step = apply(&rotation, &apply(&joint, &segment.tip));
            position = [step[0] + position[0], step[1] + position[1], step[2] + position[2]];
            rotation = product(&rotation, &product(&joint, &segment.tip_rotation));
        }
        position
    }
}

impl ChainTurn {
    fn new(radians: f64) -> Self {
        Self { cos: radians.cos(), sin: radians.sin() }
    }

    /// Returns the turn of a motor position; the order of operations is the artifact's.
    fn at(ticks: i16) -> Self {
        Self::new((f64::from(ticks) * (360.0 / 4096.0) - 180.0) * PI / 180.0)
    }

    fn about(self, axis: ChainAxis) -> Matrix {
        let Self { cos, sin } = self;
        match axis {
            ChainAxis::X => [[1.0, 0.0, 0.0], [0.0, cos, -sin], [0.0, sin, cos]],
            ChainAxis::Z => [[cos, -sin, 0.0], [sin, cos, 0.0], [0.0, 0.0, 1.0]],
        }
    }
}

const IDENTITY: Matrix = [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]];

fn product(a: &Matrix, b: &Matrix) -> Matrix {
    a.map(|[x, y, z]| std::array::from_fn(|column| x * b[0][column] + y * b[1][column] + z * b[2][column]))
}

fn apply(matrix: &Matrix, v: &Vector<f64>) -> Vector<f64> {
    matrix.map(|[x, y, z]| x * v[0] + y * v[1] + z * v[2])
}

#[cfg(test)]
mod tests {
    use super::{Chain, HAND_SEGMENTS};
    use tpg_arm::WIDOWX;

    #[test]
    fn the_hand_at_home_keeps_its_residue() {
        let [x, y, z] = Chain::new(WIDOWX).hand(WIDOWX.home);
        assert!((4.23e-14..4.24e-14).contains(&x), "{x:e}");
        assert_eq!([y, z], [346.0, 267.0]);
    }

    #[test]
    fn the_hand_is_as_long_as_the_arm_says() {
        assert_eq!(HAND_SEGMENTS.iter().sum::<f64>(), WIDOWX.links.hand);
    }
}
