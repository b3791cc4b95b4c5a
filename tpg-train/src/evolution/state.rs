//! The state of a run at the end of a generation: the content of a checkpoint.

use super::archive::Archive;
use super::genome::{Genome, TeamId};
use super::linear::Search;
use serde::{Deserialize, Serialize};
use std::collections::{BTreeMap, VecDeque};
use tpg_engine::{Policy, Summary};

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
    /// The root.
    pub policy: Policy,
    /// Ranges of the inputs, if the environment does not know all of them.
    pub ranges: Option<Vec<[f64; 2]>>,
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
    /// The demes.
    pub demes: Vec<Deme>,
    /// The archive.
    pub archive: Archive,
    /// Episodes that a best root failed, newest last.
    pub pool: VecDeque<Task>,
    /// The best root on the selection set.
    pub best: Option<Best>,
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
}

impl<Task> State<Task> {
    /// Creates the state of a run before its first generation.
    pub fn new(seed: u64, demes: usize, archive_size: usize) -> Self {
        Self {
            seed,
            generation: 0,
            searches: Vec::new(),
            demes: vec![Deme::default(); demes],
            archive: Archive::new(archive_size),
            pool: VecDeque::new(),
            best: None,
            rows: Vec::new(),
            scales: Vec::new(),
            training_episodes: 0,
            selection_episodes: 0,
            steps: 0,
        }
    }
}
