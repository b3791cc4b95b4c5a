//! The two scalar types a policy can be computed in.

use crate::ops::remainder;
use core::fmt::Debug;
use core::ops::{Add, Div, Mul, Neg, Sub};

/// The square roots: of the processor where there is `std`, else of the crate `libm`. IEEE 754 leaves no choice.
mod root {
    #[cfg(not(feature = "std"))]
    pub(super) use libm::{sqrt as f64, sqrtf as f32};

    #[cfg(feature = "std")]
    #[inline(always)]
    pub(super) fn f32(x: f32) -> f32 {
        x.sqrt()
    }

    #[cfg(feature = "std")]
    #[inline(always)]
    pub(super) fn f64(x: f64) -> f64 {
        x.sqrt()
    }
}

/// `f32` or `f64`, with exactly the operations the runtime needs.
///
/// Every operation is the IEEE-754 one, rounded to nearest even; nothing is fused or reassociated.
pub trait Scalar:
    Copy
    + Debug
    + Default
    + PartialEq
    + PartialOrd
    + Add<Output = Self>
    + Sub<Output = Self>
    + Mul<Output = Self>
    + Div<Output = Self>
    + Neg<Output = Self>
    + Send
    + Sync
    + 'static
{
    /// Zero.
    const ZERO: Self;
    /// One.
    const ONE: Self;
    /// Negative infinity: what a NaN bid counts as.
    const NEG_INFINITY: Self;

    /// The value nearest to `value`.
    fn from_f64(value: f64) -> Self;
    /// The value nearest to `value` (exact below 2²⁴ for `f32`).
    fn from_i32(value: i32) -> Self;
    /// The same number as an `f64`, always exact.
    fn to_f64(self) -> f64;
    /// The magnitude: clears the sign bit, of a NaN too.
    fn abs(self) -> Self;
    /// The remainder of a division by `divisor`, with the sign of this number, exactly: see
    /// [`Instruction::Fmod`](crate::ops::Instruction::Fmod).
    fn fmod(self, divisor: Self) -> Self;
    /// The square root, correctly rounded: see [`Instruction::Sqrt`](crate::ops::Instruction::Sqrt).
    fn square_root(self) -> Self;
    /// Truncated towards zero; the nearest end where `i32` has no such number, 0 for a NaN.
    fn to_i32(self) -> i32;
    /// The greatest whole number that is not above this one, never −0; infinities and NaN stay.
    fn floor(self) -> Self;
    /// Returns true if both are the same bits: a NaN is the same as itself, 0 is not −0.
    fn same_bits(self, other: Self) -> bool;
    /// Returns true if this is not a number.
    #[expect(clippy::eq_op, reason = "a NaN is the only value unequal to itself")]
    fn is_nan(self) -> bool {
        self != self
    }
}

/// Implements [`Scalar`]; from `$all_whole` on, every number is whole.
macro_rules! scalar {
    ($scalar:ident, $integer:ident, $all_whole:literal, $fmod:ident) => {
        impl Scalar for $scalar {
            const ZERO: Self = 0.0;
            const ONE: Self = 1.0;
            const NEG_INFINITY: Self = $scalar::NEG_INFINITY;

            #[inline(always)]
            fn same_bits(self, other: Self) -> bool {
                self.to_bits() == other.to_bits()
            }
            #[inline(always)]
            fn from_f64(value: f64) -> Self {
                value as $scalar
            }
            #[inline(always)]
            fn from_i32(value: i32) -> Self {
                value as $scalar
            }
            #[inline(always)]
            fn to_f64(self) -> f64 {
                f64::from(self)
            }
            #[inline(always)]
            fn to_i32(self) -> i32 {
                self as i32
            }
            #[inline(always)]
            fn floor(self) -> Self {
                if $scalar::abs(self) < $all_whole {
                    let whole = self as $integer as $scalar;
                    if whole > self { whole - 1.0 } else { whole }
                } else {
                    self
                }
            }
            #[inline(always)]
            fn abs(self) -> Self {
                $scalar::abs(self)
            }
            #[inline]
            fn fmod(self, divisor: Self) -> Self {
                remainder::$fmod(self, divisor)
            }
            #[inline(always)]
            fn square_root(self) -> Self {
                root::$scalar(self)
            }
        }
    };
}

scalar!(f32, i32, 8_388_608.0, fmod_f32); // 2²³
scalar!(f64, i64, 4_503_599_627_370_496.0, fmod_f64); // 2⁵²
