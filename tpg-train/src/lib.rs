//! Trains robot-arm policies: tangled program graphs and soft actor-critic.

pub mod engine;
pub mod environments;
pub mod evaluate;
pub mod evolution;
pub mod files;
pub mod ik;
pub mod random;
pub mod sac;
pub mod targets;
pub mod trial;
