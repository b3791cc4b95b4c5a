//! Work for evaluators, and its results: plain data, for threads, processes and other machines.

use crate::episode_result::EpisodeResult;
use crate::moments::Moments;
use crate::policy::PolicyGraph;
use serde::{Deserialize, Serialize};
use std::ops::Range;

/// Policies that are evaluated on the same tasks.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Work<Task> {
    /// The tasks, the same for every policy.
    pub tasks: Vec<Task>,
    /// The policies.
    pub policies: Vec<PolicyGraph>,
}

/// A policy on some of the tasks: the smallest piece of work that can be done elsewhere.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, Deserialize)]
pub struct Piece {
    /// Index of the policy.
    pub policy: usize,
    /// Indices of the tasks.
    pub tasks: Range<usize>,
}

impl Piece {
    /// Cuts each policy's tasks into at most `parts` pieces of nearly equal length, none empty; policy by policy, in the order
    /// of the tasks. Without tasks each policy is one piece.
    ///
    /// ```
    /// use tpg_engine::Piece;
    ///
    /// let pieces = Piece::cut(1, 5, 2);
    /// assert_eq!(pieces, [Piece { policy: 0, tasks: 0..3 }, Piece { policy: 0, tasks: 3..5 }]);
    /// ```
    pub fn cut(policies: usize, tasks: usize, parts: usize) -> Vec<Self> {
        let length = tasks.div_ceil(parts.max(1)).max(1);
        let starts = || (0..tasks.max(1)).step_by(length);
        let piece = |policy, from: usize| Self { policy, tasks: from..tasks.min(from + length) };
        (0..policies).flat_map(|policy| starts().map(move |from| piece(policy, from))).collect()
    }
}

/// An episode of a policy.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Play<Task> {
    /// The policy that acts.
    pub policy: PolicyGraph,
    /// The task.
    pub task: Task,
    /// Numbers of actions after which the state is recorded, ascending; each below the number of actions of the
    /// episode.
    pub after: Vec<u32>,
}

/// Result of an episode, with what the policy saw.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Played {
    /// The end.
    pub ending: EpisodeResult,
    /// Mean and spread of the flat states in which the policy decided.
    pub seen: Moments,
    /// The recorded states.
    pub states: Vec<Vec<f64>>,
}
