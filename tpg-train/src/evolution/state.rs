//! All that a run is at the end of a generation: what a checkpoint holds.

use super::archive::Archive;
use super::genome::{Genome, TeamId};
use serde::{Deserialize, Serialize};
use std::collections::{BTreeMap, VecDeque};
use tpg_engine::{Policy, Summary};

/// How a root did so far (`learn/evaluationResult.h`): the mean over all of its episodes, and how many they were.
#[derive(Clone, Copy, Debug, Default, PartialEq, Serialize, Deserialize)]
pub struct Record {
    /// Mean score.
    pub mean: f64,
    /// Episodes.
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

/// A population that breeds on its own.
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
    /// The generation that it was found in.
    pub generation: u64,
    /// Its result on the selection set.
    pub result: Summary,
    /// The root.
    pub policy: Policy,
    /// The ranges of the inputs, where the environment does not know them all.
    pub ranges: Option<Vec<[f64; 2]>>,
}

/// One line of the logs. No clock: logs are equal for any number of threads, and after a resume.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Row {
    /// The generation, from 0.
    pub generation: u64,
    /// Best running mean of a root.
    pub best_score: f64,
    /// Median of the roots' running means.
    pub median_score: f64,
    /// Fraction of this generation's episodes that the best root solved, where the problem knows success.
    pub best_success: Option<f64>,
    /// Mean of the problem's measure at the end of the best root's episodes.
    pub best_measure: f64,
    /// Roots evaluated.
    pub roots: usize,
    /// Teams after selection.
    pub teams: usize,
    /// Programs after selection.
    pub programs: usize,
    /// The result of the best root on the selection set, in generations that validate.
    pub validation: Option<Summary>,
}

/// A run at the end of a generation.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct State<Task> {
    /// The run's seed.
    pub seed: u64,
    /// The next generation.
    pub generation: u64,
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
    /// The units of literals: half the range of each value of the flat state.
    pub scales: Vec<f64>,
    /// Episodes of training so far.
    pub training_episodes: u64,
    /// Episodes of validation so far.
    pub selection_episodes: u64,
    /// Actions of all episodes so far.
    pub steps: u64,
}

impl<Task> State<Task> {
    /// A run before its first generation.
    pub fn new(seed: u64, demes: usize, archive_size: usize) -> Self {
        Self {
            seed,
            generation: 0,
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
