//! The derived quantities against independent computations: finite differences, sampling, the world frame.

use proptest::prelude::*;
use tpg_arm::frame::{Clearance, Frame};
use tpg_arm::kinematics::{self, Plane, Point};
use tpg_arm::observation::Observation;
use tpg_arm::{Arm, BaseEdge, Joint, Pose, WIDOWX};

fn poses() -> impl Strategy<Value = Pose> {
    (2i16..=4094, 1025i16..=3071, 1025i16..=3071, 1025i16..=3071).prop_map(|(a, b, c, d)| Pose([a, b, c, d]))
}

fn targets() -> impl Strategy<Value = [f64; 3]> {
    (-450.0..450.0, -450.0..450.0, 0.0..600.0).prop_map(|(x, y, z)| [x, y, z])
}

fn joint_angles(pose: Pose) -> [f64; 4] {
    [0, 1, 2, 3].map(|joint| kinematics::radians(pose, Joint(joint)))
}

proptest! {
    #[test]
    fn errors_are_those_of_the_world_turned_by_the_base(pose in poses(), target in targets()) {
        let observation = Observation::at(&WIDOWX, pose, target);
        let frame = Frame::new(&WIDOWX, &observation);
        let angle: f64 = kinematics::radians(pose, Joint(0));
        let [hx, hy, hz] = observation.hand;
        prop_assert!((hx + frame.radius() * angle.sin()).abs() < 1e-9);
        prop_assert!((hy - frame.radius() * angle.cos()).abs() < 1e-9);
        prop_assert!((hz - frame.height()).abs() < 1e-9);
        // The target is put together again from its two coordinates.
        let (radius, lateral) = (frame.target_radius(), frame.target_lateral());
        prop_assert!((target[0] - (lateral * angle.cos() - radius * angle.sin())).abs() < 1e-9);
        prop_assert!((target[1] - (lateral * angle.sin() + radius * angle.cos())).abs() < 1e-9);
    }

    #[test]
    fn pulls_are_the_gradient_of_the_distance(pose in poses(), target in targets()) {
        let frame = Frame::at(&WIDOWX, pose, target);
        let half_square = |angles: [f64; 4]| {
            let d = kinematics::distance(kinematics::hand_from_radians(&WIDOWX, angles), target);
            0.5 * d * d
        };
        for joint in 0..4 {
            let step = 1e-5;
            let (mut up, mut down) = (joint_angles(pose), joint_angles(pose));
            up[joint] += step;
            down[joint] -= step;
            let slope = (half_square(up) - half_square(down)) / (2.0 * step);
            let pull = frame.pull(Joint(joint as u8));
            prop_assert!((pull + slope).abs() < 1e-3 + 1e-6 * slope.abs(), "joint {joint}: {pull} against {}", -slope);
        }
    }

    #[test]
    fn an_azimuth_error_is_the_turn_that_brings_the_target_into_the_plane(pose in poses(), target in targets()) {
        prop_assume!(target[0].hypot(target[1]) > 1.0);
        let frame = Frame::at(&WIDOWX, pose, target);
        let [front, back] = frame.azimuth_errors();
        let base: f64 = kinematics::radians(pose, Joint(0));
        for (error, side) in [(front, 1.0), (back, -1.0)] {
            let angle = base + error;
            let lateral = target[0] * angle.cos() + target[1] * angle.sin();
            let radial = -target[0] * angle.sin() + target[1] * angle.cos();
            prop_assert!(lateral.abs() < 1e-9 && radial * side > 0.0);
            prop_assert!(angle.abs() <= std::f64::consts::PI + 1e-12);
        }
    }

    #[test]
    fn single_precision_is_near_double(pose in poses(), target in targets()) {
        let arm = WIDOWX.to_f32();
        let narrow = Frame::at(&arm, pose, target.map(|v| v as f32));
        let wide = Frame::at(&WIDOWX, pose, target.map(|v| f64::from(v as f32)));
        let near = |a: f32, b: f64, bound: f64| (f64::from(a) - b).abs() < bound;
        prop_assert!(near(narrow.radial_error(), wide.radial_error(), 5e-4));
        prop_assert!(near(narrow.lowest_corner(), wide.lowest_corner(), 5e-4));
        prop_assert!(near(narrow.clearance_up_to(f32::INFINITY).hand, wide.clearance_up_to(f64::INFINITY).hand, 2e-3));
        for joint in 0..4 {
            prop_assert!(near(narrow.pull(Joint(joint)), wide.pull(Joint(joint)), 0.5));
        }
    }

    #[test]
    fn clearance_is_the_least_distance_of_densely_sampled_sides(pose in poses()) {
        let plane = Plane::at(&WIDOWX, pose);
        if plane.collision(&WIDOWX.shapes).is_some() {
            return Ok(()); // about a third of the poses
        }
        let Clearance { hand, forearm } = Clearance::new(&plane, &WIDOWX.shapes);
        let (sampled_hand, sampled_forearm) = sampled(&WIDOWX, &plane);
        // Samples lie 1 mm apart at most, so the sampled distance is over the true one by 0.5 mm at most.
        prop_assert!(hand <= sampled_hand + 1e-9 && sampled_hand <= hand + 0.5, "{hand} {sampled_hand}");
        prop_assert!(forearm <= sampled_forearm + 1e-9 && sampled_forearm <= forearm + 0.5);
    }
}

