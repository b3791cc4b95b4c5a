//! Where roots are evaluated: behind a trait, so that evolution never knows.

use crate::action::Act;
use crate::ending::Ending;
use crate::environment::Environment;
use crate::lanes::Lanes;
use crate::options::Options;
use crate::plan::Plan;
use crate::policy::Policy;
use crate::source_set::SourceSet;
use rayon::prelude::*;
use serde::{Deserialize, Serialize};
use std::error::Error;
use std::fmt;
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

/// A state to look at: the one that a policy sees after some of its actions on a task.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Visit<Task> {
    /// The policy that acts.
    pub policy: Policy,
    /// The task.
    pub task: Task,
    /// The numbers of actions after which the state is recorded, ascending; each below the number of actions of the
    /// episode.
    pub after: Vec<u32>,
}

/// An evaluation that could not be done: a lost machine, an exception in a user's environment.
#[derive(Debug)]
pub struct EvaluationError(Box<dyn Error + Send + Sync>);

impl EvaluationError {
    /// Wraps an error or a message.
    pub fn new(error: impl Into<Box<dyn Error + Send + Sync>>) -> Self {
        Self(error.into())
    }

    /// The error itself, so that whoever raised it can have it back.
    pub fn into_inner(self) -> Box<dyn Error + Send + Sync> {
        self.0
    }
}

impl fmt::Display for EvaluationError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "the episodes could not be run: {}", self.0)
    }
}

impl Error for EvaluationError {
    fn source(&self) -> Option<&(dyn Error + 'static)> {
        Some(&*self.0)
    }
}

/// Where roots are evaluated.
///
/// An answer depends on its unit and the tasks alone. Evolution asks once a generation and waits.
pub trait Evaluator<Task> {
    /// One answer for each unit, in the order of the units.
    ///
    /// # Errors
    /// If an answer cannot be had.
    fn evaluate(&self, work: &Work<Task>) -> Result<Vec<Answer>, EvaluationError>;

    /// The flat states of each visit, one for each of its numbers of actions.
    ///
    /// # Errors
    /// If a state cannot be had.
    fn visit(&self, visits: &[Visit<Task>]) -> Result<Vec<Vec<Vec<f64>>>, EvaluationError>;

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
            .map_err(|error| EvaluationError::new(error))?;
        let sources = environment.sources();
        Ok(Self { environment, sources, options, pool, steps: AtomicU64::new(0), number: PhantomData })
    }
}

impl<S: Scalar, M: Maths<S>, E: Environment<S>> LocalThreads<'_, S, M, E> {
    /// The states of one visit: the episode runs again up to each of them.
    fn states(&self, visit: &Visit<E::Task>) -> Result<Vec<Vec<f64>>, EvaluationError> {
        let options = Options { lanes: 1, ..self.options };
        let plan = Plan::new::<M>(&visit.policy, &self.sources, options);
        let mut actions = Vec::new();
        let mut lanes = Lanes::<S, M, E>::new(self.environment, options);
        lanes.run_watched(&plan, std::slice::from_ref(&visit.task), |_, action| actions.push(action))?;
        let mut episode = self.environment.start(&visit.task);
        let mut done = 0;
        let state = |&after: &u32| {
            for &action in &actions[done..(after as usize).min(actions.len())] {
                self.environment.step(&mut episode, Act::Choice(action));
                done += 1;
            }
            let mut state = vec![S::ZERO; plan.state_length()];
            self.environment.observe(&mut episode, SourceSet::ALL, &mut state);
            state.into_iter().map(S::to_f64).collect()
        };
        Ok(visit.after.iter().map(state).collect())
    }
}

impl<S: Scalar, M: Maths<S>, E: Environment<S>> Evaluator<E::Task> for LocalThreads<'_, S, M, E> {
    fn evaluate(&self, work: &Work<E::Task>) -> Result<Vec<Answer>, EvaluationError> {
        let evaluate = |lanes: &mut Lanes<'_, S, M, E>, unit: &WorkUnit| {
            let before = lanes.steps();
            let plan = Plan::new::<M>(&unit.policy, &self.sources, self.options);
            let endings = lanes.run(&plan, &work.tasks)?;
            self.steps.fetch_add(lanes.steps() - before, Ordering::Relaxed);
            Ok(Answer { key: unit.key, endings })
        };
        self.pool.install(|| {
            (work.units.par_iter()).map_init(|| Lanes::new(self.environment, self.options), evaluate).collect()
        })
    }

    fn visit(&self, visits: &[Visit<E::Task>]) -> Result<Vec<Vec<Vec<f64>>>, EvaluationError> {
        self.pool.install(|| visits.par_iter().map(|visit| self.states(visit)).collect())
    }

    fn steps(&self) -> u64 {
        self.steps.load(Ordering::Relaxed)
    }
}
