//! The guard that looks ahead: it replaces a step that would soon be hit.

use super::behaviour::{EVASION, View, away};
use crate::arm::{JOINTS, Move, Pose};

/// Steps ahead at which a move is judged.
const SOON: f32 = 2.0;
/// Steps ahead at which the ways out are compared.
const LATER: f32 = 4.0;
/// Clearance below which a move is refused, mm.
const MARGIN: f32 = 3.0;

/// A step that the guard has looked at.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Guarded {
    /// The step to take.
    pub step: Move,
    /// True if the step that was asked for would soon be hit.
    pub threatened: bool,
}

/// Returns the move, or a better one if it would come within 3 mm of a ball in two steps: the best of the move itself, a
/// strong potential field, fleeing and holding by their clearance after four steps.
pub fn guarded(view: &View<'_>, wanted: Move) -> Guarded {
    let body = view.body;
    let after = body.at(moved(view, wanted, 1));
    if body.clearance_of_all(&after, view.balls, SOON) >= MARGIN {
        return Guarded { step: wanted, threatened: false };
    }
    // A way out against table or base is refused by the arm's own rule: it holds then, too.
    let hold = body.clearance_of_all(&view.posture, view.balls, LATER);
    let mut best = (hold, Move::STOP);
    for step in [wanted, EVASION.step(view, view.goal()), away(view)] {
        let posture = body.at(moved(view, step, 2));
        let clearance = body.clearance_of_all(&posture, view.balls, LATER);
        if clearance > best.0 {
            best = (clearance, step);
        }
    }
    Guarded { step: best.1, threatened: true }
}

/// The pose after a move was made so many times, within the joints' ranges.
fn moved(view: &View<'_>, wanted: Move, times: i16) -> Pose {
    let mut pose = view.pose;
    for joint in 0..JOINTS {
        let range = view.body.arm.ranges[joint];
        let ticks = pose.0[joint].saturating_add(i16::from(wanted.0[joint]) * times);
        pose.0[joint] = ticks.max(range.min).min(range.max);
    }
    pose
}
