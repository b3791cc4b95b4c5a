//! Faults of input, and what a proof lacks.

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

/// Something that a proof lacks: a construct that is not read, or a fact that no rule gives. Nothing is claimed then.
#[derive(Clone, Debug, PartialEq, Eq, thiserror::Error)]
#[error("{place}: {what}")]
pub struct Missing {
    /// A line of the source, an address, or a team
    pub place: String,
    /// What is missing
    pub what: String,
}

impl Missing {
    /// Says what is missing where.
    pub fn new(place: impl Into<String>, what: impl Into<String>) -> Self {
        Self { place: place.into(), what: what.into() }
    }
}

/// A result, or what it lacks.
pub type Result<T> = std::result::Result<T, Missing>;
