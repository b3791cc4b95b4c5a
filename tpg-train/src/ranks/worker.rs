//! The messages between rank 0 and the others, and the side of a rank that evaluates for rank 0. Messages are postcard's
//! bytes; tasks, whose form is the problem's own, are JSON in them, as in checkpoints.

use super::link::Link;
use serde::de::DeserializeOwned;
use serde::{Deserialize, Serialize};
use tpg_engine::{EpisodeResult, EvaluationError, Evaluator, Piece, Play, Played, PolicyGraph, Work, WorkUnit};

/// From rank 0 to a worker.
#[derive(Serialize, Deserialize)]
pub(super) enum Order {
    /// Evaluate pieces of these units on tasks in JSON; `None`: on those of the order before.
    Evaluate { tasks: Option<Vec<u8>>, units: Vec<WorkUnit>, pieces: Vec<Piece> },
    /// Run episodes and record what is seen.
    Play(Vec<PackedPlay>),
    /// Nothing more comes.
    End,
}

/// A [`Play`] whose task is JSON.
#[derive(Serialize, Deserialize)]
pub(super) struct PackedPlay {
    policy: PolicyGraph,
    task: Vec<u8>,
}

impl PackedPlay {
    pub(super) fn new<Task: Serialize>(play: &Play<Task>) -> Result<Self, EvaluationError> {
        Ok(Self { policy: play.policy.clone(), task: pack_tasks(&play.task)? })
    }
}

/// From a worker to rank 0: the first one says that it is ready, then there is one for each order.
#[derive(Serialize, Deserialize)]
pub(super) enum Reply {
    /// The worker is ready; everything that must be equal on all ranks, and its number of threads.
    Ready { identity: String, threads: u64 },
    /// An answer to each job in order; the number of steps since the worker began.
    Done { answers: Vec<Answer>, steps: u64 },
    /// The order, or the start, has failed.
    Failed(String),
}

/// The answer to a job.
#[derive(Serialize, Deserialize)]
pub(super) enum Answer {
    /// The endings of a piece.
    Endings(Vec<EpisodeResult>),
    /// The results of an episode.
    Played(Played),
}

/// Writes tasks.
pub(super) fn pack_tasks<T: Serialize + ?Sized>(tasks: &T) -> Result<Vec<u8>, EvaluationError> {
    serde_json::to_vec(tasks).map_err(EvaluationError::new)
}

/// Writes a message.
pub(super) fn encode(message: &impl Serialize) -> Result<Vec<u8>, EvaluationError> {
    postcard::to_stdvec(message).map_err(EvaluationError::new)
}

/// Reads a message.
pub(super) fn decode<T: DeserializeOwned>(bytes: &[u8]) -> Result<T, EvaluationError> {
    postcard::from_bytes(bytes).map_err(EvaluationError::new)
}

/// Answers to rank 0's orders until there are no more.
pub(super) fn serve<Task: Clone + DeserializeOwned>(
    link: &impl Link,
    ready: &Reply,
    local: &impl Evaluator<Task>,
) -> Result<(), EvaluationError> {
    link.send(0, &encode(ready)?)?;
    // Tasks stay between orders.
    let mut work = Work { tasks: Vec::new(), units: Vec::new() };
    loop {
        let answers = match decode(&link.receive()?.1) {
            Ok(Order::End) => return Ok(()),
            Ok(order) => follow(order, &mut work, local),
            Err(error) => Err(error),
        };
        let reply = match answers {
            Ok(answers) => Reply::Done { answers, steps: local.steps() },
            Err(error) => Reply::Failed(error.into_inner().to_string()),
        };
        link.send(0, &encode(&reply)?)?;
    }
}

fn follow<Task: Clone + DeserializeOwned>(
    order: Order,
    work: &mut Work<Task>,
    local: &impl Evaluator<Task>,
) -> Result<Vec<Answer>, EvaluationError> {
    match order {
        Order::Evaluate { tasks, units, pieces } => {
            if let Some(tasks) = tasks {
                work.tasks = unpack_tasks(&tasks)?;
            }
            work.units = units;
            Ok(local.pieces(work, &pieces)?.into_iter().map(Answer::Endings).collect())
        }
        Order::Play(packed) => {
            let plays = packed
                .into_iter()
                .map(|PackedPlay { policy, task }| Ok(Play { policy, task: unpack_tasks(&task)? }))
                .collect::<Result<Vec<_>, EvaluationError>>()?;
            Ok(local.play(&plays)?.into_iter().map(Answer::Played).collect())
        }
        Order::End => Ok(Vec::new()),
    }
}

/// Reads tasks.
fn unpack_tasks<T: DeserializeOwned>(bytes: &[u8]) -> Result<T, EvaluationError> {
    serde_json::from_slice(bytes).map_err(EvaluationError::new)
}
