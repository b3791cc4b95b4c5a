//! The planar arm in a chain of joints: a base that turns about a vertical axis, then three parallel level axes.

use super::urdf::{Chain, Turning, at_joint};
use crate::arm::description::LinksDescription;
use nalgebra::Vector3;
use std::f64::consts::{FRAC_PI_2, PI, TAU};
use tpg_arm::{JOINTS, TICKS_PER_TURN};
use tpg_graph::error::{InputError, Place};

/// Greatest angle between axes that count as parallel, rad.
const PARALLEL: f64 = 1e-3;
/// Greatest distance of the tip from the arm's plane, mm.
const BESIDE: f64 = 0.1;
/// Lengths below this are 0, mm.
const NOTHING: f64 = 0.01;

/// A joint's position of the project: 2048 ticks + (sign · the URDF's angle + zero), turned into ticks.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct Position {
    /// The URDF's name.
    pub(super) name: String,
    /// 1 or −1.
    pub(super) sign: f64,
    /// Rad.
    pub(super) zero: f64,
    /// First and last position, ticks, none of them beyond the URDF's limits.
    pub(super) range: [i16; 2],
}

/// The recognised arm.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct Planar {
    /// Its lengths, to a micrometre.
    pub(super) links: LinksDescription,
    /// Its joints.
    pub(super) joints: [Position; JOINTS],
    /// The place of the base's axis in the URDF, mm.
    pub(super) axis: [f64; 2],
    /// The direction to the front, in the URDF.
    pub(super) front: [f64; 2],
}

/// Finds the planar arm in a chain.
///
/// # Errors
/// Another number of joints, an axis that leans, a tip beside the plane, a range that does not fit a turn.
pub(super) fn recognise(file: &str, chain: &Chain) -> Result<Planar, InputError> {
    let [base, shoulder, elbow, wrist] = &chain.joints[..] else {
        let names = chain.joints.iter().map(|joint| joint.name.as_str()).collect::<Vec<_>>().join(", ");
        let found = format!("{} joints that turn: {names}", chain.joints.len());
        return Err(InputError::new(file, Place::Whole, found, "four; --fix JOINT=RAD holds one"));
    };
    let across = axes(file, base, [shoulder, elbow, wrist])?;
    let beside = (chain.tip - base.at).dot(&across).abs();
    if beside > BESIDE {
        let found = format!("a tip that is {beside:.3} mm beside the arm's plane");
        let accepted = format!("at most {BESIDE} mm: another --tip, or a roll that --fix holds at another angle");
        return Err(InputError::new(file, Place::Whole, found, accepted));
    }
    let front = front(across, shoulder.at - base.at, chain.tip - shoulder.at);
    // As (ahead, up) in the plane.
    let [s, e, w, t] =
        [shoulder.at, elbow.at, wrist.at, chain.tip].map(|point| ((point - base.at).dot(&front), point.z));
    let between = |from: (f64, f64), to: (f64, f64)| (to.0 - from.0, to.1 - from.1);
    let (upper, forearm, hand) = (between(s, e), between(e, w), between(w, t));
    let length = |(ahead, up): (f64, f64)| ahead.hypot(up);
    let elevation = |(ahead, up): (f64, f64)| libm::atan2(up, ahead);
    // Where the elbow stands ahead of an upright upper arm the two lengths are the maker's; else it has no bracket.
    let (upper_arm, elbow_offset, lean) = match upper {
        (ahead, up) if up > NOTHING && ahead > -NOTHING => (up, ahead, 0.0),
        bare => (length(bare), 0.0, FRAC_PI_2 - elevation(bare)),
    };
    let zeros = [0.0, lean, elevation(forearm) + lean, elevation(hand) - elevation(forearm)];
    // About this axis a turn lifts what points ahead.
    let lifts = front.cross(&Vector3::z());
    let sign = |joint: &Turning, way: f64| if joint.axis.dot(&lifts) > 0.0 { way } else { -way };
    let signs = [if base.axis.z > 0.0 { 1.0 } else { -1.0 }, sign(shoulder, -1.0), sign(elbow, 1.0), sign(wrist, 1.0)];
    let position = |joint: usize| position(file, &chain.joints[joint], signs[joint], zeros[joint]);
    let micrometres = |mm: f64| if mm.abs() < NOTHING { 0.0 } else { (mm * 1000.0).round() / 1000.0 };
    let [base_height, upper_arm, elbow_offset, forearm, hand, shoulder_radial] =
        [s.1, upper_arm, elbow_offset, length(forearm), length(hand), s.0].map(micrometres);
    Ok(Planar {
        links: LinksDescription { base: base_height, upper_arm, elbow_offset, forearm, hand, shoulder_radial },
        joints: [position(0)?, position(1)?, position(2)?, position(3)?],
        axis: [base.at.x, base.at.y],
        front: [front.x, front.y],
    })
}

/// Checks the axes and returns the direction of the three parallel ones, level.
fn axes(file: &str, base: &Turning, others: [&Turning; 3]) -> Result<Vector3<f64>, InputError> {
    let lean = base.axis.cross(&Vector3::z()).norm();
    if lean > PARALLEL {
        let found = format!("an axis that leans by {:.2} degrees", libm::asin(lean.min(1.0)).to_degrees());
        return Err(at_joint(file, base.place(), found, "a vertical axis: the base of a planar arm"));
    }
    let [shoulder, ..] = others;
    for joint in others {
        if joint.axis.z.abs() > PARALLEL || joint.axis.cross(&shoulder.axis).norm() > PARALLEL {
            let found = format!("an axis that is not level, or not parallel to that of {}", shoulder.name);
            return Err(at_joint(
                file,
                joint.place(),
                found,
                "three parallel level axes behind the base: a planar arm",
            ));
        }
    }
    let [x, y, _] = shoulder.axis.into();
    let level = Vector3::new(x, y, 0.0).try_normalize(1e-9);
    level.ok_or_else(|| at_joint(file, shoulder.place(), format!("the axis {x} {y}"), "finite numbers, not both 0"))
}

/// The side on which the shoulder stands, or the tip where the shoulder stands on the base's axis; x where both do.
fn front(across: Vector3<f64>, shoulder: Vector3<f64>, tip: Vector3<f64>) -> Vector3<f64> {
    let front = across.cross(&Vector3::z());
    let sides = [shoulder.dot(&front), tip.dot(&front), front.x + front.y];
    let decides = sides.into_iter().find(|value| value.abs() > NOTHING).unwrap_or(1.0);
    if decides < 0.0 { -front } else { front }
}

fn position(file: &str, joint: &Turning, sign: f64, zero: f64) -> Result<Position, InputError> {
    let turn = f64::from(TICKS_PER_TURN);
    let zero = if zero > PI {
        zero - TAU
    } else if zero <= -PI {
        zero + TAU
    } else {
        zero
    };
    let [one, other] = joint.limits.map(|limit| 0.5 * turn + (sign * limit + zero) * turn / TAU);
    let (low, high) = ((one.min(other) - 1e-6).ceil(), (one.max(other) + 1e-6).floor());
    // A motor's turn has 4,096 positions, 0 to 4095: a joint of a whole turn loses the last.
    let high = if high == turn { turn - 1.0 } else { high };
    if low < 0.0 || high >= turn || low >= high {
        let found =
            format!("limits that are positions {low} to {high} where 2048 is the arm upright and stretched ahead");
        return Err(at_joint(file, joint.place(), found, "positions 0 to 4095: half a turn to either side"));
    }
    Ok(Position { name: joint.name.clone(), sign, zero, range: [low as i16, high as i16] })
}
