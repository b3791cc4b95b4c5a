//! Neural networks, limited to what a soft actor-critic needs.
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
//! from the crate `libm`, not from the platform. Loops use the widest vectors of the processor, which the crate `pulp`
//! detects.

mod adam;
mod gaussian;
mod loops;
mod mlp;
mod norm;
mod product;
mod sum;

pub use adam::Adam;
pub use gaussian::{Gaussian, Samples, Spread};
pub use loops::Loops;
pub use mlp::{Mlp, Shape, Tape};
pub use product::{Factor, Finish, Scratch, multiply};

use pulp::{Simd, bytemuck};
use std::fmt::Debug;
use std::ops::{Add, AddAssign, Div, Mul, MulAssign, Neg, Sub, SubAssign};

/// `f32` or `f64`, with platform-independent elementary functions and vector operations.
pub trait Real:
    Loops
    + Copy
    + Default
    + Debug
    + PartialOrd
    + Add<Output = Self>
    + Sub<Output = Self>
    + Mul<Output = Self>
    + Div<Output = Self>
    + Neg<Output = Self>
    + AddAssign
    + SubAssign
    + MulAssign
    + 'static
{
    /// A vector register of this type.
    type Vector<S: Simd>: Copy;
    /// Returns the number of lanes of a vector.
    fn lanes<S: Simd>() -> usize;
    /// Returns a vector with the same number in each lane.
    fn splat<S: Simd>(simd: S, value: Self) -> Self::Vector<S>;
    /// Returns the lane-wise sums.
    fn plus<S: Simd>(simd: S, a: Self::Vector<S>, b: Self::Vector<S>) -> Self::Vector<S>;
    /// Returns the lane-wise products.
    fn times<S: Simd>(simd: S, a: Self::Vector<S>, b: Self::Vector<S>) -> Self::Vector<S>;
    /// Applies ReLU to each lane; NaN becomes zero.
    fn rectify<S: Simd>(simd: S, values: Self::Vector<S>) -> Self::Vector<S>;
    /// Returns the gradients in the lanes where a ReLU's output was positive, zeros elsewhere.
    fn pass<S: Simd>(simd: S, gradients: Self::Vector<S>, passed: Self::Vector<S>) -> Self::Vector<S>;
    /// Returns the whole vectors of a list.
    fn vectors<S: Simd>(values: &[Self]) -> &[Self::Vector<S>];
    /// Returns the whole vectors of a list, mutable.
    fn vectors_mut<S: Simd>(values: &mut [Self]) -> &mut [Self::Vector<S>];
    /// Returns a vector's lanes.
    fn unpack<S: Simd>(vector: &Self::Vector<S>) -> &[Self];
    /// Returns 0.
    fn zero() -> Self;
    /// Returns 1.
    fn one() -> Self;
    /// Returns the value nearest to `value`.
    fn of(value: f64) -> Self;
    /// Converts the number exactly to `f64`.
    fn wide(self) -> f64;
    /// Returns e to the power of this number.
    fn exponential(self) -> Self;
    /// Returns the natural logarithm.
    fn logarithm(self) -> Self;
    /// Returns the correctly rounded square root.
    fn root(self) -> Self;
}

macro_rules! vectors {
    (
        $type:ty, $vector:ident, $lanes:ident, $splat:ident, $add:ident, $mul:ident, $above:ident, $select:ident,
        $of:ident, $of_mut:ident
    ) => {
        type Vector<S: Simd> = S::$vector;

        #[inline(always)]
        fn lanes<S: Simd>() -> usize {
            S::$lanes
        }
        #[inline(always)]
        fn splat<S: Simd>(simd: S, value: Self) -> Self::Vector<S> {
            simd.$splat(value)
        }
        #[inline(always)]
        fn plus<S: Simd>(simd: S, a: Self::Vector<S>, b: Self::Vector<S>) -> Self::Vector<S> {
            simd.$add(a, b)
        }
        #[inline(always)]
        fn times<S: Simd>(simd: S, a: Self::Vector<S>, b: Self::Vector<S>) -> Self::Vector<S> {
            simd.$mul(a, b)
        }
        #[inline(always)]
        fn rectify<S: Simd>(simd: S, values: Self::Vector<S>) -> Self::Vector<S> {
            let zero = simd.$splat(0.0);
            simd.$select(simd.$above(values, zero), values, zero)
        }
        #[inline(always)]
        fn pass<S: Simd>(simd: S, gradients: Self::Vector<S>, passed: Self::Vector<S>) -> Self::Vector<S> {
            let zero = simd.$splat(0.0);
            simd.$select(simd.$above(passed, zero), gradients, zero)
        }
        #[inline(always)]
        fn vectors<S: Simd>(values: &[Self]) -> &[Self::Vector<S>] {
            S::$of(values).0
        }
        #[inline(always)]
        fn vectors_mut<S: Simd>(values: &mut [Self]) -> &mut [Self::Vector<S>] {
            S::$of_mut(values).0
        }
        #[inline(always)]
        fn unpack<S: Simd>(vector: &Self::Vector<S>) -> &[Self] {
            bytemuck::cast_slice(std::slice::from_ref(vector))
        }
        #[inline(always)]
        fn zero() -> Self {
            0.0
        }
        #[inline(always)]
        fn one() -> Self {
            1.0
        }
    };
}

impl Real for f32 {
    vectors!(
        f32,
        f32s,
        F32_LANES,
        splat_f32s,
        add_f32s,
        mul_f32s,
        greater_than_f32s,
        select_f32s,
        as_simd_f32s,
        as_mut_simd_f32s
    );
    fn of(value: f64) -> Self {
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
    vectors!(
        f64,
        f64s,
        F64_LANES,
        splat_f64s,
        add_f64s,
        mul_f64s,
        greater_than_f64s,
        select_f64s,
        as_simd_f64s,
        as_mut_simd_f64s
    );
    fn of(value: f64) -> Self {
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
