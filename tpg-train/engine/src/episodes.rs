//! Episodes side by side: what the lanes need of an environment, all at once.

use crate::ending::Ending;
use crate::evaluator::EvaluationError;
use crate::source_set::SourceSet;
use crate::view::View;
use tpg_runtime::policy::ActionId;

/// Some episodes of an environment, one in each lane.
///
/// [`Environment::lanes`](crate::Environment::lanes) makes them. By default each lane has an episode of its own and they
/// take turns; an environment for which that is too slow can do all lanes at once instead, with the same answers. Policies
/// of lanes choose among named actions.
///
/// # Errors
/// Episodes that run elsewhere, in another language say, can fail: the error ends the evaluation and arrives as itself.
pub trait Episodes<S, Task> {
    /// Starts an episode: in a lane that there is already, or in the next one.
    fn begin(&mut self, lane: usize, task: &Task) -> Result<(), EvaluationError>;

    /// Does one action in each lane; adds the lanes whose episode it ended, ascending.
    fn step(&mut self, actions: &[ActionId], ended: &mut Vec<(usize, Ending)>) -> Result<(), EvaluationError>;

    /// [`Environment::key`](crate::Environment::key) of each lane; empty where the problem has none.
    fn keys(&self) -> &[u64];

    /// [`Environment::cycle`](crate::Environment::cycle) in a lane.
    fn cycle(&self, lane: usize, key: u64, actions: u32) -> Option<Ending>;

    /// Writes what each lane's policy sees.
    fn observe(&mut self, wanted: SourceSet, view: &mut View<'_, S>) -> Result<(), EvaluationError>;

    /// The last lane's episode moves to `lane`, whose own is over.
    fn close_up(&mut self, lane: usize);
}
