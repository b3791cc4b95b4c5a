//! The joints between the root of a URDF and one of its links.

use nalgebra::{Rotation3, Vector3};
use roxmltree::{Document, Node};
use std::borrow::Cow;
use std::f64::consts::TAU;
use tpg_graph::error::{InputError, Place};

/// A joint that turns, with every other joint at 0 or where it is held.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct Turning {
    /// Its name.
    pub(super) name: String,
    /// The line of the file that it begins on.
    pub(super) line: u32,
    /// A point of its axis, mm, in the root's frame.
    pub(super) at: Vector3<f64>,
    /// Its axis, in the root's frame.
    pub(super) axis: Vector3<f64>,
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

/// The elements of a URDF that the chain needs.
struct Robot {
    links: Vec<String>,
    joints: Vec<UrdfJoint>,
}

struct UrdfJoint {
    name: String,
    line: u32,
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

impl UrdfJoint {
    /// Returns its name and line.
    fn place(&self) -> (&str, u32) {
        (&self.name, self.line)
    }
}

impl Turning {
    /// Returns its name and line.
    pub(super) fn place(&self) -> (&str, u32) {
        (&self.name, self.line)
    }
}

/// Returns the error at a joint of this name, on this line.
pub(super) fn at_joint(
    file: &str,
    joint: (&str, u32),
    found: impl Into<String>,
    accepted: impl Into<String>,
) -> InputError {
    let (name, line) = joint;
    InputError::new(file, Place::Path(format!("line {line}: joint {name}")), found, accepted)
}

/// What is done with joints on request.
#[derive(Clone, Copy, Debug, Default)]
pub(super) struct Requests<'r> {
    /// Joints that are held, each at an angle in rad.
    pub(super) held: &'r [(String, f64)],
    /// Joints whose limits are narrowed, rad.
    pub(super) limited: &'r [(String, [f64; 2])],
}

/// Reads the chain that ends at a link.
///
/// # Errors
/// A text that is no URDF or an unexpanded xacro, an unknown link or joint, a joint that does not turn within limits.
pub(super) fn chain(file: &str, text: &str, tip: &str, requests: Requests<'_>) -> Result<Chain, InputError> {
    let Requests { held, limited } = requests;
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
    let named = held.iter().map(|(name, _)| name).chain(limited.iter().map(|(name, _)| name));
    if let Some(unknown) = named.into_iter().find(|name| !path.iter().any(|joint| joint.name == **name)) {
        let found = format!("no joint {unknown:?} between the root and {tip:?}");
        let joints = path.iter().map(|joint| joint.name.as_str()).collect::<Vec<_>>().join(", ");
        return Err(InputError::new(file, Place::Whole, found, format!("one of {joints}")));
    }
    let (mut at, mut frame) = (Vector3::zeros(), Rotation3::identity());
    let (mut joints, mut refused) = (Vec::new(), Vec::new());
    for joint in path {
        let [place, [roll, pitch, yaw]] = joint.origin;
        at += frame * Vector3::from(place) * 1000.0;
        frame *= Rotation3::from_euler_angles(roll, pitch, yaw);
        let axis = || {
            Vector3::from(joint.axis).try_normalize(1e-9).ok_or_else(|| {
                at_joint(file, joint.place(), "an axis without a direction", "an axis such as \"0 0 1\"")
            })
        };
        if let Some((_, angle)) = held.iter().find(|(name, _)| *name == joint.name) {
            if joint.kind == JointType::Other && *angle != 0.0 {
                let found = format!("a joint that does not turn about one axis, held at {angle}");
                return Err(at_joint(file, joint.place(), found, "0, where the file puts it"));
            }
            if *angle != 0.0 {
                frame *= Rotation3::new(axis()? * *angle);
            }
        } else if joint.kind != JointType::Fixed {
            let narrowed = limited.iter().find(|(name, _)| *name == joint.name).map(|(_, limits)| *limits);
            match limits(joint, narrowed) {
                Ok(limits) => {
                    let (name, line) = (joint.name.clone(), joint.line);
                    joints.push(Turning { name, line, at, axis: frame * axis()?, limits });
                }
                Err(refusal) => refused.push((joint, refusal)),
            }
        }
    }
    match &refused[..] {
        [] => Ok(Chain { joints, tip: at }),
        [(joint, first), others @ ..] => {
            let mut accepted = first.accepted(&joint.name);
            if !others.is_empty() {
                let options: Vec<String> = others.iter().map(|(joint, other)| other.option(&joint.name)).collect();
                accepted += &format!("; the same for {}", options.join(" "));
            }
            Err(at_joint(file, joint.place(), first.found.clone(), accepted))
        }
    }
}

/// A joint that does not turn within limits.
struct UrdfRefusal {
    found: String,
    /// It could turn within limits on request.
    turns: bool,
}

impl UrdfRefusal {
    /// Returns the option of the command that mends it.
    fn option(&self, name: &str) -> String {
        if self.turns { format!("--limit {name}=LOW,HIGH") } else { format!("--fix {name}=0") }
    }

    fn accepted(&self, name: &str) -> String {
        let accepted = "a revolute joint with limits of at most a turn";
        let option = self.option(name);
        match self.turns {
            true => format!("{accepted}; {option} narrows them, --fix {name}=RAD holds the joint"),
            false => format!("{accepted}; {option} holds the joint"),
        }
    }
}

