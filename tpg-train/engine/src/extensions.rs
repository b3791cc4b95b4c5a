//! Optional parts of an environment: tasks for training, and a guard.

use crate::action::{Act, Output};
use crate::random::Stream;
use tpg_graph::SourceDocument;

/// The purpose of a list of tasks. No list for one purpose is read for another.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum TaskSet {
    /// To choose between policies within a run: the same for every run.
    Validation,
    /// To choose the settings of a hybrid, or to compare a network with itself in integers.
    Study,
    /// To calibrate the integers of a network: drawn as tasks of training are.
    Calibration,
    /// To test.
    Test,
}

/// Tasks beyond those that are drawn: see [`Environment::training`](crate::Environment::training).
pub trait Training<Task>: Sync {
    /// Returns the same task in coarser steps, `factor` times as large.
    ///
    /// A curriculum begins with coarse steps, which shorten episodes by about that factor.
    fn coarser(&self, task: Task, _factor: u8) -> Task {
        task
    }

    /// Returns the tasks of a set; `None` if they are drawn as those of training.
    fn tasks(&self, _set: TaskSet, _seed: u64, _count: usize) -> Option<Vec<Task>> {
        None
    }

    /// Returns linear policies with which evolution begins, where it does not begin with a search for weights: for each action the
    /// weights of its bid, one for each value of the flat state, and a constant. None by default.
    fn linear(&self) -> Vec<Vec<Vec<f64>>> {
        Vec::new()
    }

    /// Returns fresh tasks that show where a policy under training fails, under the rules of tests; `None` if they are drawn.
    fn evaluation_tasks(&self, _stream: &mut Stream, _count: usize) -> Option<Vec<Task>> {
        None
    }
}

/// An environment whose graphs and networks see and do different things, and which can refuse an action before it is
/// taken: see [`Environment::guarded`](crate::Environment::guarded).
pub trait Guarded<S, Episode>: Sync {
    /// Returns the sources of networks.
    fn network_sources(&self) -> Vec<SourceDocument>;

    /// Returns the outputs of networks; [`Environment::step`](crate::Environment::step) takes their values beside the named actions of graphs.
    fn network_outputs(&self) -> Vec<Output>;

    /// Writes the flat state of networks.
    fn network_observe(&self, episode: &mut Episode, state: &mut [f32]);

    /// Returns the names of the guards; the first one lets everything pass that can be taken.
    fn guards(&self) -> &'static [&'static str];

    /// Returns true if a graph's action must not be taken: the network takes over.
    fn refuses(&self, guard: &str, episode: &Episode, act: Act<'_, S>) -> bool;

    /// Changes a network's values into what may be executed; returns false, and values that do nothing, if nothing of them may.
    fn mend(&self, guard: &str, episode: &Episode, values: &mut [S]) -> bool;
}
