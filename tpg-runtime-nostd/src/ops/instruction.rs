//! The instructions themselves.

use super::Maths;
use crate::named;
use crate::scalar::Scalar;

named! {
    /// One instruction of a program line.
    ///
    /// The first nine are the paper's (armlearn-wrapper, `instructions.cpp`), in its order; the others are this project's.
    #[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
    pub enum Instruction {
        /// `a − b`
        Sub = "sub",
        /// `a + b`
        Add = "add",
        /// `a · b`
        Mul = "mul",
        /// `a / b`, unprotected: `1 / 0` is ∞, `0 / 0` NaN.
        Div = "div",
        /// `−a` where `a < b`, else `a`.
        NegateIfLess = "negate_if_less",
        /// `cos a`
        Cos = "cos",
        /// `sin a`
        Sin = "sin",
        /// Natural logarithm, unprotected: of 0 it is −∞, of a negative number NaN.
        Ln = "ln",
        /// `eᵃ`
        Exp = "exp",
        /// `|a|`
        Abs = "abs",
        /// `a` where `a < b`, else `b`: a NaN on either side gives `b`.
        Min = "min",
        /// `a` where `a > b`, else `b`: a NaN on either side gives `b`.
        Max = "max",
        /// `tan a`
        Tan = "tan",
        /// The remainder of `a / b` with the sign of `a`, as C's `fmod`, exactly. NaN where `b` is 0 or `a` infinite.
        Fmod = "fmod",
        /// `a` where `b` is not 0, else −0, which adding does not notice. A NaN is not 0.
        ///
        /// Sums of gated values are choices: `x` where `c` is not 0, else `y`, is `gate(x, c) + gate(y, 1 − gate(1, c))`.
        Gate = "gate",
        /// `⌊a / b⌋`: the quotient, rounded once and then down to a whole number; never −0. Where `b` is 0 it is [`BY_ZERO`] for a
        /// positive `a`, −[`BY_ZERO`] for a negative one, and [`ZERO_BY_ZERO`] for 0 and NaN.
        ///
        /// Of whole numbers it is exact: in `f64` up to magnitudes of 2⁵², in `f32` of 2²³.
        Quotient = "quotient",
        /// `√a`, correctly rounded. NaN of a negative number; of −0 it is −0.
        Sqrt = "sqrt",
        /// `arctan a`
        Atan = "atan",
        /// `tanh a`
        Tanh = "tanh",
    }
}

/// [`Instruction::Quotient`] of a positive number by 0: what infinity is in integers.
pub const BY_ZERO: i32 = i32::MAX;
/// [`Instruction::Quotient`] of 0 by 0: what no number is in integers. As a bid it is below all others.
pub const ZERO_BY_ZERO: i32 = i32::MIN;

impl Instruction {
    /// Number of operands that it reads: 1 or 2. With 1, the second operand is ignored.
    pub const fn arity(self) -> usize {
        match self {
            Self::Cos | Self::Sin | Self::Tan | Self::Ln | Self::Exp | Self::Atan | Self::Tanh => 1,
            Self::Abs | Self::Sqrt => 1,
            Self::Sub | Self::Add | Self::Mul | Self::Div => 2,
            Self::NegateIfLess | Self::Min | Self::Max | Self::Fmod | Self::Gate | Self::Quotient => 2,
        }
    }

    /// Returns true of the functions that [`Maths`] provides, which are expensive: `cos`, `sin`, `tan`, `ln`, `exp`, `atan` and
    /// `tanh`.
    pub const fn is_transcendental(self) -> bool {
        matches!(self, Self::Cos | Self::Sin | Self::Tan | Self::Ln | Self::Exp | Self::Atan | Self::Tanh)
    }

