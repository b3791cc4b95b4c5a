//! Forward kinematics and collision answers, checked against reference values.
//!
//! The conformance arithmetic must reproduce them exactly. The runtime's paths on the motor lattice compute the same
//! geometry from a sine table, in `f64` and `f32`: their deviation is measured, and a collision result may differ where
//! the arm almost touches something.

use super::clearance::clearance;
use serde::Deserialize;
use std::path::Path;
use tpg_arm::kinematics::{self, Lattice, Plane, Vector};
use tpg_arm::{Arm, Collision, Pose};
use tpg_paper::chain::Chain;
use tpg_paper::data::rows;
use tpg_paper::plane;

/// A reference value of kinematics and collision test.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct ReferencePose {
    /// The pose.
    pub(crate) pose: Pose,
    /// The hand, mm.
    pub(crate) hand: Vector<f64>,
    /// The collision, if there is one.
    pub(crate) collision: Option<Collision>,
}

#[derive(Deserialize)]
struct ReferenceRow {
    m0: i16,
    m1: i16,
    m2: i16,
    m3: i16,
    x: f64,
    y: f64,
    z: f64,
    collision_code: u8,
}

/// Reads recorded reference values.
pub(crate) fn reference_poses(path: &Path) -> Vec<ReferencePose> {
    let pose = |ReferenceRow { m0, m1, m2, m3, x, y, z, collision_code }| {
        let collision = match collision_code {
            0 => None,
            1 => Some(Collision::Table),
            2 => Some(Collision::HandCorner),
            3 => Some(Collision::Base),
            code => panic!("collision_code {code}"),
        };
        ReferencePose { pose: Pose([m0, m1, m2, m3]), hand: [x, y, z], collision }
    };
    rows(path).expect("recorded poses").into_iter().map(pose).collect()
}

/// Computes the reference for a pose with the conformance arithmetic.
pub(crate) fn reference(chain: &Chain, pose: Pose) -> ReferencePose {
    ReferencePose { pose, hand: chain.hand(pose), collision: plane::collision(chain.arm(), pose) }
}

/// Number of reference poses that are reproduced exactly.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub(crate) struct Exactness {
    /// Number of poses compared.
    pub(crate) poses: usize,
    /// Poses whose hand agrees in all bits of x, y and z.
    pub(crate) exact_hands: usize,
    /// Poses with the same collision result.
    pub(crate) exact_collisions: usize,
}

/// Compares the conformance arithmetic with recorded poses.
pub(crate) fn exactness(chain: &Chain, recorded: &[ReferencePose]) -> Exactness {
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
pub(crate) struct CollisionDifference {
    /// The pose.
    pub(crate) pose: Pose,
    /// Collision in the reference.
    pub(crate) expected: Option<Collision>,
    /// Collision found.
    pub(crate) found: Option<Collision>,
    /// Clearance of the arm in this pose, mm.
    pub(crate) clearance: f64,
}

/// Deviation of a runtime path from the reference poses.
#[derive(Clone, Debug, Default, PartialEq)]
pub(crate) struct Nearness {
    /// Number of poses compared.
    pub(crate) poses: usize,
    /// Largest distance between the two hands, mm.
    pub(crate) worst: f64,
    /// Collision results that differ.
    pub(crate) differences: Vec<CollisionDifference>,
}

/// Compares the runtime's lattice path in `S` with reference poses.
pub(crate) fn nearness<S: Lattice>(
    chain: &Chain,
    arm: &Arm<S>,
    poses: impl IntoIterator<Item = ReferencePose>,
) -> Nearness {
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
pub(crate) fn collision_difference<S: Lattice>(
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
