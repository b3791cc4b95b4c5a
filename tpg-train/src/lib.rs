//! Evolves tangled program graphs.

pub mod engine;
pub mod environments;
pub mod random;
