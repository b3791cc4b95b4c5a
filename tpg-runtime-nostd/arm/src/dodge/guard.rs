//! The guard that looks ahead: it replaces a step that would soon be hit.

use super::behaviour::{EVASION, View, away};
use crate::arm::{JOINTS, Move, Pose};

/// Steps ahead at which a move is judged.
const SOON: f32 = 2.0;
/// Steps ahead at which the ways out are compared.
const LATER: f32 = 4.0;
/// Clearance below which a move is refused, mm.
const MARGIN: f32 = 3.0;

/// Returns the move, or a better one if it would come within 3 mm of a ball in two steps: the best of the move itself, a
/// strong potential field, fleeing and holding by their clearance after four steps.
pub fn guarded(view: &View<'_>, wanted: Move) -> Move {
    let body = view.body;
    let after = body.at(moved(view, wanted, 1));
    if body.clearance_of_all(&after, view.balls, SOON) >= MARGIN {
        return wanted;
    }
    let mut best = (f32::NEG_INFINITY, wanted);
    for wanted in [wanted, EVASION.step(view, view.goal()), away(view), Move::STOP] {
        let posture = body.at(moved(view, wanted, 2));
        let clearance = body.clearance_of_all(&posture, view.balls, LATER);
        let clearance = if body.stands(&posture) { clearance } else { clearance - 1e3 };
        if clearance > best.0 {
            best = (clearance, wanted);
        }
    }
    best.1
}

/// The pose after a move was made so many times, within the joints' ranges.
fn moved(view: &View<'_>, wanted: Move, times: i16) -> Pose {
    let mut pose = view.pose;
    for joint in 0..JOINTS {
        let range = view.body.arm.ranges[joint];
        let ticks = pose.0[joint].saturating_add(i16::from(wanted.0[joint]) * times);
        pose.0[joint] = ticks.clamp(range.min, range.max);
    }
    pose
}
