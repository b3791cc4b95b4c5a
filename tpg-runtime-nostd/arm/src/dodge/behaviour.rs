//! Behaviours: what a policy chooses among. Each is a closed form that names the arm's next step.

use super::ball::Ball;
use super::body::{Body, Nearest, Posture};
use super::plan::{self, Plan, STEP};
use crate::arm::{JOINTS, Move, Pose};
use tpg_runtime::named;

/// Most balls that are seen.
pub const BALLS: usize = 3;

/// Everything that a behaviour looks at in one step.
#[derive(Clone, Copy, Debug)]
pub struct View<'a> {
    /// The body.
    pub body: &'a Body,
    /// Its pose.
    pub pose: Pose,
    /// The body at that pose.
    pub posture: Posture,
    /// Poses that solve the task; the first is the nearest one.
    pub goals: &'a [Pose],
    /// The balls, at most [`BALLS`]; others are not seen.
    pub balls: &'a [Ball],
    /// The nearest point of each ball now.
    near: [Option<Nearest>; BALLS],
}

impl<'a> View<'a> {
    /// Looks at a body among balls.
    pub fn new(body: &'a Body, pose: Pose, goals: &'a [Pose], balls: &'a [Ball]) -> Self {
        let posture = body.at(pose);
        let balls = balls.get(..BALLS).unwrap_or(balls);
        let mut near = [None; BALLS];
        for (near, ball) in near.iter_mut().zip(balls) {
            *near = Some(body.nearest(&posture, ball.at, ball.radius));
        }
        Self { body, pose, posture, goals, balls, near }
    }

    /// Returns the first goal; the pose itself where there is none.
    pub fn goal(&self) -> Pose {
        self.goals.first().copied().unwrap_or(self.pose)
    }

    /// Returns the balls, with the place where each is nearest now.
    pub fn nearest(&self) -> impl Iterator<Item = (&'a Ball, &Nearest)> {
        self.balls.iter().zip(self.near.iter().flatten())
    }
}

/// A potential field in joint space: attraction along the straight walk, repulsion by the gradient of every clearance that
/// is small now or will be.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Field {
    /// Weight of the repulsion.
    pub gain: f32,
    /// Clearance from which on a ball repels, mm.
    pub reach: f32,
    /// Steps that are looked ahead.
    pub ahead: f32,
    /// Part of the repulsion that acts across it, with base and shoulder exchanged.
    pub swirl: f32,
}

/// The field of the behaviours: the best of 72 settings on 200 validation scenes.
pub const FIELD: Field = Field { gain: 0.3, reach: 15.0, ahead: 20.0, swirl: 0.3 };
/// A strong field for the last moment.
pub(crate) const EVASION: Field = Field { gain: 16.0, reach: 60.0, ahead: 4.0, swirl: 0.0 };

impl Field {
    /// Returns the step of the field towards a goal.
    pub fn step(&self, view: &View<'_>, goal: Pose) -> Move {
        let walk = plan::straight(view.pose, goal);
        let mut wish = walk.0.map(f32::from);
        let mut repelled = false;
        for (ball, now) in view.nearest() {
            let soon = view.body.nearest(&view.posture, ball.after(self.ahead), ball.radius);
            let nearest = if soon.clearance < now.clearance { &soon } else { now };
            if nearest.clearance < self.reach {
                repelled = true;
                let near = if nearest.clearance < 4.0 { 4.0 } else { nearest.clearance };
                let weight = self.gain * (1.0 / near - 1.0 / self.reach);
                let gradient = view.body.gradient(&view.posture, nearest);
                for (wish, slope) in wish.iter_mut().zip(gradient) {
                    *wish += weight * slope;
                }
                wish[0] += self.swirl * weight * gradient[1];
                wish[1] -= self.swirl * weight * gradient[0];
            }
        }
        if repelled { limited(wish) } else { walk }
    }
}

/// The direction of four wishes within the most that a joint moves in a step.
fn limited(wish: [f32; JOINTS]) -> Move {
    let most = f32::from(STEP);
    let largest = wish.iter().fold(most, |largest, wish| if wish.abs() > largest { wish.abs() } else { largest });
    Move(wish.map(|wish| rounded(wish * (most / largest))))
}

/// The nearest whole number, halves away from 0.
fn rounded(value: f32) -> i8 {
    (if value < 0.0 { value - 0.5 } else { value + 0.5 }) as i8
}

