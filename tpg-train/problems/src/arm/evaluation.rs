//! Trials: success rate and failures of a policy on a list of tasks.

use crate::arm::problem::{ArmProblem, OUTCOMES};
use crate::arm::targets::Task;
use serde::Serialize;
use serde_json::{Map, Value};
use std::collections::BTreeMap;
use tpg_arm::cycle::Brent;
use tpg_arm::episode::Episode;
use tpg_arm::kinematics::Lattice;
use tpg_arm::observation::Observation;
use tpg_arm::{Arm, Move};
use tpg_engine::{EpisodeResult, Summary, quantile};
use tpg_runtime::policy::Policy;

/// Statistics of many episodes of one problem, for reports. Rates lie in 0..1, distances are in mm.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct ReachStatistics {
    /// Rate of episodes that ended at the target.
    #[serde(skip)]
    pub success_rate: f64,
    /// Rate of episodes that ended with an invalid action, including joint limits, as in the paper.
    pub collision_rate: f64,
    /// Mean final distance.
    pub mean_distance_mm: f64,
    /// Median final distance.
    median_distance_mm: f64,
    /// Mean number of actions of all episodes.
    pub mean_actions: f64,
    /// Mean number of actions of the successful episodes; 0 if there are none.
    mean_actions_on_success: f64,
    /// Number of failures of each kind.
    failures: BTreeMap<&'static str, usize>,
}

/// Runs one episode of each task.
pub fn run<S, P>(arm: &Arm<S>, policy: &P, problem: &ArmProblem, tasks: &[Task]) -> Vec<EpisodeResult>
where
    S: Lattice,
    P: Policy<State = Observation<S>, Action = Move> + ?Sized,
{
    let ending = |task: &Task| {
        let episode = Episode::with_play(arm, problem.reach(task), Brent::new(), problem.play(task));
        let summary = episode.run(policy, |_pose| ());
        problem.ending(summary.outcome, summary.actions, summary.distance.to_f64())
    };
    tasks.iter().map(ending).collect()
}

impl ReachStatistics {
    /// Computes the statistics of the arm's episodes.
    pub fn new(endings: &[EpisodeResult]) -> Self {
        let count =
            |name: &&str| endings.iter().filter(|ending| OUTCOMES[usize::from(ending.outcome)] == *name).count();
        let failures: BTreeMap<&str, usize> = OUTCOMES[1..].iter().map(|name| (*name, count(name))).collect();
        let successes: Vec<&EpisodeResult> = endings.iter().filter(|ending| ending.success == Some(true)).collect();
        let on_success: f64 = successes.iter().map(|ending| f64::from(ending.actions)).sum();
        let mut distances: Vec<f64> = endings.iter().map(|ending| ending.measure).collect();
        let count = endings.len().max(1) as f64;
        distances.sort_by(f64::total_cmp);
        let invalid = failures["joint_limit"] + failures["table"] + failures["base"];
        Self {
            success_rate: successes.len() as f64 / count,
            collision_rate: invalid as f64 / count,
            mean_distance_mm: distances.iter().sum::<f64>() / count,
            median_distance_mm: quantile(&distances, 0.5).unwrap_or(0.0),
            mean_actions: Summary::new(endings).actions,
            mean_actions_on_success: on_success / successes.len().max(1) as f64,
            failures,
        }
    }
}

/// Returns the arm's figures of episodes, for reports.
pub(crate) fn figures(endings: &[EpisodeResult]) -> Map<String, Value> {
    let figures = serde_json::to_value(ReachStatistics::new(endings)).expect("plain numbers");
    figures.as_object().cloned().unwrap_or_default()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::arm::targets::{Set, Start, tasks};
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
        let statistics = |moves| ReachStatistics::new(&run(&WIDOWX, &Always(moves), &Start::Fs.into(), &tasks));
        let turning = statistics(Move::single(Joint(0), 3));
        assert_eq!(turning.failures["joint_limit"] + (turning.success_rate * 40.0).round() as usize, 40);
        assert!(turning.mean_actions > 600.0, "the base turns 682 steps to its limit");
        let resting = statistics(Move::STOP);
        assert_eq!((resting.failures["stop"], resting.collision_rate, resting.mean_actions), (40, 0.0, 1.0));
    }
}
