//! A base that turns by less than a whole turn: targets that it cannot face are reached over the arm's back.

use tpg_arm::kinematics::{self, Plane};
use tpg_arm::observation::{Observation, Source, TargetMemo};
use tpg_arm::{Arm, JointRange, Links, Pose, WIDOWX};

/// Its base turns by 110 degrees to either side, as that of many small arms.
const ARM: Arm<f64> = limited(WIDOWX);
/// Its shoulder stands in front of the base's axis, too.
const RADIAL: Arm<f64> = limited(Arm { links: Links { shoulder_radial: 30.4, ..WIDOWX.links }, ..WIDOWX });

const fn limited(arm: Arm<f64>) -> Arm<f64> {
    let [_, shoulder, elbow, wrist] = arm.ranges;
    Arm { ranges: [JointRange { min: 797, max: 3299 }, shoulder, elbow, wrist], ..arm }
}

/// Evenly spread poses of an arm that are free.
fn free_poses(arm: &Arm<f64>) -> impl Iterator<Item = Pose> {
    let within = |joint: usize, part: i32| {
        let range = arm.ranges[joint];
        (i32::from(range.min) + (i32::from(range.max) - i32::from(range.min)) * (part % 211) / 210) as i16
    };
    let pose = move |index: i32| {
        Pose([within(0, index * 7), within(1, index * 13), within(2, index * 29), within(3, index * 53)])
    };
    (0..6000).map(pose).filter(|&pose| free(arm, pose))
}

fn free(arm: &Arm<f64>, pose: Pose) -> bool {
    Plane::at(arm, pose).collision(&arm.shapes).is_none()
}

/// The base's position that faces a target.
fn facing([x, y, _]: [f64; 3]) -> f64 {
    2048.0 + (-x).atan2(y) * 4096.0 / std::f64::consts::TAU
}

fn stance(arm: &Arm<f64>, target: [f64; 3]) -> [f64; 4] {
    let mut errors = [0.0; 4];
    Source::fill(&[Source::Stance], arm, &Observation::at(arm, arm.home, target), &TargetMemo::new(), &mut errors);
    errors.map(|error| 2048.0 + error)
}

#[test]
fn targets_that_the_base_cannot_face_are_reached_over_the_back() {
    for arm in [&ARM, &RADIAL] {
        let (mut asked, mut solved) = (0, 0);
        for goal in free_poses(arm) {
            let target = kinematics::hand(arm, goal);
            let [base, ..] = stance(arm, target);
            let beyond = |ticks: f64| !(795.0..=3301.0).contains(&ticks);
            assert!(!beyond(base), "{goal:?}: the base shall turn to {base}");
            if !beyond(facing(target)) {
                assert!((base - facing(target)).abs() < 1e-9, "{goal:?}: a target that the base can face");
                continue;
            }
            asked += 1;
            let there = Pose(stance(arm, target).map(|ticks| (ticks + 0.5) as i16));
            let off = kinematics::distance(kinematics::hand(arm, there), target);
            solved += u32::from(free(arm, there) && off < 1.3);
        }
        assert!(asked > 300 && solved * 10 > asked * 9, "{solved} of {asked}");
    }
}

#[test]
fn a_base_of_less_than_half_a_turn_still_aims_at_what_it_cannot_reach() {
    let narrow =
        Arm { ranges: [JointRange { min: 1536, max: 2560 }, ARM.ranges[1], ARM.ranges[2], ARM.ranges[3]], ..ARM };
    let aside = [-300.0, 0.0, 200.0];
    assert_eq!(stance(&narrow, aside)[0], facing(aside));
}
