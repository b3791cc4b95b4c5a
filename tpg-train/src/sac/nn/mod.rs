//! Neural networks on nalgebra's matrix product: what a soft actor-critic needs and no more.
//!
//! A batch is a matrix with one column a sample, so that a sample's values lie side by side. The parameters of a
//! network are one flat vector: the optimiser, Polyak averaging and checkpoints see numbers, not layers.
//!
//! Everything is generic over [`Real`]. Training uses `f32`; the gradient checks use `f64`, where a finite difference
//! says something.
//!
//! # The same bits
//!
//! [`Kernel::Fast`] is nalgebra's product by the crate `matrixmultiply`, which picks its kernel by the CPU it finds:
//! with and without fused multiply-add the last bits differ. It gives the same bits for the same seed on CPUs of one
//! family only. [`Kernel::Portable`] adds in one order without fusing: the same bits everywhere, at about a fifth of
//! the speed. Everything else here is portable: transcendental functions come from the crate `libm`, not from the
//! platform.

mod adam;
mod gaussian;
mod mlp;
mod product;

pub use adam::Adam;
pub use gaussian::{Gaussian, Samples, Spread};
pub use mlp::{Mlp, Shape, Tape};
pub use product::{Factor, Kernel};

use nalgebra::RealField;

/// `f32` or `f64`, with elementary functions that do not depend on the platform.
pub trait Real: RealField + Copy + Default {
    /// The value nearest to `value`.
    fn of(value: f64) -> Self;
    /// The same number, exactly.
    fn wide(self) -> f64;
    /// e to this power.
    fn exponential(self) -> Self;
    /// The natural logarithm of one more than this.
    fn log_of_next(self) -> Self;
    /// The natural logarithm.
    fn logarithm(self) -> Self;
    /// The hyperbolic tangent.
    fn squashed(self) -> Self;
    /// The correctly rounded square root.
    fn root(self) -> Self;
}

impl Real for f32 {
    fn of(value: f64) -> Self {
        value as f32
    }
    fn wide(self) -> f64 {
        f64::from(self)
    }
    fn exponential(self) -> Self {
        libm::expf(self)
    }
    fn log_of_next(self) -> Self {
        libm::log1pf(self)
    }
    fn logarithm(self) -> Self {
        libm::logf(self)
    }
    fn squashed(self) -> Self {
        libm::tanhf(self)
    }
    #[inline(always)]
    fn root(self) -> Self {
        f32::sqrt(self)
    }
}

impl Real for f64 {
    fn of(value: f64) -> Self {
        value
    }
    fn wide(self) -> f64 {
        self
    }
    fn exponential(self) -> Self {
        libm::exp(self)
    }
    fn log_of_next(self) -> Self {
        libm::log1p(self)
    }
    fn logarithm(self) -> Self {
        libm::log(self)
    }
    fn squashed(self) -> Self {
        libm::tanh(self)
    }
    #[inline(always)]
    fn root(self) -> Self {
        f64::sqrt(self)
    }
}
