//! Instructions and teams' choices without a condition: on integers, by masks.
//!
//! A mask is all ones or 0: a sign, shifted over all bits. Compilers know that, and make a condition of it again (LLVM, on
//! a Cortex-M, a predicated block); so how far to shift is hidden from them, once a decision.
//!
//! The functions are those of [`ops`](super) for every operand, NaN and infinities too.

use super::{BY_ZERO, ZERO_BY_ZERO, own, remainder};
use core::hint::black_box;
use core::marker::PhantomData;

/// Computes in `S`, `f32` or `f64`.
#[derive(Clone, Copy, Debug)]
pub struct ConstantTime<S> {
    /// The place of the top bit.
    top: u32,
    scalar: PhantomData<S>,
}

macro_rules! constant_time {
    ($scalar:ident, $key:ident, $infinity:expr, $all_whole:expr) => {
        impl Default for ConstantTime<$scalar> {
            #[inline(always)]
            fn default() -> Self {
                Self { top: black_box($key::BITS - 1), scalar: PhantomData }
            }
        }

        impl ConstantTime<$scalar> {
            /// [`Instruction::Min`](super::Instruction::Min).
            #[inline(always)]
            pub fn min(self, a: $scalar, b: $scalar) -> $scalar {
                Self::choose(self.above(b, a), a, b)
            }

            /// [`Instruction::Max`](super::Instruction::Max).
            #[inline(always)]
            pub fn max(self, a: $scalar, b: $scalar) -> $scalar {
                Self::choose(self.above(a, b), a, b)
            }

            /// [`Instruction::NegateIfLess`](super::Instruction::NegateIfLess).
            #[inline(always)]
            pub fn negate_if_less(self, a: $scalar, b: $scalar) -> $scalar {
                let sign = self.above(b, a) & $key::MIN;
                $scalar::from_bits(a.to_bits() ^ sign.cast_unsigned())
            }

            /// [`Instruction::Gate`](super::Instruction::Gate).
            #[inline(always)]
            pub fn gate(self, a: $scalar, b: $scalar) -> $scalar {
                let magnitude = b.to_bits().cast_signed() & $key::MAX;
                Self::choose(self.mask(magnitude.wrapping_sub(1)), -0.0, a)
            }

            /// [`Instruction::Quotient`](super::Instruction::Quotient).
            #[inline(always)]
            pub fn quotient(self, a: $scalar, b: $scalar) -> $scalar {
                let quotient = a / b;
                // From there on, every number is whole.
                let small = self
                    .mask((quotient.to_bits().cast_signed() & $key::MAX) - $scalar::to_bits($all_whole).cast_signed());
                let within = Self::choose(small, quotient, 0.0);
                // The nearest whole number: a conversion to an integer is followed by a test.
                let all_whole: $scalar = $all_whole;
                let nearest =
                    ($scalar::from_bits(within.to_bits() & $key::MAX.cast_unsigned()) + all_whole) - all_whole;
                let whole = $scalar::from_bits(nearest.to_bits() | (within.to_bits() & $key::MIN.cast_unsigned()));
                // Less 0 is −0 of −0, and more 0 is 0.
                let floor = whole - Self::choose(self.above(whole, within), 1.0, 0.0) + 0.0;
                let of_number = Self::choose(small, floor, quotient);
                let not_positive = Self::choose(self.above(0.0, a), -(BY_ZERO as $scalar), ZERO_BY_ZERO as $scalar);
                let by_zero = Self::choose(self.above(a, 0.0), BY_ZERO as $scalar, not_positive);
                let magnitude = b.to_bits().cast_signed() & $key::MAX;
                Self::choose(self.mask(magnitude.wrapping_sub(1)), by_zero, of_number)
            }

            /// [`Instruction::Sqrt`](super::Instruction::Sqrt): of the magnitude, which no compiler tests, and NaN below 0.
            #[inline(always)]
            pub fn sqrt(self, a: $scalar) -> $scalar {
                let bits = a.to_bits().cast_signed();
                let magnitude = bits & $key::MAX;
                let negative = self.mask(bits) & !self.mask(magnitude.wrapping_sub(1));
                let root = super::sqrt($scalar::from_bits(magnitude.cast_unsigned()));
                $scalar::from_bits(
                    root.to_bits() | (bits & $key::MIN).cast_unsigned() | (negative & $key::MAX).cast_unsigned(),
                )
            }

            /// [`clamp`](super::clamp).
            #[inline(always)]
            pub fn clamp(self, value: $scalar, low: $scalar, high: $scalar, nan: $scalar) -> $scalar {
                // Differences of what is equal are 0, not −0; where the value is NaN, both choices are of no account.
                let unsigned = value + 0.0;
                let below = self.mask((unsigned - low).to_bits().cast_signed());
                let above = self.mask(((high + 0.0) - unsigned).to_bits().cast_signed());
                let limited = Self::choose(above, high, Self::choose(below, low, value));
                Self::choose(self.is_nan(value), nan, limited)
            }

            /// Returns `then` where `a` equals `b`, else `otherwise`.
            #[inline(always)]
            pub fn if_equal(self, a: u32, b: u32, then: $scalar, otherwise: $scalar) -> $scalar {
                let different = a ^ b;
                let sign = (different | different.wrapping_neg()).cast_signed();
                Self::choose(self.mask($key::from(sign)), otherwise, then)
            }

            /// Lets a challenger bid against the best so far: it wins when its bid is as high. `.1` is where the bidder
            /// leads.
            #[inline(always)]
            pub fn challenge(self, best: ($key, u32), challenger: ($key, u32)) -> ($key, u32) {
                let lower = self.below(challenger.0, best.0);
                let key = challenger.0 ^ ((challenger.0 ^ best.0) & lower);
                let to = challenger.1 ^ ((challenger.1 ^ best.1) & lower.cast_unsigned() as u32);
                (key, to)
            }

            /// All ones where a > b; a NaN is above nothing. The difference is positive: its bits, less 1, are below
            /// infinity's.
            #[inline(always)]
            fn above(self, a: $scalar, b: $scalar) -> $key {
                let bits = (a - b).to_bits().cast_signed().wrapping_sub(1);
                self.mask(bits.wrapping_sub($infinity) & !bits)
            }

            /// All ones where a < b. Saturated, the sign of a difference is right.
            #[inline(always)]
            fn below(self, a: $key, b: $key) -> $key {
                self.mask(a.saturating_sub(b))
            }

            #[inline(always)]
            fn is_nan(self, x: $scalar) -> $key {
                self.mask($infinity.wrapping_sub(x.to_bits().cast_signed() & $key::MAX))
            }

            /// All ones where x is negative, else 0.
            #[inline(always)]
            fn mask(self, x: $key) -> $key {
                x.wrapping_shr(self.top)
            }

            /// a where the mask is all ones, b where it is 0.
            #[inline(always)]
            fn choose(mask: $key, a: $scalar, b: $scalar) -> $scalar {
                let (a, b) = (a.to_bits(), b.to_bits());
                $scalar::from_bits(b ^ ((a ^ b) & mask.cast_unsigned()))
            }
        }
    };
}

