//! The joints between the root of a URDF and one of its links.

use super::space::{NO_ROTATION, Rotation, Vector, X, Y, Z, about, compose, direction, plus, rotate};
use roxmltree::{Document, Node};
use tpg_graph::error::{InputError, Place};

/// A joint that turns, with every other joint at 0 or where it is held.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct Turning {
    /// Its name.
    pub(super) name: String,
    /// A point of its axis, mm, in the root's frame.
    pub(super) at: Vector,
    /// Its axis, in the root's frame.
    pub(super) axis: Vector,
    /// Its limits, rad.
    pub(super) limits: [f64; 2],
}

/// The joints that turn, from the root outwards, and the place of the tip, mm, while they are all at 0.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct Chain {
    /// The joints.
    pub(super) joints: Vec<Turning>,
    /// The tip.
    pub(super) tip: Vector,
}

/// The elements of a URDF that the chain needs.
struct Robot {
    links: Vec<String>,
    joints: Vec<Joint>,
}

struct Joint {
    name: String,
    kind: JointType,
    parent: String,
    child: String,
    /// The place, m, and roll, pitch and yaw, rad.
    origin: [[f64; 3]; 2],
    axis: [f64; 3],
    /// The limits, rad; 0 where the file has none.
    limits: [f64; 2],
    mimics: Option<String>,
}

#[derive(Clone, Copy, PartialEq)]
enum JointType {
    Fixed,
    Revolute,
    Continuous,
    /// Prismatic, floating, planar, spherical.
    Other,
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
    if !robot.links.iter().any(|link| link == tip) {
        let links = robot.links.join(", ");
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
    let (mut at, mut frame) = ([0.0; 3], NO_ROTATION);
    let mut joints = Vec::new();
    for joint in path {
        let (place, turned) = origin(joint);
        at = plus(at, rotate(&frame, place));
        frame = compose(&frame, &turned);
        let axis = || {
            direction(joint.axis)
                .ok_or_else(|| at_joint(file, &joint.name, "an axis without a direction", "an axis such as \"0 0 1\""))
        };
        if let Some((_, angle)) = held.iter().find(|(name, _)| *name == joint.name) {
            frame = compose(&frame, &about(axis()?, *angle));
        } else if joint.kind != JointType::Fixed {
            let limits = limits(file, joint)?;
            joints.push(Turning { name: joint.name.clone(), at, axis: rotate(&frame, axis()?), limits });
        }
    }
    Ok(Chain { joints, tip: at })
}

fn read(file: &str, text: &str) -> Result<Robot, InputError> {
    const XACRO: [&str; 4] = ["<xacro:", "${", "$(arg", "$(find"];
    if let Some(line) = text.lines().position(|line| XACRO.iter().any(|sign| line.contains(sign))) {
        let accepted = "a URDF: expand the xacro first, `xacro FILE.xacro > FILE.urdf`";
        return Err(InputError::new(file, Place::Line(line + 1), "a xacro that is not expanded", accepted));
    }
    let document = Document::parse(text)
        .map_err(|error| InputError::new(file, Place::Line(error.pos().row as usize), error.to_string(), "a URDF"))?;
    let root = document.root_element();
    if !root.has_tag_name("robot") {
        let found = format!("an element <{}>", root.tag_name().name());
        return Err(InputError::new(file, Place::Whole, found, "a URDF: <robot>"));
    }
    let named = |tag| root.children().filter(move |node| node.has_tag_name(tag));
    let links = named("link").filter_map(|link| Some(link.attribute("name")?.to_owned())).collect();
    let joints = named("joint").map(|node| read_joint(file, node)).collect::<Result<_, _>>()?;
    Ok(Robot { links, joints })
}

fn read_joint(file: &str, node: Node<'_, '_>) -> Result<Joint, InputError> {
    let name = node.attribute("name").unwrap_or_default();
    let refuse = |at: Node<'_, '_>, found: String, accepted: &str| {
        let line = at.document().text_pos_at(at.range().start).row;
        at_joint(file, name, format!("line {line}: {found}"), accepted)
    };
    let part = |tag: &'static str| node.children().find(move |part| part.has_tag_name(tag));
    let link = |tag: &'static str| {
        let link = part(tag).and_then(|part| part.attribute("link"));
        link.map(str::to_owned).ok_or_else(|| refuse(node, format!("no {tag}"), "<parent link=…/> and <child link=…/>"))
    };
    let number =
        |at, text: &str| text.parse::<f64>().map_err(|_| refuse(at, format!("{text:?}"), "a number such as -1.57"));
    let three = |tag, attribute, otherwise: [f64; 3]| {
        let Some((at, text)) = part(tag).and_then(|part| Some((part, part.attribute(attribute)?))) else {
            return Ok(otherwise);
        };
        let numbers = text.split_whitespace().map(|text| number(at, text)).collect::<Result<Vec<_>, _>>()?;
        <[f64; 3]>::try_from(numbers).map_err(|_| refuse(at, format!("{attribute}={text:?}"), "three numbers"))
    };
    let limit = |attribute| match part("limit").and_then(|part| Some((part, part.attribute(attribute)?))) {
        Some((at, text)) => number(at, text.trim()),
        None => Ok(0.0),
    };
    let kind = match node.attribute("type").unwrap_or_default() {
        "fixed" => JointType::Fixed,
        "revolute" => JointType::Revolute,
        "continuous" => JointType::Continuous,
        "prismatic" | "floating" | "planar" | "spherical" => JointType::Other,
        other => {
            let accepted = "fixed, revolute, continuous, prismatic, floating, planar, spherical";
            return Err(refuse(node, format!("the type {other:?}"), accepted));
        }
    };
    Ok(Joint {
        name: name.to_owned(),
        kind,
        parent: link("parent")?,
        child: link("child")?,
        origin: [three("origin", "xyz", [0.0; 3])?, three("origin", "rpy", [0.0; 3])?],
        axis: three("axis", "xyz", [1.0, 0.0, 0.0])?,
        limits: [limit("lower")?, limit("upper")?],
        mimics: part("mimic").map(|part| part.attribute("joint").unwrap_or_default().to_owned()),
    })
}

/// The joints from the root to a link.
fn path<'a>(file: &str, robot: &'a Robot, tip: &str) -> Result<Vec<&'a Joint>, InputError> {
    let (mut path, mut link) = (Vec::new(), tip);
    while let Some(joint) = robot.joints.iter().find(|joint| joint.child == link) {
        if path.len() == robot.joints.len() {
            return Err(at_joint(file, &joint.name, "a loop of joints", "a tree of links"));
        }
        path.push(joint);
        link = &joint.parent;
    }
    path.reverse();
    Ok(path)
}

/// The place of a joint in its parent's frame, mm, and the rotation of its own.
fn origin(joint: &Joint) -> (Vector, Rotation) {
    let [place, [roll, pitch, yaw]] = joint.origin;
    let turned = compose(&compose(&about(Z, yaw), &about(Y, pitch)), &about(X, roll));
    (place.map(|metres| 1000.0 * metres), turned)
}

fn limits(file: &str, joint: &Joint) -> Result<[f64; 2], InputError> {
    const ACCEPTED: &str = "a revolute joint with limits of at most a turn, or --fix";
    let refuse = |found: String| Err(at_joint(file, &joint.name, found, ACCEPTED));
    if let Some(other) = &joint.mimics {
        return refuse(format!("it mimics the joint {other:?}"));
    }
    let [lower, upper] = joint.limits;
    match joint.kind {
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
