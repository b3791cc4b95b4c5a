//! Rewards and episode endings.

use crate::moments::Sample;
use serde::{Deserialize, Serialize};
use std::cmp::Ordering;

/// The consequence of one action.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Step {
    /// The reward; an episode's score is the sum of its rewards.
    pub reward: f64,
    /// Number of elementary steps that the action took, at least 1: a problem may repeat an action. Discounting counts
    /// these steps.
    pub repeats: u32,
    /// End of the episode, if the action ended it.
    pub end: Option<End>,
}

impl Step {
    /// Creates a step that earns `reward` and continues the episode.
    pub const fn reward(reward: f64) -> Self {
        Self { reward, repeats: 1, end: None }
    }

    /// Returns the same step, but ending the episode.
    #[must_use]
    pub const fn ending(self, end: End) -> Self {
        Self { end: Some(end), ..self }
    }
}

/// The end of an episode as reported by the environment.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct End {
    /// Index into [`Environment::outcomes`](crate::Environment::outcomes).
    pub outcome: u8,
    /// True if the task was solved; `None` if the problem does not define success.
    pub success: Option<bool>,
    /// Value of [`Environment::measure`](crate::Environment::measure); 0 if there is none.
    pub measure: f64,
    /// True if the episode was cut off although it could have gone on: its last state then still has a value.
    pub truncated: bool,
}

impl End {
    /// Creates an end that is neither success nor failure.
    pub const fn new(outcome: u8) -> Self {
        Self { outcome, success: None, measure: 0.0, truncated: false }
    }
}

/// The result of a finished episode.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
pub struct EpisodeResult {
    /// Index into [`Environment::outcomes`](crate::Environment::outcomes).
    pub outcome: u8,
    /// True if the task was solved; `None` if the problem does not define success.
    pub success: Option<bool>,
    /// Sum of the rewards.
    pub score: f64,
    /// The last of them: what the end earned or cost.
    #[serde(default)]
    pub final_reward: f64,
    /// Value of [`Environment::measure`](crate::Environment::measure); 0 if there is none.
    pub measure: f64,
    /// Number of actions, including the last one.
    pub actions: u32,
}

/// A quantity reported in addition to the score.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Measure {
    /// Its name, as reports print it: "distance".
    pub name: &'static str,
    /// Its unit: "mm".
    pub unit: &'static str,
}

/// Criterion by which policies are ranked on a problem.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Preference {
    /// Higher mean score.
    #[default]
    Score,
    /// Higher success rate; ties are broken by the higher mean score.
    Success,
}

/// Result of a policy on several episodes.
///
/// ```
/// use std::cmp::Ordering;
/// use tpg_engine::{EpisodeResult, Preference, Summary};
///
/// let ending = |score| EpisodeResult { outcome: 0, success: None, score, final_reward: 0.0, measure: 0.0, actions: 10 };
/// let (good, bad) = (Summary::new(&[ending(4.0), ending(6.0)]), Summary::new(&[ending(4.0), ending(1.0)]));
/// assert_eq!((good.score, good.success, good.actions), (5.0, None, 10.0));
/// assert_eq!(good.compare(&bad, Preference::Score), Ordering::Greater);
/// ```
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
pub struct Summary {
    /// Number of episodes.
    pub episodes: usize,
    /// Mean score.
    pub score: f64,
    /// Fraction of successes, 0 to 1; `None` if the problem does not define success.
    pub success: Option<f64>,
    /// Mean of [`EpisodeResult::measure`].
    pub measure: f64,
    /// Mean number of actions.
    pub actions: f64,
}

impl Summary {
    /// Averages `endings`; NaN scores count as the worst, and every score is clamped to ±10³⁰.
    pub fn new(endings: &[EpisodeResult]) -> Self {
        let mean = |value: &dyn Fn(&EpisodeResult) -> f64| {
            endings.iter().map(value).sum::<f64>() / endings.len().max(1) as f64
        };
        let judged = endings.iter().filter(|ending| ending.success.is_some()).count();
        let solved = endings.iter().filter(|ending| ending.success == Some(true)).count();
        Self {
            episodes: endings.len(),
            score: mean(&|ending| finite(ending.score)),
            success: (judged > 0).then(|| solved as f64 / judged as f64),
            measure: mean(&|ending| ending.measure),
            actions: mean(&|ending| f64::from(ending.actions)),
        }
    }

    /// Returns the standard deviation of the scores of the same `endings` (of the sample, n − 1); 0 for a single one.
    pub fn score_deviation(&self, endings: &[EpisodeResult]) -> f64 {
        Sample::new(&endings.iter().map(|ending| ending.score).collect::<Vec<_>>()).sample_deviation()
    }

    /// Compares two results on a problem: the greater one is better.
    pub fn compare(&self, other: &Self, preference: Preference) -> Ordering {
        let by_score = self.score.total_cmp(&other.score);
        match preference {
            Preference::Score => by_score,
            Preference::Success => self.success.unwrap_or(0.0).total_cmp(&other.success.unwrap_or(0.0)).then(by_score),
        }
    }
}

/// Clamps a score so that it can enter a mean: the result is neither infinite nor NaN.
pub fn finite(score: f64) -> f64 {
    if score.is_nan() { -1e30 } else { score.clamp(-1e30, 1e30) }
}

#[cfg(test)]
mod tests {
    use super::{EpisodeResult, Preference, Summary};

    fn ending(score: f64, success: Option<bool>) -> EpisodeResult {
        EpisodeResult { outcome: 0, success, score, final_reward: 0.0, measure: 1.0, actions: 2 }
    }

    #[test]
    fn success_is_undefined_where_no_episode_has_one() {
        assert_eq!(Summary::new(&[ending(1.0, None), ending(3.0, None)]).success, None);
        assert_eq!(Summary::new(&[ending(1.0, Some(true)), ending(3.0, Some(false))]).success, Some(0.5));
        assert!(Summary::new(&[ending(f64::NAN, None)]).score < -1e29);
    }

    #[test]
    fn success_comes_first_only_where_the_problem_says_so() {
        let often = Summary::new(&[ending(1.0, Some(true)), ending(1.0, Some(true))]);
        let high = Summary::new(&[ending(9.0, Some(true)), ending(9.0, Some(false))]);
        assert!(often.compare(&high, Preference::Score).is_lt());
        assert!(often.compare(&high, Preference::Success).is_gt());
    }
}
