//! Evaluation of roots behind a trait, so that evolution does not depend on where it runs.

use crate::environment::Environment;
use crate::episode_result::EpisodeResult;
use crate::error::EvaluationError;
use crate::groups::side_by_side;
use crate::lanes::{DEFAULT_LANES, Lanes};
use crate::plan::Plan;
use crate::policy::PolicyGraph;
use crate::work::{Piece, Play, Played, Work};
use rayon::prelude::*;
use std::marker::PhantomData;
use tpg_graph::SourceDocument;
use tpg_runtime::ops::Maths;
use tpg_runtime::scalar::Scalar;

/// A place where roots are evaluated.
///
/// An answer depends only on its policy and the tasks. Evolution calls once per generation and waits for the result.
pub trait Evaluator<Task> {
    /// Returns the endings of each policy, one for each task.
    ///
    /// # Errors
    /// If an answer cannot be obtained.
    fn evaluate(&self, work: &Work<Task>) -> Result<Vec<Vec<EpisodeResult>>, EvaluationError>;

    /// Returns the endings of each piece, one for each of its tasks: those that [`evaluate`](Self::evaluate) returns for
    /// the policy on these tasks. By default one piece after another.
    ///
    /// # Errors
    /// If an answer cannot be obtained.
    fn pieces(&self, work: &Work<Task>, pieces: &[Piece]) -> Result<Vec<Vec<EpisodeResult>>, EvaluationError>
    where
        Task: Clone,
    {
        let one = |Piece { policy, tasks }: &Piece| {
            let (tasks, policies) = (work.tasks[tasks.clone()].to_vec(), vec![work.policies[*policy].clone()]);
            Ok(self.evaluate(&Work { tasks, policies })?.concat())
        };
        pieces.iter().map(one).collect()
    }

    /// Returns the result of each episode, with what the policy saw.
    ///
    /// # Errors
    /// If an answer cannot be obtained.
    fn play(&self, plays: &[Play<Task>]) -> Result<Vec<Played>, EvaluationError>;
}

/// Evaluation on the threads of this machine.
///
/// ```
/// use tpg_engine::{Destination, Edge, Environment, Evaluator, LocalThreads, PolicyGraph, Work};
/// use tpg_runtime::ops::Own;
/// # use tpg_engine::random::Stream;
/// # use tpg_engine::{Act, ActionSpace, SourceSet, Step};
/// # use tpg_graph::SourceDocument;
/// # struct Counter;
/// # impl Environment<f32> for Counter {
/// #     type Task = f32;
/// #     type Episode = f32;
/// #     fn sources(&self) -> Vec<SourceDocument> {
/// #         vec![SourceDocument::new("count", "1", vec![[0.0, 9.0]])]
/// #     }
/// #     fn actions(&self) -> ActionSpace { ActionSpace::discrete(["down", "up"]) }
/// #     fn time_limit(&self) -> u32 { 5 }
/// #     fn draw(&self, _: &mut Stream) -> f32 { 0.0 }
/// #     fn start(&self, task: &f32) -> f32 { *task }
/// #     fn observe(&self, count: &mut f32, _: SourceSet, state: &mut [f32]) { state[0] = *count; }
/// #     fn step(&self, count: &mut f32, act: Act<'_, f32>) -> Step {
/// #         let change = if act.choice() == 1 { 1.0 } else { -1.0 };
/// #         *count += change;
/// #         Step::reward(f64::from(change))
/// #     }
/// # }
///
/// // `Counter` has the actions `down` and `up`, which earn −1 and 1, and a limit of 5 actions.
/// // Root n always takes action n.
/// let policy = |action| {
///     PolicyGraph::new(1, 0, vec![vec![Edge { program: 0, to: Destination::Action(action) }]], vec![vec![]])
/// };
/// let work = Work { tasks: vec![0.0, 3.0], policies: vec![policy(0), policy(1)] };
/// let evaluator = LocalThreads::<f32, Own, _>::new(&Counter, 2)?;
/// let answers = evaluator.evaluate(&work)?;
/// assert_eq!(answers.iter().map(|endings| endings[0].score).collect::<Vec<_>>(), [-5.0, 5.0]);
/// # Ok::<(), tpg_engine::EvaluationError>(())
/// ```
#[derive(Debug)]
pub struct LocalThreads<'e, S, M, E> {
    environment: &'e E,
    sources: Vec<SourceDocument>,
    pool: rayon::ThreadPool,
    number: PhantomData<(S, M)>,
}

impl<'e, S: Scalar, M: Maths<S>, E: Environment<S>> LocalThreads<'e, S, M, E> {
    /// Starts `threads` threads; 0 means as many as the machine has.
    ///
    /// # Errors
    /// If the threads cannot be started.
    pub fn new(environment: &'e E, threads: usize) -> Result<Self, EvaluationError> {
        let pool = (rayon::ThreadPoolBuilder::new().num_threads(threads).build()).map_err(EvaluationError::new)?;
        let sources = environment.sources();
        Ok(Self { environment, sources, pool, number: PhantomData })
    }

    /// Returns the number of threads.
    pub fn threads(&self) -> usize {
        self.pool.current_num_threads()
    }
}

impl<S: Scalar, M: Maths<S>, E: Environment<S>> Evaluator<E::Task> for LocalThreads<'_, S, M, E> {
    fn evaluate(&self, work: &Work<E::Task>) -> Result<Vec<Vec<EpisodeResult>>, EvaluationError> {
        self.pieces(work, &Piece::cut(work.policies.len(), work.tasks.len(), 1))
    }

    fn pieces(&self, work: &Work<E::Task>, pieces: &[Piece]) -> Result<Vec<Vec<EpisodeResult>>, EvaluationError> {
        let evaluate = |lanes: &mut Lanes<'_, S, M, E>, group: &[Piece]| {
            let policies: Vec<&PolicyGraph> = group.iter().map(|piece| &work.policies[piece.policy]).collect();
            let tasks: Vec<&[E::Task]> = group.iter().map(|piece| &work.tasks[piece.tasks.clone()]).collect();
            let plan = Plan::of_roots::<M>(&policies, &self.sources);
            lanes.run_roots(&plan, &tasks)
        };
        let groups = side_by_side(work, pieces, DEFAULT_LANES, self.threads());
        let endings: Result<Vec<Vec<Vec<EpisodeResult>>>, _> = self.pool.install(|| {
            groups.into_par_iter().map_init(|| Lanes::new(self.environment, DEFAULT_LANES), evaluate).collect()
        });
        Ok(endings?.into_iter().flatten().collect())
    }

    fn play(&self, plays: &[Play<E::Task>]) -> Result<Vec<Played>, EvaluationError> {
        let play = |lanes: &mut Lanes<'_, S, M, E>, play: &Play<E::Task>| {
            let plan = Plan::observing_all::<M>(&play.policy, &self.sources);
            lanes.play(&plan, play)
        };
        self.pool.install(|| plays.par_iter().map_init(|| Lanes::new(self.environment, 1), play).collect())
    }
}
