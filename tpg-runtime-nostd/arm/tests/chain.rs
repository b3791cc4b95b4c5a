//! General chains: the WidowX as one against the planar arm, derivatives against differences.

use proptest::prelude::*;
use std::f64::consts::TAU;
use tpg_arm::chain::{Axis, Chain, Kinematics, Link, Placed};
use tpg_arm::dodge::{Body, WIDOWX_RADII};
use tpg_arm::kinematics::distance;
use tpg_arm::{Arm, JointRange, Links, Pose, WIDOWX};

const LINK: Link<f64> = Link {
    origin: [0.0; 3],
    turned: Link::STRAIGHT,
    axis: Axis::Z,
    reversed: false,
    zero: 2048,
    range: JointRange { min: 0, max: 4095 },
};

/// The WidowX with a shoulder 30.4 mm ahead of the base's axis, as planar arm and as chain. The chain's frames are turned, so
/// that the shoulder's axis is its x, the others' are z.
const PLANAR: Arm<f64> = Arm { links: Links { shoulder_radial: 30.4, ..WIDOWX.links }, ..WIDOWX };
const CHAIN: Chain<f64, 4> = Chain {
    links: [
        Link { range: PLANAR.ranges[0], ..LINK },
        Link { origin: [0.0, 30.4, 125.0], axis: Axis::X, reversed: true, range: PLANAR.ranges[1], ..LINK },
        // z becomes x, x becomes y, y becomes z: a rotation by a third of a turn.
        Link {
            origin: [0.0, 49.0, 142.0],
            turned: [[0.0, 0.0, 1.0], [1.0, 0.0, 0.0], [0.0, 1.0, 0.0]],
            range: PLANAR.ranges[2],
            ..LINK
        },
        Link { origin: [142.0, 0.0, 0.0], range: PLANAR.ranges[3], ..LINK },
    ],
    tip: [155.0, 0.0, 0.0],
};

/// The WidowX 250 S. `tpg_problems` has it as a file, and a test of that against its URDF.
const WX250S: Chain<f64, 6> = Chain {
    links: [
        Link { origin: [0.0, 0.0, 72.0], range: JointRange { min: 1, max: 4095 }, ..LINK },
        Link { origin: [0.0, 0.0, 38.65], axis: Axis::Y, range: JointRange { min: 820, max: 3345 }, ..LINK },
        Link { origin: [49.75, 0.0, 250.0], axis: Axis::Y, range: JointRange { min: 649, max: 3094 }, ..LINK },
        Link { origin: [175.0, 0.0, 0.0], axis: Axis::X, range: JointRange { min: 1, max: 4095 }, ..LINK },
        Link { origin: [75.0, 0.0, 0.0], axis: Axis::Y, range: JointRange { min: 911, max: 3447 }, ..LINK },
        Link { origin: [65.0, 0.0, 0.0], axis: Axis::X, range: JointRange { min: 1, max: 4095 }, ..LINK },
    ],
    tip: [93.575, 0.0, 0.0],
};

fn planar_poses() -> impl Strategy<Value = [i16; 4]> {
    let [a, b, c, d] = PLANAR.ranges.map(|range| range.min..=range.max);
    (a, b, c, d).prop_map(|(a, b, c, d)| [a, b, c, d])
}

fn poses() -> impl Strategy<Value = [i16; 6]> {
    let [a, b, c, d, e, f] = WX250S.links.map(|link| link.range.min + 4..=link.range.max - 4);
    (a, b, c, d, e, f).prop_map(|(a, b, c, d, e, f)| [a, b, c, d, e, f])
}

fn places() -> impl Strategy<Value = [f64; 3]> {
    (-500.0..500.0, -500.0..500.0, 0.0..700.0).prop_map(|(x, y, z)| [x, y, z])
}

/// Returns the slope over 8 ticks, a radian.
fn slope(after: f64, before: f64) -> f64 {
    (after - before) / (8.0 * TAU / 4096.0)
}

fn beside<const N: usize>(pose: [i16; N], joint: usize, ticks: i16) -> [i16; N] {
    let mut beside = pose;
    beside[joint] += ticks;
    beside
}

