//! The problems that come with the trainer.

pub mod arm;

pub use arm::{ArmEnvironment, ArmProblem, ArmScalar, ArmTask};
