//! The known arms against their makers' own descriptions: tips by another program, from the URDF (`arms/vectors.py`).

use std::f64::consts::{PI, TAU};
use tpg_arm::kinematics::{Plane, distance, hand, hand_from_radians};
use tpg_arm::{Arm, JOINTS, Pose, TICKS_PER_TURN};
use tpg_problems::arm::arms::NamedArm;
use tpg_problems::arm::ik;

/// An arm with what turns the URDF's angles into its own: own = sign · URDF's + zero, rad.
struct Known {
    name: &'static str,
    tips: &'static str,
    signs: [f64; JOINTS],
    zeros: [f64; JOINTS],
    /// The URDF's limits, rad.
    limits: [[f64; 2]; JOINTS],
    /// Greatest distance of the tips, mm.
    bound: f64,
}

/// The tables have five decimals of a millimetre. The SO-101's axes are parallel to 0.00001 rad only.
fn known() -> [Known; 3] {
    let degrees = |limits: [[f64; 2]; JOINTS]| limits.map(|ends| ends.map(f64::to_radians));
    [
        Known {
            name: "px100",
            tips: include_str!("arms/px100.csv"),
            signs: [1.0, 1.0, -1.0, -1.0],
            zeros: [0.0; JOINTS],
            limits: degrees([[-179.9999, 179.9999], [-111.0, 107.0], [-121.0, 92.0], [-100.0, 123.0]]),
            bound: 1e-4,
        },
        Known {
            name: "open-manipulator-x",
            tips: include_str!("arms/open-manipulator-x.csv"),
            signs: [1.0, 1.0, -1.0, -1.0],
            zeros: [0.0; JOINTS],
            limits: [[-PI, PI], [-1.5, 1.5], [-1.5, 1.4], [-1.7, 1.97]],
            bound: 1e-4,
        },
        Known {
            name: "so101",
            tips: include_str!("arms/so101.csv"),
            signs: [-1.0, 1.0, -1.0, -1.0],
            zeros: [0.0, 0.0, 0.038528, -0.088104],
            limits: [[-1.91986, 1.91986], [-1.74533, 1.74533], [-1.69, 1.69], [-1.65806, 1.65806]],
            bound: 0.02,
        },
    ]
}

/// Rows of numbers below a heading.
fn rows(text: &str) -> impl Iterator<Item = Vec<f64>> {
    text.lines().skip(1).map(|line| line.split(',').map(|value| value.parse().expect("a number")).collect())
}

fn arm(name: &str) -> Arm<f64> {
    Arm::from(&NamedArm::find(name).expect("it is known").description())
}

#[test]
fn tips_are_where_the_urdf_puts_them() {
    for Known { name, tips, signs, zeros, bound, .. } in known() {
        let (arm, mut worst, mut poses) = (arm(name), 0.0f64, 0);
        for row in rows(tips) {
            let [a, b, c, d, x, y, z] = row[..] else { panic!("seven numbers") };
            let radians = [a, b, c, d].map(|ticks| ticks * TAU / f64::from(TICKS_PER_TURN));
            let angles = std::array::from_fn(|joint| signs[joint] * radians[joint] + zeros[joint]);
            // Ahead is x in the URDF and y here.
            worst = worst.max(distance(hand_from_radians(&arm, angles), [-y, x, z]));
            poses += 1;
        }
        assert!(poses >= 100 && worst < bound, "{name}: {poses} poses, {worst} mm");
    }
}

#[test]
fn ranges_are_the_urdfs_limits_to_a_tick_and_never_beyond() {
    for Known { name, signs, zeros, limits, .. } in known() {
        for (joint, range) in arm(name).ranges.into_iter().enumerate() {
            let ticks = |angle: f64| (signs[joint] * angle + zeros[joint]) * f64::from(TICKS_PER_TURN) / TAU + 2048.0;
            let [one, other] = limits[joint].map(ticks);
            let (low, high) = (one.min(other) - 1e-6, one.max(other) + 1e-6);
            let (min, max) = (f64::from(range.min), f64::from(range.max));
            assert!(low <= min && min < low + 1.01 && max <= high && high - 1.01 < max, "{name}, joint {joint}");
        }
    }
}

/// On the way there and back: the inverse kinematics of an arm finds the poses whose tips it was given.
#[test]
fn nearly_every_tip_of_a_free_pose_has_a_goal() {
    for Known { name, .. } in known() {
        let arm = arm(name);
        let (mut asked, mut found) = (0, 0);
        for index in 0..400i32 {
            let within = |joint: usize, part: i32| {
                let range = arm.ranges[joint];
                (i32::from(range.min) + (i32::from(range.max) - i32::from(range.min)) * (part % 101) / 100) as i16
            };
            let pose =
                Pose([within(0, index * 7), within(1, index * 13), within(2, index * 29), within(3, index * 53)]);
            if Plane::at(&arm, pose).collision(&arm.shapes).is_none() {
                asked += 1;
                found += u32::from(!ik::goals_of_pitches(&arm, hand(&arm, pose), 1440).is_empty());
            }
        }
        assert!(asked > 100 && found + 4 >= asked, "{name}: {found} of {asked}");
    }
}
