//! The arm's problem: tasks, scores and endings.

use crate::arm::targets::{self, Start, Task};
use serde::{Deserialize, Serialize};
use tpg_arm::episode::{Outcome, ReachTask};
use tpg_arm::kinematics::Lattice;
use tpg_arm::observation::Source;
use tpg_arm::{Collision, Invalid, JOINTS, Play, Pose, TICKS_PER_TURN};
use tpg_engine::random::{Purpose, Stream};
use tpg_engine::{EpisodeResult, Measure};

/// The arm's problem and its scoring.
#[derive(Clone, Debug, PartialEq)]
pub struct ArmProblem {
    /// Start of episodes.
    pub start: Start,
    /// An episode succeeds below this distance, mm.
    pub tolerance: f64,
    /// Maximum number of actions.
    pub max_actions: u32,
    /// Each joint stands up to that many ticks beside its motor, drawn for each episode.
    pub backlash: i16,
    /// Ticks by which an action moves one joint.
    pub step: i8,
    /// True if there is an action that does nothing (and so ends the episode).
    pub may_stop: bool,
    /// Sources that a policy sees.
    pub sources: Vec<Source>,
    /// Score of a success; a failure scores −distance in mm.
    pub bonus: f64,
    /// Bonus added to a success for each unused action.
    pub per_unused_action: f64,
}

impl From<Start> for ArmProblem {
    /// The project's problem without sources, for policies that observe by themselves: actions of 3 ticks, a tolerance of 3 mm,
    /// the paper's score.
    fn from(start: Start) -> Self {
        Self {
            start,
            tolerance: targets::TOLERANCE,
            max_actions: start.max_actions(),
            backlash: 0,
            step: 3,
            may_stop: true,
            sources: Vec::new(),
            bonus: 10.0,
            per_unused_action: 0.01,
        }
    }
}

impl ArmProblem {
    /// Returns a task under this problem's tolerance and limit.
    pub fn reach<S: Lattice>(&self, task: &Task) -> ReachTask<S> {
        ReachTask {
            start: task.start,
            target: task.target.map(S::from_f64),
            tolerance: S::from_f64(self.tolerance),
            max_actions: self.max_actions,
        }
    }

    /// Draws the play of the joints in a task: the same for every policy that does the task.
    pub fn play(&self, Task { start, target: [x, y, z] }: &Task) -> Play {
        if self.backlash == 0 {
            return Play::NONE;
        }
        let most = i64::from(self.backlash);
        let place = y.to_bits() ^ z.to_bits().rotate_left(32);
        let mut random = Stream::new(start.packed(), x.to_bits(), Purpose::Play, place);
        Play([(); JOINTS].map(|()| random.between(-most, most) as i16))
    }

    /// Returns the ending of an episode with its score: for a success the bonus plus that for unused actions, for a
    /// failure minus the distance, mm.
    pub fn ending(&self, outcome: Outcome, actions: u32, distance: f64) -> EpisodeResult {
        let success = outcome == Outcome::Reached;
        let unused = f64::from(self.max_actions.saturating_sub(actions));
        let score = if success { unused * self.per_unused_action + self.bonus } else { -distance };
        EpisodeResult {
            outcome: outcome_number(outcome),
            success: Some(success),
            score,
            final_reward: score,
            measure: distance,
            actions,
        }
    }
}

impl Task {
    /// Converts the task to a problem with the paper's tolerance.
    pub fn problem<S: Lattice>(&self, start: Start) -> ReachTask<S> {
        ArmProblem::from(start).reach(self)
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

impl From<&ArmTask> for Task {
    fn from(task: &ArmTask) -> Self {
        Self { start: Pose(task.start), target: task.target }
    }
}

impl From<Task> for ArmTask {
    fn from(task: Task) -> Self {
        Self { start: task.start.0, target: task.target, roughness: 1 }
    }
}

/// True if joint positions are within two turns, far from any overflow. Joint limits are the rules' concern: a step that
/// violates them ends the episode.
pub(super) fn on_the_arm(ticks: [i16; JOINTS]) -> bool {
    ticks.iter().all(|&ticks| i32::from(ticks).abs() <= 2 * TICKS_PER_TURN)
}

/// The measure of an episode: distance from the hand to the target at its end.
pub(crate) const DISTANCE: Measure = Measure { name: "distance", unit: "mm" };

/// Names of the outcomes, as counted by `eval --json`.
pub(crate) const OUTCOMES: [&str; 7] = ["reached", "cycle", "stop", "joint_limit", "table", "base", "timeout"];

/// Returns the index of an outcome in [`OUTCOMES`].
pub(crate) fn outcome_number(outcome: Outcome) -> u8 {
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

#[cfg(test)]
mod tests {
    use super::{ArmProblem, Task};
    use crate::arm::targets::{Set, Start, tasks};
    use std::collections::BTreeSet;
    use tpg_arm::{Play, WIDOWX};

    #[test]
    fn play_belongs_to_the_task_and_fills_its_range() {
        let problem = ArmProblem { backlash: 6, ..Start::Rs.into() };
        let tasks = tasks(&WIDOWX, 1, Set::Validation, Start::Rs, 300);
        let drawn: Vec<Play> = tasks.iter().map(|task| problem.play(task)).collect();
        assert_eq!(drawn, tasks.iter().map(|task| problem.play(task)).collect::<Vec<_>>());
        for joint in 0..4 {
            let ticks: BTreeSet<i16> = drawn.iter().map(|play| play.0[joint]).collect();
            assert_eq!(ticks, (-6..=6).collect(), "joint {joint}");
        }
        // Another start, another target: other play.
        let [one, other] = [tasks[0], tasks[1]];
        let mixed = Task { start: other.start, ..one };
        assert!(problem.play(&mixed) != problem.play(&one) && problem.play(&mixed) != problem.play(&other));
        assert_eq!(ArmProblem::from(Start::Rs).play(&one), Play::NONE);
    }
}
