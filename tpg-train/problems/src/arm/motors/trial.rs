//! An episode under the rules of tests: single steps of 3 ticks, an end for every failure, the paper's score.

use super::ARM;
use crate::arm::environment::ArmProblem;
use crate::arm::targets::{Start, Task};
use tpg_arm::cycle::Brent;
use tpg_arm::episode::{Episode, Outcome};
use tpg_arm::frame::Frame;
use tpg_arm::{Move, Pose};
use tpg_engine::{End, Ending, Step};

/// A test episode under way.
#[derive(Clone, Debug)]
pub(super) struct Trial {
    start: Start,
    target: [f64; 3],
    episode: Episode<'static, f32, Brent>,
}

impl Trial {
    pub(super) fn new(start: Start, pose: Pose, target: [f64; 3]) -> Self {
        let task = Task { start: pose, target };
        Self { start, target, episode: Episode::new(&ARM, task.problem(start), Brent::new()) }
    }

    pub(super) fn pose(&self) -> Pose {
        self.episode.observation().pose
    }

    pub(super) fn target(&self) -> [f64; 3] {
        self.target
    }

    pub(super) fn distance(&self) -> f32 {
        self.episode.observation().distance()
    }

    pub(super) fn frame(&self) -> Frame<'static, f32> {
        Frame::of(&ARM, self.episode.observation())
    }

    /// Takes one step. Rest, and a pose that comes again, end the episode only where `stuck_ends`.
    pub(super) fn step(&mut self, decide: impl Fn(Pose) -> Move, stuck_ends: bool) -> Step {
        let outcome = match self.episode.advance(decide(self.pose())) {
            Some(Outcome::Stop | Outcome::Cycle) if !stuck_ends => {
                (self.episode.actions() >= self.start.max_actions()).then_some(Outcome::Timeout)
            }
            outcome => outcome,
        };
        let Some(outcome) = outcome else { return Step::reward(0.0) };
        let rules = ArmProblem::new(self.start, Vec::new());
        let truncated = outcome == Outcome::Timeout;
        let Ending { outcome, success, score, measure, .. } =
            rules.ending(outcome, self.episode.actions(), f64::from(self.distance()));
        Step::reward(score).ending(End { outcome, success, measure, truncated })
    }
}
