//! The providers of sine, cosine, tangent, logarithm and exponential.

use super::{eight, own};
use crate::scalar::Scalar;

/// The transcendental functions that programs use, in one scalar type.
pub trait Maths<S: Scalar>: Copy + Default + Send + Sync + 'static {
    /// Sine of `x` radians.
    fn sin(x: S) -> S;
    /// Cosine of `x` radians.
    fn cos(x: S) -> S;
    /// Tangent of `x` radians.
    fn tan(x: S) -> S;
    /// Natural logarithm.
    fn ln(x: S) -> S;
    /// Exponential.
    fn exp(x: S) -> S;
    /// Replaces at least the first `used` numbers by their sines, with the same bits as one by one.
    #[inline]
    fn sines(numbers: &mut [S; 8], used: usize) {
        numbers[..used].iter_mut().for_each(|x| *x = Self::sin(*x));
    }
    /// As [`sines`](Self::sines), cosines.
    #[inline]
    fn cosines(numbers: &mut [S; 8], used: usize) {
        numbers[..used].iter_mut().for_each(|x| *x = Self::cos(*x));
    }
    /// As [`sines`](Self::sines), tangents.
    #[inline]
    fn tangents(numbers: &mut [S; 8], used: usize) {
        numbers[..used].iter_mut().for_each(|x| *x = Self::tan(*x));
    }
    /// As [`sines`](Self::sines), natural logarithms.
    #[inline]
    fn logarithms(numbers: &mut [S; 8], used: usize) {
        numbers[..used].iter_mut().for_each(|x| *x = Self::ln(*x));
    }
    /// As [`sines`](Self::sines), exponentials.
    #[inline]
    fn exponentials(numbers: &mut [S; 8], used: usize) {
        numbers[..used].iter_mut().for_each(|x| *x = Self::exp(*x));
    }
}

/// This project's kernels: no loop, no table search, the same bits on every machine and in generated C.
/// Error bounds are stated and measured in [`own`].
#[derive(Clone, Copy, Debug, Default)]
pub struct Own;

/// The platform's libm with feature `std`, else the crate `libm`.
///
/// Graphs that GEGELATI trained used their machine's libm; another one is near, not bit-equal. That is why
/// a graph names its provider.
#[derive(Clone, Copy, Debug, Default)]
pub struct System;

/// Implements a provider by its five functions in one scalar type, and more.
macro_rules! provider {
    ($provider:ty, $scalar:ty, [$sin:path, $cos:path, $tan:path, $ln:path, $exp:path] $($more:item)*) => {
        impl Maths<$scalar> for $provider {
            #[inline]
            fn sin(x: $scalar) -> $scalar {
                $sin(x)
            }
            #[inline]
            fn cos(x: $scalar) -> $scalar {
                $cos(x)
            }
            #[inline]
            fn tan(x: $scalar) -> $scalar {
                $tan(x)
            }
            #[inline]
            fn ln(x: $scalar) -> $scalar {
                $ln(x)
            }
            #[inline]
            fn exp(x: $scalar) -> $scalar {
                $exp(x)
            }
            $($more)*
        }
    };
}

/// Implements [`Own`] in the scalar type of this name.
macro_rules! own_kernels {
    ($scalar:ident) => {
        provider! {
            Own,
            $scalar,
            [own::$scalar::sin, own::$scalar::cos, own::$scalar::tan, own::$scalar::ln, own::$scalar::exp]
            #[inline(always)]
            fn sines(numbers: &mut [$scalar; 8], _used: usize) {
                eight::$scalar::sines(numbers);
            }
            #[inline(always)]
            fn cosines(numbers: &mut [$scalar; 8], _used: usize) {
                eight::$scalar::cosines(numbers);
            }
            #[inline(always)]
            fn logarithms(numbers: &mut [$scalar; 8], _used: usize) {
                numbers.iter_mut().for_each(|x| *x = own::$scalar::ln(*x));
            }
            #[inline(always)]
            fn exponentials(numbers: &mut [$scalar; 8], _used: usize) {
                numbers.iter_mut().for_each(|x| *x = own::$scalar::exp(*x));
            }
        }
    };
}

own_kernels!(f32);
own_kernels!(f64);

#[cfg(feature = "std")]
provider!(System, f32, [f32::sin, f32::cos, f32::tan, f32::ln, f32::exp]);
#[cfg(feature = "std")]
provider!(System, f64, [f64::sin, f64::cos, f64::tan, f64::ln, f64::exp]);
#[cfg(not(feature = "std"))]
provider!(System, f32, [libm::sinf, libm::cosf, libm::tanf, libm::logf, libm::expf]);
#[cfg(not(feature = "std"))]
provider!(System, f64, [libm::sin, libm::cos, libm::tan, libm::log, libm::exp]);
