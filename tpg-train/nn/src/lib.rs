//! Neural networks, limited to what a soft actor-critic needs, and its update.
//!
//! A batch is a matrix with one column per sample, so that a sample's values are contiguous. The parameters of a
//! network are one flat vector: the optimiser, Polyak averaging and checkpoints see numbers, not layers.
//!
//! Everything is generic over [`Real`]. Training uses `f32`; the gradient checks use `f64`, in which finite differences
//! are meaningful.
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
mod loops;
mod mlp;
mod product;
mod sum;
mod vectors;

pub use adam::Adam;
pub use agent::{Agent, Experience, Learner, Rates, UpdateFigures, Workspace};
pub use gaussian::{Gaussian, Samples, Spread};
pub use loops::Loops;
pub use mlp::{Mlp, Shape, Tape};
pub use product::{Factor, Finish, Scratch, multiply};

use fearless_simd::SimdFloatElement;

/// `f32` or `f64`, with vectors and platform-independent elementary functions.
pub trait Real: SimdFloatElement + Loops + 'static {
    /// Returns 0.
    #[inline(always)]
    fn zero() -> Self {
        Self::default()
    }
    /// Returns 1.
    #[inline(always)]
    fn one() -> Self {
        Self::from(1u8)
    }
    /// Returns the value nearest to `value`.
    fn nearest(value: f64) -> Self;
    /// Converts the number exactly to `f64`.
    fn wide(self) -> f64;
    /// Returns e to the power of this number.
    fn exponential(self) -> Self;
    /// Returns the natural logarithm.
    fn logarithm(self) -> Self;
    /// Returns the correctly rounded square root.
    fn root(self) -> Self;
}

impl Real for f32 {
    fn nearest(value: f64) -> Self {
        value as f32
    }
    fn wide(self) -> f64 {
        f64::from(self)
    }
    fn exponential(self) -> Self {
        libm::expf(self)
    }
    fn logarithm(self) -> Self {
        libm::logf(self)
    }
    #[inline(always)]
    fn root(self) -> Self {
        f32::sqrt(self)
    }
}

impl Real for f64 {
    fn nearest(value: f64) -> Self {
        value
    }
    fn wide(self) -> f64 {
        self
    }
    fn exponential(self) -> Self {
        libm::exp(self)
    }
    fn logarithm(self) -> Self {
        libm::log(self)
    }
    #[inline(always)]
    fn root(self) -> Self {
        f64::sqrt(self)
    }
}
