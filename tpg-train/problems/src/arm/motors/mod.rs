//! The arm by its four motors: preferences that become steps, as soft actor-critics act.
//!
//! | module | subject |
//! | --- | --- |
//! | (root) | [`Motors`], the environment |
//! | [`config`] | the section `[problem]` |
//! | `episode` | an episode under the rules of training or of tests |

pub mod config;
mod episode;

pub use config::{MotorsConfig, Reward};
pub use episode::MotorsEpisode;

use super::problem::{ArmProblem, DISTANCE, OUTCOMES, on_the_arm};
use super::targets::{self, ReachableSpace, Set, Start};
use super::{drawing, ik};
use serde::{Deserialize, Serialize};
use tpg_arm::sac::{Decision, FEATURE_NAMES, features};
use tpg_arm::{Arm, JOINTS, Pose};
use tpg_engine::random::Stream;
use tpg_engine::{Act, ActionSpace, Environment, Measure, Output, Preference, SourceSet, Step, TaskSet, Training};
use tpg_graph::SourceDocument;

/// The names of the motors, in order.
const MOTORS: [&str; JOINTS] = ["base", "shoulder", "elbow", "wrist"];

/// Returns the sources of networks: one for each input.
pub(super) fn sources() -> Vec<SourceDocument> {
    // Dimensionless already: nothing to scale.
    FEATURE_NAMES.map(|name| crate::source(name, "", [f64::NEG_INFINITY, f64::INFINITY])).into()
}

/// Returns the outputs of networks: a preference for each motor.
pub(super) fn outputs() -> Vec<Output> {
    let output = |name: &str| Output { name: name.to_owned(), unit: String::new(), min: -1.0, max: 1.0 };
    MOTORS.map(output).into()
}

/// The arm, driven by a preference of −1 to 1 for each motor.
///
/// Training episodes have a shaped reward, may repeat an action, and are cut off without failing. Episodes of validation
/// and evaluation tasks follow the rules of tests: single steps, the paper's score.
#[derive(Clone, Debug)]
pub struct Motors {
    start: Start,
    config: MotorsConfig,
    /// In the precision that actors run in.
    arm: Arm<f32>,
    description: Arm<f64>,
    decision: Decision<f32>,
    seed: u64,
    /// The rules of tests; those of the settings if there are none.
    tests: Option<ArmProblem>,
}

/// One episode's task.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
pub struct MotorsTask {
    /// The pose at the start, ticks.
    pub start: [i16; JOINTS],
    /// The point that the hand shall reach, mm.
    pub target: [f64; 3],
    /// The rules of the episode.
    pub rules: Rules,
}

/// The rules of an episode.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "snake_case")]
pub enum Rules {
    /// Those of the configuration.
    Training,
    /// Those of tests, with the limit of that start.
    Test(Start),
}

impl Motors {
    /// The problem of that start. The space that tasks are drawn from, and the validation tasks, depend on `seed`.
    pub fn new(start: Start, config: MotorsConfig, seed: u64) -> Self {
        let description = config.arm();
        Self { start, arm: description.to_f32(), description, decision: config.decision(), config, seed, tests: None }
    }

    /// Returns the same problem with other rules of tests.
    #[must_use]
    pub(crate) fn with_tests(self, tests: ArmProblem) -> Self {
        Self { tests: Some(tests), ..self }
    }

    fn rules(&self, start: Start) -> ArmProblem {
        self.tests.clone().unwrap_or_else(|| self.config.tests(start))
    }

    /// The settings.
    pub fn config(&self) -> &MotorsConfig {
        &self.config
    }

    /// A task that training can use: where the reward needs poses that solve it, some are known.
    fn fresh(&self, start: Start, rules: Rules, stream: &mut Stream) -> MotorsTask {
        let reach = ReachableSpace::shared(&self.description, self.seed, Set::Training);
        loop {
            let targets::Task { start, target } = reach.task(start, stream);
            if !self.config.reward.knows_goals() || !ik::goals(&self.description, target).is_empty() {
                return MotorsTask { start: start.0, target, rules };
            }
        }
    }
}