/// Differences over 8 ticks are off by a third derivative, 600 mm · (4 · 2π/4096)² / 6 < 0.01 mm a radian.
fn jacobian_is_that_of_small_steps<const N: usize>(
    arm: &impl Kinematics<f64, N>,
    pose: [i16; N],
) -> Result<(), TestCaseError> {
    for (joint, moved) in arm.place(pose).jacobian().into_iter().enumerate() {
        let [before, after] = [-4, 4].map(|ticks| arm.place(beside(pose, joint, ticks)).tip);
        for axis in 0..3 {
            let slope = slope(after[axis], before[axis]);
            prop_assert!((slope - moved[axis]).abs() < 0.01, "joint {joint}: {slope}, {}", moved[axis]);
        }
    }
    Ok(())
}

proptest! {
    #[test]
    fn a_chain_made_of_the_planar_arm_is_the_planar_arm(pose in planar_poses()) {
        let (chain, planar): (Placed<f64, 4>, _) = (CHAIN.place(pose), PLANAR.place(pose));
        prop_assert!(distance(chain.tip, planar.tip) < 1e-12 * 600.0);
        for joint in 1..4 {
            prop_assert!(distance(chain.points[joint], planar.points[joint]) < 1e-12 * 600.0);
            prop_assert!(distance(chain.axes[joint], planar.axes[joint]) < 1e-12);
        }
        for (a, b) in chain.jacobian().into_iter().zip(planar.jacobian()) {
            prop_assert!(distance(a, b) < 1e-12 * 600.0);
        }
        prop_assert_eq!(chain.axes[0], planar.axes[0]);
        prop_assert!(CHAIN.allows(pose) && !CHAIN.allows(beside(pose, 1, 2048)));
    }

    #[test]
    fn jacobians_are_those_of_small_steps(planar in planar_poses(), pose in poses()) {
        jacobian_is_that_of_small_steps(&PLANAR, planar)?;
        jacobian_is_that_of_small_steps(&WX250S, pose)?;
    }

    /// The capsules of forearm and hand are the body's; upper arm and bracket are one here.
    #[test]
    fn the_planar_arm_is_as_far_from_a_ball_as_its_body(pose in planar_poses(), at in places()) {
        let body = Body::new(PLANAR.to_f32(), WIDOWX_RADII);
        let nearest = body.nearest(&body.at(Pose(pose)), at.map(|value| value as f32), 40.0);
        let [_, _, forearm, hand] = WIDOWX_RADII.map(f64::from);
        let near = PLANAR.place(pose).near(&[-1e3, -1e3, forearm, hand], at, 40.0);
        prop_assume!(nearest.capsule >= 2);
        prop_assert!((near.clearance - f64::from(nearest.clearance)).abs() < 1e-3);
        prop_assert_eq!(near.link, nearest.capsule);
        let gradients = PLANAR.place(pose).gradient(&near).into_iter().zip(body.gradient(&body.at(Pose(pose)), &nearest));
        for (own, bodys) in gradients {
            // Near an axis the direction away is ill-conditioned in f32.
            prop_assert!(near.clearance < -60.0 || (own - f64::from(bodys)).abs() < 0.5, "{own} {bodys}");
        }
    }

    #[test]
    fn the_clearance_grows_as_its_gradient_says(pose in poses(), at in places()) {
        let near = |pose| WX250S.place(pose).near(&[60.0, 40.0, 35.0, 35.0, 30.0, 30.0], at, 40.0);
        let here = near(pose);
        prop_assume!(here.clearance > -20.0);
        for (joint, gradient) in WX250S.place(pose).gradient(&here).into_iter().enumerate() {
            let [before, after] = [-4, 4].map(|ticks| near(beside(pose, joint, ticks)));
            // Where another link becomes the nearest the clearance has a kink.
            if before.link == here.link && after.link == here.link {
                let slope = slope(after.clearance, before.clearance);
                prop_assert!((slope - gradient).abs() < 1.5 + 0.01 * gradient.abs(), "{joint}: {slope} {gradient}");
            }
        }
    }
}

#[test]
fn an_arm_without_joints_is_far_from_everything() {
    let none: Chain<f64, 0> = Chain { links: [], tip: [1.0, 2.0, 3.0] };
    let placed = none.place([]);
    assert_eq!(placed.tip, [1.0, 2.0, 3.0]);
    assert_eq!(placed.near(&[], [0.0; 3], 5.0).clearance, f64::INFINITY);
}
