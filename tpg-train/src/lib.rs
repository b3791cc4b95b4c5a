//! Trains robot-arm policies: tangled program graphs and soft actor-critic.

pub mod ik;
pub mod random;
pub mod sac;
pub mod targets;
pub mod trial;
