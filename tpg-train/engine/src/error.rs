//! Errors of evaluations.

use std::error::Error;

/// An evaluation that failed: a lost machine, an exception in a user's environment.
#[derive(Debug, thiserror::Error)]
#[error("the episodes could not be run: {0}")]
pub struct EvaluationError(#[source] Box<dyn Error + Send + Sync>);

impl EvaluationError {
    /// Wraps an error or a message.
    pub fn new(error: impl Into<Box<dyn Error + Send + Sync>>) -> Self {
        Self(error.into())
    }

    /// Returns the wrapped error, so that its origin can handle it.
    pub fn into_inner(self) -> Box<dyn Error + Send + Sync> {
        self.0
    }
}
