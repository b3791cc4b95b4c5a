//! The runtime of learned robot-arm policies.
#![no_std]

pub mod ops;
pub mod policy;
pub mod scalar;
