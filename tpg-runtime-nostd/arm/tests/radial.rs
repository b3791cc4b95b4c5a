//! An arm whose shoulder stands in front of the base's axis: what the base turns round further out, and what aims at it.

use proptest::prelude::*;
use std::f32::consts::TAU;
use tpg_arm::dodge::{Body, WIDOWX_RADII};
use tpg_arm::frame::Frame;
use tpg_arm::kinematics::{self, Plane};
use tpg_arm::observation::{Observation, Source, TargetMemo};
use tpg_arm::{Arm, Joint, Links, Pose, WIDOWX};

const RADIAL: f64 = 30.4;
const ARM: Arm<f64> = Arm { links: Links { shoulder_radial: RADIAL, ..WIDOWX.links }, ..WIDOWX };
const BODY: Body = Body::new(ARM.to_f32(), WIDOWX_RADII);

fn poses() -> impl Strategy<Value = Pose> {
    (2i16..=4094, 1025i16..=3071, 1025i16..=3071, 1025i16..=3071).prop_map(|(a, b, c, d)| Pose([a, b, c, d]))
}

fn targets() -> impl Strategy<Value = [f64; 3]> {
    (-450.0..450.0, -450.0..450.0, 0.0..600.0).prop_map(|(x, y, z)| [x, y, z])
}

proptest! {
    #[test]
    fn the_whole_arm_stands_further_out(pose in poses()) {
        let (there, here) = (kinematics::hand(&ARM, pose), kinematics::hand(&WIDOWX, pose));
        let angle: f64 = kinematics::radians(pose, Joint(0));
        let ahead = [-RADIAL * angle.sin(), RADIAL * angle.cos(), 0.0];
        for axis in 0..3 {
            prop_assert!((there[axis] - here[axis] - ahead[axis]).abs() < 1e-9);
        }
        prop_assert!(kinematics::distance(there, [0.0, 0.0, ARM.links.base]) <= ARM.reach() + 1e-9);
    }

    #[test]
    fn pulls_are_the_gradient_of_the_distance(pose in poses(), target in targets()) {
        let frame = Frame::at(&ARM, pose, target);
        let half_square = |joint: usize, by: f64| {
            let mut angles = [0, 1, 2, 3].map(|joint| kinematics::radians(pose, Joint(joint)));
            angles[joint] += by;
            let d = kinematics::distance(kinematics::hand_from_radians(&ARM, angles), target);
            0.5 * d * d
        };
        for joint in 0..4 {
            let slope = (half_square(joint, 1e-5) - half_square(joint, -1e-5)) / 2e-5;
            let pull = frame.pull(Joint(joint as u8));
            prop_assert!((pull + slope).abs() < 1e-3 + 1e-6 * slope.abs(), "joint {joint}: {pull} against {}", -slope);
        }
    }

    #[test]
    fn the_clearance_grows_as_its_gradient_says(pose in poses(), at in targets()) {
        const TICKS: i16 = 4;
        let nearest = |pose| BODY.nearest(&BODY.at(pose), at.map(|value| value as f32), 40.0);
        let here = nearest(pose);
        prop_assume!(here.clearance > -20.0);
        for (joint, slope) in BODY.gradient(&BODY.at(pose), &here).into_iter().enumerate() {
            let beside = |ticks: i16| {
                let mut pose = pose;
                pose.0[joint] += ticks;
                nearest(pose)
            };
            let (before, after) = (beside(-TICKS), beside(TICKS));
            if before.capsule == here.capsule && after.capsule == here.capsule {
                let difference = (after.clearance - before.clearance) / (2.0 * f32::from(TICKS) * TAU / 4096.0);
                prop_assert!((difference - slope).abs() < 1.5 + 0.01 * slope.abs(), "{joint}: {difference} {slope}");
            }
        }
    }

    #[test]
    fn values_stay_within_their_ranges(pose in poses(), goal in poses()) {
        let free = |pose| Plane::at(&ARM, pose).collision(&ARM.shapes).is_none();
        prop_assume!(free(pose) && free(goal));
        let seen = Observation::at(&ARM, pose, kinematics::hand(&ARM, goal));
        for source in Source::ALL {
            let mut values = [0.0; 8];
            Source::fill(&[source], &ARM, &seen, &TargetMemo::new(), &mut values);
            for (index, value) in values.into_iter().take(source.length()).enumerate() {
                let [low, high] = source.range(&ARM, index);
                prop_assert!(low <= value && value <= high, "{} {index}: {value}", source.name());
            }
        }
    }
}

/// The stance of the WidowX's own test, with its bound.
#[test]
fn the_stance_reaches_most_targets() {
    let (mut asked, mut solved) = (0, 0);
    for index in 0..3000i32 {
        let within = |joint: usize, part: i32| {
            let range = ARM.ranges[joint];
            (i32::from(range.min) + (i32::from(range.max) - i32::from(range.min)) * (part % 211) / 210) as i16
        };
        let goal = Pose([within(0, index * 7), within(1, index * 13), within(2, index * 29), within(3, index * 53)]);
        let free = |pose| Plane::at(&ARM, pose).collision(&ARM.shapes).is_none();
        if !free(goal) {
            continue;
        }
        asked += 1;
        let target = kinematics::hand(&ARM, goal);
        let mut errors = [0.0; 4];
        Source::fill(
            &[Source::Stance],
            &ARM,
            &Observation::at(&ARM, ARM.home, target),
            &TargetMemo::new(),
            &mut errors,
        );
        let there = Pose(errors.map(|error| (2048.0 + error + 0.5) as i16));
        // Rounding to ticks moves the hand by up to about 1 mm.
        solved += u32::from(free(there) && kinematics::distance(kinematics::hand(&ARM, there), target) < 1.3);
    }
    assert!(asked > 500 && solved * 10 > asked * 9, "{solved} of {asked}");
}