constant_time!(f32, i32, 0x7f80_0000_i32, 8_388_608.0);
constant_time!(f64, i64, 0x7ff0_0000_0000_0000_i64, 4_503_599_627_370_496.0);

impl ConstantTime<f32> {
    /// A bid as an integer in the order of bids; a NaN counts as −∞.
    #[inline(always)]
    pub fn order(self, bid: f32) -> i32 {
        // −0 becomes 0. Then the bits of numbers are in their order, those of negative numbers once they are inverted.
        let bits = (bid + 0.0).to_bits();
        let order = bits ^ (self.mask(bits.cast_signed()).cast_unsigned() >> 1);
        // So that infinity is the highest integer, and a positive NaN wraps round: no NaN is above −∞ any more, and saturated all are
        // the same.
        order.wrapping_add(0x007f_ffff).cast_signed().saturating_sub(0x00ff_fffe)
    }
}

impl ConstantTime<f64> {
    /// A bid as an integer in the order of bids; a NaN counts as −∞.
    #[inline(always)]
    pub fn order(self, bid: f64) -> i64 {
        let unordered = self.is_nan(bid);
        let bits = bid.to_bits().cast_signed();
        let negative = self.mask(bits);
        // 0 for −0.
        let order = ((bits & i64::MAX) ^ negative).wrapping_sub(negative);
        (order & !unordered).wrapping_sub(0x7ff0_0000_0000_0000 & unordered)
    }
}

/// Implements own maths by the kernels of [`own::f32`] that make masks, too.
macro_rules! own_maths {
    ($($function:ident = $kernel:ident, $about:literal;)+) => {
        impl ConstantTime<f32> {
            $(
                #[doc = $about]
                #[inline(always)]
                pub fn $function(self, x: f32) -> f32 {
                    own::f32::$kernel(self.top, x)
                }
            )+
        }
    };
}

