//! Soft actor-critic.
pub mod nn;
