//! The providers of the transcendental functions.

use super::{eight, own};
use crate::scalar::Scalar;

/// Defines functions of eight numbers by those of one.
macro_rules! at_once {
    ($($many:ident = $one:ident,)+) => {
        $(
            #[doc = concat!("Replaces at least the first `used` numbers by their ", stringify!($many), ",")]
            /// with the same bits as one by one.
            #[inline]
            fn $many(numbers: &mut [S; 8], used: usize) {
                numbers[..used].iter_mut().for_each(|x| *x = Self::$one(*x));
            }
        )+
    };
}

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
    /// Arctangent, in radians.
    fn atan(x: S) -> S;
    /// Hyperbolic tangent.
    fn tanh(x: S) -> S;
    at_once! {
        sines = sin,
        cosines = cos,
        tangents = tan,
        logarithms = ln,
        exponentials = exp,
        arctangents = atan,
        hyperbolic_tangents = tanh,
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

/// Implements a provider by its functions in one scalar type, and more.
macro_rules! provider {
    ($provider:ty, $scalar:ty, [$($function:ident = $path:expr),+] $($more:item)*) => {
        impl Maths<$scalar> for $provider {
            $(
                #[inline]
                fn $function(x: $scalar) -> $scalar {
                    $path(x)
                }
            )+
            $($more)*
        }
    };
}

/// Defines functions of eight numbers that compilers turn into vectors: they do not ask how many are used.
macro_rules! all_eight {
    ($scalar:ident, $($many:ident = $one:ident),+) => {
        $(
            #[inline(always)]
            fn $many(numbers: &mut [$scalar; 8], _used: usize) {
                numbers.iter_mut().for_each(|x| *x = own::$scalar::$one(*x));
            }
        )+
    };
}

/// Implements [`Own`] in the scalar type of this name.
macro_rules! own_kernels {
    ($scalar:ident) => {
        provider! {
            Own,
            $scalar,
            [
                sin = own::$scalar::sin,
                cos = own::$scalar::cos,
                tan = own::$scalar::tan,
                ln = own::$scalar::ln,
                exp = own::$scalar::exp,
                atan = own::$scalar::atan,
                tanh = own::$scalar::tanh
            ]
            #[inline(always)]
            fn sines(numbers: &mut [$scalar; 8], _used: usize) {
                eight::$scalar::sines(numbers);
            }
            #[inline(always)]
            fn cosines(numbers: &mut [$scalar; 8], _used: usize) {
                eight::$scalar::cosines(numbers);
            }
            all_eight! { $scalar, logarithms = ln, exponentials = exp, arctangents = atan, hyperbolic_tangents = tanh }
        }
    };
}

own_kernels!(f32);
own_kernels!(f64);

/// Implements [`System`] by the functions of the standard library, or of `libm` without it.
macro_rules! platform {
    ($scalar:ident, $functions:ty, $ln:ident) => {
        provider!(
            System,
            $scalar,
            [
                sin = <$functions>::sin,
                cos = <$functions>::cos,
                tan = <$functions>::tan,
                ln = <$functions>::$ln,
                exp = <$functions>::exp,
                atan = <$functions>::atan,
                tanh = <$functions>::tanh
            ]
        );
    };
}

#[cfg(feature = "std")]
platform!(f32, f32, ln);
#[cfg(feature = "std")]
platform!(f64, f64, ln);
#[cfg(not(feature = "std"))]
platform!(f32, libm::Libm<f32>, log);
#[cfg(not(feature = "std"))]
platform!(f64, libm::Libm<f64>, log);
