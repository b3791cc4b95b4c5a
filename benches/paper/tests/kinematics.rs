//! The runtime's kinematics against the paper's matrix chain, over the poses inside the joint limits: the error bounds
//! that `tpg_arm::kinematics` states, and the collision answers that differ.

use crate::support::fk::{self, CollisionDifference, Nearness};
use tpg_arm::kinematics::Lattice;
use tpg_arm::{Arm, Pose, WIDOWX};
use tpg_paper::chain::Chain;
use tpg_paper::plane;

/// Number of poses drawn. With 20,000,000 the figures stated by `tpg_arm::kinematics` are reproduced.
fn poses_to_draw() -> usize {
    tpg_testing::amount(1_000_000 / 10, 1_000_000)
}
/// Bounds stated by `tpg_arm::kinematics`, mm.
const F64_BOUND: f64 = 5e-13;
const F32_BOUND: f64 = 1.1e-4;

/// Draws uniformly distributed poses inside the limits with splitmix64.
fn poses(arm: &Arm<f64>, count: usize) -> impl Iterator<Item = Pose> {
    let ranges = arm.ranges;
    let mut state = 1_u64;
    let mut below = move |bound: u64| {
        state = state.wrapping_add(0x9e37_79b9_7f4a_7c15);
        let mut bits = state;
        bits = (bits ^ (bits >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
        bits = (bits ^ (bits >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
        (bits ^ (bits >> 31)) % bound
    };
    (0..count).map(move |_| Pose(ranges.map(|range| range.min + below((range.max - range.min) as u64 + 1) as i16)))
}

fn check<S: Lattice>(name: &str, arm: &Arm<S>, bound: f64) {
    let chain = Chain::new(WIDOWX);
    let drawn = poses(&WIDOWX, poses_to_draw()).map(|pose| fk::reference(&chain, pose));
    let Nearness { poses, worst, differences } = fk::nearness(&chain, arm, drawn);
    println!("{name}: {poses} poses, worst error {worst:e} mm, {} collision answers differ", differences.len());
    assert_eq!(poses, poses_to_draw());
    assert!(worst <= bound, "{name}: {worst:e} mm");
    assert_touching(name, bound, &differences);
}

/// Checks that collision results differ only where the clearance is below the kinematics' error.
fn assert_touching(name: &str, bound: f64, differences: &[CollisionDifference]) {
    for difference in differences {
        assert!(difference.clearance <= bound, "{name}: not explained by rounding: {difference:?}");
    }
}

#[test]
fn the_f64_lattice_path_is_within_its_bound() {
    check("f64", &WIDOWX, F64_BOUND);
}

#[test]
fn the_f32_lattice_path_is_within_its_bound() {
    check("f32", &WIDOWX.to_f32(), F32_BOUND);
}

/// Checks every pose that 3-tick actions can reach from home; collisions do not depend on the base's angle.
#[test]
#[ignore = "318 million poses: minutes"]
fn collision_answers_over_the_whole_grid_of_actions() {
    let narrow = WIDOWX.to_f32();
    let grid = |joint: usize| {
        let range = WIDOWX.ranges[joint];
        (range.min..=range.max).filter(move |ticks| (ticks - WIDOWX.home.0[joint]) % 3 == 0)
    };
    let (mut poses, mut in_f64, mut in_f32) = (0_u64, Vec::new(), Vec::new());
    for shoulder in grid(1) {
        for elbow in grid(2) {
            for wrist in grid(3) {
                let pose = Pose([WIDOWX.home.0[0], shoulder, elbow, wrist]);
                let expected = plane::collision(&WIDOWX, pose);
                in_f64.extend(fk::collision_difference(&WIDOWX, &WIDOWX, pose, expected));
                in_f32.extend(fk::collision_difference(&WIDOWX, &narrow, pose, expected));
                poses += 1;
            }
        }
    }
    println!("{poses} poses: {} answers differ in f64, {} in f32", in_f64.len(), in_f32.len());
    for difference in in_f64.iter().chain(&in_f32) {
        println!("{difference:?}");
    }
    assert_touching("f64", F64_BOUND, &in_f64);
    assert_touching("f32", F32_BOUND, &in_f32);
}