named! {
    /// A behaviour: an action of a policy.
    #[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
    pub enum Behaviour {
        /// Follows the plan that the search has found.
        Plan = "plan",
        /// Walks straight to the goal.
        Straight = "straight",
        /// Stays.
        Hold = "hold",
        /// Flees from the nearest ball as fast as it can.
        Away = "away",
        /// Walks to the goal in the potential field.
        Field = "field",
        /// Follows the plan in the potential field.
        FieldPlan = "field_plan",
        /// Stretches upwards where the base points, in the potential field.
        Upright = "upright",
        /// Goes in the field to the goal with the base moved 200 ticks up from where it is.
        FieldBaseUp = "field_base_up",
        /// The same with the base moved down.
        FieldBaseDown = "field_base_down",
        /// The same with the shoulder moved up.
        FieldShoulderUp = "field_shoulder_up",
        /// The same with the shoulder moved down.
        FieldShoulderDown = "field_shoulder_down",
        /// The same with the elbow moved up.
        FieldElbowUp = "field_elbow_up",
        /// The same with the elbow moved down.
        FieldElbowDown = "field_elbow_down",
        /// The same with the wrist moved up.
        FieldWristUp = "field_wrist_up",
        /// The same with the wrist moved down.
        FieldWristDown = "field_wrist_down",
    }
}

/// Ticks by which a shifted goal lies aside.
const SHIFT: i16 = 200;

impl Behaviour {
    /// Returns what the behaviour costs beyond a plain walk, in instructions of a Cortex-M4, about.
    pub const fn price(self) -> u16 {
        match self {
            Self::Plan | Self::Straight | Self::Hold => 0,
            Self::Away => 150,
            _ => 1000,
        }
    }

    /// Returns true if the behaviour computes a potential field.
    pub(crate) const fn walks_in_field(self) -> bool {
        !matches!(self, Self::Plan | Self::Straight | Self::Hold | Self::Away)
    }

    /// Returns the step that the behaviour takes; following the plan changes it.
    pub fn step(self, view: &View<'_>, plan: &mut Plan) -> Move {
        match self {
            Self::Plan => plan.advance(view.pose),
            Self::Straight => plan::straight(view.pose, view.goal()),
            Self::Hold => Move::STOP,
            Self::Away => away(view),
            Self::Field => FIELD.step(view, view.goal()),
            Self::FieldPlan => FIELD.step(view, plan.next()),
            Self::Upright => {
                let [base, ..] = view.pose.0;
                let [_, shoulder, elbow, wrist] = view.body.arm.home.0;
                FIELD.step(view, Pose([base, shoulder, elbow, wrist]))
            }
            Self::FieldBaseUp => shifted(view, 0, SHIFT),
            Self::FieldBaseDown => shifted(view, 0, -SHIFT),
            Self::FieldShoulderUp => shifted(view, 1, SHIFT),
            Self::FieldShoulderDown => shifted(view, 1, -SHIFT),
            Self::FieldElbowUp => shifted(view, 2, SHIFT),
            Self::FieldElbowDown => shifted(view, 2, -SHIFT),
            Self::FieldWristUp => shifted(view, 3, SHIFT),
            Self::FieldWristDown => shifted(view, 3, -SHIFT),
        }
    }
}

/// Goes in the field to the goal with one joint moved aside from where it is.
fn shifted(view: &View<'_>, joint: usize, aside: i16) -> Move {
    let mut goal = view.goal();
    let joint = joint.min(JOINTS - 1);
    let range = view.body.arm.ranges[joint];
    goal.0[joint] = view.pose.0[joint].saturating_add(aside).max(range.min).min(range.max);
    FIELD.step(view, goal)
}

/// Moves against the nearest ball: the gradient of its clearance at full speed.
pub fn away<'v>(view: &'v View<'_>) -> Move {
    let closest = |best: &'v Nearest, next: &'v Nearest| if next.clearance < best.clearance { next } else { best };
    let Some(nearest) = view.nearest().map(|(_, nearest)| nearest).reduce(closest) else { return Move::STOP };
    let gradient = view.body.gradient(&view.posture, nearest);
    let largest = gradient.iter().fold(1e-3f32, |largest, g| if g.abs() > largest { g.abs() } else { largest });
    let full = f32::from(STEP);
    Move(gradient.map(|slope| rounded(slope * (full / largest))))
}