own_maths! {
    sin = sin_by, "Sine of `x` radians.";
    cos = cos_by, "Cosine of `x` radians.";
    tan = tan_by, "Tangent of `x` radians.";
    ln = ln_by, "Natural logarithm.";
    exp = exp_by, "Exponential.";
    atan = atan_by, "Arctangent.";
    tanh = tanh_by, "Hyperbolic tangent.";
}

impl ConstantTime<f32> {
    /// [`Instruction::Fmod`](super::Instruction::Fmod).
    #[inline(always)]
    pub fn fmod(self, a: f32, b: f32) -> f32 {
        remainder::fmod_by(self.top, a, b)
    }
}

impl ConstantTime<f64> {
    /// [`Instruction::Fmod`](super::Instruction::Fmod). This one loops: it takes the steps that the exponents need.
    #[inline(always)]
    pub fn fmod(self, a: f64, b: f64) -> f64 {
        remainder::fmod_f64(a, b)
    }
}

#[cfg(test)]
mod tests {
    use super::ConstantTime;
    use crate::ops;
    use proptest::prelude::*;

    macro_rules! as_ops {
        ($name:ident, $scalar:ident, $bits:ident, $special:expr) => {
            #[test]
            fn $name() {
                let special: [$scalar; _] = $special;
                let any = prop_oneof![proptest::sample::select(special.to_vec()), any::<$bits>().prop_map($scalar::from_bits)];
                proptest!(ProptestConfig::with_cases(20_000), |(a in any.clone(), b in any)| {
                    let ct = ConstantTime::<$scalar>::default();
                    prop_assert_eq!(ct.min(a, b).to_bits(), ops::min(a, b).to_bits());
                    prop_assert_eq!(ct.max(a, b).to_bits(), ops::max(a, b).to_bits());
                    prop_assert_eq!(ct.negate_if_less(a, b).to_bits(), ops::negate_if_less(a, b).to_bits());
                    prop_assert_eq!(ct.gate(a, b).to_bits(), ops::gate(a, b).to_bits());
                    let (quotient, expected) = (ct.quotient(a, b), ops::quotient(a, b));
                    prop_assert!(quotient.to_bits() == expected.to_bits() || (quotient.is_nan() && expected.is_nan()));
                    let (root, expected) = (ct.sqrt(a), ops::sqrt(a));
                    prop_assert!(root.to_bits() == expected.to_bits() || (root.is_nan() && expected.is_nan()));
                    let (rest, expected) = (ct.fmod(a, b), ops::fmod(a, b));
                    prop_assert!(rest.to_bits() == expected.to_bits() || (rest.is_nan() && expected.is_nan()));
                    for (low, high, nan) in [(-1.0, 1.0, 0.0), (-0.0, 0.0, -0.0), (0.0, $scalar::MAX, 0.0), (2.0, 3.0, 3.0)] {
                        let expected = ops::clamp(a, low, high, nan);
                        prop_assert_eq!(ct.clamp(a, low, high, nan).to_bits(), expected.to_bits());
                    }
                    prop_assert_eq!(ct.if_equal(3, 3, a, b).to_bits(), a.to_bits());
                    prop_assert_eq!(ct.if_equal(3, 3 + (1 << 31), a, b).to_bits(), b.to_bits());
                    let (_, to) = ct.challenge((ct.order(a), 1), (ct.order(b), 2));
                    prop_assert_eq!(to, ops::challenge((ops::bid(a), 1), (ops::bid(b), 2)).1);
                });
            }
        };
    }

    const SPECIAL: [f32; 12] = [
        0.0,
        -0.0,
        1.0,
        -1.0,
        f32::MIN_POSITIVE,
        1e-45,
        -1e-45,
        f32::MAX,
        f32::MIN,
        f32::INFINITY,
        f32::NEG_INFINITY,
        f32::NAN,
    ];

    as_ops!(f32_is_as_ops, f32, u32, SPECIAL);
    as_ops!(f64_is_as_ops, f64, u64, SPECIAL.map(f64::from));

    #[test]
    fn own_maths_is_the_same() {
        let ct = ConstantTime::<f32>::default();
        for x in (0..=u32::MAX).step_by(9973).map(f32::from_bits).chain(SPECIAL) {
            use ops::own::f32::{atan, cos, exp, ln, sin, tan, tanh};
            let own = [sin(x), cos(x), tan(x), ln(x), exp(x), atan(x), tanh(x)];
            let masked = [ct.sin(x), ct.cos(x), ct.tan(x), ct.ln(x), ct.exp(x), ct.atan(x), ct.tanh(x)];
            assert_eq!(masked.map(f32::to_bits), own.map(f32::to_bits), "{x:e}");
        }
    }
}
