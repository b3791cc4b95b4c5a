//! The instruction set of TPG programs and the two providers of its transcendental functions.
//!
//! Programs compute in `f32` or `f64`; every result is the IEEE-754 one. Infinities and NaN flow freely: nothing is
//! protected, as in GEGELATI. A comparison with NaN is false.

pub mod constant_time;
mod eight;
mod instruction;
mod maths;
pub mod own;
pub(crate) mod remainder;

pub use instruction::{BY_ZERO, Instruction, ZERO_BY_ZERO, fmod, gate, max, min, negate_if_less, quotient, sqrt};
pub use maths::{Maths, Own, System};

/// A bid as teams compare it: a NaN counts as −∞ (GEGELATI, `tpgExecutionEngine.cpp`).
#[inline(always)]
pub fn bid<S: crate::scalar::Scalar>(value: S) -> S {
    if value.is_nan() { S::NEG_INFINITY } else { value }
}

/// Lets `challenger` bid against the best so far: it wins when its bid is as high, so of equal bids the last wins
/// (GEGELATI, `tpgExecutionEngine.cpp`). Both bids have gone through [`bid`]; `.1` is where the bidder leads.
#[inline(always)]
pub fn challenge<S: crate::scalar::Scalar, To>(best: (S, To), challenger: (S, To)) -> (S, To) {
    if challenger.0 >= best.0 { challenger } else { best }
}

/// Limits an output to its range: `low` where `value` is lower, `high` where it is higher, and `nan` where it is NaN.
///
/// ```
/// use tpg_runtime::ops::clamp;
///
/// assert_eq!([-3.0, 0.5, 9.0, f32::NAN].map(|value| clamp(value, -2.0, 2.0, 0.0)), [-2.0, 0.5, 2.0, 0.0]);
/// ```
#[inline(always)]
pub fn clamp<S: crate::scalar::Scalar>(value: S, low: S, high: S, nan: S) -> S {
    // What is neither in the range nor below it is NaN: no test of its own.
    if value >= low {
        if value > high { high } else { value }
    } else if value < low {
        low
    } else {
        nan
    }
}
