//! The messages between rank 0 and the others: postcard's bytes. Tasks, whose form is the problem's own, are JSON in them, as
//! in checkpoints.

use serde::de::DeserializeOwned;
use serde::{Deserialize, Serialize};
use tpg_engine::{Ending, EvaluationError, Piece, Play, Played, PolicyGraph, Visit, WorkUnit};

/// From rank 0 to a worker.
#[derive(Serialize, Deserialize)]
pub(super) enum Order {
    /// Evaluate pieces of these units on tasks in JSON; `None`: on those of the order before.
    Evaluate { tasks: Option<Vec<u8>>, units: Vec<WorkUnit>, pieces: Vec<Piece> },
    /// Record states.
    Visit(Vec<PackedVisit>),
    /// Run episodes and record what is seen.
    Play(Vec<PackedPlay>),
    /// Compute the cells with these numbers.
    Cells(Vec<u64>),
    /// Nothing more comes.
    End,
}

/// A [`Visit`] whose task is JSON.
#[derive(Serialize, Deserialize)]
pub(super) struct PackedVisit {
    policy: PolicyGraph,
    task: Vec<u8>,
    after: Vec<u32>,
}

impl PackedVisit {
    pub(super) fn of<Task: Serialize>(visit: &Visit<Task>) -> Result<Self, EvaluationError> {
        let Visit { policy, task, after } = visit;
        Ok(Self { policy: policy.clone(), task: pack_tasks(task)?, after: after.clone() })
    }

    pub(super) fn unpack<Task: DeserializeOwned>(self) -> Result<Visit<Task>, EvaluationError> {
        let Self { policy, task, after } = self;
        Ok(Visit { policy, task: unpack_tasks(&task)?, after })
    }
}

/// A [`Play`] whose task is JSON.
#[derive(Serialize, Deserialize)]
pub(super) struct PackedPlay {
    policy: PolicyGraph,
    task: Vec<u8>,
}

impl PackedPlay {
    pub(super) fn of<Task: Serialize>(play: &Play<Task>) -> Result<Self, EvaluationError> {
        let Play { policy, task } = play;
        Ok(Self { policy: policy.clone(), task: pack_tasks(task)? })
    }

    pub(super) fn unpack<Task: DeserializeOwned>(self) -> Result<Play<Task>, EvaluationError> {
        let Self { policy, task } = self;
        Ok(Play { policy, task: unpack_tasks(&task)? })
    }
}

/// From a worker to rank 0: the first one says that it is ready, then there is one for each order.
#[derive(Serialize, Deserialize)]
pub(super) enum Reply {
    /// The worker is ready; everything that must be equal on all ranks, and its number of threads.
    Ready { identity: String, threads: u64 },
    /// Endings of each piece in order; the number of steps since the worker began.
    Evaluated { endings: Vec<Vec<Ending>>, steps: u64 },
    /// States of each visit in order.
    Visited(Vec<Vec<Vec<f64>>>),
    /// Results of each episode in order; the number of steps since the worker began.
    Played { played: Vec<Played>, steps: u64 },
    /// Bytes of each cell in order.
    Cells(Vec<Vec<u8>>),
    /// The order, or the start, has failed.
    Failed(String),
}

/// Writes tasks.
pub(super) fn pack_tasks<T: Serialize + ?Sized>(tasks: &T) -> Result<Vec<u8>, EvaluationError> {
    serde_json::to_vec(tasks).map_err(EvaluationError::new)
}

/// Reads tasks.
pub(super) fn unpack_tasks<T: DeserializeOwned>(bytes: &[u8]) -> Result<T, EvaluationError> {
    serde_json::from_slice(bytes).map_err(EvaluationError::new)
}

/// Writes a message.
pub(super) fn encode(message: &impl Serialize) -> Result<Vec<u8>, EvaluationError> {
    postcard::to_stdvec(message).map_err(EvaluationError::new)
}

/// Reads a message.
pub(super) fn decode<T: DeserializeOwned>(bytes: &[u8]) -> Result<T, EvaluationError> {
    postcard::from_bytes(bytes).map_err(EvaluationError::new)
}
