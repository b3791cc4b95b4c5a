//! Kinematics on the motor lattice against libm, over every motor position and many poses, and its symmetries.

use proptest::prelude::*;
use std::f64::consts::PI;
use tpg_arm::kinematics::{self, Angle, Direction, Lattice, Plane};
use tpg_arm::{Arm, JOINTS, Joint, Pose, TICKS_PER_TURN, WIDOWX};

/// The whole turn, a turn below it and a turn above.
const POSITIONS: std::ops::Range<i32> = -TICKS_PER_TURN..2 * TICKS_PER_TURN;

/// The sine of a position, by libm at the angle reduced to its quarter: integers reduce without rounding.
fn reference_sine(ticks: i32) -> f64 {
    let half_turn = TICKS_PER_TURN / 2;
    let within_half = ticks.rem_euclid(half_turn);
    let within_quarter = within_half.min(half_turn - within_half);
    let sine = libm::sin(f64::from(within_quarter) * PI / f64::from(half_turn));
    if ticks.div_euclid(half_turn) % 2 == 0 { sine } else { -sine }
}

#[test]
fn the_f64_table_is_libm_at_every_position() {
    for ticks in POSITIONS {
        let Direction { cos, sin } = Angle(ticks).direction::<f64>();
        assert_eq!(sin.to_bits(), reference_sine(ticks).to_bits(), "sin {ticks}");
        assert_eq!(cos.to_bits(), reference_sine(ticks + TICKS_PER_TURN / 4).to_bits(), "cos {ticks}");
    }
}

#[test]
fn the_f32_table_is_libm_at_every_position_rounded_once() {
    for ticks in POSITIONS {
        let Direction { cos, sin } = Angle(ticks).direction::<f32>();
        assert_eq!(sin.to_bits(), (reference_sine(ticks) as f32).to_bits(), "sin {ticks}");
        assert_eq!(cos.to_bits(), (reference_sine(ticks + TICKS_PER_TURN / 4) as f32).to_bits(), "cos {ticks}");
    }
}

/// libm at the unreduced angle differs by what rounding the angle itself costs.
#[test]
fn the_tables_are_near_libm_at_the_unreduced_angle() {
    for ticks in 0..TICKS_PER_TURN {
        let radians = f64::from(ticks) * PI / f64::from(TICKS_PER_TURN / 2);
        let wide = Angle(ticks).direction::<f64>();
        assert!((wide.sin - libm::sin(radians)).abs() <= 1e-15, "sin {ticks}");
        assert!((wide.cos - libm::cos(radians)).abs() <= 1e-15, "cos {ticks}");
        let narrow = Angle(ticks).direction::<f32>();
        assert!((f64::from(narrow.sin) - libm::sin(radians)).abs() <= 3e-8, "sin {ticks}");
        assert!((f64::from(narrow.cos) - libm::cos(radians)).abs() <= 3e-8, "cos {ticks}");
    }
}

#[test]
fn quarters_turn_exactly() {
    let quarter = TICKS_PER_TURN / 4;
    for ticks in POSITIONS {
        let here = Angle(ticks).direction::<f64>();
        assert_eq!(here.quarter_ahead(), Angle(ticks + quarter).direction());
        assert_eq!(here.quarter_behind(), Angle(ticks - quarter).direction());
    }
}

#[test]
fn the_sine_table_ends() {
    assert_eq!(f64::quarter_sine(1024), 1.0);
    assert_eq!((f64::quarter_sine(1025), f32::quarter_sine(usize::MAX)), (0.0, 0.0));
}

#[test]
fn the_arm_at_home() {
    assert_eq!(kinematics::hand(&WIDOWX, WIDOWX.home), [0.0, 346.0, 267.0]);
    assert_eq!(kinematics::hand(&WIDOWX.to_f32(), WIDOWX.home), [0.0, 346.0, 267.0]);
}

/// The greatest distance, mm, between the hand by table and by libm, over poses that cover the joints' ranges.
fn worst_against_radians<S: Lattice>(arm: &Arm<S>) -> f64 {
    let positions = |joint: usize| {
        let range = arm.ranges[joint];
        // Primes, so that ends, middles and everything between come up.
        (range.min..=range.max).step_by(tpg_testing::amount(127, 61)).chain([range.max])
    };
    let mut worst = 0.0_f64;
    for base in positions(0) {
        for shoulder in positions(1) {
            for elbow in positions(2) {
                for wrist in positions(3) {
                    let pose = Pose([base, shoulder, elbow, wrist]);
                    let radians = [0, 1, 2, 3].map(|joint| kinematics::radians(pose, Joint(joint)));
                    let by_table = kinematics::hand(arm, pose);
                    let by_libm = kinematics::hand_from_radians(arm, radians);
                    worst = worst.max(kinematics::distance(by_table.map(S::to_f64), by_libm.map(S::to_f64)));
                }
            }
        }
    }
    worst
}

#[test]
fn the_lattice_path_is_near_libm_in_f64() {
    let worst = worst_against_radians(&WIDOWX);
    println!("worst {worst:e} mm");
    assert!(worst <= 6e-13, "{worst:e} mm");
}

#[test]
fn the_lattice_path_is_near_libm_in_f32() {
    let worst = worst_against_radians(&WIDOWX.to_f32());
    println!("worst {worst:e} mm");
    assert!(worst <= 3e-4, "{worst:e} mm");
}

#[test]
fn a_joint_that_does_not_exist_has_no_angle() {
    assert_eq!(kinematics::radians::<f64>(Pose([0; JOINTS]), Joint(4)), 0.0);
}

proptest! {
    #[test]
    fn no_pose_panics(positions: [i16; JOINTS]) {
        let pose = Pose(positions);
        for coordinate in kinematics::hand(&WIDOWX, pose) {
            prop_assert!(coordinate.abs() <= 700.0);
        }
        for coordinate in kinematics::hand(&WIDOWX.to_f32(), pose) {
            prop_assert!(coordinate.abs() <= 700.0);
        }
        Plane::at(&WIDOWX, pose).collision(&WIDOWX.shapes);
        Plane::at(&WIDOWX.to_f32(), pose).collision(&WIDOWX.to_f32().shapes);
    }

    #[test]
    fn no_angle_panics(ticks: i32) {
        let Direction { cos, sin } = Angle(ticks).direction::<f64>();
        prop_assert!((cos * cos + sin * sin - 1.0).abs() <= 4e-16);
        prop_assert_eq!(Angle(ticks.wrapping_add(TICKS_PER_TURN)).direction::<f64>(), Direction { cos, sin });
    }

    #[test]
    fn the_base_swings_the_hand_about_its_axis(positions: [i16; JOINTS], base: i16) {
        let [x, y, z] = kinematics::hand(&WIDOWX, Pose(positions));
        let [_, shoulder, elbow, wrist] = positions;
        let [turned_x, turned_y, turned_z] = kinematics::hand(&WIDOWX, Pose([base, shoulder, elbow, wrist]));
        prop_assert_eq!(z, turned_z);
        prop_assert!((x.hypot(y) - turned_x.hypot(turned_y)).abs() <= 1e-12);
    }
}
