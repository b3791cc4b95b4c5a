//! Parallel episodes: the interface between lanes and an environment.

use crate::action::Acts;
use crate::episode_result::EpisodeResult;
use crate::error::EvaluationError;
use crate::source_set::SourceSet;
use crate::view::View;

/// Parallel episodes of an environment, one in each lane.
///
/// Created by [`Environment::lanes`](crate::Environment::lanes). By default each lane has an episode of its own, and
/// they are stepped one after another; an environment for which that is too slow can step all lanes at once, with the
/// same results. Policies in lanes choose among named actions.
///
/// # Errors
/// Episodes that run elsewhere, for example in another language, can fail: the error ends the evaluation and is
/// returned unchanged.
pub trait Episodes<S, Task> {
    /// Starts an episode in an existing lane, or in the next new one.
    fn begin(&mut self, lane: usize, task: &Task) -> Result<(), EvaluationError>;

    /// Takes one action in each lane; appends the lanes whose episode ended, in ascending order.
    fn step(&mut self, acts: Acts<'_, S>, ended: &mut Vec<(usize, EpisodeResult)>) -> Result<(), EvaluationError>;

    /// Returns [`Environment::key`](crate::Environment::key) of each lane; empty, the default, if the problem has none.
    fn keys(&self) -> &[u64] {
        &[]
    }

    /// Returns [`Environment::cycle`](crate::Environment::cycle) of a lane.
    fn cycle(&self, _lane: usize, _key: u64, _actions: u32) -> Option<EpisodeResult> {
        None
    }

    /// Writes the observation of each lane's policy.
    fn observe(&mut self, wanted: SourceSet, view: &mut View<'_, S>) -> Result<(), EvaluationError>;

    /// Moves the last lane's episode to `lane`, whose own episode is over.
    fn close_up(&mut self, lane: usize);
}
