use super::*;
use crate::{Problem, ProblemSettings};
use tpg_arm::kinematics::{distance, hand_from_radians};

const RADII: Radii = Radii { link: 20.0, base: 60.0 };

/// An arm of five joints whose base stands aside, turned and with its axis downwards; forearm and hand are bent at 0.
const ARM: &str = r#"<robot name="five">
  <link name="root"/><link name="a"/><link name="b"/><link name="c"/><link name="d"/><link name="e"/><link name="tip"/>
  <joint name="pan" type="revolute">
    <parent link="root"/><child link="a"/><origin xyz="0.02 0.01 0.05" rpy="3.141592653589793 0 0"/>
    <axis xyz="0 0 1"/><limit lower="-1.5" upper="1.0" effort="1" velocity="1"/>
  </joint>
  <joint name="lift" type="revolute">
    <parent link="a"/><child link="b"/><origin xyz="0.03 0.004 -0.06" rpy="3.141592653589793 0 0"/>
    <axis xyz="0 1 0"/><limit lower="-1.2" upper="1.6" effort="1" velocity="1"/>
  </joint>
  <joint name="bend" type="revolute">
    <parent link="b"/><child link="c"/><origin xyz="0.025 0.007 0.11"/>
    <axis xyz="0 -1 0"/><limit lower="-1.4" upper="1.3" effort="1" velocity="1"/>
  </joint>
  <joint name="tilt" type="revolute">
    <parent link="c"/><child link="d"/><origin xyz="0.12 0 0.016"/>
    <axis xyz="0 1 0"/><limit lower="-1.7" upper="1.5" effort="1" velocity="1"/>
  </joint>
  <joint name="roll" type="continuous">
    <parent link="d"/><child link="e"/><origin xyz="0.05 -0.003 -0.01"/><axis xyz="1 0 0"/>
  </joint>
  <joint name="mount" type="fixed"><parent link="e"/><child link="tip"/><origin xyz="0.06 0 0"/></joint>
  <joint name="finger" type="prismatic">
    <parent link="e"/><child link="jaw"/><axis xyz="0 1 0"/><limit lower="0" upper="0.02" effort="1" velocity="1"/>
  </joint>
  <link name="jaw"/>
</robot>"#;

fn held() -> Vec<(String, f64)> {
    vec![("roll".to_owned(), 0.0)]
}

/// Requests to hold joints.
fn holding(held: &[(String, f64)]) -> Requests<'_> {
    Requests { held, ..Requests::default() }
}

fn refusal(text: &str, tip: &str, fix: &[(String, f64)]) -> String {
    import("five.urdf", text, tip, fix, &[], RADII).expect_err("it is wrong").to_string()
}

fn planar_section(text: &str) -> String {
    import("five.urdf", text, "tip", &held(), &[], RADII).expect("an arm")
}

#[test]
fn lengths_zeros_and_ranges_are_those_of_the_urdf() {
    let chain = urdf::chain("five.urdf", ARM, "tip", holding(&held())).expect("a chain");
    let arm = planar::recognise("five.urdf", &chain).expect("a planar arm");
    let links = arm.links;
    assert_eq!([links.base, links.shoulder_radial], [110.0, 30.0]);
    assert_eq!([links.upper_arm, links.elbow_offset], [110.0, 25.0]);
    assert_eq!([links.forearm, links.hand], [121.062, 110.454]);
    assert_eq!(arm.joints.each_ref().map(|joint| joint.sign), [-1.0, 1.0, 1.0, -1.0]);
    assert_eq!(arm.joints.each_ref().map(|joint| (joint.zero * 1e4).round()), [0.0, 0.0, 1326.0, -2232.0]);
    // By hand: 2048 - 1.0 · 651.9 = 1396.1, 2048 + 1.5 · 651.9 = 3025.8.
    assert_eq!(arm.joints[0].range, [1397, 3025]);
}

