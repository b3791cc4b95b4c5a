//! Sine, cosine, tangent, logarithm, exponential, arctangent and hyperbolic tangent without loops.
//!
//! Everything is computed whatever the argument: no condition decides what is executed, so that a program has one
//! instruction count. The statements are in the order of the operations, none of which is fused or reassociated, and the
//! C templates `own_f32.c` and `own_f64.c` of `tpg-codegen` hold the same ones, with tables and coefficients that are printed
//! from the constants here: the bits are the same on every machine that rounds to nearest.
//!
//! # Method
//!
//! * **Sine and cosine** reduce every finite argument exactly, in integers (Payne and Hanek, *Radian reduction for
//!   trigonometric functions*, 1983): the mantissa times a window on the bits of 2/π is the angle in quadrants, modulo 4,
//!   as a fixed-point number. Its upper bits are the quadrant; what is left, times π/2, goes into one of two polynomials,
//!   chosen as a row of coefficients.
//! * **Tangent** is sine by cosine, which is never 0.
//! * **Logarithm**: `ln(2ᵏ·m) = k·ln 2 + 2·artanh((m − 1) / (m + 1))` for `√½ ≤ m < √2`.
//! * **Exponential**: `eˣ = 2ⁿ·eʳ` with `n` the integer nearest to `x / ln 2`.
//! * **Arctangent**: `π/4 + arctan((a − 1) / (a + 1))` or `π/2 + arctan(−1 / a)` where that leaves a smaller argument, then a
//!   polynomial.
//! * **Hyperbolic tangent**: `1 − 2 / (e²ᵃ + 1)`, and a polynomial below 0.55.
//!
//! Polynomials are minimax fits of Sollya's `fpminimax`; `tests/fixtures/own_maths/coefficients.sollya` derives them.
//!
//! # Error bounds
//!
//! In `f32` over every argument there is, in `f64` over the references in `tests/fixtures/own_maths` and 30 million
//! random arguments against 64-bit mantissas; `tests/own_maths.rs` measures them again.
//!
//! | | `f32` | `f64` |
//! | --- | --- | --- |
//! | `sin`, `cos` | 8.8e-8, 1.5 ulp | 1.7e-16, 1.5 ulp |
//! | `tan` | 3.5 ulp | 3.5 ulp |
//! | `ln` | 0.96 ulp | 0.96 ulp |
//! | `exp` | 1 ulp | 1 ulp |
//! | `atan` | 2.1 ulp | 2.5 ulp |
//! | `tanh` | 1.5 ulp | 2.5 ulp |
//!
//! `sin` is odd, keeps the sign of zero and never leaves [−1, 1]; so is `tanh`; `cos` is even. Infinities give what IEEE 754
//! recommends, NaN gives NaN.
// It is compiled alone, too, where generated code is verified: nothing here may depend on the rest of the crate.

/// A polynomial, given from the constant term on, by Horner's rule.
macro_rules! polynomial {
    ($x:ident, $last:ident) => {
        $last
    };
    ($x:ident, $first:ident $($rest:ident)+) => {
        polynomial!($x, $($rest)+) * $x + $first
    };
}

