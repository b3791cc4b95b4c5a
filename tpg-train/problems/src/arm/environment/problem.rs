//! The arm's problem: tasks, scores and endings.

use crate::arm::targets::{self, Start, Task};
use serde::{Deserialize, Serialize};
use tpg_arm::episode::Outcome;
use tpg_arm::observation::Source;
use tpg_arm::{Collision, Invalid, JOINTS};
use tpg_engine::Ending;

/// The arm's problem and its scoring.
#[derive(Clone, Debug, PartialEq)]
pub struct ArmProblem {
    /// Start of episodes.
    pub start: Start,
    /// An episode succeeds below this distance, mm.
    pub tolerance: f64,
    /// Maximum number of actions.
    pub max_actions: u32,
    /// Ticks by which an action moves one joint.
    pub step: i8,
    /// True if there is an action that does nothing (and so ends the episode).
    pub may_stop: bool,
    /// Sources that a policy sees.
    pub sources: Vec<Source>,
    /// Score of a success; a failure scores −distance in mm.
    pub bonus: f64,
    /// Maximum cost of a failure, mm. Infinite if the policy acts alone, finite if another policy takes over.
    pub hand_over_price: f64,
    /// Bonus added to a success for each unused action.
    pub per_unused_action: f64,
}

impl ArmProblem {
    /// Creates the project's problem with the given sources: actions of 3 ticks, a tolerance of 3 mm, the paper's
    /// score.
    pub fn new(start: Start, sources: Vec<Source>) -> Self {
        Self {
            start,
            tolerance: targets::TOLERANCE,
            max_actions: start.max_actions(),
            step: 3,
            may_stop: true,
            sources,
            bonus: 10.0,
            hand_over_price: f64::INFINITY,
            per_unused_action: 0.01,
        }
    }
}

impl ArmProblem {
    /// Returns the ending of an episode with its score: for a success the bonus plus that for unused actions, for a
    /// failure minus the distance, mm.
    pub fn ending(&self, outcome: Outcome, actions: u32, distance: f64) -> Ending {
        let success = outcome == Outcome::Reached;
        let unused = f64::from(self.max_actions.saturating_sub(actions));
        let score =
            if success { unused * self.per_unused_action + self.bonus } else { -distance.min(self.hand_over_price) };
        Ending { outcome: outcome_number(outcome), success: Some(success), score, measure: distance, actions }
    }
}

/// The task of one episode.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
pub struct ArmTask {
    /// Start of the arm, ticks.
    pub start: [i16; JOINTS],
    /// Target of the hand, mm.
    pub target: [f64; 3],
    /// Factor by which steps and tolerance exceed the problem's: 1, or more early in a curriculum.
    pub roughness: u8,
}

impl From<Task> for ArmTask {
    fn from(task: Task) -> Self {
        Self { start: task.start.0, target: task.target, roughness: 1 }
    }
}

/// Names of the outcomes, as counted by `eval --json`.
pub const OUTCOMES: [&str; 7] = ["reached", "cycle", "stop", "joint_limit", "table", "base", "timeout"];

/// Returns the index of an outcome in [`OUTCOMES`].
pub fn outcome_number(outcome: Outcome) -> u8 {
    match outcome {
        Outcome::Reached => 0,
        Outcome::Cycle => 1,
        Outcome::Stop => 2,
        Outcome::Invalid(Invalid::JointLimit(_)) => 3,
        Outcome::Invalid(Invalid::Collision(Collision::Table | Collision::HandCorner)) => 4,
        Outcome::Invalid(Invalid::Collision(Collision::Base)) => 5,
        Outcome::Timeout => 6,
    }
}