/// The tip by the urdf's own frames and by the arm's kinematics, over a grid of angles.
#[test]
fn tips_are_where_the_urdf_puts_them() {
    let chain = |angles: [f64; 4]| {
        let names = ["pan", "lift", "bend", "tilt"].map(str::to_owned);
        let held = held().into_iter().chain(names.into_iter().zip(angles)).collect::<Vec<_>>();
        urdf::chain("five.urdf", ARM, "tip", holding(&held)).expect("a chain").tip.into()
    };
    let section = planar_section(ARM);
    let own = Problem::from_toml("own.toml", &format!("[problem]\nname = \"fs\"\n{section}")).expect("an arm");
    let ProblemSettings::Arm(config) = own.settings else { panic!("an arm's problem") };
    let arm = config.arm();
    let recognised =
        planar::recognise("five.urdf", &urdf::chain("five.urdf", ARM, "tip", holding(&held())).expect("a chain"));
    let joints = recognised.expect("planar").joints;
    let mut poses = 0;
    for index in 0..256 {
        let angles = [0, 2, 4, 6].map(|shift| f64::from((index >> shift) % 4) * 0.6 - 0.8);
        let own = std::array::from_fn(|joint| joints[joint].sign * angles[joint] + joints[joint].zero);
        let ([x, y, z], tip) = (hand_from_radians(&arm, own), chain(angles));
        // Ahead is x in the URDF and y here; the axis stands at (20, 10).
        let off = distance([y + 20.0, -x + 10.0, z], tip);
        assert!(off < 2e-3, "{angles:?}: {off} mm");
        poses += 1;
    }
    assert_eq!(poses, 256);
}

#[test]
fn an_arm_that_stretches_ahead_at_0_has_no_bracket() {
    let text = ARM.replace("0.025 0.007 0.11", "0.11 0.007 0").replace("upper=\"1.6\"", "upper=\"1.5\"");
    let chain = urdf::chain("five.urdf", &text, "tip", holding(&held()));
    let arm = planar::recognise("five.urdf", &chain.expect("a chain")).expect("a planar arm");
    assert_eq!([arm.links.upper_arm, arm.links.elbow_offset], [110.0, 0.0]);
    assert!((arm.joints[1].zero - std::f64::consts::FRAC_PI_2).abs() < 1e-12);
}

#[test]
fn what_is_no_arm_is_refused_with_file_and_joint() {
    let lift = "<axis xyz=\"0 1 0\"/><limit lower=\"-1.2\" upper=\"1.6\" effort=\"1\" velocity=\"1\"/>";
    for (from, to, expected) in [
        (
            lift,
            "<axis xyz=\"0 1 0\"/>",
            "five.urdf: line 7: joint lift: no limits; accepted: a revolute joint with limits",
        ),
        (
            "lower=\"-1.2\" upper=\"1.6\"",
            "lower=\"-7\" upper=\"7\"",
            "five.urdf: line 7: joint lift: limits of -7 to 7 rad, which",
        ),
        (
            "lower=\"-1.2\" upper=\"1.6\"",
            "lower=\"2\" upper=\"1\"",
            "five.urdf: line 7: joint lift: limits of 2 to 1 rad",
        ),
        (
            "name=\"lift\" type=\"revolute\"",
            "name=\"lift\" type=\"continuous\"",
            "five.urdf: line 7: joint lift: a continuous joint",
        ),
        (
            "name=\"lift\" type=\"revolute\"",
            "name=\"lift\" type=\"prismatic\"",
            "five.urdf: line 7: joint lift: a joint that does not",
        ),
        (
            lift,
            "<axis xyz=\"0 1 0\"/><mimic joint=\"pan\"/>",
            "five.urdf: line 7: joint lift: it mimics the joint \"pan\"",
        ),
        (lift, &lift.replace("0 1 0", "0 0 0"), "five.urdf: line 7: joint lift: an axis without a direction"),
        ("<parent link=\"root\"/>", "<parent link=\"tip\"/>", "five.urdf: line"),
        ("0.05 -0.003", "${width} -0.003", "five.urdf: line 20: a xacro that is not expanded"),
        ("</robot>", "", "five.urdf: line "),
        ("<robot", "<robots", "five.urdf: line "),
        ("0.05 -0.003", "0.05 x", "five.urdf: line 20: joint roll"),
        ("type=\"prismatic\"", "type=\"telescope\"", "five.urdf: line 23: joint finger: the type \"telescope\""),
    ] {
        let text = ARM.replacen(from, to, 1);
        assert_ne!(text, ARM, "{from} is in the text");
        let error = refusal(&text, "tip", &held());
        assert!(error.starts_with(expected), "{error}");
    }
    assert_eq!(
        refusal(ARM, "hand", &held()),
        "five.urdf: no link \"hand\" for the tip; accepted: one of root, a, b, c, d, e, tip, jaw"
    );
    let twist = [("roll".to_owned(), 0.0), ("twist".to_owned(), 0.0)];
    assert!(
        refusal(ARM, "tip", &twist)
            .starts_with("five.urdf: no joint \"twist\" between the root and \"tip\"; accepted: one of pan")
    );
    assert!(refusal(ARM, "tip", &[]).starts_with("five.urdf: line 19: joint roll: a continuous joint"));
}