    /// Computes the instruction with the transcendental functions of `M`.
    #[inline]
    pub fn apply<S: Scalar, M: Maths<S>>(self, a: S, b: S) -> S {
        match self {
            Self::Sub => a - b,
            Self::Add => a + b,
            Self::Mul => a * b,
            Self::Div => a / b,
            Self::NegateIfLess => negate_if_less(a, b),
            Self::Cos => M::cos(a),
            Self::Sin => M::sin(a),
            Self::Ln => M::ln(a),
            Self::Exp => M::exp(a),
            Self::Abs => a.abs(),
            Self::Min => min(a, b),
            Self::Max => max(a, b),
            Self::Tan => M::tan(a),
            Self::Fmod => a.fmod(b),
            Self::Gate => gate(a, b),
            Self::Quotient => quotient(a, b),
            Self::Sqrt => a.square_root(),
            Self::Atan => M::atan(a),
            Self::Tanh => M::tanh(a),
        }
    }
}

/// [`Instruction::NegateIfLess`].
#[inline(always)]
pub fn negate_if_less<S: Scalar>(a: S, b: S) -> S {
    if a < b { -a } else { a }
}

/// [`Instruction::Min`].
#[inline(always)]
pub fn min<S: Scalar>(a: S, b: S) -> S {
    if a < b { a } else { b }
}

/// [`Instruction::Max`].
#[inline(always)]
pub fn max<S: Scalar>(a: S, b: S) -> S {
    if a > b { a } else { b }
}

/// [`Instruction::Fmod`].
#[inline(always)]
pub fn fmod<S: Scalar>(a: S, b: S) -> S {
    a.fmod(b)
}

/// [`Instruction::Gate`].
#[inline(always)]
pub fn gate<S: Scalar>(a: S, b: S) -> S {
    if b == S::ZERO { -S::ZERO } else { a }
}

/// [`Instruction::Quotient`].
#[inline(always)]
pub fn quotient<S: Scalar>(a: S, b: S) -> S {
    if b != S::ZERO {
        (a / b).floor()
    } else if a > S::ZERO {
        S::from_i32(BY_ZERO)
    } else if a < S::ZERO {
        S::from_i32(-BY_ZERO)
    } else {
        S::from_i32(ZERO_BY_ZERO)
    }
}

/// [`Instruction::Sqrt`].
#[inline(always)]
pub fn sqrt<S: Scalar>(a: S) -> S {
    a.square_root()
}

#[cfg(test)]
mod tests {
    use super::quotient;
    use proptest::prelude::*;

    #[test]
    fn quotients_by_zero_have_the_sign_of_the_dividend() {
        let most = f64::from(i32::MAX);
        for zero in [0.0, -0.0] {
            let quotients = [1.0, -0.5, 0.0, -0.0, f64::NAN, f64::INFINITY].map(|a| quotient(a, zero));
            assert_eq!(quotients, [most, -most, -most - 1.0, -most - 1.0, -most - 1.0, most]);
        }
        assert!(quotient(f64::NAN, 2.0).is_nan() && quotient(2.0, f64::NAN).is_nan());
        assert_eq!(quotient(f64::INFINITY, -2.0), f64::NEG_INFINITY);
        assert_eq!([quotient(-0.0, 3.0_f32), quotient(0.0, -3.0)].map(f32::to_bits), [0, 0]);
        assert_eq!([quotient(-1e-30, 3.0), quotient(9e15_f64, 2.0), quotient(-1e300, 2.0)], [-1.0, 4.5e15, -5e299]);
    }

    proptest! {
        #[test]
        fn quotients_of_whole_numbers_are_exact(a in -(1_i64 << 52)..=1 << 52, b in any::<i32>(), c in any::<u8>()) {
            for b in [i64::from(b), i64::from(c), -i64::from(c)].into_iter().filter(|&b| b != 0) {
                let floor = a.div_euclid(b) - i64::from(b < 0 && a.rem_euclid(b) != 0);
                prop_assert_eq!(quotient(a as f64, b as f64), floor as f64, "{} {}", a, b);
            }
        }
    }
}
