//! The rule of one step, and the collision test at places worked out by hand.

use proptest::prelude::*;
use tpg_arm::kinematics::{Direction, Lattice, Plane, Point};
use tpg_arm::{Arm, BaseEdge, Collision, Invalid, JOINTS, Joint, Move, Pose, Shapes, Step, WIDOWX};

fn step(pose: [i16; JOINTS], wanted: [i8; JOINTS]) -> Step {
    WIDOWX.step(Pose(pose), Move(wanted))
}

fn free(pose: [i16; JOINTS]) -> Step {
    Step { pose: Pose(pose), invalid: None }
}

fn collision(pose: [i16; JOINTS]) -> Option<Collision> {
    Plane::at(&WIDOWX, Pose(pose)).collision(&WIDOWX.shapes)
}

#[test]
fn a_move_adds_its_ticks() {
    assert_eq!(step([2048; 4], [3, -3, 3, -3]), free([2051, 2045, 2051, 2045]));
    assert_eq!(step([2048; 4], [0; 4]), free([2048; 4]));
}

#[test]
fn the_ends_of_a_range_are_inside() {
    assert_eq!(step([5, 2048, 2048, 2048], [-3, 0, 0, 0]), free([2, 2048, 2048, 2048]));
    assert_eq!(step([4091, 2048, 2048, 2048], [3, 0, 0, 0]), free([4094, 2048, 2048, 2048]));
}

#[test]
fn a_joint_at_its_limit_stays_and_the_others_still_move() {
    let limit = |joint| Some(Invalid::JointLimit(Joint(joint)));
    let at_limit = step([4094, 2048, 2048, 2048], [3, 3, 3, 3]);
    assert_eq!(at_limit, Step { pose: Pose([4094, 2051, 2051, 2051]), invalid: limit(0) });
    let two = step([4094, 2048, 3070, 2048], [3, 3, 3, 3]);
    assert_eq!(two, Step { pose: Pose([4094, 2051, 3070, 2051]), invalid: limit(0) });
}

#[test]
fn a_joint_outside_its_range_is_invalid_even_unmoved() {
    let outside = step([0, 2048, 2048, 2048], [0; 4]);
    assert_eq!(outside, Step { pose: Pose([0, 2048, 2048, 2048]), invalid: Some(Invalid::JointLimit(Joint(0))) });
}

/// Walks one joint by 3 ticks until a step is refused.
fn walk_until_refused(mut pose: [i16; JOINTS], joint: u8, ticks: i8) -> (Pose, Step) {
    loop {
        let step = WIDOWX.step(Pose(pose), Move::single(Joint(joint), ticks));
        if step.invalid.is_some() {
            return (Pose(pose), step);
        }
        pose = step.pose.0;
    }
}

#[test]
fn a_collision_takes_the_whole_move_back() {
    // The outstretched arm bows its shoulder until the hand is on the table.
    let (before, refused) = walk_until_refused([2048; 4], 1, 3);
    let Step { pose, invalid } = refused;
    assert_eq!(pose, before);
    assert!(matches!(invalid, Some(Invalid::Collision(_))), "{invalid:?}");
    // With other joints in the same move: all of them stay.
    let together = WIDOWX.step(before, Move([3, 3, 0, 0]));
    assert_eq!(together, refused);
}

#[test]
fn a_limit_is_reported_before_a_collision_of_the_same_move() {
    let (before, _) = walk_until_refused([4094, 2048, 2048, 2048], 1, 3);
    let both = WIDOWX.step(before, Move([3, 3, 0, 0]));
    assert_eq!(both, Step { pose: before, invalid: Some(Invalid::JointLimit(Joint(0))) });
}

#[test]
fn collisions_of_every_kind() {
    let kinds: std::collections::BTreeSet<Option<Collision>> = (1025..=3071)
        .step_by(31)
        .flat_map(|shoulder| (1025..=3071).step_by(31).map(move |elbow| (shoulder, elbow)))
        .flat_map(|(shoulder, elbow)| (1025..=3071).step_by(31).map(move |wrist| [2048, shoulder, elbow, wrist]))
        .map(collision)
        .collect();
    let all = [None, Some(Collision::Table), Some(Collision::HandCorner), Some(Collision::Base)];
    assert_eq!(kinds, all.into_iter().collect());
}

#[test]
fn the_arm_at_home_is_free() {
    assert_eq!(collision(WIDOWX.home.0), None);
}

/// A plane whose hand points along +x from `wrist`, where the elbow is too; everything else is far away.
fn reaching(wrist: Point<f64>) -> Plane<f64> {
    let ahead = Direction { cos: 1.0, sin: 0.0 };
    let far = Point { x: 1000.0, z: 1000.0 };
    Plane {
        bracket: far,
        elbow: wrist,
        wrist,
        tip: far,
        forearm: ahead,
        forearm_across: ahead.quarter_behind(),
        hand: ahead,
        hand_across: ahead.quarter_behind(),
    }
}

