//! An episode under the rules of training: a shaped reward, repeated actions, a cut that is no failure.

use super::Config;
use crate::arm::problem::outcome_number;
use crate::arm::targets::Start;
use crate::arm::{ik, targets};
use tpg_arm::episode::Outcome;
use tpg_arm::frame::Frame;
use tpg_arm::{Arm, JOINTS, Move, Play, Pose, TICKS_PER_TURN, kinematics};
use tpg_engine::{End, Step};

/// A training episode under way.
#[derive(Clone, Debug)]
pub(super) struct TrainingEpisode {
    pose: Pose,
    target: [f64; 3],
    play: Play,
    /// Steps done.
    steps: u32,
    /// Poses that solve the task, for a reward that knows them.
    goals: Vec<[i16; JOINTS]>,
    distance: f32,
    steps_to_goal: f32,
    /// Position of the base at which the arm's front faces the target, ticks.
    facing: f32,
}

impl TrainingEpisode {
    pub(super) fn new(config: &Config, arm: &Arm<f32>, pose: Pose, target: [f64; 3]) -> Self {
        let goals = if config.reward.knows_goals() { ik::goals(&config.arm(), target) } else { Vec::new() };
        let goals: Vec<[i16; JOINTS]> = goals.into_iter().map(|pose| pose.0).collect();
        let play = config.tests(Start::Rs).play(&targets::Task { start: pose, target });
        let distance = distance(arm, play.joints(pose), target);
        let steps_to_goal = steps_to_goal(pose, &goals);
        let [x, y, _] = target;
        let turns = libm::atan2(-x, y) / core::f64::consts::TAU;
        let facing = (f64::from(TICKS_PER_TURN) * (0.5 + turns)) as f32;
        Self { pose, target, play, steps: 0, goals, distance, steps_to_goal, facing }
    }

    pub(super) fn pose(&self) -> Pose {
        self.pose
    }

    pub(super) fn target(&self) -> [f64; 3] {
        self.target
    }

    pub(super) fn distance(&self) -> f32 {
        self.distance
    }

    /// Steps that the base must turn until the arm's front faces the target: within its range, so not always the short way.
    fn steps_to_facing(&self) -> f32 {
        (f32::from(self.pose.0[0]) - self.facing).abs() / 3.0
    }

    pub(super) fn frame<'a>(&self, arm: &'a Arm<f32>) -> Frame<'a, f32> {
        Frame::at(arm, self.pose, self.target.map(|mm| mm as f32))
    }

    /// Takes one action: a step that is decided anew in every pose, repeated far from the target.
    pub(super) fn step(&mut self, config: &Config, arm: &Arm<f32>, decide: impl Fn(Pose) -> Move) -> Step {
        let reward = &config.reward;
        let repeats = ((self.distance / config.repeat_per_mm) as u32).clamp(1, config.repeat_most);
        let (distance_before, to_goal_before) = (self.distance, self.steps_to_goal);
        let to_facing_before = self.steps_to_facing();
        let (mut steps, mut outcome, mut invalid) = (0, None, None);
        while steps < repeats && outcome.is_none() {
            let step = arm.step(self.pose, decide(self.pose));
            self.pose = step.pose;
            self.distance = distance(arm, self.play.joints(self.pose), self.target);
            steps += 1;
            self.steps += 1;
            invalid = step.invalid;
            if let Some(invalid) = invalid {
                outcome = Some(Outcome::Invalid(invalid));
            } else if f64::from(self.distance) < config.tolerance {
                outcome = Some(Outcome::Reached);
            } else if self.steps >= config.max_steps {
                outcome = Some(Outcome::Timeout);
            }
        }
        self.steps_to_goal = steps_to_goal(self.pose, &self.goals);
        let over = matches!(outcome, Some(Outcome::Reached | Outcome::Invalid(_)));
        let earned = reward.step * steps as f32
            + reward.log_distance * libm::logf((distance_before + 3.0) / (self.distance + 3.0))
            + reward.distance * (distance_before - self.distance)
            + reward.steps_to_goal * (to_goal_before - self.steps_to_goal)
            + reward.azimuth * (to_facing_before - self.steps_to_facing())
            + if outcome == Some(Outcome::Reached) { reward.success } else { 0.0 }
            + if invalid.is_some() { reward.invalid } else { 0.0 };
        let end = outcome.map(|outcome| End {
            outcome: outcome_number(outcome),
            success: Some(outcome == Outcome::Reached),
            measure: f64::from(self.distance),
            truncated: !over,
        });
        Step { reward: f64::from(earned), repeats: steps, end }
    }
}

fn distance(arm: &Arm<f32>, joints: Pose, target: [f64; 3]) -> f32 {
    kinematics::distance(kinematics::hand(arm, joints), target.map(|mm| mm as f32))
}

/// The steps to the nearest goal with all motors moving at once: (max + 0.02 Σ of the ticks to go)/3, at most 1000.
fn steps_to_goal(pose: Pose, goals: &[[i16; JOINTS]]) -> f32 {
    // In hundredths of a tick: whole numbers, which compilers put into vectors.
    let cost = |goal: &[i16; JOINTS]| {
        let [a, b, c, d] = std::array::from_fn(|joint| i32::from((pose.0[joint] - goal[joint]).abs()));
        100 * a.max(b).max(c.max(d)) + 2 * (a + b + c + d)
    };
    let least = goals.iter().map(cost).min().unwrap_or(0);
    (least as f32 / 300.0).min(1000.0)
}
