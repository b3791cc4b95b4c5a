//! The part of a controller around a policy: what it sees, how its choice is carried out, and what is remembered.

use super::behaviour::{Behaviour, View};
use super::guard::{guarded, permitted};
use super::plan::steps;
use super::scout::Scout;
use super::sources::{VALUES, values};
use crate::arm::Move;

/// Effort of what every control step does: readings checked, body and balls placed, values gathered, motors watched; and of each
/// ball.
const SEE: u16 = 1150;
const SEE_BALL: u16 = 410;

/// A controller's settings.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct DodgerSettings {
    /// The cost that a whole control step may have, in instructions of a Cortex-M4, about: the search takes what the rest leaves.
    pub effort: u16,
    /// True if steps that would be hit are replaced.
    pub guard: bool,
}

impl DodgerSettings {
    /// The settings of the project's policies.
    pub const DEFAULT: Self = Self { effort: 9700, guard: true };
}

/// Memory from step to step of one task.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Dodger {
    settings: DodgerSettings,
    scout: Scout,
    /// Steps from the goal, at their least.
    least: u32,
    /// Steps since then.
    since: u8,
}

impl Dodger {
    /// Begins a task.
    pub fn new(settings: DodgerSettings, view: &View<'_>) -> Self {
        let mut scout = Scout::new(settings.effort, view);
        scout.step(view, 0);
        Self { settings, scout, least: steps(view.pose, view.goal()), since: 0 }
    }

    /// Returns what a policy sees.
    pub fn observe(&self, view: &View<'_>) -> [f32; VALUES] {
        values(view, &self.scout, self.since)
    }

    /// Turns a policy's choice into a step that the arm can take, and searches on.
    pub fn act(&mut self, view: &View<'_>, choice: Behaviour) -> Move {
        let wanted = choice.step(view, self.scout.plan_mut());
        let answer =
            if self.settings.guard { guarded(view, wanted, choice.walks_in_field()) } else { permitted(view, wanted) };
        let left = steps(view.pose, view.goal());
        if left < self.least {
            (self.least, self.since) = (left, 0);
        } else {
            self.since = self.since.saturating_add(1);
        }
        // A way out has cost what the search may cost.
        if !answer.threatened {
            let seen = SEE + SEE_BALL * view.balls.len() as u16;
            self.scout.step(view, seen + choice.price() + answer.effort);
        }
        answer.step
    }

    /// Returns the search.
    pub fn scout(&self) -> &Scout {
        &self.scout
    }
}