fn read(file: &str, text: &str) -> Result<Robot, InputError> {
    let text = with_namespaces(text.trim_start_matches(['\u{feff}', ' ', '\t', '\r']));
    let document = Document::parse(&text)
        .map_err(|error| InputError::new(file, Place::Line(error.pos().row as usize), error.to_string(), "a URDF"))?;
    let root = document.root_element();
    if let Some(node) = root.children().find_map(xacro) {
        let line = document.text_pos_at(node.range().start).row as usize;
        let accepted = "a URDF: expand the xacro first, `xacro FILE.xacro > FILE.urdf`";
        return Err(InputError::new(file, Place::Line(line), "a xacro that is not expanded", accepted));
    }
    if !root.has_tag_name("robot") {
        let found = format!("an element <{}>", root.tag_name().name());
        return Err(InputError::new(file, Place::Whole, found, "a URDF: <robot>"));
    }
    let named = |tag| root.children().filter(move |node| node.has_tag_name(tag));
    let links = named("link").filter_map(|link| Some(link.attribute("name")?.to_owned())).collect();
    let joints = named("joint").map(|node| read_joint(file, node)).collect::<Result<_, _>>()?;
    Ok(Robot { links, joints })
}

/// Declares the prefixes that a text uses without a declaration, as simulators' extensions do.
fn with_namespaces(text: &str) -> Cow<'_, str> {
    const MOST: usize = 16;
    let mut text = Cow::Borrowed(text);
    for _ in 0..MOST {
        let Err(roxmltree::Error::UnknownNamespace(prefix, _)) = Document::parse(&text) else { break };
        let Some(place) = text.find("<robot").map(|start| start + "<robot".len()) else { break };
        text.to_mut().insert_str(place, &format!(" xmlns:{prefix}=\"{prefix}\""));
    }
    text
}

/// Returns what xacro would replace: an element of its own, or a link or a part of a joint with an expression. Comments and what
/// is not read do not count.
fn xacro<'a, 'i>(node: Node<'a, 'i>) -> Option<Node<'a, 'i>> {
    let of_xacro = |node: Node<'_, '_>| node.tag_name().namespace().is_some_and(|name| name.contains("xacro"));
    let has_expression = |node: Node<'_, '_>| {
        node.attributes().any(|attribute| ["${", "$(arg", "$(find"].iter().any(|sign| attribute.value().contains(sign)))
    };
    if node.has_tag_name("joint") {
        return node.descendants().find(|part| of_xacro(*part) || has_expression(*part));
    }
    (of_xacro(node) || (node.has_tag_name("link") && has_expression(node))).then_some(node)
}

fn read_joint(file: &str, node: Node<'_, '_>) -> Result<UrdfJoint, InputError> {
    let name = node.attribute("name").unwrap_or_default();
    let line = |at: Node<'_, '_>| at.document().text_pos_at(at.range().start).row;
    let refuse = |at: Node<'_, '_>, found: String, accepted: &str| at_joint(file, (name, line(at)), found, accepted);
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
    Ok(UrdfJoint {
        name: name.to_owned(),
        line: line(node),
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
fn path<'a>(file: &str, robot: &'a Robot, tip: &str) -> Result<Vec<&'a UrdfJoint>, InputError> {
    let (mut path, mut link) = (Vec::new(), tip);
    while let Some(joint) = robot.joints.iter().find(|joint| joint.child == link) {
        if path.len() == robot.joints.len() {
            return Err(at_joint(file, joint.place(), "a loop of joints", "a tree of links"));
        }
        path.push(joint);
        link = &joint.parent;
    }
    path.reverse();
    Ok(path)
}

/// Returns a joint's limits, narrowed on request; limits that contain nothing count for none then.
fn limits(joint: &UrdfJoint, narrowed: Option<[f64; 2]>) -> Result<[f64; 2], UrdfRefusal> {
    let refuse = |turns: bool, found: String| Err(UrdfRefusal { found, turns });
    if let Some(other) = &joint.mimics {
        return refuse(false, format!("it mimics the joint {other:?}"));
    }
    let [lower, upper] = joint.limits;
    let none = (lower == 0.0 && upper == 0.0) || !(lower.is_finite() && upper.is_finite());
    let [lower, upper] = match (joint.kind, narrowed) {
        (JointType::Fixed | JointType::Other, _) => {
            return refuse(false, "a joint that does not turn about one axis".to_owned());
        }
        (JointType::Revolute, Some([low, high])) if !none && lower < upper => [low.max(lower), high.min(upper)],
        (_, Some(narrowed)) => narrowed,
        (JointType::Continuous, None) => return refuse(true, "a continuous joint, which has no limits".to_owned()),
        (JointType::Revolute, None) if none => return refuse(true, "no limits".to_owned()),
        (JointType::Revolute, None) if lower >= upper => {
            return refuse(true, format!("limits of {lower} to {upper} rad"));
        }
        (JointType::Revolute, None) => [lower, upper],
    };
    if lower >= upper {
        let found = format!("limits of {} to {} rad, which --limit does not meet", joint.limits[0], joint.limits[1]);
        return refuse(true, found);
    }
    if upper - lower > TAU + 1e-3 {
        return refuse(true, format!("limits of {lower} to {upper} rad, which are more than a turn"));
    }
    Ok([lower, upper])
}
