//! Forward kinematics and collision answers, checked against reference values.
//!
//! The conformance arithmetic must reproduce them exactly. The runtime's paths on the motor lattice compute the same
//! geometry from a sine table, in `f64` and `f32`: their deviation is measured, and a collision result may differ where
//! the arm almost touches something.

use super::chain::Chain;
use super::clearance::clearance;
use super::data::ReferencePose;
use super::plane;
use tpg_arm::kinematics::{self, Lattice, Plane};
use tpg_arm::{Arm, Collision, Pose};

/// Computes the reference for a pose with the conformance arithmetic.
pub fn reference(chain: &Chain, pose: Pose) -> ReferencePose {
    ReferencePose { pose, hand: chain.hand(pose), collision: plane::collision(chain.arm(), pose) }
}

/// Number of reference poses that are reproduced exactly.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Exactness {
    /// Number of poses compared.
    pub poses: usize,
    /// Poses whose hand agrees in all bits of x, y and z.
    pub exact_hands: usize,
    /// Poses with the same collision result.
    pub exact_collisions: usize,
}

/// Compares the conformance arithmetic with recorded poses.
pub fn exactness(chain: &Chain, recorded: &[ReferencePose]) -> Exactness {
    let mut result = Exactness::default();
    for expected in recorded {
        let found = reference(chain, expected.pose);
        result.poses += 1;
        result.exact_hands += usize::from(found.hand.map(f64::to_bits) == expected.hand.map(f64::to_bits));
        result.exact_collisions += usize::from(found.collision == expected.collision);
    }
    result
}

/// A pose whose collision result differs from the reference.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct CollisionDifference {
    /// The pose.
    pub pose: Pose,
    /// Collision in the reference.
    pub expected: Option<Collision>,
    /// Collision found.
    pub found: Option<Collision>,
    /// Clearance of the arm in this pose, mm.
    pub clearance: f64,
}

/// Deviation of a runtime path from the reference poses.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Nearness {
    /// Number of poses compared.
    pub poses: usize,
    /// Largest distance between the two hands, mm.
    pub worst: f64,
    /// Collision results that differ.
    pub differences: Vec<CollisionDifference>,
}

/// Compares the runtime's lattice path in `S` with reference poses.
pub fn nearness<S: Lattice>(chain: &Chain, arm: &Arm<S>, poses: impl IntoIterator<Item = ReferencePose>) -> Nearness {
    let mut result = Nearness::default();
    for expected in poses {
        let hand = kinematics::hand(arm, expected.pose).map(S::to_f64);
        result.poses += 1;
        result.worst = result.worst.max(kinematics::distance(hand, expected.hand));
        result.differences.extend(collision_difference(chain.arm(), arm, expected.pose, expected.collision));
    }
    result
}

/// Returns the runtime's collision result for a pose if it differs from `expected`.
pub fn collision_difference<S: Lattice>(
    reference: &Arm<f64>,
    arm: &Arm<S>,
    pose: Pose,
    expected: Option<Collision>,
) -> Option<CollisionDifference> {
    let found = Plane::at(arm, pose).collision(&arm.shapes);
    (found != expected).then(|| {
        let clearance = clearance(&plane::at(reference, pose), &reference.shapes);
        CollisionDifference { pose, expected, found, clearance }
    })
}
