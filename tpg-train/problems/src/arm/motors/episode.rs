//! An episode under either rules: those of training, with a shaped reward, repeated actions and a cut that is no failure; those of
//! tests, with single steps, an end for every failure and the paper's score.

use super::MotorsConfig;
use crate::arm::ik;
use crate::arm::problem::{ArmProblem, outcome_number};
use crate::arm::targets::{Start, Task};
use tpg_arm::cycle::{Brent, CycleDetector as _};
use tpg_arm::episode::Outcome;
use tpg_arm::frame::Frame;
use tpg_arm::{Arm, JOINTS, Move, Play, Pose, TICKS_PER_TURN, kinematics};
use tpg_engine::{End, EpisodeResult, Step};

/// An episode under way.
#[derive(Clone, Debug)]
pub struct MotorsEpisode {
    pub(super) course: Course,
    rules: Judge,
}

/// The arm on its way.
#[derive(Clone, Debug)]
pub(super) struct Course {
    pub(super) pose: Pose,
    pub(super) target: [f64; 3],
    /// Hand to target, mm.
    pub(super) distance: f32,
    play: Play,
    /// Steps done.
    steps: u32,
}

/// The judge of a step.
#[derive(Clone, Debug)]
enum Judge {
    Training(Shaping),
    Test(Box<ArmProblem>, Brent),
}

/// The knowledge in the reward of training.
#[derive(Clone, Debug)]
struct Shaping {
    /// Poses that solve the task, for a reward that knows them.
    goals: Vec<[i16; JOINTS]>,
    steps_to_goal: f32,
    /// Position of the base at which the arm's front faces the target, ticks.
    facing: f32,
}

impl MotorsEpisode {
    /// Begins an episode of training.
    pub(super) fn training(config: &MotorsConfig, arm: &Arm<f32>, task: &Task) -> Self {
        let goals = if config.reward.knows_goals() { ik::goals(&config.arm(), task.target) } else { Vec::new() };
        let goals: Vec<[i16; JOINTS]> = goals.into_iter().map(|pose| pose.0).collect();
        let steps_to_goal = steps_to_goal(task.start, &goals);
        let [x, y, _] = task.target;
        let turns = libm::atan2(-x, y) / core::f64::consts::TAU;
        let facing = (f64::from(TICKS_PER_TURN) * (0.5 + turns)) as f32;
        let course = Course::new(arm, task, config.tests(Start::Rs).play(task));
        Self { course, rules: Judge::Training(Shaping { goals, steps_to_goal, facing }) }
    }

    /// Begins an episode of tests.
    pub(super) fn test(rules: ArmProblem, arm: &Arm<f32>, task: &Task) -> Self {
        let mut detector = Brent::new();
        detector.reset(task.start);
        Self { course: Course::new(arm, task, rules.play(task)), rules: Judge::Test(Box::new(rules), detector) }
    }

    /// Returns the arm's pose.
    pub fn pose(&self) -> Pose {
        self.course.pose
    }

    pub(super) fn frame<'a>(&self, arm: &'a Arm<f32>) -> Frame<'a, f32> {
        Frame::at(arm, self.course.pose, self.course.target.map(|mm| mm as f32))
    }

    /// Takes one action.
    pub(super) fn step(&mut self, config: &MotorsConfig, arm: &Arm<f32>, decide: impl Fn(Pose) -> Move) -> Step {
        match &mut self.rules {
            Judge::Training(shaping) => shaping.step(&mut self.course, config, arm, decide),
            Judge::Test(rules, detector) => tested(&mut self.course, rules, detector, arm, decide),
        }
    }
}

impl Course {
    fn new(arm: &Arm<f32>, task: &Task, play: Play) -> Self {
        let Task { start: pose, target } = *task;
        Self { pose, target, play, steps: 0, distance: distance(arm, play.joints(pose), target) }
    }

