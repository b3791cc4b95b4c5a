//! Functions of a scalar that kinematics needs beyond arithmetic.

use super::Direction;
use tpg_runtime::scalar::Scalar;

/// A scalar that also knows the directions of angles: by table on the motor lattice, by libm anywhere.
pub trait Lattice: Scalar {
    /// Sine of `index` · π/2048, for `index` in 0..=1024; 0 beyond.
    ///
    /// Equal to `libm::sin` in `f64`, rounded to this type.
    fn quarter_sine(index: usize) -> Self;
    /// This number, or with `negative` its negative, whose sign alone differs.
    fn negated_if(self, negative: bool) -> Self;
    /// The direction of an angle in radians, by libm.
    fn direction_of(radians: Self) -> Direction<Self>;
    /// The correctly rounded square root; NaN for negative numbers.
    fn sqrt(self) -> Self;
    /// The angle of the point (`x`, `self`), rad, −π..π, by libm in this type's own precision.
    fn atan2(self, x: Self) -> Self;
    /// The natural logarithm, by libm in this type's own precision.
    fn ln(self) -> Self;
}

include!(concat!(env!("OUT_DIR"), "/sine.rs"));

impl Lattice for f32 {
    #[inline]
    fn quarter_sine(index: usize) -> Self {
        SINE_F32.get(index).copied().unwrap_or(0.0)
    }
    #[inline]
    fn negated_if(self, negative: bool) -> Self {
        // In an integer register, where it takes one instruction on a Cortex-M.
        Self::from_bits(self.to_bits() ^ u32::from(negative) << 31)
    }
    #[inline]
    fn direction_of(radians: Self) -> Direction<Self> {
        Direction { cos: libm::cosf(radians), sin: libm::sinf(radians) }
    }
    #[inline]
    fn sqrt(self) -> Self {
        tpg_kernels::sqrt(self)
    }
    #[inline]
    fn atan2(self, x: Self) -> Self {
        libm::atan2f(self, x)
    }
    #[inline]
    fn ln(self) -> Self {
        libm::logf(self)
    }
}

impl Lattice for f64 {
    #[inline]
    fn quarter_sine(index: usize) -> Self {
        SINE_F64.get(index).copied().unwrap_or(0.0)
    }
    #[inline]
    fn negated_if(self, negative: bool) -> Self {
        Self::from_bits(self.to_bits() ^ u64::from(negative) << 63)
    }
    #[inline]
    fn direction_of(radians: Self) -> Direction<Self> {
        Direction { cos: libm::cos(radians), sin: libm::sin(radians) }
    }
    #[inline]
    fn sqrt(self) -> Self {
        libm::sqrt(self)
    }
    #[inline]
    fn atan2(self, x: Self) -> Self {
        libm::atan2(self, x)
    }
    #[inline]
    fn ln(self) -> Self {
        libm::log(self)
    }
}
