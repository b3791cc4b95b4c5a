//! Messages between ranks by MPI.

use mpi::topology::SimpleCommunicator;
use mpi::traits::{Communicator, Destination, MatchedReceiveVec, Source};
use tpg_engine::EvaluationError;
use tpg_train::Link;

/// The link of an MPI job. Only the thread that initialised MPI may use it.
pub(crate) struct World(pub(crate) SimpleCommunicator);

impl Link for World {
    fn rank(&self) -> usize {
        self.0.rank() as usize
    }

    fn ranks(&self) -> usize {
        self.0.size() as usize
    }

    fn send(&self, to: usize, message: &[u8]) -> Result<(), EvaluationError> {
        if i32::try_from(message.len()).is_err() {
            let text = format!("a message of {} bytes to rank {to}; MPI sends less than 2 GiB at once", message.len());
            return Err(EvaluationError::new(text));
        }
        self.0.process_at_rank(to as i32).send(message);
        Ok(())
    }

    fn poll(&self) -> Result<Option<(usize, Vec<u8>)>, EvaluationError> {
        let Some(probed) = self.0.any_process().immediate_matched_probe() else { return Ok(None) };
        let (bytes, status) = probed.matched_receive_vec();
        Ok(Some((status.source_rank() as usize, bytes)))
    }
}
