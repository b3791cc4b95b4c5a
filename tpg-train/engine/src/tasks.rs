//! Tasks for every purpose.

use crate::environment::Environment;
use crate::extensions::TaskSet;
use crate::random::{Purpose, Stream};
use tpg_runtime::scalar::Scalar;

/// Returns `count` tasks of a set: the environment's own list, or drawn ones. Validation tasks have the seed 0.
pub fn tasks<S: Scalar, E: Environment<S> + ?Sized>(
    environment: &E,
    set: TaskSet,
    seed: u64,
    count: usize,
) -> Vec<E::Task> {
    if let Some(tasks) = environment.training().and_then(|training| training.tasks(set, seed, count)) {
        return tasks;
    }
    let stream = |index| match set {
        TaskSet::Validation => Stream::new(0, 0, Purpose::Selection, index),
        TaskSet::Study => Stream::new(seed, 0, Purpose::Selection, index),
        TaskSet::Calibration => Stream::new(seed, index, Purpose::Reset, 0),
        TaskSet::Test => Stream::new(seed, 0, Purpose::Evaluation, index),
    };
    (0..count as u64).map(|index| environment.draw(&mut stream(index))).collect()
}

/// Returns the same task in coarser steps, `factor` times as large, where the environment has them.
pub fn coarser<S: Scalar, E: Environment<S> + ?Sized>(environment: &E, task: E::Task, factor: u8) -> E::Task {
    match environment.training() {
        Some(training) => training.coarser(task, factor),
        None => task,
    }
}
