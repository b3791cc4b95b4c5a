//! The section `[chain]` of joints that are no planar arm.

use super::section::one_line;
use super::space::{
    NO_ROTATION, Rotation, Vector, X, Y, Z, about, compose, cross, direction, dot, inverse, minus, norm, rotate, times,
};
use super::urdf::{Chain, Turning, at_joint};
use crate::arm::chain::{ChainDescription, LinkDescription, SignedAxis};
use std::f64::consts::TAU;
use tpg_arm::TICKS_PER_TURN;
use tpg_graph::error::InputError;

const A_RADIAN: f64 = TICKS_PER_TURN as f64 / TAU;
const MIDDLE: f64 = 0.5 * TICKS_PER_TURN as f64;
/// Greatest distance of a unit vector from an axis of its frame that counts as none.
const ALONG: f64 = 1e-9;

/// Describes a chain. The frames of its links stand as the URDF's root does while every joint is at 0; only for an axis that leans
/// is one turned.
///
/// # Errors
/// Limits that no range of positions holds.
pub(super) fn describe(file: &str, chain: &Chain) -> Result<ChainDescription, InputError> {
    let (mut at, mut frame) = ([0.0; 3], NO_ROTATION);
    let mut links = Vec::new();
    for joint in &chain.joints {
        let (own, axis) = own_frame(joint.axis);
        let (zero, range) = positions(file, joint)?;
        links.push(LinkDescription {
            name: one_line(&joint.name),
            origin: micrometres(rotate(&inverse(&frame), minus(joint.at, at))),
            // Adding 0 takes the sign of −0.
            turned: compose(&inverse(&frame), &own).map(|row| row.map(|value| value + 0.0)),
            axis,
            zero,
            range,
        });
        (at, frame) = (joint.at, own);
    }
    Ok(ChainDescription { tip: micrometres(rotate(&inverse(&frame), minus(chain.tip, at))), links })
}

/// Returns the frame of a joint, in the root's, and the axis in it.
fn own_frame(axis: Vector) -> (Rotation, SignedAxis) {
    let straight = [
        (X, SignedAxis::X),
        (Y, SignedAxis::Y),
        (Z, SignedAxis::Z),
        (times(-1.0, X), SignedAxis::MinusX),
        (times(-1.0, Y), SignedAxis::MinusY),
        (times(-1.0, Z), SignedAxis::MinusZ),
    ];
    match straight.into_iter().find(|(along, _)| norm(minus(axis, *along)) < ALONG) {
        Some((_, signed)) => (NO_ROTATION, signed),
        None => {
            let across = cross(Z, axis);
            let angle = libm::atan2(norm(across), dot(Z, axis));
            (direction(across).map_or(NO_ROTATION, |across| about(across, angle)), SignedAxis::Z)
        }
    }
}

/// Returns the position at the URDF's 0 and the first and last one, none of them beyond the limits. Zero is the middle unless
/// limits far to one side leave no room.
fn positions(file: &str, joint: &Turning) -> Result<(i16, [i16; 2]), InputError> {
    let [low, high] = joint.limits.map(|limit| limit * A_RADIAN);
    let fits = |zero: f64| zero + low >= -0.5 && zero + high < f64::from(TICKS_PER_TURN) + 0.5;
    let zero = if fits(MIDDLE) { MIDDLE } else { MIDDLE - (0.5 * (low + high)).round() };
    let (first, last) = ((zero + low - 1e-6).ceil().max(0.0), (zero + high + 1e-6).floor());
    let last = last.min(f64::from(TICKS_PER_TURN - 1));
    if first >= last || zero.abs() > f64::from(i16::MAX) {
        let found = format!("limits of {} to {} rad", joint.limits[0], joint.limits[1]);
        let accepted = "limits that are at least a tick of 1/4096 turn apart";
        let accepted = format!("{accepted}; --fix {}=RAD holds the joint", joint.name);
        return Err(at_joint(file, joint.place(), found, accepted));
    }
    Ok((zero as i16, [first as i16, last as i16]))
}

fn micrometres(place: Vector) -> Vector {
    // Adding 0 takes the sign of what is rounded to −0.
    place.map(|mm| (mm * 1000.0).round() / 1000.0 + 0.0)
}

/// Returns the section as text; `reason` says why it is no planar arm.
pub(super) fn text(file: &str, tip: &str, held: &str, chain: &ChainDescription, reason: &str) -> String {
    let mut sections = toml::Table::new();
    sections.insert("chain".to_owned(), toml::Value::try_from(chain).expect("plain data"));
    format!(
        "# From {file:?}, tip {}{held}.\n\
         #\n\
         # Not a planar arm: {}.\n\
         # Geometry only, for programs with `tpg_arm::chain`: training is for planar arms.\n\
         #\n\
         # Positions are ticks, 4096 a turn; lengths are in mm. The URDF's angles, rad: (position - zero) / {A_RADIAN:.1}, where zero is 2048\n\
         # if it is left out.\n\
         {sections}",
        one_line(tip),
        one_line(reason),
    )
}
