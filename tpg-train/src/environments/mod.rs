//! The problems that come with the trainer.

pub mod arm;
pub mod pendulum;

pub use arm::{ArmEnvironment, ArmProblem, ArmScalar, ArmTask};
pub use pendulum::Pendulum;
