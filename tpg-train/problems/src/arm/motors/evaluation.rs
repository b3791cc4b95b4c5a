//! An episode under the rules of tests: single steps of 3 ticks, an end for every failure, the paper's score.

use crate::arm::problem::ArmProblem;
use crate::arm::targets::Task;
use tpg_arm::cycle::{Brent, CycleDetector as _};
use tpg_arm::episode::{Outcome, Simulation};
use tpg_arm::frame::Frame;
use tpg_arm::{Arm, Move, Pose};
use tpg_engine::{End, EpisodeResult, Step};

/// A test episode under way.
#[derive(Clone, Debug)]
pub(super) struct EvaluationEpisode {
    rules: ArmProblem,
    target: [f64; 3],
    course: Simulation<f32>,
    detector: Brent,
}

impl EvaluationEpisode {
    pub(super) fn new(arm: &Arm<f32>, rules: ArmProblem, task: &Task) -> Self {
        let mut detector = Brent::new();
        detector.reset(task.start);
        let course = Simulation::new(arm, rules.reach(task), rules.play(task));
        Self { rules, target: task.target, course, detector }
    }

    pub(super) fn pose(&self) -> Pose {
        self.course.observation().pose
    }

    pub(super) fn target(&self) -> [f64; 3] {
        self.target
    }

    pub(super) fn distance(&self, arm: &Arm<f32>) -> f32 {
        self.course.distance(arm)
    }

    pub(super) fn frame<'a>(&self, arm: &'a Arm<f32>) -> Frame<'a, f32> {
        Frame::new(arm, self.course.observation())
    }

    /// Takes one step.
    pub(super) fn step(&mut self, arm: &Arm<f32>, decide: impl Fn(Pose) -> Move) -> Step {
        let wanted = decide(self.pose());
        let Some(outcome) = self.course.advance(arm, &mut self.detector, wanted) else { return Step::reward(0.0) };
        let truncated = outcome == Outcome::Timeout;
        let EpisodeResult { outcome, success, score, measure, .. } =
            self.rules.ending(outcome, self.course.actions(), f64::from(self.distance(arm)));
        Step::reward(score).ending(End { outcome, success, measure, truncated })
    }
}
