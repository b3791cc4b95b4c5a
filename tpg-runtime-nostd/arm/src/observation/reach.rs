//! The inverse kinematics of base, shoulder and elbow while the wrist stays.
//!
//! With the wrist held, the arm is two rigid parts: shoulder–elbow, and elbow–tip. Two sides and the distance from
//! shoulder to target make a triangle, so the elbow's goal follows from the law of cosines and the shoulder's from the
//! target's direction.

use crate::arm::{Arm, JOINTS, JointRange, TICKS_PER_TURN};
use crate::kinematics::{Angle, Lattice, Vector};
use tpg_runtime::ops::clamp;

/// A target as the inverse kinematics sees it: what does not depend on the wrist.
pub(super) struct ReachTarget<S> {
    /// Base's goal, ticks.
    base: S,
    /// True where the base turns its back to the target, which lies beyond its range.
    pub(super) behind: bool,
    /// Shoulder to target, mm.
    wanted: S,
    /// Of the target as seen from the shoulder, in the arm plane turned to it, rad.
    direction: S,
    /// Shoulder to elbow, mm.
    upper: S,
    /// Between the upper arm and the line to the elbow, rad.
    upper_angle: S,
}

/// Goals of the joints; they depend on the wrist's position and the target alone.
pub(super) struct Goal<S> {
    /// Base, shoulder, elbow and wrist, ticks.
    pub(super) ticks: [S; JOINTS],
    /// Ticks by which shoulder and elbow lie outside their ranges, and mm by which the target is out of reach.
    pub(super) excess: S,
}

impl<S: Lattice> ReachTarget<S> {
    /// Of a target in mm.
    pub(super) fn at(arm: &Arm<S>, target: Vector<S>) -> Self {
        let links = &arm.links;
        let [x, y, z] = target;
        let far = (x * x + y * y).sqrt();
        let facing = S::from_i32(TICKS_PER_TURN / 2) + ticks_of((-x).atan2(y));
        let (base, behind) = turned(facing, arm.ranges[0]);
        // From the shoulder, once the base has turned; negative over the arm's back.
        let range = if behind { -far } else { far } - links.shoulder_radial;
        let height = z - links.base;
        Self {
            base,
            behind,
            wanted: (range * range + height * height).sqrt(),
            // The stretched arm points to negative x of its plane: so does a target on the front side.
            direction: height.atan2(-range),
            upper: (links.upper_arm * links.upper_arm + links.elbow_offset * links.elbow_offset).sqrt(),
            upper_angle: links.elbow_offset.atan2(links.upper_arm),
        }
    }

    /// The goals for a wrist position in ticks, with the elbow's bend that the joint ranges allow better, or the first.
    pub(super) fn keeping_wrist(&self, arm: &Arm<S>, wrist: i16) -> Goal<S> {
        let Self { base, wanted, direction, upper, upper_angle, .. } = *self;
        let links = &arm.links;
        let turned = Angle(TICKS_PER_TURN / 2 - i32::from(wrist)).direction::<S>();
        let (along, aside) = (links.forearm + links.hand * turned.cos, links.hand * turned.sin);
        let lower = (along * along + aside * aside).sqrt();
        let lower_angle = aside.atan2(along);

        let reach = clamp(wanted, (upper - lower).abs(), upper + lower, wanted);
        let cosine = (reach * reach - upper * upper - lower * lower) / (S::from_f64(2.0) * upper * lower);
        let cosine = clamp(cosine, -S::ONE, S::ONE, cosine);
        let square = S::ONE - cosine * cosine;
        let sine = clamp(square, S::ZERO, S::ONE, square).sqrt();
        // The angle at the elbow, and the one at the shoulder between the lines to elbow and target.
        let bent = sine.atan2(cosine);
        let lean = (lower * sine).atan2(upper + lower * cosine);
        let [_, shoulder_range, elbow_range, _] = arm.ranges;
        let bend = |bent: S, lean: S| {
            let upper_arm = direction - upper_angle - lean;
            let forearm = bent - lower_angle + upper_angle;
            let shoulder = near_middle(S::from_i32(TICKS_PER_TURN / 4) + ticks_of(upper_arm));
            let elbow = near_middle(S::from_i32(3 * TICKS_PER_TURN / 4) - ticks_of(forearm));
            let excess = outside(shoulder, shoulder_range).abs() + outside(elbow, elbow_range).abs();
            Goal { ticks: [base, shoulder, elbow, S::from_i32(wrist.into())], excess }
        };
        let (first, second) = (bend(bent, lean), bend(-bent, -lean));
        let Goal { ticks, excess } = if second.excess < first.excess { second } else { first };
        Goal { ticks, excess: excess + (wanted - reach).abs() }
    }
}

/// Ticks of an angle in radians.
fn ticks_of<S: Lattice>(radians: S) -> S {
    radians * S::from_f64(f64::from(TICKS_PER_TURN) / core::f64::consts::TAU)
}

/// Ticks by which the base may miss its target: a joint of a whole turn has up to two positions less than the turn.
const MISSED: i16 = 2;

/// The base's goal, and whether it turns the arm's back to the target: where only that lies within its range.
#[inline(always)]
fn turned<S: Lattice>(facing: S, range: JointRange) -> (S, bool) {
    let within = |ticks: S| {
        ticks >= S::from_i32(i32::from(range.min) - i32::from(MISSED))
            && ticks <= S::from_i32(i32::from(range.max) + i32::from(MISSED))
    };
    if within(facing) {
        return (facing, false);
    }
    let half = S::from_i32(TICKS_PER_TURN / 2);
    let away = if facing > half { facing - half } else { facing + half };
    // An arm whose base turns by less than half a turn reaches some targets neither way.
    if within(away) { (away, true) } else { (facing, false) }
}

/// A joint goal, moved by at most two turns to 0..=4096, around the middle of a joint's travel: the sums above never leave
/// that.
fn near_middle<S: Lattice>(ticks: S) -> S {
    let (half, turn) = (S::from_i32(TICKS_PER_TURN / 2), S::from_i32(TICKS_PER_TURN));
    let once = |ticks: S| {
        if ticks > half {
            ticks - turn
        } else if ticks < -half {
            ticks + turn
        } else {
            ticks
        }
    };
    half + once(once(ticks - half))
}

fn outside<S: Lattice>(ticks: S, range: JointRange) -> S {
    let ends = [range.min, range.max].map(|end| S::from_i32(i32::from(end)));
    ticks - clamp(ticks, ends[0], ends[1], ticks)
}
