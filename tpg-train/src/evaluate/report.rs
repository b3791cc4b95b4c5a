//! The figures that `tpg-train eval` prints.

use crate::effort::Effort;
use crate::hybrid::rollout::{HybridResult, TRIGGERS};
use crate::hybrid::shared::{Episodes, Facts, Shared};
use serde::Serialize;
use serde_json::{Map, Value};
use std::collections::BTreeMap;
use std::fmt::Write as _;
use tpg_engine::{EpisodeResult, Measure, Sample, Summary, confidence, finite, quantile};
use tpg_graph::Graph;

/// The result of a policy on test episodes. Rates are between 0 and 1; scores have the problem's unit.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct EvaluationReport {
    /// The problem's name.
    pub problem: String,
    /// The policy's file.
    pub policy: String,
    /// The number of episodes.
    pub episodes: usize,
    /// The seed of the test episodes; null for a file of episodes.
    pub seed: Option<u64>,
    /// The mean score.
    pub mean_score: f64,
    /// The standard deviation of the scores, over the episodes (of the sample, n − 1).
    pub std_score: f64,
    /// The lowest score.
    pub min_score: f64,
    /// The mean number of actions.
    pub mean_steps: f64,
    /// The fraction of successes; null where the problem knows no success.
    pub success_rate: Option<f64>,
    /// The 95 % interval of the success rate (Wilson's).
    pub success_ci95: Option<[f64; 2]>,
    /// The number of episodes for each way to end.
    pub outcomes: BTreeMap<String, usize>,
    /// Wear of actuators; absent for named actions, for hybrids, and for controllers that the problem brings.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub effort: Option<Effort>,
    /// The fraction of actions that a graph chose.
    pub tpg_action_ratio: f64,
    /// The figures of a hybrid.
    #[serde(flatten)]
    pub hybrid: Option<HybridFigures>,
    /// The problem's own figures.
    #[serde(flatten)]
    pub figures: Map<String, Value>,
    /// The name and unit of the problem's measure, its mean and its median.
    #[serde(skip)]
    pub measure: Option<(Measure, [f64; 2])>,
    /// The episodes.
    #[serde(skip)]
    pub endings: Vec<EpisodeResult>,
    /// The comparison with another policy; absent if none was asked for.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub against: Option<Box<Against>>,
}

/// Another policy on the same episodes.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct Against {
    /// The result of the other policy.
    pub other: EvaluationReport,
    /// The mean of the score less the other's, episode by episode.
    pub difference: f64,
    /// Its 95 % interval.
    pub difference_ci95: [f64; 2],
}

impl Against {
    /// Compares episodes with those of another policy, pair by pair.
    pub fn new(these: &[EpisodeResult], other: EvaluationReport) -> Self {
        let pairs = these.iter().zip(&other.endings);
        let differences: Vec<f64> = pairs.map(|(this, other)| finite(this.score) - finite(other.score)).collect();
        let sample = Sample::new(&differences);
        Self { other, difference: sample.mean, difference_ci95: sample.interval() }
    }

    fn to_table(&self) -> String {
        let Self { other, difference, difference_ci95: [low, high] } = self;
        let words = match (*low > 0.0, *high < 0.0) {
            (true, _) => "the first is better",
            (_, true) => "the second is better",
            _ => "no clear difference",
        };
        format!("\n{}\ndifference     {difference:+.2} (95 %: {low:+.2} to {high:+.2}): {words}\n", other.to_table())
    }
}

/// Figures that only a hybrid has.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct HybridFigures {
    /// The actions per episode that the network chose.
    pub network_actions: f64,
    /// Hand-overs to the network per episode, by cause: guard, drift, stall, cycle.
    pub hand_overs: BTreeMap<String, f64>,
    /// The number of times per episode that the network handed back.
    pub hand_backs: f64,
    /// The actions per episode that the graph asked the network for; absent for a graph that does not ask.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub asks: Option<f64>,
    /// Its 95 % interval, of ± 1.96 standard errors.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub asks_ci95: Option<[f64; 2]>,
}

impl EvaluationReport {
    /// Creates the report of episodes; `hybrid` is the graph of a hybrid.
    pub fn new(
        problem: &dyn Shared,
        policy: &str,
        episodes: Episodes<'_>,
        done: HybridResult,
        hybrid: Option<&Graph>,
    ) -> Self {
        let (endings, Facts { outcomes, measure, .. }) = (&done.endings, problem.facts());
        let summary = Summary::new(endings);
        let Summary { score: mean, success, actions, .. } = summary;
        let count = |place: usize| endings.iter().filter(|ending| usize::from(ending.outcome) == place).count();
        let judged = endings.iter().filter(|ending| ending.success.is_some()).count();
        let measures: Vec<f64> = endings.iter().map(|ending| ending.measure).collect();
        let median = quantile(&measures, 0.5).unwrap_or(0.0);
        let asks = |graph: &Graph| {
            graph.asks().next()?;
            Some(Sample::new(&done.asks.iter().map(|&asks| asks.into()).collect::<Vec<_>>()))
        };
        let hand_overs = TRIGGERS.iter().zip(done.hand_overs).map(|(&name, count)| (name.to_owned(), count));
        Self {
            problem: problem.name(),
            policy: policy.to_owned(),
            episodes: endings.len(),
            seed: episodes.file.is_none().then_some(episodes.seed),
            mean_score: mean,
            std_score: summary.score_deviation(endings),
            min_score: endings.iter().map(|ending| ending.score).fold(f64::INFINITY, f64::min),
            mean_steps: actions,
            success_rate: success,
            success_ci95: success.map(|rate| confidence(rate, judged)),
            outcomes: outcomes.iter().enumerate().map(|(place, &name)| (name.to_owned(), count(place))).collect(),
            effort: done.effort,
            tpg_action_ratio: done.tpg_action_ratio,
            hybrid: hybrid.map(|graph| HybridFigures {
                asks: asks(graph).map(|asks| asks.mean),
                asks_ci95: asks(graph).map(|asks| asks.interval()),
                network_actions: done.network_actions,
                hand_overs: hand_overs.collect(),
                hand_backs: done.hand_backs,
            }),
            figures: problem.figures(endings),
            measure: measure.map(|measure| (measure, [summary.measure, median])),
            endings: done.endings,
            against: None,
        }
    }