/// A hand of length 10, from −1 to +1 across, no forearm to speak of, and one edge (four times).
fn shapes(edge: BaseEdge<f64>) -> Shapes<f64> {
    Shapes {
        hand_length: 10.0,
        hand_edges: [1.0, -1.0],
        forearm_overhang: 0.0,
        forearm_edges: [0.0, 0.0],
        base: [edge; 4],
    }
}

#[test]
fn touching_counts_as_a_hit() {
    // The tip's face is the segment from (20, 49) to (20, 51); the lower edge, which lies above here, is at z = 51.
    let plane = reaching(Point { x: 10.0, z: 50.0 });
    let hits = |x, z| plane.collision(&shapes(BaseEdge { x, z })) == Some(Collision::Base);
    assert!(hits([20.0, 30.0], [50.0, 50.0]), "a horizontal edge that ends on the face");
    assert!(!hits([20.1, 30.0], [50.0, 50.0]), "and just off it");
    assert!(hits([20.0, 20.0], [10.0, 49.0]), "a vertical edge that ends at the face's end");
    assert!(!hits([20.0, 20.0], [10.0, 48.9]), "and just below it");
    assert!(hits([15.0, 15.0], [50.0, 52.0]), "a vertical edge through the lower edge");
    assert!(hits([-20.0, -30.0], [50.0, 50.0]), "the mirror image of an edge");
    assert!(hits([12.0, 13.0], [51.0, 51.0]), "an edge along the face: undefined, so a hit");
}

#[test]
fn below_the_table_is_strict() {
    let far_edge = shapes(BaseEdge { x: [500.0, 510.0], z: [500.0, 500.0] });
    let at = |z| reaching(Point { x: 10.0, z }).collision(&far_edge);
    assert_eq!(at(1.0), None, "the lower corner is on the table");
    assert_eq!(at(0.9), Some(Collision::HandCorner));
    assert_eq!(at(-0.1), Some(Collision::Table));
}

fn inside() -> impl Strategy<Value = [i16; JOINTS]> {
    [2..=4094_i16, 1025..=3071_i16, 1025..=3071_i16, 1025..=3071_i16]
}

/// Checks that hold for every step from inside the limits, in any scalar.
fn check_step<S: Lattice>(arm: &Arm<S>, pose: Pose, wanted: Move) -> Result<(), TestCaseError> {
    let Step { pose: after, invalid } = arm.step(pose, wanted);
    prop_assert!(after.0.iter().zip(&arm.ranges).all(|(&ticks, range)| range.contains(ticks)));
    let asked = Pose(std::array::from_fn(|joint| pose.0[joint] + i16::from(wanted.0[joint])));
    match invalid {
        None => {
            prop_assert_eq!(after, asked);
            prop_assert_eq!(Plane::at(arm, after).collision(&arm.shapes), None);
        }
        Some(Invalid::JointLimit(joint)) => {
            let joint = usize::from(joint.0);
            prop_assert!(!arm.ranges[joint].contains(asked.0[joint]));
            prop_assert_eq!(after.0[joint], pose.0[joint]);
        }
        Some(Invalid::Collision(collision)) => {
            prop_assert_eq!(after, pose);
            prop_assert_eq!(Plane::at(arm, asked).collision(&arm.shapes), Some(collision));
        }
    }
    Ok(())
}

proptest! {
    #![proptest_config(ProptestConfig { cases: 4096, ..ProptestConfig::default() })]

    #[test]
    fn a_step_keeps_its_rules(pose in inside(), wanted: [i8; JOINTS]) {
        check_step(&WIDOWX, Pose(pose), Move(wanted))?;
        check_step(&WIDOWX.to_f32(), Pose(pose), Move(wanted))?;
    }

    #[test]
    fn a_step_of_the_policies_keeps_its_rules(pose in inside(), wanted in [-3..=3_i8, -3..=3, -3..=3, -3..=3]) {
        check_step(&WIDOWX, Pose(pose), Move(wanted))?;
        check_step(&WIDOWX.to_f32(), Pose(pose), Move(wanted))?;
    }

    #[test]
    fn no_pose_and_no_move_panics(pose: [i16; JOINTS], wanted: [i8; JOINTS]) {
        WIDOWX.step(Pose(pose), Move(wanted));
        WIDOWX.to_f32().step(Pose(pose), Move(wanted));
    }

    #[test]
    fn the_base_does_not_matter_to_a_collision(pose in inside(), base: i16) {
        let [_, shoulder, elbow, wrist] = pose;
        prop_assert_eq!(collision(pose), collision([base, shoulder, elbow, wrist]));
    }
}

#[test]
fn a_single_move_of_a_joint_that_does_not_exist_stops() {
    assert_eq!(Move::single(Joint(4), 3), Move::STOP);
    assert_eq!(Move::single(Joint(3), 3), Move([0, 0, 0, 3]));
}
