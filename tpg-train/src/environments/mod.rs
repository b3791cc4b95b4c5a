//! The problems that come with the trainer.

pub mod arm;
pub mod description;
pub mod pendulum;

pub use arm::{ArmEnvironment, ArmProblem, ArmScalar, ArmTask};
pub use description::ArmDescription;
pub use pendulum::Pendulum;
