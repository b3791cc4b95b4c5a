//! Functions of a scalar that kinematics needs beyond arithmetic.

use tpg_runtime::scalar::Scalar;

/// A scalar that also knows the sines of the motor lattice, by table, and the square root of a microcontroller's FPU.
pub trait Lattice: Scalar {
    /// Sine of `index` · π/2048, for `index` in 0..=1024; 0 beyond.
    ///
    /// Equal to `libm::sin` in `f64`, rounded to this type.
    fn quarter_sine(index: usize) -> Self;
    /// This number, or with `negative` its negative, whose sign alone differs.
    fn negated_if(self, negative: bool) -> Self;
    /// The correctly rounded square root; NaN for negative numbers.
    fn sqrt(self) -> Self;
    /// The angle of the point (`x`, `self`), rad, −π..π, by libm in this type's own precision.
    fn atan2(self, x: Self) -> Self;
    /// The natural logarithm, by libm in this type's own precision.
    fn ln(self) -> Self;
}

include!(concat!(env!("OUT_DIR"), "/sine.rs"));

macro_rules! lattice {
    ($type:ty, $bits:ty, $sines:ident, $sqrt:path, $atan2:path, $ln:path) => {
        impl Lattice for $type {
            #[inline]
            fn quarter_sine(index: usize) -> Self {
                $sines.get(index).copied().unwrap_or(0.0)
            }
            #[inline]
            fn negated_if(self, negative: bool) -> Self {
                // In an integer register, where it takes one instruction on a Cortex-M.
                Self::from_bits(self.to_bits() ^ <$bits>::from(negative) << (<$bits>::BITS - 1))
            }
            #[inline]
            fn sqrt(self) -> Self {
                $sqrt(self)
            }
            #[inline]
            fn atan2(self, x: Self) -> Self {
                $atan2(self, x)
            }
            #[inline]
            fn ln(self) -> Self {
                $ln(self)
            }
        }
    };
}

lattice!(f32, u32, SINE_F32, tpg_kernels::sqrt, libm::atan2f, libm::logf);
lattice!(f64, u64, SINE_F64, libm::sqrt, libm::atan2, libm::log);
