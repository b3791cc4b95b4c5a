//! An arm whose shoulder stands in front of the base's axis, described in C: the library answers with the same bits as Rust.

use crate::linked;
use crate::text::{braces, float, push_bits};
use std::fmt::Write as _;
use std::fs;
use tempfile::TempDir;
use tpg_arm::kinematics::{self, Plane};
use tpg_arm::observation::{Observation, Source, TargetMemo};
use tpg_arm::{Arm, BaseEdge, Collision, Invalid, JointRange, Links, Move, Pose, Shapes, Step};
use tpg_testing::numbers::Numbers;

/// The SO-101's numbers.
const ARM: Arm<f64> = Arm {
    home: Pose([2048; 4]),
    fixed_servos: [2048; 2],
    ranges: [
        JointRange { min: 797, max: 3299 },
        JointRange { min: 911, max: 3185 },
        JointRange { min: 972, max: 3174 },
        JointRange { min: 910, max: 3071 },
    ],
    links: Links {
        base: 116.6,
        upper_arm: 112.57,
        elbow_offset: 28.0,
        forearm: 135.0,
        hand: 159.423,
        shoulder_radial: 30.399,
    },
    shapes: Shapes {
        hand_length: 167.0,
        hand_edges: [37.0, -33.0],
        forearm_overhang: 10.2,
        forearm_edges: [20.0, -18.0],
        base: [
            BaseEdge { x: [69.9, 69.9], z: [0.0, 69.6] },
            BaseEdge { x: [50.6, 69.9], z: [69.6, 69.6] },
            BaseEdge { x: [50.6, 50.6], z: [69.6, 126.8] },
            BaseEdge { x: [0.0, 50.6], z: [126.8, 126.8] },
        ],
    },
};

const POSES: usize = 2000;
/// The most values of a source.
const LONGEST: usize = 8;

struct Case {
    pose: Pose,
    wanted: Move,
    target: [f32; 3],
}

/// Poses over the whole range, every tenth at its ends; each with the hand's place at another one for its target.
fn cases(arm: &Arm<f32>) -> Vec<Case> {
    let mut numbers = Numbers(11);
    let mut pose = |end: bool| {
        Pose(arm.ranges.map(|JointRange { min, max }| {
            let span = i32::from(max) - i32::from(min);
            let within = (numbers.next_u32() % (span as u32 + 1)) as i16;
            if end && within % 2 == 0 { min } else { min + within }
        }))
    };
    let case = |number: usize| {
        let (here, there) = (pose(number.is_multiple_of(10)), pose(false));
        let wanted = Move([0, 1, 2, 3].map(|joint: usize| ((number + joint) % 7) as i8 - 3));
        Case { pose: here, wanted, target: kinematics::hand(arm, there) }
    };
    (0..POSES).map(case).collect()
}

fn header(arm: &Arm<f32>, cases: &[Case]) -> String {
    let Links { base, upper_arm, elbow_offset, forearm, hand, shoulder_radial } = arm.links;
    let shapes = &arm.shapes;
    let edges = shapes.base.map(|edge| braces([braces(edge.x.map(float)), braces(edge.z.map(float))]));
    let [base, upper_arm, elbow_offset, forearm, hand, shoulder_radial] =
        [base, upper_arm, elbow_offset, forearm, hand, shoulder_radial].map(float);
    let parts = [
        braces([braces(arm.home.0)]),
        braces(arm.fixed_servos),
        braces(arm.ranges.map(|range| range.min)),
        braces(arm.ranges.map(|range| range.max)),
        base,
        upper_arm,
        elbow_offset,
        forearm,
        hand,
        float(shapes.hand_length),
        braces(shapes.hand_edges.map(float)),
        float(shapes.forearm_overhang),
        braces(shapes.forearm_edges.map(float)),
        braces(edges),
        shoulder_radial,
    ];
    let mut text = format!("static const tpg_arm_description_t description = {};\n", braces(parts));
    let mut array = |kind: &str, name: &str, lines: Vec<String>| {
        let _ = writeln!(text, "static const {kind} {name} = {{\n{}\n}};", lines.join(",\n"));
    };
    array("tpg_pose_t", "poses[]", cases.iter().map(|case| braces([braces(case.pose.0)])).collect());
    array("tpg_move_t", "moves[]", cases.iter().map(|case| braces([braces(case.wanted.0)])).collect());
    array("float", "targets[][3]", cases.iter().map(|case| braces(case.target.map(float))).collect());
    let _ = writeln!(text, "#define SOURCES {}", braces(0..Source::ALL.len()));
    let _ = writeln!(text, "#define LONGEST {LONGEST}U");
    text
}

fn by_rust(arm: &Arm<f32>, cases: &[Case]) -> String {
    let mut text = String::new();
    for Case { pose, wanted, target } in cases {
        push_bits(&mut text, &kinematics::hand(arm, *pose));
        let seen = Observation::at(arm, *pose, *target);
        for source in Source::ALL {
            let mut values = [0.0; LONGEST];
            Source::fill(&[source], arm, &seen, &TargetMemo::new(), &mut values);
            push_bits(&mut text, &values);
        }
        let collision = match Plane::at(arm, *pose).collision(&arm.shapes) {
            None => 0,
            Some(collision) => code(collision),
        };
        let Step { pose: Pose([a, b, c, d]), invalid } = arm.step(*pose, *wanted);
        let validity = match invalid {
            None => 0,
            Some(Invalid::JointLimit(joint)) => 1 + i32::from(joint.0),
            Some(Invalid::Collision(collision)) => code(collision),
        };
        let _ = writeln!(text, "{collision} {a} {b} {c} {d} {validity}");
    }
    text
}

/// The header's number.
fn code(collision: Collision) -> i32 {
    match collision {
        Collision::Table => 5,
        Collision::HandCorner => 6,
        Collision::Base => 7,
    }
}

#[test]
fn an_arm_described_in_c_is_the_one_described_in_rust() {
    let Some(archive) = linked::archive("an arm described in C") else { return };
    let arm = ARM.to_f32();
    let cases = cases(&arm);
    let folder = TempDir::new().expect("a temporary folder");
    fs::write(folder.path().join("arm.h"), header(&arm, &cases)).expect("the folder can be written");
    let by_c = linked::output_of("radial.c", folder.path(), &[], &archive);
    assert_eq!(by_c.lines().count(), POSES);
    for (number, (c, rust)) in by_c.lines().zip(by_rust(&arm, &cases).lines()).enumerate() {
        assert_eq!(c.trim(), rust.trim(), "{:?}", cases[number].pose);
    }
    // Table, corner, base and limits must occur.
    let ends = |with: &str| by_c.lines().filter(|line| line.ends_with(with)).count();
    assert!([" 1", " 2", " 3", " 4", " 5", " 6", " 7"].iter().all(|end| ends(end) > 0), "some code never came");
}
