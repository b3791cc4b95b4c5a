//! The joints between the root of a URDF and one of its links.

use nalgebra::{Isometry3, Translation3, Unit, UnitQuaternion, Vector3};
use tpg_graph::error::{InputError, Place};
use urdf_rs::{Joint, JointType, Robot};

/// A joint that turns, with every other joint at 0 or where it is held.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct Turning {
    /// Its name.
    pub(super) name: String,
    /// A point of its axis, mm, in the root's frame.
    pub(super) at: Vector3<f64>,
    /// Its axis, in the root's frame.
    pub(super) axis: Unit<Vector3<f64>>,
    /// Its limits, rad.
    pub(super) limits: [f64; 2],
}

/// The joints that turn, from the root outwards, and the place of the tip, mm, while they are all at 0.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct Chain {
    /// The joints.
    pub(super) joints: Vec<Turning>,
    /// The tip.
    pub(super) tip: Vector3<f64>,
}

/// Returns the error at a joint.
pub(super) fn at_joint(file: &str, joint: &str, found: impl Into<String>, accepted: &str) -> InputError {
    InputError::new(file, Place::Path(format!("joint {joint}")), found, accepted)
}

/// Reads the chain that ends at a link.
///
/// # Errors
/// A text that is no URDF or an unexpanded xacro, an unknown link or joint, a joint that does not turn within limits.
pub(super) fn chain(file: &str, text: &str, tip: &str, held: &[(String, f64)]) -> Result<Chain, InputError> {
    let robot = read(file, text)?;
    if !robot.links.iter().any(|link| link.name == tip) {
        let links = robot.links.iter().map(|link| link.name.as_str()).collect::<Vec<_>>().join(", ");
        return Err(InputError::new(
            file,
            Place::Whole,
            format!("no link {tip:?} for the tip"),
            format!("one of {links}"),
        ));
    }
    let path = path(file, &robot, tip)?;
    if let Some((unknown, _)) = held.iter().find(|(name, _)| !path.iter().any(|joint| joint.name == *name)) {
        let found = format!("no joint {unknown:?} between the root and {tip:?}, to be held");
        let joints = path.iter().map(|joint| joint.name.as_str()).collect::<Vec<_>>().join(", ");
        return Err(InputError::new(file, Place::Whole, found, format!("one of {joints}")));
    }
    let mut frame = Isometry3::identity();
    let mut joints = Vec::new();
    for joint in path {
        frame *= origin(joint);
        let axis = || {
            let [x, y, z] = joint.axis.xyz.0;
            Unit::try_new(Vector3::new(x, y, z), 1e-9)
                .ok_or_else(|| at_joint(file, &joint.name, "an axis without a direction", "an axis such as \"0 0 1\""))
        };
        if let Some((_, angle)) = held.iter().find(|(name, _)| *name == joint.name) {
            frame *= UnitQuaternion::from_axis_angle(&axis()?, *angle);
        } else if joint.joint_type != JointType::Fixed {
            let limits = limits(file, joint)?;
            joints.push(Turning {
                name: joint.name.clone(),
                at: frame.translation.vector,
                axis: frame.rotation * axis()?,
                limits,
            });
        }
    }
    Ok(Chain { joints, tip: frame.translation.vector })
}

fn read(file: &str, text: &str) -> Result<Robot, InputError> {
    const XACRO: [&str; 4] = ["<xacro:", "${", "$(arg", "$(find"];
    if let Some(line) = text.lines().position(|line| XACRO.iter().any(|sign| line.contains(sign))) {
        let accepted = "a URDF: expand the xacro first, `xacro FILE.xacro > FILE.urdf`";
        return Err(InputError::new(file, Place::Line(line + 1), "a xacro that is not expanded", accepted));
    }
    urdf_rs::read_from_string(text).map_err(|error| InputError::new(file, Place::Whole, error.to_string(), "a URDF"))
}

/// The joints from the root to a link.
fn path<'a>(file: &str, robot: &'a Robot, tip: &str) -> Result<Vec<&'a Joint>, InputError> {
    let (mut path, mut link) = (Vec::new(), tip);
    while let Some(joint) = robot.joints.iter().find(|joint| joint.child.link == link) {
        if path.len() == robot.joints.len() {
            return Err(at_joint(file, &joint.name, "a loop of joints", "a tree of links"));
        }
        path.push(joint);
        link = &joint.parent.link;
    }
    path.reverse();
    Ok(path)
}

/// The frame of a joint in its parent's, mm.
fn origin(joint: &Joint) -> Isometry3<f64> {
    let ([x, y, z], [roll, pitch, yaw]) = (joint.origin.xyz.0, joint.origin.rpy.0);
    let place = Translation3::new(1000.0 * x, 1000.0 * y, 1000.0 * z);
    Isometry3::from_parts(place, UnitQuaternion::from_euler_angles(roll, pitch, yaw))
}

fn limits(file: &str, joint: &Joint) -> Result<[f64; 2], InputError> {
    const ACCEPTED: &str = "a revolute joint with limits of at most a turn, or --fix";
    let refuse = |found: String| Err(at_joint(file, &joint.name, found, ACCEPTED));
    if let Some(mimic) = &joint.mimic {
        return refuse(format!("it mimics the joint {:?}", mimic.joint));
    }
    let (lower, upper) = (joint.limit.lower, joint.limit.upper);
    match joint.joint_type {
        JointType::Revolute if lower == 0.0 && upper == 0.0 || !(lower.is_finite() && upper.is_finite()) => {
            refuse("no limits".to_owned())
        }
        JointType::Revolute if lower >= upper => refuse(format!("limits of {lower} to {upper} rad")),
        JointType::Revolute if upper - lower > std::f64::consts::TAU + 1e-3 => {
            refuse(format!("limits of {lower} to {upper} rad, which are more than a turn"))
        }
        JointType::Revolute => Ok([lower, upper]),
        JointType::Continuous => refuse("a continuous joint, which has no limits".to_owned()),
        _ => refuse("a joint that does not turn about one axis".to_owned()),
    }
}
