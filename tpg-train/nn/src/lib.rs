//! Neural networks, limited to what a soft actor-critic needs, and its update.
//!
//! A batch is a matrix with one column per sample, so that a sample's values are contiguous. The parameters of a
//! network are one flat vector: the optimiser, Polyak averaging and checkpoints see numbers, not layers.
//!
//! # Reproducibility
//!
//! Everything here gives the same bits on every machine: each sum has one order, independent of the width of the
//! vectors that compute it ([`multiply`]); no multiplication is fused with an addition; transcendental functions come
//! from the crate `libm`, not from the platform. Loops use the widest vectors of the processor, which the crate
//! `fearless_simd` detects.

mod adam;
mod agent;
mod gaussian;
mod mlp;
mod product;
mod sum;
mod vectors;

pub use adam::Adam;
pub use agent::{Agent, Experience, Learner, Rates, UpdateFigures, Workspace};
pub use gaussian::{Gaussian, Samples};
pub use mlp::{Mlp, Shape, Tape};
pub use product::{Factor, Finish, Scratch, multiply};
