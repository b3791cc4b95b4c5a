//! What is asked of the arm, how it is scored, and how episodes end.

use crate::arm::targets::{self, Start, Task};
use serde::{Deserialize, Serialize};
use tpg_arm::episode::Outcome;
use tpg_arm::observation::Source;
use tpg_arm::{Collision, Invalid, JOINTS};
use tpg_engine::Ending;

/// What is asked of the arm, and how it is scored.
#[derive(Clone, Debug, PartialEq)]
pub struct ArmProblem {
    /// Where episodes start.
    pub start: Start,
    /// An episode succeeds nearer than this, mm.
    pub tolerance: f64,
    /// After this many actions it is over.
    pub max_actions: u32,
    /// Ticks that an action moves one joint.
    pub step: i8,
    /// Whether there is an action that does nothing (and so ends the episode).
    pub may_stop: bool,
    /// What a policy sees.
    pub sources: Vec<Source>,
    /// Score of a success; a failure scores −distance in mm.
    pub bonus: f64,
    /// The most that a failure costs, mm. Infinite where the policy acts alone; less where another policy takes over.
    pub hand_over_price: f64,
    /// Added to a success for each action that was not needed.
    pub per_unused_action: f64,
}

impl ArmProblem {
    /// The project's problem: actions of 3 ticks, 3 mm, the paper's score, with those sources.
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
    /// The ending of an episode, with its score: for a success the bonus and the actions it did not need, for a failure
    /// minus the distance, mm.
    pub fn ending(&self, outcome: Outcome, actions: u32, distance: f64) -> Ending {
        let success = outcome == Outcome::Reached;
        let unused = f64::from(self.max_actions.saturating_sub(actions));
        let score =
            if success { unused * self.per_unused_action + self.bonus } else { -distance.min(self.hand_over_price) };
        Ending { outcome: outcome_number(outcome), success: Some(success), score, measure: distance, actions }
    }
}

/// One episode's task.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
pub struct ArmTask {
    /// Where the arm starts, ticks.
    pub start: [i16; JOINTS],
    /// Where the hand shall go, mm.
    pub target: [f64; 3],
    /// So many times larger than the problem's are steps and tolerance: 1, or more early in a curriculum.
    pub roughness: u8,
}

impl From<Task> for ArmTask {
    fn from(task: Task) -> Self {
        Self { start: task.start.0, target: task.target, roughness: 1 }
    }
}

/// Names of the outcomes, as `eval --json` counts them.
pub const OUTCOMES: [&str; 7] = ["reached", "cycle", "stop", "joint_limit", "table", "base", "timeout"];

/// Place of an outcome in [`OUTCOMES`].
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
