//! All that a run is at the end of a generation: what a checkpoint holds.

use super::archive::Archive;
use super::genome::{Genome, TeamId};
use serde::{Deserialize, Serialize};
use std::collections::{BTreeMap, VecDeque};
use tpg_engine::Policy;

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
    /// What it was chosen by: 100 · success − 0.3 · mean error.
    pub worth: f64,
    /// Part of the selection episodes that it did.
    pub success: f64,
    /// Mean error at their end.
    pub error: f64,
    /// It.
    pub policy: Policy,
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
    /// Part of this generation's episodes that the best root did.
    pub best_success: f64,
    /// Mean error of the best root at the end of this generation's episodes.
    pub best_error: f64,
    /// Roots evaluated.
    pub roots: usize,
    /// Teams after selection.
    pub teams: usize,
    /// Programs after selection.
    pub programs: usize,
    /// Success of the best root on the selection set, in generations that validate.
    pub validation_success: Option<f64>,
    /// Its mean error there.
    pub validation_error: Option<f64>,
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
        }
    }
}
