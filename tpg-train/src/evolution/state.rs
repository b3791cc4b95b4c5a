//! The state of a run at the end of a generation: the content of a checkpoint.

use super::archive::Archive;
use super::genome::{Genome, TeamId};
use super::linear::Search;
use super::milestones::Milestones;
use serde::{Deserialize, Serialize};
use std::collections::{BTreeMap, VecDeque};
use tpg_engine::{Ending, PolicyGraph, Preference, Summary};

/// A root's record so far (`learn/evaluationResult.h`): the mean over all of its episodes, and their number.
#[derive(Clone, Copy, Debug, Default, PartialEq, Serialize, Deserialize)]
pub struct Record {
    /// Mean score.
    pub mean: f64,
    /// Number of episodes.
    pub evaluations: u64,
}

impl Record {
    /// Adds the scores of a generation.
    pub fn add(&mut self, scores: &[f64]) {
        let before = self.mean * self.evaluations as f64;
        self.evaluations += scores.len() as u64;
        self.mean = (before + scores.iter().sum::<f64>()) / self.evaluations.max(1) as f64;
    }
}

/// A population that breeds separately.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize)]
pub struct Deme {
    /// Its teams and programs.
    pub genome: Genome,
    /// Its surviving roots' records.
    pub records: BTreeMap<TeamId, Record>,
}

/// The best root on the selection set so far.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Best {
    /// Generation in which it was found.
    pub generation: u64,
    /// Its result on the selection set.
    pub result: Summary,
    /// Standard error of that result: of the mean score, or of the success rate where policies are compared by it.
    #[serde(default)]
    pub error: f64,
    /// The root.
    pub policy: PolicyGraph,
    /// Ranges of the inputs, if the environment does not know all of them.
    pub ranges: Option<Vec<[f64; 2]>>,
}

impl Best {
    /// Enters a hall of fame: the roots that no other one [covers](Self::covers), smallest first.
    pub(super) fn enter(self, hall: &mut Vec<Self>, preference: Preference) {
        if hall.iter().any(|other| other.covers(&self, preference)) {
            return;
        }
        hall.retain(|other| !self.covers(other, preference));
        let place = hall.partition_point(|other| other.policy.size() < self.policy.size());
        hall.insert(place, self);
    }

    /// Returns the smallest root of a hall of fame whose result is at most `errors` standard errors below the best one. Where that
    /// reaches the target of the run, so does the choice.
    pub(super) fn choose(hall: &[Self], errors: f64, preference: Preference, target: Option<f64>) -> Option<&Self> {
        let figure = |it: &Self| match preference {
            Preference::Score => it.result.score,
            Preference::Success => it.result.success.unwrap_or(0.0),
        };
        let best = hall.iter().max_by(|a, b| a.result.compare(&b.result, preference))?;
        let least = figure(best) - errors * best.error;
        let reaches = |it: &Self| target.is_none_or(|target| it.result.score >= target);
        hall.iter().find(|it| figure(it) >= least && (reaches(it) || !reaches(best)))
    }

    /// Returns true if this root is neither larger nor worse than the other.
    fn covers(&self, other: &Self, preference: Preference) -> bool {
        self.policy.size() <= other.policy.size() && self.result.compare(&other.result, preference).is_ge()
    }
}

/// One row of the logs. It contains no times: logs are equal for any number of threads, and after a resume.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Row {
    /// The generation, from 0.
    pub generation: u64,
    /// Best running mean of a root.
    pub best_score: f64,
    /// Median of the roots' running means.
    pub median_score: f64,
    /// Fraction of this generation's episodes that the best root solved, if the problem defines success.
    pub best_success: Option<f64>,
    /// Mean of the problem's measure at the end of the best root's episodes.
    pub best_measure: f64,
    /// Number of roots evaluated.
    pub roots: usize,
    /// Number of teams after selection.
    pub teams: usize,
    /// Number of programs after selection.
    pub programs: usize,
    /// Result of the best root on the selection set, in generations that validate.
    pub validation: Option<Summary>,
}