/// Defines the kernels of a scalar type, by the constants and the function `circle` beside them. The lists name the coefficients of
/// the polynomials for `ln`, `exp`, `atan` and `tanh`.
///
/// Masks stand where a compiler would branch for a condition. `top` is the place of the top bit, which a caller may hide from the
/// compiler: see [`constant_time`](crate::ops::constant_time).
macro_rules! kernels {
    ($float:ident, $bits:ident, [$($ln:ident)+], [$($exp:ident)+], [$($atan:ident)+], [$($tanh:ident)+]) => {
        /// The place of the top bit.
        pub(in crate::ops) const TOP: u32 = $bits::BITS - 1;
        /// Everything but the sign.
        pub(in crate::ops) const MAGNITUDE: $bits = $bits::MAX >> 1;
        pub(in crate::ops) const SIGN: $bits = !MAGNITUDE;
        /// Bits of a number's fraction.
        const DIGITS: u32 = $float::MANTISSA_DIGITS - 1;
        /// The least normal number, and also the bit below which the exponent begins.
        pub(in crate::ops) const LEAST_NORMAL: $bits = 1 << DIGITS;
        pub(in crate::ops) const FRACTION: $bits = LEAST_NORMAL - 1;
        const BIAS: $bits = $float::MAX_EXP as $bits - 1;
        pub(in crate::ops) const INFINITY: $bits = MAGNITUDE - FRACTION;
        pub(in crate::ops) const NAN: $bits = INFINITY | LEAST_NORMAL >> 1;

        /// Sine of `x` radians: odd, and never beyond ±1.
        #[inline]
        pub fn sin(x: $float) -> $float {
            sin_by(TOP, x)
        }

        #[inline(always)]
        pub(in crate::ops) fn sin_by(top: u32, x: $float) -> $float {
            let bits = x.to_bits();
            let of_magnitude = circle(top, bits & MAGNITUDE, 1 << ($bits::BITS - 3));
            $float::from_bits(of_magnitude ^ (bits & SIGN))
        }

        /// Cosine of `x` radians: even, and never beyond ±1.
        #[inline]
        pub fn cos(x: $float) -> $float {
            cos_by(TOP, x)
        }

        #[inline(always)]
        pub(in crate::ops) fn cos_by(top: u32, x: $float) -> $float {
            $float::from_bits(circle(top, x.to_bits() & MAGNITUDE, 3 << ($bits::BITS - 3)))
        }

        /// Tangent of `x` radians: sine by cosine; odd.
        #[inline]
        pub fn tan(x: $float) -> $float {
            tan_by(TOP, x)
        }

        #[inline(always)]
        pub(in crate::ops) fn tan_by(top: u32, x: $float) -> $float {
            sin_by(top, x) / cos_by(top, x)
        }

        /// All ones where the top bit is set, else 0.
        #[inline(always)]
        pub(in crate::ops) fn mask(top: u32, bits: $bits) -> $bits {
            bits.cast_signed().wrapping_shr(top).cast_unsigned()
        }

        /// `a` where the mask is all ones, `b` where it is 0.
        #[inline(always)]
        pub(in crate::ops) fn choose(mask: $bits, a: $bits, b: $bits) -> $bits {
            b ^ ((a ^ b) & mask)
        }

        /// Natural logarithm; of ±0 it is −∞, of a negative number NaN.
        #[inline]
        pub fn ln(x: $float) -> $float {
            ln_by(TOP, x)
        }

        #[inline(always)]
        pub(in crate::ops) fn ln_by(top: u32, x: $float) -> $float {
            let bits = x.to_bits();

            // x = m · 2^exponent with √½ ≤ m < √2, a subnormal number being scaled up first.
            let scaled = (x * (1_u64 << SCALE) as $float).to_bits();
            let small = mask(top, bits.wrapping_sub(LEAST_NORMAL));
            let normal = choose(small, scaled, bits);
            let bias = (BIAS + (SCALE & small)) as i32;
            let shifted = normal.wrapping_add((BIAS << DIGITS) - ROOT_OF_HALF);
            let exponent = ((shifted >> DIGITS) as i32).wrapping_sub(bias) as $float;
            let m = $float::from_bits((shifted & FRACTION).wrapping_add(ROOT_OF_HALF));

            // ln(1 + f) = 2 artanh(s) = 2s + s·R(s²) for s = f / (2 + f); and 2s = f − s·f, where f is exact.
            let f = m - 1.0;
            let g = f + 2.0;
            let s = f / g;
            let w = s * s;
            let [$($ln),+] = LN;
            let p = (f - (polynomial!(w, $($ln)+)) * w) * s;
            let low = exponent * LN_2_LOW;
            let p = f - (p - low);
            let high = exponent * LN_2_HIGH;
            let value = (high + p).to_bits();

            // What is not in 1..INFINITY: infinity and NaN stay, zeros and what is negative have values of their own.
            let before = bits.wrapping_sub(1);
            let special = mask(top, before | (INFINITY - 2).wrapping_sub(before));
            let zero = mask(top, (bits & MAGNITUDE).wrapping_sub(1));
            let limit = choose(zero, INFINITY | SIGN, bits | (mask(top, bits) & NAN));
            $float::from_bits(choose(special, limit, value))
        }

        /// `eˣ`, subnormal results included.
        #[inline]
        pub fn exp(x: $float) -> $float {
            exp_by(TOP, x)
        }

        #[inline(always)]
        pub(in crate::ops) fn exp_by(top: u32, x: $float) -> $float {
            // Adding it leaves the nearest integer in the low bits of the sum.
            const ROUND: $float = (3_u64 << (DIGITS - 1)) as $float;

            // Beyond the limit nothing changes any more; NaN is put back at the end.
            let bits = x.to_bits();
            let magnitude = bits & MAGNITUDE;
            let limit = EXP_LIMIT.to_bits();
            let limited = choose(mask(top, magnitude.wrapping_sub(limit)), magnitude, limit);
            let a = $float::from_bits(limited | (bits & SIGN));

            // x = n·ln 2 + r with |r| ≤ ½ ln 2.
            let sum = a * core::$float::consts::LOG2_E + ROUND;
            let n = sum - ROUND;
            let high = n * LN_2_HIGH;
            let low = n * LN_2_LOW;
            let r = a - high - low;

            // eʳ = 1 + (r + r²·P(r)).
            let [$($exp),+] = EXP;
            let p = (polynomial!(r, $($exp)+)) * r * r + r + 1.0;

            // Times 2ⁿ as two powers of two: the first product is exact, the second rounds once, if at all.
            let biased = sum.to_bits().wrapping_sub(ROUND.to_bits() - 2 * BIAS);
            let half = biased >> 1;
            let value = p * $float::from_bits(half << DIGITS);
            let value = value * $float::from_bits(biased.wrapping_sub(half) << DIGITS);

            let not_a_number = mask(top, INFINITY.wrapping_sub(magnitude));
            $float::from_bits(value.to_bits() | (not_a_number & NAN))
        }

        /// Arctangent; odd.
        #[inline]
        pub fn atan(x: $float) -> $float {
            atan_by(TOP, x)
        }

        #[inline(always)]
        pub(in crate::ops) fn atan_by(top: u32, x: $float) -> $float {
            let bits = x.to_bits();
            let magnitude = bits & MAGNITUDE;
            let a = $float::from_bits(magnitude);

            // arctan a = π/4 + arctan((a − 1) / (a + 1)) = π/2 + arctan(−1 / a): whichever leaves a small argument.
            let low = mask(top, magnitude.wrapping_sub(ATAN_LOW));
            let high = mask(top, ATAN_HIGH.wrapping_sub(magnitude));
            let pick = |of_low: $float, of_middle: $float, of_high: $float| {
                $float::from_bits(choose(low, of_low.to_bits(), choose(high, of_high.to_bits(), of_middle.to_bits())))
            };
            let [[quarter, quarter_rest], [half, half_rest]] = QUARTERS;
            let above = pick(a, a - 1.0, -1.0);
            let below = pick(1.0, a + 1.0, a);
            let t = above / below;
            let offset = pick(0.0, quarter, half);
            let rest = pick(0.0, quarter_rest, half_rest);

            let [$($atan),+] = ATAN;
            let s = t * t;
            let p = t + ((polynomial!(s, $($atan)+)) * s * t + rest);
            let value = offset + p;
            $float::from_bits(value.to_bits() | (bits & SIGN))
        }

        /// Hyperbolic tangent: odd, and never beyond ±1.
        #[inline]
        pub fn tanh(x: $float) -> $float {
            tanh_by(TOP, x)
        }

        #[inline(always)]
        pub(in crate::ops) fn tanh_by(top: u32, x: $float) -> $float {
            let bits = x.to_bits();
            let magnitude = bits & MAGNITUDE;
            let a = $float::from_bits(magnitude);

            // 1 − 2 / (e²ᵃ + 1), where that does not cancel.
            let grown = exp_by(top, a + a);
            let part = 2.0 / (grown + 1.0);
            let far = 1.0 - part;

            let [$($tanh),+] = TANH;
            let s = a * a;
            let p = (polynomial!(s, $($tanh)+)) * s * a;
            let near = a + p;

            let small = mask(top, magnitude.wrapping_sub(TANH_NEAR));
            $float::from_bits(choose(small, near.to_bits(), far.to_bits()) | (bits & SIGN))
        }
    };
}

pub mod f32;
pub mod f64;
