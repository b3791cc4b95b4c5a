//! Cycle detection over poses: [`tpg_runtime::cycle`] with the arm's key.

use crate::arm::Pose;
use tpg_runtime::cycle;
pub use tpg_runtime::cycle::CycleDetector;

/// The exact set of visited poses.
pub type Visited<const N: usize> = cycle::Visited<Pose, N>;

/// Brent's detector, in 16 bytes.
pub type Brent = cycle::Brent<Pose>;