#[test]
fn one_message_names_every_joint_that_needs_an_option() {
    let text = ARM.replace("lower=\"-1.2\" upper=\"1.6\"", "lower=\"1\" upper=\"-1\"").replace(
        "<joint name=\"mount\" type=\"fixed\">",
        "<joint name=\"mount\" type=\"prismatic\"><limit lower=\"0\" upper=\"1\"/>",
    );
    assert_eq!(
        refusal(&text, "tip", &[]),
        "five.urdf: line 7: joint lift: limits of 1 to -1 rad; accepted: a revolute joint with limits of at most a turn; \
         --limit lift=LOW,HIGH narrows them, --fix lift=RAD holds the joint; \
         the same for --limit roll=LOW,HIGH --fix mount=0"
    );
    let limits = [("lift".to_owned(), [-1.2, 1.6]), ("roll".to_owned(), [-3.0, 3.0])];
    let requests = Requests { held: &[("mount".to_owned(), 0.0)], limited: &limits };
    let joints = urdf::chain("five.urdf", &text, "tip", requests).expect("a chain").joints;
    assert_eq!([joints[1].limits, joints[4].limits], [[-1.2, 1.6], [-3.0, 3.0]]);
    let slides =
        refusal(&text.replace("name=\"pan\" type=\"revolute\"", "name=\"pan\" type=\"prismatic\""), "tip", &[]);
    assert!(slides.contains("at most a turn; --fix pan=0 holds the joint; the same for --limit lift"), "{slides}");
}

#[test]
fn limits_on_request_narrow_wide_ones_and_stop_endless_joints() {
    let limit = |joint: &str, limits: [f64; 2]| vec![(joint.to_owned(), limits)];
    let wide = ARM.replace("lower=\"-1.2\" upper=\"1.6\"", "lower=\"-6.2832\" upper=\"1.6\"");
    let chain = |text: &str, limited: &[(String, [f64; 2])], held: &[(String, f64)]| {
        urdf::chain("five.urdf", text, "tip", Requests { held, limited }).map(|chain| chain.joints)
    };
    let joints = chain(&wide, &limit("lift", [-1.25, 3.0]), &held()).expect("a chain");
    assert_eq!(joints[1].limits, [-1.25, 1.6], "the file's own end stays");
    let joints = chain(ARM, &limit("roll", [-3.0, 3.0]), &[]).expect("a chain");
    assert_eq!(joints[4].limits, [-3.0, 3.0]);
    let none = ARM.replace("<limit lower=\"-1.2\" upper=\"1.6\" effort=\"1\" velocity=\"1\"/>", "");
    assert_eq!(chain(&none, &limit("lift", [-1.0, 1.0]), &held()).expect("a chain")[1].limits, [-1.0, 1.0]);

    let refused =
        |text: &str, limited: &[(String, [f64; 2])]| chain(text, limited, &held()).expect_err("refused").to_string();
    let says = refused(&wide, &[]);
    assert!(
        says.contains("which are more than a turn; accepted: ") && says.contains("--limit lift=LOW,HIGH"),
        "{says}"
    );
    assert!(refused(&wide, &limit("lift", [2.0, 3.0])).contains("which --limit does not meet"));
    assert!(refused(&wide, &limit("twist", [2.0, 3.0])).contains("no joint \"twist\""));

    let imported = import("five.urdf", &wide, "tip", &held(), &limit("lift", [-1.25, 1.5]), RADII).expect("an arm");
    assert!(imported.starts_with("# From \"five.urdf\", tip tip, roll held at 0 rad, lift within -1.25 to 1.5 rad.\n"));
}

