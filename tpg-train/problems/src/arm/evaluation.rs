//! Trials: success rate and failures of a policy on a list of tasks.

use crate::arm::problem::{ArmProblem, OUTCOMES};
use crate::arm::targets::{Start, Task};
use serde::Serialize;
use serde_json::{Map, Value, json};
use tpg_arm::cycle::Brent;
use tpg_arm::episode::{Episode, Summary};
use tpg_arm::kinematics::Lattice;
use tpg_arm::observation::Observation;
use tpg_arm::{Arm, Move, Pose};
use tpg_engine::EpisodeResult;
use tpg_runtime::policy::Policy;

/// Statistics of many episodes of one problem. Rates lie in 0..1, distances are in mm.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct ReachStatistics {
    /// Start of the episodes.
    pub problem: Start,
    /// Number of episodes.
    pub episodes: usize,
    /// Rate of episodes that ended at the target.
    pub success_rate: f64,
    /// Rate of episodes that ended with an invalid action, including joint limits, as in the paper.
    pub collision_rate: f64,
    /// Mean final distance.
    pub mean_distance_mm: f64,
    /// Median final distance.
    pub median_distance_mm: f64,
    /// Mean number of actions of all episodes.
    pub mean_actions: f64,
    /// Mean number of actions of the successful episodes; 0 if there are none.
    pub mean_actions_on_success: f64,
    /// Reasons for the failures.
    pub failures: Failures,
    /// The episodes, in order.
    #[serde(skip)]
    pub endings: Vec<EpisodeResult>,
}

/// Failed episodes by the kind of their end.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize)]
pub struct Failures {
    /// A pose was repeated.
    pub cycle: usize,
    /// The policy chose not to move.
    pub stop: usize,
    /// A joint would have left its range.
    pub joint_limit: usize,
    /// The arm, or a corner of the hand, would have gone below the table.
    pub table: usize,
    /// The arm would have hit its own base.
    pub base: usize,
    /// The action limit was reached.
    pub timeout: usize,
}

/// Runs one episode of each task.
pub fn run<S, P>(arm: &Arm<S>, policy: &P, problem: impl Into<ArmProblem>, tasks: &[Task]) -> ReachStatistics
where
    S: Lattice,
    P: Policy<State = Observation<S>, Action = Move> + ?Sized,
{
    let problem = problem.into();
    let summaries: Vec<_> = tasks.iter().map(|task| watch(arm, policy, &problem, task, |_pose| ())).collect();
    summarise(problem, &summaries)
}

/// Runs one episode and calls `each` with the pose after every action.
pub fn watch<S, P>(arm: &Arm<S>, policy: &P, problem: &ArmProblem, task: &Task, each: impl FnMut(Pose)) -> Summary<S>
where
    S: Lattice,
    P: Policy<State = Observation<S>, Action = Move> + ?Sized,
{
    Episode::with_play(arm, problem.reach(task), Brent::new(), problem.play(task)).run(policy, each)
}

/// Computes the statistics of episodes with a problem's scores; a start's are the paper's.
pub fn summarise<S: Lattice>(problem: impl Into<ArmProblem>, summaries: &[Summary<S>]) -> ReachStatistics {
    let problem = problem.into();
    let ending = |summary: &Summary<S>| problem.ending(summary.outcome, summary.actions, summary.distance.to_f64());
    ReachStatistics::new(problem.start, summaries.iter().map(ending).collect())
}

impl ReachStatistics {
    /// Computes the statistics of the arm's episodes.
    pub fn new(problem: Start, endings: Vec<EpisodeResult>) -> Self {
        let failed = |name: &str| endings.iter().filter(|ending| OUTCOMES[usize::from(ending.outcome)] == name).count();
        let failures = Failures {
            cycle: failed("cycle"),
            stop: failed("stop"),
            joint_limit: failed("joint_limit"),
            table: failed("table"),
            base: failed("base"),
            timeout: failed("timeout"),
        };
        let successes: Vec<&EpisodeResult> = endings.iter().filter(|ending| ending.success == Some(true)).collect();
        let on_success: f64 = successes.iter().map(|ending| f64::from(ending.actions)).sum();
        let mut distances: Vec<f64> = endings.iter().map(|ending| ending.measure).collect();
        let count = endings.len().max(1) as f64;
        distances.sort_by(f64::total_cmp);
        let mean_distance_mm = distances.iter().sum::<f64>() / count;
        let invalid = failures.joint_limit + failures.table + failures.base;
        Self {
            problem,
            episodes: endings.len(),
            success_rate: successes.len() as f64 / count,
            collision_rate: invalid as f64 / count,
            mean_distance_mm,
            median_distance_mm: median(&distances),
            mean_actions: endings.iter().map(|ending| f64::from(ending.actions)).sum::<f64>() / count,
            mean_actions_on_success: on_success / successes.len().max(1) as f64,
            failures,
            endings,
        }
    }
}

/// Returns the arm's figures of episodes, for reports.
pub(super) fn figures(endings: &[EpisodeResult]) -> Map<String, Value> {
    let trial = ReachStatistics::new(Start::Fs, endings.to_vec());
    let figures = json!({
        "collision_rate": trial.collision_rate,
        "mean_distance_mm": trial.mean_distance_mm,
        "median_distance_mm": trial.median_distance_mm,
        "mean_actions": trial.mean_actions,
        "mean_actions_on_success": trial.mean_actions_on_success,
        "failures": trial.failures,
    });
    figures.as_object().cloned().unwrap_or_default()
}

fn median(sorted: &[f64]) -> f64 {
    match sorted.len() {
        0 => 0.0,
        n if n % 2 == 1 => sorted[n / 2],
        n => 0.5 * (sorted[n / 2 - 1] + sorted[n / 2]),
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::arm::targets::{Set, tasks};
    use tpg_arm::{Joint, WIDOWX};

    /// A policy that always takes the same move.
    struct Always(Move);

    impl Policy for Always {
        type State = Observation<f64>;
        type Action = Move;
        fn decide(&self, _seen: &Observation<f64>) -> Move {
            self.0
        }
    }

    #[test]
    fn every_episode_is_counted_once_under_its_end() {
        let tasks = tasks(&WIDOWX, 5, Set::Validation, Start::Fs, 40);
        let turning = run(&WIDOWX, &Always(Move::single(Joint(0), 3)), Start::Fs, &tasks);
        assert_eq!(turning.failures.joint_limit + (turning.success_rate * 40.0).round() as usize, 40);
        assert!(turning.mean_actions > 600.0, "the base turns 682 steps to its limit");
        let resting = run(&WIDOWX, &Always(Move::STOP), Start::Fs, &tasks);
        assert_eq!((resting.failures.stop, resting.collision_rate, resting.mean_actions), (40, 0.0, 1.0));
    }

    #[test]
    fn the_median_of_an_even_number_lies_between() {
        assert_eq!([median(&[]), median(&[1.0, 2.0, 9.0]), median(&[1.0, 2.0, 4.0, 9.0])], [0.0, 2.0, 3.0]);
    }
}
