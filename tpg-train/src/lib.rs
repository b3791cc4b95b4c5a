//! Evolves tangled program graphs.

pub mod engine;
pub mod random;
