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
    /// Evaluate policies, each on some of the tasks in JSON.
    Evaluate { tasks: Vec<u8>, jobs: Vec<(PolicyGraph, Range<usize>)> },
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
    link: &dyn Link,
    ready: &Reply,
    local: &dyn Evaluator<Task>,
) -> Result<(), EvaluationError> {
    link.send(0, &encode(ready)?)?;
    loop {
        let endings = match decode(&link.receive()?.1) {
            Ok(Order::End) => return Ok(()),
            Ok(Order::Evaluate { tasks, jobs }) => {
                let (policies, ranges): (Vec<PolicyGraph>, Vec<Range<usize>>) = jobs.into_iter().unzip();
                let pieces = (0..).zip(ranges).map(|(policy, tasks)| Piece { policy, tasks }).collect::<Vec<_>>();
                let tasks = serde_json::from_slice(&tasks).map_err(EvaluationError::new);
                tasks.and_then(|tasks| local.pieces(&Work { tasks, policies }, &pieces))
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
