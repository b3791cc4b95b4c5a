//! The records of roots, and the rows of the logs.

use serde::{Deserialize, Serialize};
use tpg_engine::Summary;

/// A root's record so far (`learn/evaluationResult.h`): the mean over all of its episodes, and their number.
#[derive(Clone, Copy, Debug, Default, PartialEq, Serialize, Deserialize)]
pub(crate) struct Record {
    /// Mean score.
    pub mean: f64,
    /// Number of episodes.
    pub evaluations: u64,
}

impl Record {
    /// Adds the scores of a generation.
    pub(crate) fn add(&mut self, scores: impl Iterator<Item = f64>) {
        let (mut sum, before) = (self.mean * self.evaluations as f64, self.evaluations);
        for score in scores {
            sum += score;
            self.evaluations += 1;
        }
        if self.evaluations > before {
            self.mean = sum / self.evaluations as f64;
        }
    }
}

/// One row of the logs. It contains no times: logs are equal for any number of threads, and after a resume.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize)]
pub struct Row {
    /// The generation, from 0.
    pub generation: u64,
    /// Steps of the environment that the run has made with it, those of validation included.
    pub steps: u64,
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
    /// Result of the best root on the validation set, in generations that validate.
    pub validation: Option<Summary>,
}

#[cfg(test)]
mod tests {
    use super::Record;

    #[test]
    fn a_bad_episode_moves_a_long_record_little_and_decides_about_a_new_one() {
        let (mut long, mut new) = (Record { mean: 100.0, evaluations: 9 }, Record::default());
        long.add([0.0].into_iter());
        new.add([0.0].into_iter());
        assert_eq!((long.mean, new.mean), (90.0, 0.0));
    }
}
