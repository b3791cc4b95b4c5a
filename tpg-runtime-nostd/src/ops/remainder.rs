//! The remainder of a division, exactly.
//!
//! A number is an integer times a power of two. So a remainder needs no rounding: the dividend's integer is divided by the
//! divisor's, then what is left of it is shifted and divided again, as many bits at once as fit a word, until both have the
//! divisor's power. The C template `fmod.c` of `tpg-codegen` holds the same steps.
// It is compiled alone, too, where generated code is verified: nothing here may depend on the rest of the crate.

use super::own::f32::{INFINITY, LEAST_NORMAL, MAGNITUDE, NAN, choose, mask};

macro_rules! fmod {
    ($fmod:ident, $float:ident, $word:ident) => {
        /// The remainder of `a / b` with the sign of `a`. NaN where `a` is infinite, `b` is 0, or one of them is NaN.
        #[inline]
        pub(crate) fn $fmod(a: $float, b: $float) -> $float {
            /// Bits behind a number's first one.
            const FRACTION: u32 = $float::MANTISSA_DIGITS - 1;
            const LEAST_NORMAL: $word = 1 << FRACTION;
            const INFINITY: $word = $float::INFINITY.to_bits();
            /// Bits of a step: what is left, shifted by them, fits a word.
            const STEP: u32 = $word::BITS - $float::MANTISSA_DIGITS;

            let (dividend, divisor) = (a.abs().to_bits(), b.abs().to_bits());
            if dividend >= INFINITY || divisor > INFINITY || divisor == 0 {
                return $float::NAN;
            }
            if dividend < divisor {
                return a;
            }
            let exponent = |bits: $word| (bits >> FRACTION).max(1) as u32;
            let integer = |bits: $word| {
                let first = if bits < LEAST_NORMAL { 0 } else { LEAST_NORMAL };
                (bits & (LEAST_NORMAL - 1)) | first
            };
            let (power, modulus) = (exponent(divisor), integer(divisor));
            // The modulus is never 0; without a condition, a division would have a panic.
            let remainder = |value: $word| value.checked_rem(modulus).unwrap_or(0);
            let mut rest = remainder(integer(dividend));
            let mut left = exponent(dividend).wrapping_sub(power);
            while left > 0 {
                let step = left.min(STEP);
                rest = remainder(rest << step);
                left = left.wrapping_sub(step);
            }
            // Both products are exact.
            let value = rest as $float * ($float::EPSILON) * $float::from_bits($word::from(power as u16) << FRACTION);
            value.copysign(a)
        }
    };
}

fmod!(fmod_f32, f32, u32);
fmod!(fmod_f64, f64, u64);

/// [`fmod_f32`] without a condition: every division takes the steps of the farthest exponents there are. `top` is the place
/// of the top bit, hidden from the compiler: see [`constant_time`](super::constant_time).
#[inline]
pub(crate) fn fmod_by(top: u32, a: f32, b: f32) -> f32 {
    let (bits, dividend, divisor) = (a.to_bits(), a.to_bits() & MAGNITUDE, b.to_bits() & MAGNITUDE);
    let (integer, exponent, scaled_up) = normal(top, dividend);
    let (modulus, power, scaled_down) = normal(top, divisor);
    let above = exponent.wrapping_sub(scaled_up).wrapping_sub(power.wrapping_sub(scaled_down));
    let left = above & !mask(top, above);

    // 35 steps of up to 8 bits: exponents are at most 276 apart.
    let (rest, left) = seven_steps(top, modulus, integer, left);
    let (rest, left) = seven_steps(top, modulus, rest, left);
    let (rest, left) = seven_steps(top, modulus, rest, left);
    let (rest, left) = seven_steps(top, modulus, rest, left);
    let (rest, _) = seven_steps(top, modulus, rest, left);

    // The products are exact.
    let one_or_less = f32::from_bits(127_u32.wrapping_sub(scaled_down) << 23);
    let value = rest as f32 * f32::EPSILON * f32::from_bits((power & 0xff) << 23) * one_or_less;
    let value = value.to_bits() | (bits & !MAGNITUDE);
    let value = choose(mask(top, dividend.wrapping_sub(divisor)), bits, value);
    let infinite = mask(top, (INFINITY - 1).wrapping_sub(dividend));
    let unordered = mask(top, INFINITY.wrapping_sub(divisor));
    let zero = mask(top, divisor.wrapping_sub(1));
    f32::from_bits(value | (NAN & (infinite | unordered | zero)))
}

/// A magnitude's integer of 24 bits and its exponent, and by which power of two a subnormal one was scaled: 24, else 0.
#[inline(always)]
fn normal(top: u32, magnitude: u32) -> (u32, u32, u32) {
    let subnormal = mask(top, magnitude.wrapping_sub(LEAST_NORMAL));
    let scaled = (f32::from_bits(magnitude) * 16777216.0).to_bits();
    let bits = choose(subnormal, scaled, magnitude);
    ((bits & (LEAST_NORMAL - 1)) | LEAST_NORMAL, bits >> 23, 24 & subnormal)
}

#[inline]
fn seven_steps(top: u32, modulus: u32, mut rest: u32, mut left: u32) -> (u32, u32) {
    macro_rules! step {
        () => {
            let bits = choose(mask(top, left.wrapping_sub(8)), left, 8);
            rest = rest.wrapping_shl(bits) % (modulus | LEAST_NORMAL);
            left = left.wrapping_sub(bits);
        };
    }
    step!();
    step!();
    step!();
    step!();
    step!();
    step!();
    step!();
    (rest, left)
}

#[cfg(test)]
mod tests {
    use super::{fmod_by, fmod_f32, fmod_f64};
    use proptest::prelude::*;
    use std::vec::Vec;

    /// The language's own remainder is the reference: it is exact, too.
    macro_rules! is_exact {
        ($name:ident, $float:ident, $word:ident, $($fmod:expr),+) => {
            #[test]
            fn $name() {
                let special = [
                    0.0, 1.0, 2.5, 3.0, $float::MIN_POSITIVE, $float::from_bits(1), $float::from_bits(5), $float::MAX,
                    $float::INFINITY, $float::NAN, $float::EPSILON, $float::from_bits(7 << 20), 0.1,
                ];
                let signed: Vec<$float> = special.into_iter().flat_map(|value| [value, -value]).collect();
                let any = prop_oneof![
                    proptest::sample::select(signed),
                    any::<$word>().prop_map($float::from_bits),
                    (-2000_i16..2000).prop_map($float::from),
                ];
                proptest!(ProptestConfig::with_cases(100_000), |(a in any.clone(), b in any)| {
                    let expected = a % b;
                    for found in [$($fmod(a, b)),+] {
                        let same = found.to_bits() == expected.to_bits() || (found.is_nan() && expected.is_nan());
                        prop_assert!(same, "{a:e} {b:e}: {found:e}, not {expected:e}");
                    }
                });
            }
        };
    }

    is_exact!(f32_is_exact, f32, u32, fmod_f32, |a, b| fmod_by(31, a, b));
    is_exact!(f64_is_exact, f64, u64, fmod_f64);
}
