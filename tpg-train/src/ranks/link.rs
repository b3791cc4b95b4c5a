//! Messages between ranks.

use std::time::Duration;
use tpg_engine::EvaluationError;

/// Number of looks for a message without sleep between them.
const AWAKE: u64 = 200;
/// Time between two later looks.
const ASLEEP: Duration = Duration::from_micros(50);

/// A rank's connection to the others. Messages between two ranks arrive in the order in which they were sent.
pub trait Link {
    /// Returns the number of this rank, from 0.
    fn rank(&self) -> usize;

    /// Returns the number of ranks.
    fn ranks(&self) -> usize;

    /// Sends a message; may wait until the receiver takes it.
    ///
    /// # Errors
    /// If the rank cannot be reached.
    fn send(&self, to: usize, message: &[u8]) -> Result<(), EvaluationError>;

    /// Returns the next message and its sender; `None` if there is none yet.
    ///
    /// # Errors
    /// If a rank is lost.
    fn poll(&self) -> Result<Option<(usize, Vec<u8>)>, EvaluationError>;

    /// Waits for the next message.
    ///
    /// # Errors
    /// If a rank is lost.
    fn receive(&self) -> Result<(usize, Vec<u8>), EvaluationError> {
        let mut looks = 0;
        loop {
            if let Some(message) = self.poll()? {
                return Ok(message);
            }
            // Awake at first, then asleep, so that a waiting rank leaves its core to others.
            if looks < AWAKE {
                std::thread::yield_now()
            } else {
                std::thread::sleep(ASLEEP)
            }
            looks += 1;
        }
    }
}
