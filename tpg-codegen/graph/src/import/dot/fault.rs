//! Errors on lines.

use crate::error::{InputError, Place};

/// An error on one line.
#[derive(Debug)]
pub(super) struct Fault {
    pub(super) found: String,
    pub(super) accepted: String,
}

impl Fault {
    pub(super) fn new(found: impl Into<String>, accepted: impl Into<String>) -> Self {
        Self { found: found.into(), accepted: accepted.into() }
    }

    pub(super) fn on(self, file: &str, line: usize) -> InputError {
        InputError::new(file, Place::Line(line), self.found, self.accepted)
    }
}

/// Returns an error on a line that is named later.
pub(super) fn refuse<T>(found: impl Into<String>, accepted: impl Into<String>) -> Result<T, Fault> {
    Err(Fault::new(found, accepted))
}
