//! The messages between rank 0 and the others, and the side of a rank that evaluates for rank 0. Messages are postcard's
//! bytes; tasks, whose form is the problem's own, are JSON in them, as in checkpoints.

use super::link::Link;
use serde::de::DeserializeOwned;
use serde::{Deserialize, Serialize};
use std::ops::Range;
use tpg_engine::{EpisodeResult, EvaluationError, Evaluator, Piece, PolicyGraph, Work};

/// From rank 0 to a worker.
#[derive(Serialize, Deserialize)]
pub(super) enum Order {
    /// Evaluate policies, each on some of the tasks in JSON; `None`: of those of the order before.
    Evaluate { tasks: Option<Vec<u8>>, jobs: Vec<(PolicyGraph, Range<usize>)> },
    /// Nothing more comes.
    End,
}

/// From a worker to rank 0: the first one says that it is ready, then there is one for each order.
#[derive(Serialize, Deserialize)]
pub(super) enum Reply {
    /// The worker is ready; everything that must be equal on all ranks, and its number of threads.
    Ready { identity: String, threads: u64 },
    /// The endings of each job in order.
    Done(Vec<Vec<EpisodeResult>>),
    /// The order, or the start, has failed.
    Failed(String),
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
    local: &dyn Evaluator<Task>,
) -> Result<(), EvaluationError> {
    link.send(0, &encode(ready)?)?;
    // Tasks stay between orders.
    let mut work = Work { tasks: Vec::new(), policies: Vec::new() };
    loop {
        let endings = match decode(&link.receive()?.1) {
            Ok(Order::End) => return Ok(()),
            Ok(Order::Evaluate { tasks, jobs }) => {
                let ranges: Vec<Range<usize>>;
                (work.policies, ranges) = jobs.into_iter().unzip();
                let pieces = (0..).zip(ranges).map(|(policy, tasks)| Piece { policy, tasks }).collect::<Vec<_>>();
                let read = tasks.map_or(Ok(()), |tasks| unpack_tasks(&tasks).map(|tasks| work.tasks = tasks));
                read.and_then(|()| local.pieces(&work, &pieces))
            }
            Err(error) => Err(error),
        };
        let reply = match endings {
            Ok(endings) => Reply::Done(endings),
            Err(error) => Reply::Failed(error.into_inner().to_string()),
        };
        link.send(0, &encode(&reply)?)?;
    }
}

/// Reads tasks.
fn unpack_tasks<T: DeserializeOwned>(bytes: &[u8]) -> Result<T, EvaluationError> {
    serde_json::from_slice(bytes).map_err(EvaluationError::new)
}