/// The least distance from points along each part's two sides to the base's edges.
fn sampled(arm: &Arm<f64>, plane: &Plane<f64>) -> (f64, f64) {
    let shapes = &arm.shapes;
    let [upper, lower] = plane.tip_corners(shapes);
    let heel = plane.wrist.along(plane.hand_across, shapes.hand_edges[1]);
    let [end_upper, end_lower] = plane.forearm_end_corners(shapes);
    let elbow = plane.elbow.along(plane.forearm_across, shapes.forearm_edges[1]);
    let side = |p: Point<f64>, q: Point<f64>| {
        (0..=400).map(|i| f64::from(i) / 400.0).map(move |t| (p.x + t * (q.x - p.x), p.z + t * (q.z - p.z)))
    };
    let least = |points: &mut dyn Iterator<Item = (f64, f64)>| {
        points.map(|point| distance_to_base(&shapes.base, point)).fold(f64::INFINITY, f64::min)
    };
    (
        least(&mut side(upper, lower).chain(side(heel, lower))),
        least(&mut side(end_upper, end_lower).chain(side(elbow, end_lower))),
    )
}

/// To the staircase under the outline.
fn distance_to_base(base: &[BaseEdge<f64>], (x, z): (f64, f64)) -> f64 {
    let to_box = |edge: &BaseEdge<f64>| (x.abs() - edge.x[1]).max(0.0).hypot((z - edge.z[1]).max(0.0));
    base.iter().map(to_box).fold(f64::INFINITY, f64::min)
}

#[test]
fn clearance_falls_to_nothing_before_the_arm_hits_its_base() {
    // Turn the wrist tick by tick until it hits the base: one tick before, the clearance is almost 0.
    let mut touched = 0;
    for elbow in (1050..2000).step_by(50) {
        for shoulder in (1500..2400).step_by(100) {
            let free = |wrist: i16| {
                let plane = Plane::at(&WIDOWX, Pose([2048, shoulder, elbow, wrist]));
                plane.collision(&WIDOWX.shapes).is_none()
            };
            let Some(wrist) = (1026i16..3071).find(|&wrist| free(wrist) && !free(wrist - 1)) else { continue };
            let hit = Plane::at(&WIDOWX, Pose([2048, shoulder, elbow, wrist - 1])).collision(&WIDOWX.shapes);
            if hit == Some(tpg_arm::Collision::Base) {
                touched += 1;
                let plane = Plane::at(&WIDOWX, Pose([2048, shoulder, elbow, wrist]));
                let clearance = Clearance::new(&plane, &WIDOWX.shapes).hand;
                assert!(clearance < 0.5, "{clearance} mm left at {shoulder} {elbow} {wrist}");
            }
        }
    }
    assert!(touched > 10, "only {touched} poses touch: the test would show nothing");
}

#[test]
fn room_is_what_the_range_leaves() {
    let frame = Frame::at(&WIDOWX, Pose([2, 3071, 2048, 1030]), [0.0, 300.0, 100.0]);
    let room = |joint| frame.room(Joint(joint));
    assert_eq!([0, 1, 2, 3].map(room), [[4092.0, 0.0], [0.0, 2046.0], [1023.0, 1023.0], [2041.0, 5.0]]);
    assert_eq!(room(4), [0.0, 0.0]);
}

#[test]
fn the_links_point_as_the_plane_says() {
    let frame = Frame::at(&WIDOWX, WIDOWX.home, [0.0, 300.0, 100.0]);
    let [upper_arm, forearm, hand] = frame.links();
    assert_eq!((upper_arm.cos, upper_arm.sin), (0.0, 1.0));
    assert_eq!((forearm.cos, forearm.sin, hand.cos, hand.sin), (-1.0, 0.0, -1.0, 0.0));
    assert_eq!((frame.radius(), frame.height()), (346.0, 267.0));
}
