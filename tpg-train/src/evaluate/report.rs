//! What `tpg-train eval` says.

use crate::engine::Ending;
use crate::evolution::config::Shield;
use crate::hybrid::trial::HybridTrial;
use crate::targets::Start;
use crate::trial::{Failures, Trial};
use serde::Serialize;
use std::collections::BTreeMap;
use tpg_arm::hybrid::Cause;

/// What `eval --json` prints. Rates are between 0 and 1.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct Report {
    /// `fs` or `rs`.
    pub problem: String,
    /// The policy's file.
    pub policy: String,
    /// `none`, `limits` or `limits-and-collision`: the actions that the policy cannot choose.
    pub shield: String,
    /// Episodes.
    pub episodes: usize,
    /// The seed of the test set; absent for a file of episodes.
    pub seed: Option<u64>,
    /// Part of the episodes that reached their target.
    pub success_rate: f64,
    /// Part of the episodes that an invalid action ended.
    pub collision_rate: f64,
    /// Mean distance at the end.
    pub mean_distance_mm: f64,
    /// Median distance at the end.
    pub median_distance_mm: f64,
    /// Mean number of actions.
    pub mean_actions: f64,
    /// Mean number of actions of the episodes that reached their target.
    pub mean_actions_on_success: f64,
    /// Part of the actions that the TPG chose: 1 but for a hybrid.
    pub tpg_action_ratio: f64,
    /// Time of one action on this machine, all lanes together: policy and environment.
    pub ns_per_action: f64,
    /// Episodes by how they failed.
    pub failures: BTreeMap<String, usize>,
    /// Hand-overs an episode to a hybrid's network, by cause; absent for other policies.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub hand_overs: Option<BTreeMap<String, f64>>,
}

impl Report {
    /// Of the endings of some episodes; `seconds` is what they took.
    pub fn new(
        problem: Start,
        policy: &str,
        shield: Shield,
        seed: Option<u64>,
        endings: &[Ending],
        outcomes: &[&str],
        seconds: f64,
    ) -> Self {
        let share = |count: usize| count as f64 / endings.len().max(1) as f64;
        let of = |names: &[&str]| endings.iter().filter(|e| names.contains(&outcomes[usize::from(e.outcome)])).count();
        let mean = |values: &[f64]| values.iter().sum::<f64>() / values.len().max(1) as f64;
        let mut distances: Vec<f64> = endings.iter().map(|ending| ending.error).collect();
        distances.sort_by(f64::total_cmp);
        let actions: Vec<f64> = endings.iter().map(|ending| f64::from(ending.actions)).collect();
        let on_success: Vec<f64> =
            (endings.iter().filter(|ending| ending.success)).map(|ending| f64::from(ending.actions)).collect();
        let failures = outcomes.iter().filter(|&&name| name != "reached").map(|&name| (name.to_owned(), of(&[name])));
        let middle = distances.len() / 2;
        let median = if distances.len() % 2 == 1 {
            distances[middle]
        } else if middle > 0 {
            0.5 * (distances[middle - 1] + distances[middle])
        } else {
            0.0
        };
        Self {
            problem: match problem {
                Start::Fs => "fs".to_owned(),
                Start::Rs => "rs".to_owned(),
            },
            policy: policy.to_owned(),
            shield: shield.name().to_owned(),
            episodes: endings.len(),
            seed,
            success_rate: share(endings.iter().filter(|ending| ending.success).count()),
            collision_rate: share(of(&["joint_limit", "table", "base"])),
            mean_distance_mm: mean(&distances),
            median_distance_mm: median,
            mean_actions: mean(&actions),
            mean_actions_on_success: mean(&on_success),
            tpg_action_ratio: 1.0,
            ns_per_action: seconds * 1e9 / actions.iter().sum::<f64>().max(1.0),
            failures: failures.collect(),
            hand_overs: None,
        }
    }

    /// Of a policy that is no graph; `seconds` is what its episodes took.
    pub fn of_trial(trial: &Trial, policy: &str, seed: Option<u64>, seconds: f64) -> Self {
        let Failures { cycle, stop, joint_limit, table, base, timeout } = trial.failures;
        let failures = [
            ("base", base),
            ("cycle", cycle),
            ("joint_limit", joint_limit),
            ("stop", stop),
            ("table", table),
            ("timeout", timeout),
        ];
        Self {
            problem: match trial.problem {
                Start::Fs => "fs".to_owned(),
                Start::Rs => "rs".to_owned(),
            },
            policy: policy.to_owned(),
            shield: Shield::None.name().to_owned(),
            episodes: trial.episodes,
            seed,
            success_rate: trial.success_rate,
            collision_rate: trial.collision_rate,
            mean_distance_mm: trial.mean_distance_mm,
            median_distance_mm: trial.median_distance_mm,
            mean_actions: trial.mean_actions,
            mean_actions_on_success: trial.mean_actions_on_success,
            tpg_action_ratio: 0.0,
            ns_per_action: seconds * 1e9 / (trial.mean_actions * trial.episodes as f64).max(1.0),
            failures: failures.map(|(name, count)| (name.to_owned(), count)).into(),
            hand_overs: None,
        }
    }

    /// Of a graph and a network that share the arm; `seconds` is what their episodes took.
    pub fn of_hybrid(done: &HybridTrial, policy: &str, seed: Option<u64>, seconds: f64) -> Self {
        let causes = Cause::ALL.map(|cause| cause.name().to_owned());
        Self {
            tpg_action_ratio: done.tpg_action_ratio,
            hand_overs: Some(causes.into_iter().zip(done.hand_overs).collect()),
            ..Self::of_trial(&done.trial, policy, seed, seconds)
        }
    }

    /// The report as a table for people.
    pub fn to_table(&self) -> String {
        let failures: Vec<String> = self
            .failures
            .iter()
            .filter(|(_, count)| **count > 0)
            .map(|(name, count)| format!("{name} {count}"))
            .collect();
        format!(
            "{} on {}, {} episodes\n\
             shield         {}\n\
             success        {:.1} %\n\
             collision      {:.1} %\n\
             distance       {:.2} mm mean, {:.2} mm median\n\
             actions        {:.0} mean, {:.0} mean on success\n\
             failures       {}\n\
             {}\
             time           {:.1} ns per action, all lanes together\n",
            self.policy,
            self.problem,
            self.episodes,
            self.shield,
            100.0 * self.success_rate,
            100.0 * self.collision_rate,
            self.mean_distance_mm,
            self.median_distance_mm,
            self.mean_actions,
            self.mean_actions_on_success,
            failures.join(", "),
            self.hand_overs.as_ref().map_or(String::new(), |causes| {
                let causes: Vec<String> = causes.iter().map(|(name, count)| format!("{name} {count:.2}")).collect();
                let ratio = 100.0 * self.tpg_action_ratio;
                format!("by the graph   {ratio:.1} % of the actions; hand-overs an episode: {}\n", causes.join(", "))
            }),
            self.ns_per_action
        )
    }
}