#[test]
fn what_is_not_read_does_not_matter() {
    let expected = planar_section(ARM);
    for (from, to) in [
        (
            "<link name=\"root\"/>",
            "<link name=\"root\"><visual><geometry><mesh/></geometry><material/><material/></visual></link>",
        ),
        ("<link name=\"jaw\"/>", "<!-- was rpy=\"${pi/2} 0 0\" <xacro:arm/> --><link name=\"jaw\"/>"),
        (
            "<link name=\"jaw\"/>",
            "<link name=\"jaw\"/><gazebo><plugin><ns>$(arg ns)</ns><sensor:camera/></plugin></gazebo>",
        ),
        (" effort=\"1\" velocity=\"1\"", ""),
        ("<robot", "\n  <robot xmlns:xacro=\"http://www.ros.org/wiki/xacro\""),
    ] {
        let text = ARM.replace(from, to);
        assert_ne!(text, ARM, "{from} is in the text");
        assert_eq!(planar_section(&text), expected, "{to}");
    }
    for xacro in ["<xacro:property name=\"a\" value=\"1\"/>", "<link name=\"${prefix}a\"/>"] {
        let text = ARM.replace("<link name=\"jaw\"/>", xacro);
        assert!(refusal(&text, "tip", &held()).contains("a xacro that is not expanded"), "{xacro}");
    }
}

#[test]
fn what_is_no_planar_arm_is_refused_with_the_reason() {
    let lift = "<axis xyz=\"0 1 0\"/><limit lower=\"-1.2\" upper=\"1.6\" effort=\"1\" velocity=\"1\"/>";
    for (from, to, reason) in [
        (
            lift,
            lift.replace("0 1 0", "1 0 0"),
            "line 11: joint bend: an axis that is not level, or not parallel to that of lift",
        ),
        (lift, lift.replace("0 1 0", "1 2 -3"), "line 7: joint lift: an axis that is not level"),
        (
            lift,
            lift.replace("-1.2", "0").replace("1.6", "4"),
            "line 7: joint lift: limits that are positions 2048 to 4655",
        ),
        (
            "<axis xyz=\"0 0 1\"/>",
            "<axis xyz=\"0 1 1\"/>".to_owned(),
            "line 3: joint pan: an axis that leans by 45.00 degrees",
        ),
        ("0.05 -0.003 -0.01", "0.05 0.003 -0.01".to_owned(), "a tip that is 6.000 mm beside the arm's plane"),
    ] {
        let message = refusal(&ARM.replacen(from, &to, 1), "tip", &held());
        assert!(message.starts_with(&format!("five.urdf: {reason}")), "{message}");
    }
    let limited =
        ARM.replace("\"continuous\"", "\"revolute\"").replace("<axis xyz=\"1 0 0\"/>", &lift.replace("0 1 0", "1 0 0"));
    let message = refusal(&limited, "tip", &[]);
    assert!(
        message.starts_with("five.urdf: 5 joints that turn: pan, lift, bend, tilt, roll; accepted: four"),
        "{message}"
    );
}

#[test]
fn the_comments_say_how_to_come_back_to_the_urdf() {
    let section = planar_section(ARM);
    for line in [
        "# From \"five.urdf\", tip tip, roll held at 0 rad.",
        "# The origin is on the axis of pan, at x = 20.0, y = 10.0 mm of the URDF; ahead is 0.0 degrees from its x. Positions are",
        "#     pan = -(position - 2048) / 651.9",
        "#     bend = (position - 2048 - 86.4) / 651.9",
        "#     tilt = -(position - 2048 + 145.5) / 651.9",
        "[problem.arm.shapes]",
    ] {
        assert!(section.lines().any(|own| own == line), "{line} is not in\n{section}");
    }
}

/// A name with a line's end must not become a key of the configuration.
#[test]
fn names_stay_in_their_comments() {
    let text = ARM.replace("\"lift\"", "\"lift&#10;[problem]&#10;name = 1\"");
    let section = planar_section(&text);
    assert!(section.contains(r"lift\n[problem]\nname = 1 = "), "{section}");
    let table: toml::Table = section.parse().expect("TOML");
    let problem = table["problem"].as_table().expect("a table");
    assert_eq!(problem.keys().collect::<Vec<_>>(), ["arm"]);
}
