//! The features of a [`Frame`] that the network reads.

use crate::arm::Joint;
use crate::frame::Frame;
use crate::kinematics::Lattice;

/// Number of features.
pub const FEATURES: usize = 38;

/// Lengths are divided by this, mm: about the arm's reach, halved.
const LENGTH: f32 = 250.0;
/// The fine error channels show this many mm as 1, and saturate at twice as many.
const NEAR: f32 = 25.0;
/// Limits and obstacles are seen from this far, in ticks and in mm.
const HORIZON: f32 = 60.0;

/// The names of the features, in order: the observation contract that a weight file declares.
pub const FEATURE_NAMES: [&str; FEATURES] = [
    "base",
    "shoulder",
    "elbow",
    "wrist",
    "radius",
    "height",
    "target_radius",
    "target_lateral",
    "target_height",
    "radial_error",
    "height_error",
    "near_radial_error",
    "near_lateral_error",
    "near_height_error",
    "upper_arm_sin",
    "upper_arm_cos",
    "forearm_sin",
    "forearm_cos",
    "hand_sin",
    "hand_cos",
    "pull_shoulder",
    "pull_elbow",
    "pull_wrist",
    "pull_base",
    "log_distance",
    "azimuth_front",
    "azimuth_back",
    "room_above_base",
    "room_below_base",
    "room_above_shoulder",
    "room_below_shoulder",
    "room_above_elbow",
    "room_below_elbow",
    "room_above_wrist",
    "room_below_wrist",
    "lowest_corner",
    "hand_clearance",
    "forearm_clearance",
];

/// Checksum of the features' names: a network of other features is refused.
pub const FEATURE_CONTRACT: u32 = tpg_runtime::net::contract(&FEATURE_NAMES);

/// The network's input, every value within about −2..2.
///
/// | index | value |
/// | --- | --- |
/// | 0–3 | (m0 − 2048)/2048; (m_i − 2048)/1024: motor positions, m in ticks |
/// | 4–10 | (ρ, z, t_r, t_l, t_z, e_r, e_z)/250 mm |
/// | 11–13 | (e_r, t_l, e_z)/25 mm, each clipped to ±2 |
/// | 14–19 | sin, cos of the angles of upper arm, forearm and hand |
/// | 20–23 | [`pull`](Frame::pull) of shoulder, elbow, wrist, base over 200 mm·(d + 5 mm) |
/// | 24 | ln(d + 3 mm)/3 − 1 |
/// | 25–26 | the two azimuth errors over π |
/// | 27–34 | per joint min(room above/60 ticks, 1), min(room below/60 ticks, 1) |
/// | 35 | min(height of the lowest hand corner/60 mm, 1) |
/// | 36–37 | min(clearance/60 mm, 1) of hand and forearm from the arm's base |
///
/// Costs four sines, one atan2, one ln and three roots, all of them in `f32`.
pub fn features(frame: &Frame<'_, f32>) -> [f32; FEATURES] {
    let [base, shoulder, elbow, wrist] = frame.pose().0.map(|ticks| f32::from(ticks) - 2048.0);
    let (radial, height) = (frame.radial_error(), frame.height_error());
    let (target_radius, lateral) = (frame.target_radius(), frame.target_lateral());
    let [upper_arm, forearm, hand] = frame.links();
    let distance = Lattice::sqrt(radial * radial + lateral * lateral + height * height);
    let pull = |joint| frame.pull(Joint(joint)) / (200.0 * (distance + 5.0));
    let [front, back] = frame.azimuth_errors();
    let room = |joint| frame.room(Joint(joint)).map(seen);
    let [[above_base, below_base], [above_shoulder, below_shoulder]] = [0, 1].map(room);
    let [[above_elbow, below_elbow], [above_wrist, below_wrist]] = [2, 3].map(room);
    let clearance = frame.clearance_up_to(HORIZON);
    [
        base / 2048.0,
        shoulder / 1024.0,
        elbow / 1024.0,
        wrist / 1024.0,
        frame.radius() / LENGTH,
        frame.height() / LENGTH,
        target_radius / LENGTH,
        lateral / LENGTH,
        frame.target()[2] / LENGTH,
        radial / LENGTH,
        height / LENGTH,
        near(radial),
        near(lateral),
        near(height),
        upper_arm.sin,
        upper_arm.cos,
        forearm.sin,
        forearm.cos,
        hand.sin,
        hand.cos,
        pull(1),
        pull(2),
        pull(3),
        pull(0),
        Lattice::ln(distance + 3.0) / 3.0 - 1.0,
        front / core::f32::consts::PI,
        back / core::f32::consts::PI,
        above_base,
        below_base,
        above_shoulder,
        below_shoulder,
        above_elbow,
        below_elbow,
        above_wrist,
        below_wrist,
        seen(frame.lowest_corner()),
        seen(clearance.hand),
        seen(clearance.forearm),
    ]
}

fn near(error: f32) -> f32 {
    (error / NEAR).clamp(-2.0, 2.0)
}

fn seen(room: f32) -> f32 {
    (room / HORIZON).min(1.0)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::arm::{Arm, Pose, WIDOWX};
    use proptest::prelude::*;

    const ARM: Arm<f32> = WIDOWX.to_f32();

    fn feature(name: &str, values: &[f32; FEATURES]) -> f32 {
        values[FEATURE_NAMES.iter().position(|&n| n == name).expect("a feature")]
    }

    #[test]
    fn at_home_before_a_target_ahead() {
        // Hand at (0, 346, 267); the target 25 mm further out and 10 mm lower.
        let frame = Frame::at(&ARM, ARM.home, [0.0, 371.0, 257.0]);
        let values = features(&frame);
        for (name, expected) in [
            ("radius", 346.0 / 250.0),
            ("near_radial_error", 1.0),
            ("near_height_error", -0.4),
            ("target_lateral", 0.0),
            ("azimuth_front", 0.0),
            ("azimuth_back", 1.0),
            ("room_above_wrist", 1.0),
            ("hand_clearance", 1.0),
        ] {
            assert!(
                (feature(name, &values).abs() - f32::abs(expected)).abs() < 1e-6,
                "{name}: {}",
                feature(name, &values)
            );
        }
        // Lowering the elbow's position lowers the hand; pulling the wrist down alike.
        assert!(feature("pull_shoulder", &values) != 0.0);
        assert!(feature("near_height_error", &values) < 0.0);
    }

    proptest! {
        #[test]
        fn what_is_beyond_the_horizon_need_not_be_known(
            (b, c, d) in (1025i16..=3071, 1025i16..=3071, 1025i16..=3071),
        ) {
            let frame = Frame::at(&ARM, Pose([2048, b, c, d]), [0.0, 300.0, 300.0]);
            let (whole, near) = (frame.clearance_up_to(f32::INFINITY), frame.clearance_up_to(HORIZON));
            prop_assert_eq!(seen(whole.hand), seen(near.hand));
            prop_assert_eq!(seen(whole.forearm), seen(near.forearm));
            prop_assert!(whole.hand >= HORIZON || whole.hand == near.hand);
        }

        #[test]
        fn every_feature_is_finite_and_small(
            (a, b, c, d) in (2i16..=4094, 1025i16..=3071, 1025i16..=3071, 1025i16..=3071),
            (x, y, z) in (-500f32..500.0, -500f32..500.0, 0f32..620.0),
        ) {
            for (value, name) in features(&Frame::at(&ARM, Pose([a, b, c, d]), [x, y, z])).iter().zip(FEATURE_NAMES) {
                prop_assert!(value.is_finite() && value.abs() <= 5.0, "{name} = {value}");
            }
        }
    }
}
