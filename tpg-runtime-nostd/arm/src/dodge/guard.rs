//! The guard: no step is taken against limits, table or base, and one that would soon be hit is replaced.

use super::ball::Ball;
use super::behaviour::{EVASION, View, away};
use super::body::Posture;
use crate::arm::{Move, Pose};
use core::mem;

/// Steps ahead at which a move is judged.
const SOON: f32 = 2.0;
/// Steps ahead at which the ways out are compared.
const LATER: f32 = 4.0;
/// Clearance below which a move is refused, mm: from a ball that moves, and from one that stays.
const MARGIN: f32 = 3.0;
const STILL: f32 = 0.5;
/// A sum of rounded numbers may be off by that, mm.
const ROUNDING: f32 = 0.01;

/// Effort of placing the arm, of a ball beside it, of the test against table and base, and of a face near the base.
const PLACE: u16 = 260;
const BALL: u16 = 190;
const BASE: u16 = 240;
const FACE: u16 = 110;

/// A step that the guard has looked at.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Guarded {
    /// The step to take: the arm's rule refuses no part of it.
    pub step: Move,
    /// True if the step that was asked for would soon be hit.
    pub threatened: bool,
    /// The cost of looking, in instructions of a Cortex-M4, about.
    pub effort: u16,
}

/// Returns the part of a move that the arm's own rule lets pass: a joint that would leave its range stays, and nothing moves
/// if the arm would touch table or base.
pub fn permitted(view: &View<'_>, wanted: Move) -> Guarded {
    let step = within(view, wanted);
    if view.body.is_free_next(&view.posture) {
        return Guarded { step, threatened: false, effort: 0 };
    }
    let (free, effort) = tested(view, &view.body.at(after(view, step, 1)));
    Guarded { step: if free { step } else { Move::STOP }, threatened: false, effort: PLACE + effort }
}

/// Returns what is [`permitted`] of a move, or a better one if it would come too near to a ball in two steps: the best of the move
/// itself, a strong potential field, fleeing and holding by their clearance after four steps.
///
/// `walked` says that the move has cost a potential field already: the strong one is not paid for then.
pub fn guarded(view: &View<'_>, wanted: Move, walked: bool) -> Guarded {
    let body = view.body;
    let mut step = within(view, wanted);
    let free = body.is_free_next(&view.posture);
    let motion = body.motion() + ROUNDING;
    let is_far = |ball: &Ball, clearance: f32| clearance - (motion + SOON * ball.speed_bound()) >= margin(ball);
    let far = view.nearest().all(|(ball, near)| is_far(ball, near.clearance));
    if free && far {
        return Guarded { step, threatened: false, effort: 0 };
    }
    let placed = body.at(after(view, step, 1));
    let (mut posture, mut effort) = (&placed, PLACE);
    if !free {
        let (free, cost) = tested(view, posture);
        effort += cost;
        if !free {
            (step, posture) = (Move::STOP, &view.posture);
        }
    }
    if far {
        return Guarded { step, threatened: false, effort };
    }
    effort += BALL * view.balls.len() as u16;
    let spares = |ball: &Ball| body.clearance(posture, ball.after(SOON), ball.radius) >= margin(ball);
    if view.balls.iter().all(spares) {
        return Guarded { step, threatened: false, effort };
    }
    // What is worse than holding, or not known to be permitted, is no way out. One exact test is paid for.
    let mut best = (body.clearance_of_all(&view.posture, view.balls, LATER), Move::STOP);
    let mut exact = true;
    let evasion = (!walked).then(|| EVASION.step(view, view.goal()));
    for (way, is_permitted) in [(Some(step), true), (evasion, false), (Some(away(view)), false)] {
        let Some(way) = way else { continue };
        let way = within(view, way);
        let posture = body.at(after(view, way, 2));
        let clearance = body.clearance_of_all(&posture, view.balls, LATER);
        let mut passes = || {
            is_permitted
                || body.is_free_next(&posture)
                || (mem::take(&mut exact) && body.is_free(&body.at(after(view, way, 1))))
        };
        if clearance > best.0 && passes() {
            best = (clearance, way);
        }
    }
    Guarded { step: best.1, threatened: true, effort: u16::MAX }
}

/// The clearance that is kept from a ball, mm.
fn margin(ball: &Ball) -> f32 {
    if ball.stays() { STILL } else { MARGIN }
}

/// True if the arm touches neither table nor base, and the effort of knowing.
#[inline(always)]
fn tested(view: &View<'_>, posture: &Posture) -> (bool, u16) {
    if view.body.is_clearly_free(posture) {
        return (true, 0);
    }
    let (free, faces) = view.body.is_free_after(posture);
    (free, BASE + FACE * faces)
}

/// A move without the joints that would leave their ranges.
fn within(view: &View<'_>, wanted: Move) -> Move {
    let mut step = wanted;
    for ((ticks, at), range) in step.0.iter_mut().zip(view.pose.0).zip(&view.body.arm.ranges) {
        if !range.contains(at.saturating_add(i16::from(*ticks))) {
            *ticks = 0;
        }
    }
    step
}

/// The pose after repeating a move, within the joints' ranges.
fn after(view: &View<'_>, step: Move, times: i16) -> Pose {
    let mut pose = view.pose;
    for ((at, by), range) in pose.0.iter_mut().zip(step.0).zip(&view.body.arm.ranges) {
        *at = at.saturating_add(i16::from(by) * times).max(range.min).min(range.max);
    }
    pose
}
