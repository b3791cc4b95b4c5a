//! The problems that come with the trainer.

pub mod arm;
pub mod reachable;

pub use arm::{ArmEnvironment, ArmProblem, ArmScalar, ArmTask, Start};
pub use reachable::{Reachable, Sampling};