/// State of a run at the end of a generation.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct State<Task> {
    /// The run's seed.
    pub seed: u64,
    /// The next generation.
    pub generation: u64,
    /// The searches of a linear start.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub searches: Vec<Search>,
    /// The best search that stalled before another one began.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub stalled: Option<Search>,
    /// Milestones of a start that is limited by steps.
    #[serde(default, skip_serializing_if = "Milestones::is_empty")]
    pub milestones: Milestones,
    /// The demes.
    pub demes: Vec<Deme>,
    /// The archive.
    pub archive: Archive,
    /// Episodes that a best root failed, newest last.
    pub pool: VecDeque<Task>,
    /// The best root on the selection set.
    pub best: Option<Best>,
    /// The hall of fame: of the roots that won a validation, those of which no other is both smaller and better; smallest
    /// first.
    #[serde(default)]
    pub hall: Vec<Best>,
    /// The logs.
    pub rows: Vec<Row>,
    /// Units of literals: half the range of each value of the flat state.
    pub scales: Vec<f64>,
    /// Number of training episodes so far.
    pub training_episodes: u64,
    /// Number of validation episodes so far.
    pub selection_episodes: u64,
    /// Number of actions of all episodes so far.
    pub steps: u64,
    /// Number of them in validation.
    #[serde(default)]
    pub selection_steps: u64,
    /// Mean number of actions in a training episode of the newest generation, rounded up.
    #[serde(default)]
    pub episode_steps: u64,
}

/// Returns the number of actions of episodes.
fn actions<'a>(endings: impl IntoIterator<Item = &'a Ending>) -> u64 {
    endings.into_iter().map(|ending| u64::from(ending.actions)).sum()
}

impl<Task> State<Task> {
    /// Creates the state of a run before its first generation.
    pub fn new(seed: u64, demes: usize, archive_size: usize) -> Self {
        Self {
            seed,
            generation: 0,
            searches: Vec::new(),
            stalled: None,
            milestones: Milestones::default(),
            demes: vec![Deme::default(); demes],
            archive: Archive::new(archive_size),
            pool: VecDeque::new(),
            best: None,
            hall: Vec::new(),
            rows: Vec::new(),
            scales: Vec::new(),
            training_episodes: 0,
            selection_episodes: 0,
            steps: 0,
            selection_steps: 0,
            episode_steps: 0,
        }
    }

    /// Counts the training episodes of a generation, which ended so.
    pub(super) fn count_training<'a>(&mut self, endings: impl Iterator<Item = &'a Ending> + Clone) {
        let (episodes, steps) = (endings.clone().count() as u64, actions(endings));
        self.training_episodes += episodes;
        self.steps += steps;
        self.episode_steps = steps.div_ceil(episodes.max(1));
    }

    /// Counts episodes of validation, which ended so.
    pub(super) fn count_selection(&mut self, endings: &[Ending]) {
        let steps = actions(endings);
        self.selection_episodes += endings.len() as u64;
        self.steps += steps;
        self.selection_steps += steps;
    }
}

#[cfg(test)]
mod tests {
    use super::Best;
    use tpg_engine::{Destination, Edge, Ending, PolicyGraph, Preference, Summary};

    fn best(edges: usize, score: f64, generation: u64) -> Best {
        let result = Summary::of(&[Ending { outcome: 0, success: None, score, measure: 0.0, actions: 1 }]);
        let team = vec![Edge { program: 0, to: Destination::Action(0) }; edges];
        Best { generation, result, error: 0.1, policy: PolicyGraph::new(1, 0, vec![team], vec![vec![]]), ranges: None }
    }

    #[test]
    fn the_hall_of_fame_holds_what_nothing_smaller_beats() {
        let mut hall = Vec::new();
        for (generation, (size, score)) in (0..).zip([(5, 1.0), (3, 0.5), (7, 0.9), (5, 1.0), (9, 2.0), (2, 0.5)]) {
            best(size, score, generation).enter(&mut hall, Preference::Score);
        }
        let found: Vec<_> = hall.iter().map(|it| (it.policy.size(), it.result.score, it.generation)).collect();
        assert_eq!(found, [(2, 0.5, 5), (5, 1.0, 0), (9, 2.0, 4)]);

        // Errors of 0.1 each: 10 of them reach 1.0, 15 reach 0.5.
        let chosen = |errors, target| Best::choose(&hall, errors, Preference::Score, target).map(|it| it.policy.size());
        assert_eq!(chosen(9.0, None), Some(9));
        assert_eq!(chosen(10.5, None), Some(5));
        assert_eq!(chosen(15.5, None), Some(2));
        assert_eq!(chosen(15.5, Some(0.9)), Some(5), "what reaches the target");
        assert_eq!(chosen(15.5, Some(7.0)), Some(2), "nothing does");
        assert_eq!(Best::choose(&[], 1.0, Preference::Score, None), None);
    }
}
