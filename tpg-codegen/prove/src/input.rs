//! Faults of input: what is not a graph, not C of the subset, or not an object.

use std::path::PathBuf;

/// A fault of a file.
#[derive(Clone, Debug, PartialEq, Eq, thiserror::Error)]
#[error("{file}: {place}: found {found}, expected {accepted}")]
pub struct InputError {
    /// The file
    pub file: String,
    /// A place in it
    pub place: String,
    /// What was found there
    pub found: String,
    /// What is accepted
    pub accepted: String,
}

/// A failure of a command.
#[derive(Debug, thiserror::Error)]
pub enum Error {
    /// Bad input
    #[error(transparent)]
    Input(#[from] InputError),
    /// A file that cannot be read or written
    #[error("{}: {error}", path.display())]
    File {
        /// The file
        path: PathBuf,
        /// The reason
        error: std::io::Error,
    },
}
