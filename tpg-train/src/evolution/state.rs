//! The state of a run at the end of a generation: the content of a checkpoint.

use super::budget::Budget;
use super::population::Population;
use super::record::Row;
use super::search::Search;
use serde::{Deserialize, Serialize};
use std::collections::VecDeque;
use tpg_engine::{EpisodeResult, PolicyGraph, Preference, Summary};

/// The best root on the validation set so far.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Best {
    /// Generation in which it was found.
    pub generation: u64,
    /// Its result on the validation set.
    pub result: Summary,
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

    /// Returns true if this root is neither larger nor worse than the other.
    fn covers(&self, other: &Self, preference: Preference) -> bool {
        self.policy.size() <= other.policy.size() && self.result.compare(&other.result, preference).is_ge()
    }
}

/// State of a run at the end of a generation.
#[derive(Clone, Debug, Serialize, Deserialize)]
pub(crate) struct State<Task> {
    /// The run's seed.
    pub seed: u64,
    /// The next generation.
    pub generation: u64,
    /// The budget of the search for weights.
    pub budget: Budget,
    /// The search for weights, until it has ended.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub search: Option<Search>,
    /// The best search that stalled before another one began.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub stalled: Option<Search>,
    /// The evolving roots.
    pub population: Population,
    /// Episodes that a best root failed, newest last.
    pub pool: VecDeque<Task>,
    /// The best root on the validation set.
    pub best: Option<Best>,
    /// The hall of fame: of the roots that won a validation, those of which no other is both smaller and better; smallest
    /// first.
    pub hall: Vec<Best>,
    /// The logs.
    pub rows: Vec<Row>,
    /// Units of literals: half the range of each value of the flat state.
    pub scales: Vec<f64>,
    /// Number of actions of all episodes so far.
    pub steps: u64,
    /// Number of them in validation.
    pub selection_steps: u64,
    /// The maximum number of steps with which the newest generation was the last one.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub ended_at: Option<u64>,
    /// Mean number of actions in a training episode of the newest generation's best candidate, rounded up.
    pub episode_steps: u64,
}

/// Returns the number of actions of episodes.
pub(super) fn actions<'a>(endings: impl IntoIterator<Item = &'a EpisodeResult>) -> u64 {
    endings.into_iter().map(|ending| u64::from(ending.actions)).sum()
}

impl<Task> State<Task> {
    /// Creates the state of a run before its first generation.
    pub(crate) fn new(seed: u64) -> Self {
        Self {
            seed,
            generation: 0,
            budget: Budget::default(),
            search: None,
            stalled: None,
            population: Population::default(),
            pool: VecDeque::new(),
            best: None,
            hall: Vec::new(),
            rows: Vec::new(),
            scales: Vec::new(),
            steps: 0,
            selection_steps: 0,
            ended_at: None,
            episode_steps: 0,
        }
    }

    /// Counts the training episodes of a generation, and the length of those of its best candidate.
    pub(super) fn count_training(&mut self, endings: &[Vec<EpisodeResult>], best: usize) {
        self.steps += actions(endings.iter().flatten());
        if let Some(best) = endings.get(best).filter(|best| !best.is_empty()) {
            self.episode_steps = actions(best).div_ceil(best.len() as u64);
        }
    }

    /// Counts episodes of validation, which ended so.
    pub(super) fn count_selection(&mut self, endings: &[EpisodeResult]) {
        let steps = actions(endings);
        self.steps += steps;
        self.selection_steps += steps;
    }

    /// Adds the episodes that a policy failed to the pool, which holds the newest `most`; if the problem does not define success,
    /// those with a score below the mean.
    pub(super) fn remember_hard(&mut self, tasks: &[Task], endings: &[EpisodeResult], most: usize)
    where
        Task: Clone + PartialEq,
    {
        let mean = Summary::new(endings).score;
        for (task, ending) in tasks.iter().zip(endings) {
            let is_hard = ending.success.map_or(ending.score < mean, |success| !success);
            // With duplicates, the pool would fill up with the few episodes that no root can solve.
            if is_hard && !self.pool.contains(task) {
                self.pool.push_back(task.clone());
            }
        }
        while self.pool.len() > most {
            self.pool.pop_front();
        }
    }
}

#[cfg(test)]
mod tests {
    use super::Best;
    use tpg_engine::{Destination, Edge, EpisodeResult, PolicyGraph, Preference, Summary};

    fn best(edges: usize, score: f64, generation: u64) -> Best {
        let result = Summary::new(&[EpisodeResult {
            outcome: 0,
            success: None,
            score,
            final_reward: 0.0,
            measure: 0.0,
            actions: 1,
        }]);
        let team = vec![Edge { program: 0, to: Destination::Action(0) }; edges];
        Best { generation, result, policy: PolicyGraph::new(1, 0, vec![team], vec![vec![]]), ranges: None }
    }

    #[test]
    fn the_hall_of_fame_holds_what_nothing_smaller_beats() {
        let mut hall = Vec::new();
        for (generation, (size, score)) in (0..).zip([(5, 1.0), (3, 0.5), (7, 0.9), (5, 1.0), (9, 2.0), (2, 0.5)]) {
            best(size, score, generation).enter(&mut hall, Preference::Score);
        }
        let found: Vec<_> = hall.iter().map(|it| (it.policy.size(), it.result.score, it.generation)).collect();
        assert_eq!(found, [(2, 0.5, 5), (5, 1.0, 0), (9, 2.0, 4)]);
    }
}
