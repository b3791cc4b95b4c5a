//! Where roots are evaluated: behind a trait, so that evolution never knows.

use crate::environment::{Ending, Environment};
use crate::lanes::{Lanes, Options};
use crate::plan::Plan;
use crate::policy::Policy;
use rayon::prelude::*;
use serde::{Deserialize, Serialize};
use std::marker::PhantomData;
use std::sync::atomic::{AtomicU64, Ordering};
use tpg_graph::SourceDocument;
use tpg_runtime::ops::Maths;
use tpg_runtime::scalar::Scalar;

/// The address of a unit of work.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash, Serialize, Deserialize)]
pub struct UnitKey {
    /// The run's seed.
    pub seed: u64,
    /// The generation.
    pub generation: u64,
    /// The root's number, unique in its run.
    pub root: u64,
}

/// One root to be evaluated: everything about it that the evaluation needs.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct WorkUnit {
    /// Who asks.
    pub key: UnitKey,
    /// What is evaluated.
    pub policy: Policy,
}

/// Units that are evaluated on the same tasks.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Work<Task> {
    /// The tasks, the same for every unit.
    pub tasks: Vec<Task>,
    /// The units.
    pub units: Vec<WorkUnit>,
}

/// How a root did.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Answer {
    /// The unit's address.
    pub key: UnitKey,
    /// One ending for each task, in order.
    pub endings: Vec<Ending>,
}

/// An evaluation that could not be done (a lost machine, say). Local threads have none.
#[derive(Debug, thiserror::Error)]
#[error("the roots could not be evaluated: {0}")]
pub struct EvaluationError(pub String);

/// Where roots are evaluated.
///
/// An answer depends on its unit and the tasks alone. Evolution asks once a generation and waits.
pub trait Evaluator<Task> {
    /// One answer for each unit, in the order of the units.
    ///
    /// # Errors
    /// If an answer cannot be had.
    fn evaluate(&self, work: &Work<Task>) -> Result<Vec<Answer>, EvaluationError>;

    /// Environment steps done so far, for the log's steps per second; 0 where nobody counts.
    fn steps(&self) -> u64 {
        0
    }
}

/// The threads of this machine.
#[derive(Debug)]
pub struct LocalThreads<'e, S, M, E> {
    environment: &'e E,
    sources: Vec<SourceDocument>,
    options: Options,
    pool: rayon::ThreadPool,
    steps: AtomicU64,
    number: PhantomData<(S, M)>,
}

impl<'e, S: Scalar, M: Maths<S>, E: Environment<S>> LocalThreads<'e, S, M, E> {
    /// `threads` threads; 0 for as many as the machine has.
    ///
    /// # Errors
    /// If the threads cannot be started.
    pub fn new(environment: &'e E, options: Options, threads: usize) -> Result<Self, EvaluationError> {
        let pool = (rayon::ThreadPoolBuilder::new().num_threads(threads).build())
            .map_err(|error| EvaluationError(error.to_string()))?;
        let sources = environment.sources();
        Ok(Self { environment, sources, options, pool, steps: AtomicU64::new(0), number: PhantomData })
    }
}

impl<S: Scalar, M: Maths<S>, E: Environment<S>> Evaluator<E::Task> for LocalThreads<'_, S, M, E> {
    fn evaluate(&self, work: &Work<E::Task>) -> Result<Vec<Answer>, EvaluationError> {
        let evaluate = |lanes: &mut Lanes<'_, S, M, E>, unit: &WorkUnit| {
            let before = lanes.steps();
            let plan = Plan::new::<M>(&unit.policy, &self.sources, self.options);
            let endings = lanes.run(&plan, &work.tasks);
            self.steps.fetch_add(lanes.steps() - before, Ordering::Relaxed);
            Answer { key: unit.key, endings }
        };
        Ok(self.pool.install(|| {
            (work.units.par_iter()).map_init(|| Lanes::new(self.environment, self.options), evaluate).collect()
        }))
    }

    fn steps(&self) -> u64 {
        self.steps.load(Ordering::Relaxed)
    }
}
