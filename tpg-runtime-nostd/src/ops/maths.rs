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

impl Maths<f32> for Own {
    #[inline]
    fn sin(x: f32) -> f32 {
        own::f32::sin(x)
    }
    #[inline]
    fn cos(x: f32) -> f32 {
        own::f32::cos(x)
    }
    #[inline]
    fn tan(x: f32) -> f32 {
        own::f32::tan(x)
    }
    #[inline]
    fn ln(x: f32) -> f32 {
        own::f32::ln(x)
    }
    #[inline]
    fn exp(x: f32) -> f32 {
        own::f32::exp(x)
    }
    #[inline(always)]
    fn sines(numbers: &mut [f32; 8], _used: usize) {
        eight::f32::sines(numbers);
    }
    #[inline(always)]
    fn cosines(numbers: &mut [f32; 8], _used: usize) {
        eight::f32::cosines(numbers);
    }
    #[inline(always)]
    fn logarithms(numbers: &mut [f32; 8], _used: usize) {
        numbers.iter_mut().for_each(|x| *x = own::f32::ln(*x));
    }
    #[inline(always)]
    fn exponentials(numbers: &mut [f32; 8], _used: usize) {
        numbers.iter_mut().for_each(|x| *x = own::f32::exp(*x));
    }
}

impl Maths<f64> for Own {
    #[inline]
    fn sin(x: f64) -> f64 {
        own::f64::sin(x)
    }
    #[inline]
    fn cos(x: f64) -> f64 {
        own::f64::cos(x)
    }
    #[inline]
    fn tan(x: f64) -> f64 {
        own::f64::tan(x)
    }
    #[inline]
    fn ln(x: f64) -> f64 {
        own::f64::ln(x)
    }
    #[inline]
    fn exp(x: f64) -> f64 {
        own::f64::exp(x)
    }
    #[inline(always)]
    fn sines(numbers: &mut [f64; 8], _used: usize) {
        eight::f64::sines(numbers);
    }
    #[inline(always)]
    fn cosines(numbers: &mut [f64; 8], _used: usize) {
        eight::f64::cosines(numbers);
    }
    #[inline(always)]
    fn logarithms(numbers: &mut [f64; 8], _used: usize) {
        numbers.iter_mut().for_each(|x| *x = own::f64::ln(*x));
    }
    #[inline(always)]
    fn exponentials(numbers: &mut [f64; 8], _used: usize) {
        numbers.iter_mut().for_each(|x| *x = own::f64::exp(*x));
    }
}

#[cfg(feature = "std")]
mod system {
    use super::{Maths, System};

    impl Maths<f32> for System {
        #[inline]
        fn sin(x: f32) -> f32 {
            x.sin()
        }
        #[inline]
        fn cos(x: f32) -> f32 {
            x.cos()
        }
        #[inline]
        fn tan(x: f32) -> f32 {
            x.tan()
        }
        #[inline]
        fn ln(x: f32) -> f32 {
            x.ln()
        }
        #[inline]
        fn exp(x: f32) -> f32 {
            x.exp()
        }
    }

    impl Maths<f64> for System {
        #[inline]
        fn sin(x: f64) -> f64 {
            x.sin()
        }
        #[inline]
        fn cos(x: f64) -> f64 {
            x.cos()
        }
        #[inline]
        fn tan(x: f64) -> f64 {
            x.tan()
        }
        #[inline]
        fn ln(x: f64) -> f64 {
            x.ln()
        }
        #[inline]
        fn exp(x: f64) -> f64 {
            x.exp()
        }
    }
}

#[cfg(not(feature = "std"))]
mod system {
    use super::{Maths, System};

    impl Maths<f32> for System {
        #[inline]
        fn sin(x: f32) -> f32 {
            libm::sinf(x)
        }
        #[inline]
        fn cos(x: f32) -> f32 {
            libm::cosf(x)
        }
        #[inline]
        fn tan(x: f32) -> f32 {
            libm::tanf(x)
        }
        #[inline]
        fn ln(x: f32) -> f32 {
            libm::logf(x)
        }
        #[inline]
        fn exp(x: f32) -> f32 {
            libm::expf(x)
        }
    }

    impl Maths<f64> for System {
        #[inline]
        fn sin(x: f64) -> f64 {
            libm::sin(x)
        }
        #[inline]
        fn cos(x: f64) -> f64 {
            libm::cos(x)
        }
        #[inline]
        fn tan(x: f64) -> f64 {
            libm::tan(x)
        }
        #[inline]
        fn ln(x: f64) -> f64 {
            libm::log(x)
        }
        #[inline]
        fn exp(x: f64) -> f64 {
            libm::exp(x)
        }
    }
}