impl Environment<f32> for Motors {
    type Task = MotorsTask;
    type Episode = MotorsEpisode;

    fn sources(&self) -> Vec<SourceDocument> {
        sources()
    }

    fn actions(&self) -> ActionSpace {
        ActionSpace::Box(outputs())
    }

    fn outcomes(&self) -> &'static [&'static str] {
        &OUTCOMES
    }

    fn measure(&self) -> Option<Measure> {
        Some(DISTANCE)
    }

    fn preference(&self) -> Preference {
        Preference::Success
    }

    /// Every episode ends by its own rules before.
    fn time_limit(&self) -> u32 {
        self.config.max_steps.max(Start::Rs.max_actions())
    }

    fn draw(&self, stream: &mut Stream) -> MotorsTask {
        let start = if stream.chance(self.config.fixed_start_share) { Start::Fs } else { Start::Rs };
        self.fresh(start, Rules::Training, stream)
    }

    fn training(&self) -> Option<&dyn Training<MotorsTask>> {
        Some(self)
    }

    /// Training begins there, unless the hand is at its target already.
    fn task_from(&self, episode: &MotorsEpisode) -> Option<MotorsTask> {
        let rules = Rules::Training;
        let far = f64::from(episode.course.distance) > self.config.tolerance;
        far.then_some(MotorsTask { start: episode.pose().0, target: episode.course.target, rules })
    }

    fn moment(&self, episode: &MotorsEpisode) -> Vec<f64> {
        drawing::moment(episode.pose(), episode.course.target)
    }

    fn accepts(&self, task: &MotorsTask) -> bool {
        let needs_goals = task.rules == Rules::Training && self.config.reward.knows_goals();
        on_the_arm(task.start) && (!needs_goals || !ik::goals(&self.description, task.target).is_empty())
    }

    fn start(&self, task: &MotorsTask) -> MotorsEpisode {
        let reach = targets::Task { start: Pose(task.start), target: task.target };
        match task.rules {
            Rules::Training => MotorsEpisode::training(&self.config, &self.arm, &reach),
            Rules::Test(start) => MotorsEpisode::test(self.rules(start), &self.arm, &reach),
        }
    }

    fn observe(&self, episode: &mut MotorsEpisode, _wanted: SourceSet, state: &mut [f32]) {
        state.copy_from_slice(&features(&episode.frame(&self.arm)));
    }

    fn step(&self, episode: &mut MotorsEpisode, act: Act<'_, f32>) -> Step {
        let values = act.values();
        let preferences = std::array::from_fn(|joint| libm::atanhf(values[joint]));
        episode.step(&self.config, &self.arm, |pose| self.decision.decide(preferences, pose, &self.arm.ranges))
    }
}

impl Training<MotorsTask> for Motors {
    /// For calibration there are `count` of each start.
    fn tasks(&self, set: TaskSet, seed: u64, count: usize) -> Option<Vec<MotorsTask>> {
        let own = [self.start];
        let starts = if set == TaskSet::Calibration { &[Start::Fs, Start::Rs][..] } else { &own };
        let (set, seed) = Set::asked(set, seed, self.seed);
        let tasks = starts.iter().flat_map(|&start| {
            let tasks = targets::tasks(&self.description, seed, set, start, count).into_iter();
            let rules = Rules::Test(start);
            tasks.map(move |task| MotorsTask { start: task.start.0, target: task.target, rules })
        });
        Some(tasks.collect())
    }

    /// Random starts first, then fixed ones.
    fn evaluation_tasks(&self, stream: &mut Stream, count: usize) -> Option<Vec<MotorsTask>> {
        let fixed = (count as f64 * self.config.trial_fixed_share).round() as usize;
        let mut tasks = Vec::with_capacity(count);
        for (start, count) in [(Start::Rs, count - fixed), (Start::Fs, fixed)] {
            tasks.extend((0..count).map(|_| self.fresh(start, Rules::Test(start), stream)));
        }
        Some(tasks)
    }
}

#[cfg(test)]
mod tests;
