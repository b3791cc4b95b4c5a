//! Work for evaluators, and its results: plain data, for threads, processes and other machines.

use crate::episode_result::EpisodeResult;
use crate::moments::Moments;
use crate::policy::PolicyGraph;
use serde::{Deserialize, Serialize};
use std::ops::Range;

/// The identity of a unit of work.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash, Serialize, Deserialize)]
pub struct UnitKey {
    /// Seed of the run.
    pub seed: u64,
    /// Generation.
    pub generation: u64,
    /// Number of the root, unique in its run.
    pub root: u64,
}

/// A root to evaluate, with everything that its evaluation needs.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct WorkUnit {
    /// Identity of the requested evaluation.
    pub key: UnitKey,
    /// Policy to evaluate.
    pub policy: PolicyGraph,
}

/// Units that are evaluated on the same tasks.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Work<Task> {
    /// The tasks, the same for every unit.
    pub tasks: Vec<Task>,
    /// The units.
    pub units: Vec<WorkUnit>,
}

/// A root on some of the tasks: the smallest piece of work that can be done elsewhere.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, Deserialize)]
pub struct Piece {
    /// Index of the unit.
    pub unit: usize,
    /// Indices of the tasks.
    pub tasks: Range<usize>,
}

impl Piece {
    /// Cuts each unit's tasks into at most `parts` pieces of nearly equal length, none empty; unit by unit, in the order
    /// of the tasks. Without tasks each unit is one piece.
    ///
    /// ```
    /// use tpg_engine::Piece;
    ///
    /// let pieces = Piece::cut(1, 5, 2);
    /// assert_eq!(pieces, [Piece { unit: 0, tasks: 0..3 }, Piece { unit: 0, tasks: 3..5 }]);
    /// ```
    pub fn cut(units: usize, tasks: usize, parts: usize) -> Vec<Self> {
        let length = tasks.div_ceil(parts.max(1)).max(1);
        let starts = || (0..tasks.max(1)).step_by(length);
        let piece = |unit, from: usize| Self { unit, tasks: from..tasks.min(from + length) };
        (0..units).flat_map(|unit| starts().map(move |from| piece(unit, from))).collect()
    }
}

/// Result of a root.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct UnitResult {
    /// Identity of the unit.
    pub key: UnitKey,
    /// One ending for each task, in order.
    pub endings: Vec<EpisodeResult>,
}

/// States to record: those that a policy sees after given numbers of actions on a task.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Visit<Task> {
    /// The policy that acts.
    pub policy: PolicyGraph,
    /// The task.
    pub task: Task,
    /// Numbers of actions after which the state is recorded, ascending; each below the number of actions of the
    /// episode.
    pub after: Vec<u32>,
}

/// An episode of a policy.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Play<Task> {
    /// The policy that acts.
    pub policy: PolicyGraph,
    /// The task.
    pub task: Task,
}

/// Result of an episode, with what the policy saw.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Played {
    /// The end.
    pub ending: EpisodeResult,
    /// Mean and spread of the flat states in which the policy decided.
    pub seen: Moments,
}