    /// Takes a step; `Some` where it was invalid or came to the target.
    fn step(&mut self, arm: &Arm<f32>, wanted: Move, tolerance: f64) -> Option<Outcome> {
        let step = arm.step(self.pose, wanted);
        self.pose = step.pose;
        self.distance = distance(arm, self.play.joints(self.pose), self.target);
        self.steps += 1;
        let reached = f64::from(self.distance) < tolerance;
        step.invalid.map(Outcome::Invalid).or(reached.then_some(Outcome::Reached))
    }
}

/// Takes a single step by the rules of tests.
fn tested(
    course: &mut Course,
    rules: &ArmProblem,
    detector: &mut Brent,
    arm: &Arm<f32>,
    decide: impl Fn(Pose) -> Move,
) -> Step {
    let wanted = decide(course.pose);
    // As an episode in single precision compares.
    let outcome = match course.step(arm, wanted, f64::from(rules.tolerance as f32)) {
        Some(outcome) => outcome,
        None if wanted == Move::STOP => Outcome::Stop,
        None if detector.repeats(course.pose) => Outcome::Cycle,
        None if course.steps >= rules.max_actions => Outcome::Timeout,
        None => return Step::reward(0.0),
    };
    let truncated = outcome == Outcome::Timeout;
    let EpisodeResult { outcome, success, score, measure, .. } =
        rules.ending(outcome, course.steps, f64::from(course.distance));
    Step::reward(score).ending(End { outcome, success, measure, truncated })
}

impl Shaping {
    /// Takes one action of training: a step that is decided anew in every pose, repeated far from the target.
    fn step(
        &mut self,
        course: &mut Course,
        config: &MotorsConfig,
        arm: &Arm<f32>,
        decide: impl Fn(Pose) -> Move,
    ) -> Step {
        let reward = &config.reward;
        let repeats = ((course.distance / config.repeat_per_mm) as u32).clamp(1, config.repeat_most);
        let (distance_before, to_goal_before) = (course.distance, self.steps_to_goal);
        let to_facing_before = self.steps_to_facing(course.pose);
        let (mut steps, mut outcome) = (0, None);
        while steps < repeats && outcome.is_none() {
            outcome = course.step(arm, decide(course.pose), config.tolerance);
            outcome = outcome.or((course.steps >= config.max_steps).then_some(Outcome::Timeout));
            steps += 1;
        }
        self.steps_to_goal = steps_to_goal(course.pose, &self.goals);
        let is_invalid = matches!(outcome, Some(Outcome::Invalid(_)));
        let earned = reward.step * steps as f32
            + reward.log_distance * libm::logf((distance_before + 3.0) / (course.distance + 3.0))
            + reward.distance * (distance_before - course.distance)
            + reward.steps_to_goal * (to_goal_before - self.steps_to_goal)
            + reward.azimuth * (to_facing_before - self.steps_to_facing(course.pose))
            + if outcome == Some(Outcome::Reached) { reward.success } else { 0.0 }
            + if is_invalid { reward.invalid } else { 0.0 };
        let end = outcome.map(|outcome| End {
            outcome: outcome_number(outcome),
            success: Some(outcome == Outcome::Reached),
            measure: f64::from(course.distance),
            truncated: outcome == Outcome::Timeout,
        });
        Step { reward: f64::from(earned), repeats: steps, end }
    }

    /// Steps that the base must turn until the arm's front faces the target: within its range, so not always the short way.
    fn steps_to_facing(&self, pose: Pose) -> f32 {
        (f32::from(pose.0[0]) - self.facing).abs() / 3.0
    }
}

fn distance(arm: &Arm<f32>, joints: Pose, target: [f64; 3]) -> f32 {
    kinematics::distance(kinematics::hand(arm, joints), target.map(|mm| mm as f32))
}

/// The steps to the nearest goal with all motors moving at once: (max + 0.02 Σ of the ticks to go)/3, at most 1000.
fn steps_to_goal(pose: Pose, goals: &[[i16; JOINTS]]) -> f32 {
    let least = goals.iter().map(|goal| ik::walk_length(pose.0, *goal)).min().unwrap_or(0);
    (least as f32 / 300.0).min(1000.0)
}
