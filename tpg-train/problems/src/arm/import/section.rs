//! The section `[problem.arm]` of a recognised arm, with comments.

use super::planar::{Planar, Position};
use crate::arm::ArmDescription;
use crate::arm::description::ShapesDescription;
use std::f64::consts::TAU;
use std::fmt::Write as _;
use tpg_arm::TICKS_PER_TURN;

/// Thicknesses for the collision test, mm: a URDF's shapes are not read.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Radii {
    /// Half the thickness of forearm and hand.
    pub link: f64,
    /// The radius of the base.
    pub base: f64,
}

/// Returns the arm's description: upright and stretched ahead at the start, as near as its ranges allow, with plain shapes of
/// the given radii.
pub(super) fn describe(arm: &Planar, radii: Radii) -> ArmDescription {
    let middle = (TICKS_PER_TURN / 2) as i16;
    let ranges = arm.joints.each_ref().map(|joint| joint.range);
    let height = (arm.links.base - radii.link).max(0.0);
    let (side, top) = ([radii.base, radii.base, 0.0, height], [0.0, radii.base, height, height]);
    ArmDescription {
        home: ranges.map(|[min, max]| middle.clamp(min, max)),
        fixed_servos: [middle; 2],
        ranges,
        links: arm.links,
        shapes: ShapesDescription {
            hand_length: arm.links.hand,
            hand_edges: [radii.link, -radii.link],
            forearm_overhang: radii.link,
            forearm_edges: [radii.link, -radii.link],
            base: [side, top, side, top],
        },
    }
}

/// Lists the joints that are held.
pub(super) fn held(fix: &[(String, f64)]) -> String {
    fix.iter().map(|(joint, angle)| format!(", {} held at {angle} rad", one_line(joint))).collect()
}

/// Lists the joints whose limits are narrowed.
pub(super) fn limited(limit: &[(String, [f64; 2])]) -> String {
    limit.iter().map(|(joint, [low, high])| format!(", {} within {low} to {high} rad", one_line(joint))).collect()
}

/// Returns the section as text.
pub(super) fn text(file: &str, tip: &str, held: &str, arm: &Planar, description: &ArmDescription) -> String {
    // Adding 0 takes the sign of what is rounded to −0.
    let tenths = |value: f64| (10.0 * value).round() / 10.0 + 0.0;
    let ahead = tenths(libm::atan2(arm.front[1], arm.front[0]).to_degrees());
    let [x, y] = arm.axis.map(tenths);
    let mut text = format!(
        "# From {file:?}, tip {}{held}.\n\
         #\n\
         # The origin is on the axis of {}, at x = {x:.1}, y = {y:.1} mm of the URDF; ahead is {ahead:.1} degrees from its x. Positions are\n\
         # ticks, 4096 a turn; at 2048 the upper arm stands upright, forearm and hand are stretched ahead. Lengths are in mm.\n\
         # The URDF's angles, rad:\n\
         #\n",
        one_line(tip),
        one_line(&arm.joints[0].name)
    );
    for joint in &arm.joints {
        writeln!(text, "#     {}", angle_of(joint)).expect("a string");
    }
    let mut problem = toml::Table::new();
    problem.insert("arm".to_owned(), toml::Value::try_from(description).expect("plain data"));
    let mut file = toml::Table::new();
    file.insert("problem".to_owned(), problem.into());
    let section = file.to_string();
    let shapes = "# The shapes are not the URDF's, which are not read: bars of --radius and a column of --base-radius. Put better ones here.\n\
                  [problem.arm.shapes]";
    text + &section.replacen("[problem.arm.shapes]", shapes, 1)
}

/// The URDF's angle as an expression of the position.
fn angle_of(Position { name, sign, zero, .. }: &Position) -> String {
    let a_radian = f64::from(TICKS_PER_TURN) / TAU;
    let minus = if *sign < 0.0 { "-" } else { "" };
    let zero = (10.0 * zero * a_radian).round() / 10.0;
    let less = match zero {
        0.0 => String::new(),
        zero if zero > 0.0 => format!(" - {zero:.1}"),
        zero => format!(" + {:.1}", -zero),
    };
    format!("{} = {minus}(position - {}{less}) / {a_radian:.1}", one_line(name), TICKS_PER_TURN / 2)
}

/// Returns a name of the URDF as a comment can hold it: a line's end or another control character would leave the comment.
pub(super) fn one_line(name: &str) -> String {
    let shown = |character: char| {
        if character.is_control() { character.escape_default().collect() } else { character.to_string() }
    };
    name.chars().map(shown).collect()
}
