//! The instructions themselves.

use super::Maths;
use crate::scalar::Scalar;

/// One instruction of a program line.
///
/// The first nine are the paper's (armlearn-wrapper, `instructions.cpp`), in its order; the others are this project's.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub enum Instruction {
    /// `a − b`
    Sub,
    /// `a + b`
    Add,
    /// `a · b`
    Mul,
    /// `a / b`, unprotected: `1 / 0` is ∞, `0 / 0` NaN.
    Div,
    /// `−a` where `a < b`, else `a`.
    NegateIfLess,
    /// `cos a`
    Cos,
    /// `sin a`
    Sin,
    /// Natural logarithm, unprotected: of 0 it is −∞, of a negative number NaN.
    Ln,
    /// `eᵃ`
    Exp,
    /// `|a|`
    Abs,
    /// `a` where `a < b`, else `b`: a NaN on either side gives `b`.
    Min,
    /// `a` where `a > b`, else `b`: a NaN on either side gives `b`.
    Max,
    /// `tan a`
    Tan,
    /// The remainder of `a / b` with the sign of `a`, as C's `fmod`, exactly. NaN where `b` is 0 or `a` infinite.
    Fmod,
    /// `a` where `b` is not 0, else −0, which adding does not notice. A NaN is not 0.
    ///
    /// Sums of gated values are choices: `x` where `c` is not 0, else `y`, is `gate(x, c) + gate(y, 1 − gate(1, c))`.
    Gate,
}

impl Instruction {
    /// Every instruction, in the order of the enumeration.
    pub const ALL: [Self; 15] = [
        Self::Sub,
        Self::Add,
        Self::Mul,
        Self::Div,
        Self::NegateIfLess,
        Self::Cos,
        Self::Sin,
        Self::Ln,
        Self::Exp,
        Self::Abs,
        Self::Min,
        Self::Max,
        Self::Tan,
        Self::Fmod,
        Self::Gate,
    ];

    /// The name in `graph.json`, in sidecars and in messages.
    pub const fn name(self) -> &'static str {
        match self {
            Self::Sub => "sub",
            Self::Add => "add",
            Self::Mul => "mul",
            Self::Div => "div",
            Self::NegateIfLess => "negate_if_less",
            Self::Cos => "cos",
            Self::Sin => "sin",
            Self::Ln => "ln",
            Self::Exp => "exp",
            Self::Abs => "abs",
            Self::Min => "min",
            Self::Max => "max",
            Self::Tan => "tan",
            Self::Fmod => "fmod",
            Self::Gate => "gate",
        }
    }

    /// The instruction of that [`name`](Self::name).
    pub fn from_name(name: &str) -> Option<Self> {
        Self::ALL.into_iter().find(|instruction| instruction.name() == name)
    }

    /// Number of operands that it reads: 1 or 2. With 1, the second operand is ignored.
    pub const fn arity(self) -> usize {
        match self {
            Self::Cos | Self::Sin | Self::Ln | Self::Exp | Self::Abs | Self::Tan => 1,
            Self::Sub | Self::Add | Self::Mul | Self::Div => 2,
            Self::NegateIfLess | Self::Min | Self::Max | Self::Fmod | Self::Gate => 2,
        }
    }

    /// Returns true of sine, cosine, tangent, logarithm and exponential: the business of [`Maths`], and expensive.
    pub const fn is_transcendental(self) -> bool {
        matches!(self, Self::Cos | Self::Sin | Self::Tan | Self::Ln | Self::Exp)
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