    /// The report as a table for people.
    pub fn to_table(&self) -> String {
        let mut text = format!("{} on {}, {} episodes\n", self.policy, self.problem, self.episodes);
        let mut row = |name: &str, value: String| {
            let _ = writeln!(text, "{name:14} {value}");
        };
        row("score", format!("{:.2} mean, ± {:.2} sd, {:.2} lowest", self.mean_score, self.std_score, self.min_score));
        if let (Some(rate), Some([low, high])) = (self.success_rate, self.success_ci95) {
            row("success", format!("{:.1} % (95 %: {:.1} to {:.1})", 100.0 * rate, 100.0 * low, 100.0 * high));
        }
        if let Some((Measure { name, unit }, [mean, median])) = &self.measure {
            row(name, format!("{mean:.2} {unit} mean, {median:.2} {unit} median"));
        }
        row("actions", format!("{:.1} mean", self.mean_steps));
        if let Some(Effort { saturated, chatter }) = self.effort {
            row("effort", format!("{:.1} % of actions saturated, chatter {chatter:.4}", 100.0 * saturated));
        }
        if let Some(hybrid) = &self.hybrid {
            let share = 100.0 * self.tpg_action_ratio;
            let causes = hybrid.hand_overs.iter().map(|(name, count)| format!("{name} {count:.2}"));
            let causes = causes.collect::<Vec<_>>().join(", ");
            row("by the graph", format!("{share:.1} % of the actions; hand-overs an episode: {causes}"));
            if let (Some(asks), Some([few, many])) = (hybrid.asks, hybrid.asks_ci95) {
                row("asks", format!("{asks:.2} an episode (95 %: {few:.2} to {many:.2})"));
            }
        }
        let ends = self.outcomes.iter().filter(|(_, count)| **count > 0);
        row("ends", ends.map(|(name, count)| format!("{name} {count}")).collect::<Vec<_>>().join(", "));
        text + &self.against.as_ref().map(|against| against.to_table()).unwrap_or_default()
    }
}

#[cfg(test)]
mod tests {
    use super::{Against, Episodes, EvaluationReport, HybridResult};
    use tpg_engine::{EpisodeResult, TaskSet};
    use tpg_problems::{Problem, ProblemName};
    use tpg_runtime::switch::Driver;

    #[test]
    fn undefined_figures_are_null() {
        let ending =
            EpisodeResult { outcome: 0, success: None, score: 2.0, final_reward: 0.0, measure: 0.0, actions: 3 };
        let done = HybridResult::alone(vec![ending, EpisodeResult { score: 4.0, ..ending }], Driver::Sac);
        let problem = Problem::new(ProblemName::Pendulum);
        let episodes = Episodes { set: TaskSet::Test, count: 2, seed: 1, file: None };
        let report = EvaluationReport::new(&problem, "graph.json", episodes, done, None);
        let json = serde_json::to_value(&report).expect("plain data");
        assert_eq!((&json["mean_score"], &json["min_score"]), (&3.0.into(), &2.0.into()));
        assert!((json["std_score"].as_f64().expect("a number") - 2f64.sqrt()).abs() < 1e-12);
        assert!(json["success_rate"].is_null() && json["success_ci95"].is_null());
        assert!(json.get("mean_distance_mm").is_none() && json.get("against").is_none());
    }

    #[test]
    fn a_difference_is_that_of_pairs() {
        let ending =
            |score| EpisodeResult { outcome: 0, success: None, score, final_reward: 0.0, measure: 0.0, actions: 3 };
        let (these, others) = ([1.0, 102.0, 7.0].map(ending), [0.0, 101.0, 5.5].map(ending));
        let episodes = Episodes { set: TaskSet::Test, count: 3, seed: 1, file: None };
        let problem = Problem::new(ProblemName::Pendulum);
        let report = |endings: &[EpisodeResult]| {
            let done = HybridResult::alone(endings.to_vec(), Driver::Sac);
            EvaluationReport::new(&problem, "graph.json", episodes, done, None)
        };
        let against = |others: &[EpisodeResult]| Against::new(&these, report(others));
        let found = against(&others);
        assert!((found.difference - 3.5 / 3.0).abs() < 1e-12);
        let half = 1.959_964 * (1.0f64 / 12.0).sqrt() / 3f64.sqrt();
        assert!((found.difference_ci95[0] - (3.5 / 3.0 - half)).abs() < 1e-6, "{found:?}");
        assert!(found.to_table().ends_with("difference     +1.17 (95 %: +0.84 to +1.49): the first is better\n"));
        assert!(
            against(&these).to_table().ends_with("difference     +0.00 (95 %: +0.00 to +0.00): no clear difference\n")
        );
        let better = against(&[2.0, 103.0, 8.5].map(ending));
        assert!(better.to_table().ends_with(": the second is better\n"), "{}", better.to_table());
    }
}
