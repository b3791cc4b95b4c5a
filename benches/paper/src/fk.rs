//! Forward kinematics and collision answers, checked against reference values.
//!
//! The conformance arithmetic must give them to the bit. The runtime's paths on the motor lattice compute the same
//! geometry from a sine table, in `f64` and `f32`: they are near, by how much is measured, and a collision answer may
//! differ where the arm all but touches something.

use super::chain::Chain;
use super::clearance::clearance;
use super::data::ReferencePose;
use super::plane;
use tpg_arm::kinematics::{self, Lattice, Plane};
use tpg_arm::{Arm, Collision, Pose};

/// What the conformance arithmetic says about a pose.
pub fn reference(chain: &Chain, pose: Pose) -> ReferencePose {
    ReferencePose { pose, hand: chain.hand(pose), collision: plane::collision(chain.arm(), pose) }
}

/// How many reference poses come out to the bit.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Exactness {
    /// Poses compared.
    pub poses: usize,
    /// Those whose hand is the same in all bits of x, y and z.
    pub exact_hands: usize,
    /// Those with the same collision answer.
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

/// A pose whose collision answer is not the reference's.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct CollisionDifference {
    /// The pose.
    pub pose: Pose,
    /// The reference's answer.
    pub expected: Option<Collision>,
    /// The other answer.
    pub found: Option<Collision>,
    /// How near the arm is to changing its answer there, mm.
    pub clearance: f64,
}

/// How near a path of the runtime comes to reference poses.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Nearness {
    /// Poses compared.
    pub poses: usize,
    /// The greatest distance between the two hands, mm.
    pub worst: f64,
    /// The collision answers that differ.
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

/// The runtime's collision answer at a pose, where it is not `expected`.
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
