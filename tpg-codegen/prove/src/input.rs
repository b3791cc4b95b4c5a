//! The reasons why a proof is not decided.

/// Something that a proof lacks: a construct that is not read, a fault of a file, or a fact that no rule gives. Nothing is claimed then.
#[derive(Clone, Debug, PartialEq, Eq, thiserror::Error)]
#[error("{place}: {what}")]
pub struct Missing {
    /// A line or a part of a file, an address, or a team
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
