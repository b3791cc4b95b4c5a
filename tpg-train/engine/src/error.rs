//! Errors of evaluations.

use std::error::Error;
use std::fmt;

/// An evaluation that failed: a lost machine, an exception in a user's environment.
#[derive(Debug)]
pub struct EvaluationError(Box<dyn Error + Send + Sync>);

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
