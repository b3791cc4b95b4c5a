//! The kernels in `f32`. No operation is wider than `f32` and `u64`: a Cortex-M4F runs all of it in hardware.

use core::f32::consts::{FRAC_PI_2, FRAC_PI_4};

/// The place of the top bit.
pub(in crate::ops) const TOP: u32 = 31;
/// Everything but the sign.
pub(in crate::ops) const MAGNITUDE: u32 = 0x7fff_ffff;
pub(in crate::ops) const SIGN: u32 = 0x8000_0000;
pub(in crate::ops) const FRACTION: u32 = 0x007f_ffff;
/// The least normal number, and also the bit below which the exponent begins.
pub(in crate::ops) const LEAST_NORMAL: u32 = 0x0080_0000;
const INFINITY: u32 = 0x7f80_0000;
const MINUS_INFINITY: u32 = 0xff80_0000;
const NAN: u32 = 0x7fc0_0000;

/// `floor(2/π · 2^(8i + 5)) mod 2³²`: a window on the bits of 2/π for every byte of the exponent, so that no word needs
/// to be shifted after loading. The zeros are never read: they make a place of every number of five bits and 8.
pub const TWO_OVER_PI: [u32; 40] = [
    0x0000_0014,
    0x0000_145f,
    0x0014_5f30,
    0x145f_306d,
    0x5f30_6dc9,
    0x306d_c9c8,
    0x6dc9_c882,
    0xc9c8_82a5,
    0xc882_a53f,
    0x82a5_3f84,
    0xa53f_84ea,
    0x3f84_eafa,
    0x84ea_fa3e,
    0xeafa_3ea6,
    0xfa3e_a69b,
    0x3ea6_9bb8,
    0xa69b_b81b,
    0x9bb8_1b6c,
    0xb81b_6c52,
    0x1b6c_52b3,
    0x6c52_b327,
    0x52b3_2788,
    0xb327_8872,
    0x2788_7208,
    0x8872_083f,
    0,
    0,
    0,
    0,
    0,
    0,
    0,
    0,
    0,
    0,
    0,
    0,
    0,
    0,
    0,
];

/// `floor(π/2 · 2³¹)`.
pub const HALF_PI: u64 = 0xc90f_daa2;

/// Row 0: `sin r = r + r·s·P(s)`, row 1: `cos r = 1 + 1·s·P(s)`, both for `s = r²`, `|r| ≤ π/4`;
/// relative errors of the polynomials 2.0e-10 and 1.2e-10.
pub const CIRCLE: [[f32; 4]; 2] =
    [[-0.16666667, 0.008333372, -0.00019849911, 2.800547e-6], [-0.5, 0.041666646, -0.0013887311, 2.4432566e-5]];

/// ln 2, the first part short enough that its product with an exponent is exact.
pub const LN_2_HIGH: f32 = 0.69314575;
/// The rest of ln 2 behind [`LN_2_HIGH`].
pub const LN_2_LOW: f32 = 1.4286068e-6;

/// `ln((1 + s) / (1 − s)) = 2·s + s·w·P(w)` for `w = s²`, from the constant term on.
pub const LN: [f32; 3] = [0.66666776, 0.39977583, 0.2987083];

/// `eʳ = 1 + (r + r²·P(r))` for `|r| ≤ ½ ln 2`, from the constant term on.
pub const EXP: [f32; 5] = [0.4999999, 0.16666521, 0.041668963, 0.008368675, 0.0013782504];

/// `arctan t = t + t·s·P(s)` for `s = t²`, `|t| ≤ √2 − 1`; relative error of the polynomial 2.1e-8.
pub const ATAN: [f32; 4] = [-0.3333295, 0.19977732, -0.13877875, 0.08054265];

/// π/4 and π/2, and what is missing from each.
pub const QUARTERS: [[f32; 2]; 2] = [[FRAC_PI_4, -2.1855694e-8], [FRAC_PI_2, -4.371139e-8]];

/// `tanh a = a + a·s·P(s)` for `s = a²`, `|a| ≤ 0.55`; relative error of the polynomial 3.7e-8.
pub const TANH: [f32; 4] = [-0.33332947, 0.13320726, -0.052671693, 0.0164371];

/// Sine of `x` radians: off by at most 8.8e-8, and by at most 1.5 ulp, for every finite `x`; odd, and never beyond ±1.
#[inline]
pub fn sin(x: f32) -> f32 {
    sin_by(TOP, x)
}

#[inline(always)]
pub(in crate::ops) fn sin_by(top: u32, x: f32) -> f32 {
    let bits = x.to_bits();
    let of_magnitude = circle(top, bits & MAGNITUDE, 0x2000_0000);
    f32::from_bits(of_magnitude ^ (bits & SIGN))
}

/// Cosine of `x` radians: off by at most 8.8e-8, and by at most 1.5 ulp, for every finite `x`; even, and never
/// beyond ±1.
#[inline]
pub fn cos(x: f32) -> f32 {
    cos_by(TOP, x)
}

#[inline(always)]
pub(in crate::ops) fn cos_by(top: u32, x: f32) -> f32 {
    f32::from_bits(circle(top, x.to_bits() & MAGNITUDE, 0x6000_0000))
}

/// Tangent of `x` radians: sine by cosine, off by at most 3.5 ulp for every finite `x`; odd.
#[inline]
pub fn tan(x: f32) -> f32 {
    tan_by(TOP, x)
}

#[inline(always)]
pub(in crate::ops) fn tan_by(top: u32, x: f32) -> f32 {
    sin_by(top, x) / cos_by(top, x)
}

/// All ones where the top bit is set, else 0. Masks rather than conditions, where a compiler would branch. `top` is
/// [`TOP`], which a caller may hide from the compiler: see [`constant_time`](crate::ops::constant_time).
#[inline(always)]
pub(in crate::ops) fn mask(top: u32, bits: u32) -> u32 {
    bits.cast_signed().wrapping_shr(top).cast_unsigned()
}

/// `a` where the mask is all ones, `b` where it is 0.
#[inline(always)]
pub(in crate::ops) fn choose(mask: u32, a: u32, b: u32) -> u32 {
    b ^ ((a ^ b) & mask)
}

/// The bits of `sin(a + offset − ⅛ turn)`, `a` given by its bits and the offset in 2⁻³² turns.
///
/// With an eighth of a turn added, the quadrant nearest to the angle is in the top two bits of the sum.
#[inline]
fn circle(top: u32, magnitude: u32, offset: u32) -> u32 {
    // a = mantissa · 2^(8·byte + 125 − 150). Everything below ¼ is taken for something in [¼, ½): only the quadrant of
    // such an angle is used, and that is right.
    // (The last mask is for the compiler, which sees the index in its range and leaves out the check.)
    let above = (magnitude >> 23).wrapping_sub(125);
    let exponent = above & !mask(top, above) & 0xff;
    let byte = (exponent >> 3) as usize;
    let mantissa = u64::from(((magnitude & FRACTION) | LEAST_NORMAL) << (exponent & 7));

    // a · 2/π modulo 4 in units of 2⁻⁶²: the product of the mantissa with those 96 bits of 2/π that matter. Higher ones
    // would add whole turns, lower ones less than a unit.
    let high = mantissa.wrapping_mul(u64::from(TWO_OVER_PI[byte])) << 32;
    let middle = mantissa.wrapping_mul(u64::from(TWO_OVER_PI[byte + 4]));
    let low = mantissa.wrapping_mul(u64::from(TWO_OVER_PI[byte + 8])) >> 32;
    let angle = high.wrapping_add(middle).wrapping_add(low);

    wave(top, magnitude, angle, offset, |turn| CIRCLE[((turn >> 30) & 1) as usize])
}

/// The bits of `sin(a + offset − ⅛ turn)`, `a` given by its bits and as an angle in units of 2⁻⁶² quadrants; `row` returns the row of
/// [`CIRCLE`] for a quadrant, which is in the top two bits.
#[inline(always)]
pub(in crate::ops) fn wave(
    top: u32,
    magnitude: u32,
    angle: u64,
    offset: u32,
    row: impl FnOnce(u32) -> [f32; 4],
) -> u32 {
    // The quadrant, and the signed distance from its middle with its sign taken off. (Ones' complement: a unit is lost.)
    let turn = ((angle >> 32) as u32).wrapping_add(offset);
    let distance = (turn & 0x3fff_ffff).wrapping_sub(0x2000_0000);
    let negative = mask(top, distance);
    let distance_high = u64::from(distance ^ negative);
    let distance_low = u64::from((angle as u32) ^ negative);

    // Times π/2, in units of 2⁻⁶¹ radians, then to a float with one rounding that counts: the upper 24 bits are exact.
    let radians = distance_high.wrapping_mul(HALF_PI).wrapping_add(distance_low.wrapping_mul(HALF_PI) >> 32);
    let upper = (radians >> 37) as u32 as f32;
    let lower = (radians >> 5) as u32 as f32;
    let upper = upper * 5.9604645e-8; // 2⁻²⁴
    let lower = lower * 1.3877788e-17; // 2⁻⁵⁶
    let reduced = (upper + lower).to_bits() | (distance & SIGN);

    // What is below ¾ needs no reduction, and must not lose its own bits to one.
    let small = mask(top, magnitude.wrapping_sub(0x3f40_0000));
    let r = f32::from_bits(choose(small, magnitude, reduced));

    // Odd quadrants are the cosine's.
    let base = f32::from_bits(choose(mask(top, turn << 1), 1.0_f32.to_bits(), r.to_bits()));
    let [c0, c1, c2, c3] = row(turn);
    let s = r * r;
    let p = (((c3 * s + c2) * s + c1) * s + c0) * s * base;

    // Zero, unless infinity or NaN make it NaN.
    let zero = f32::from_bits(magnitude) * 0.0;
    let p = p + zero;
    let value = base + p;

    // The lower half turn is negative.
    value.to_bits() ^ (turn & SIGN)
}

/// Natural logarithm: off by at most 0.96 ulp; of ±0 it is −∞, of a negative number NaN.
#[inline]
pub fn ln(x: f32) -> f32 {
    ln_by(TOP, x)
}

#[inline(always)]
pub(in crate::ops) fn ln_by(top: u32, x: f32) -> f32 {
    let bits = x.to_bits();

    // x = m · 2^exponent with √½ ≤ m < √2, a subnormal number being scaled up first.
    let scaled = (x * 8388608.0).to_bits();
    let small = mask(top, bits.wrapping_sub(LEAST_NORMAL));
    let normal = choose(small, scaled, bits);
    let bias = 127 + (23 & small) as i32;
    let shifted = normal.wrapping_add(0x3f80_0000 - 0x3f35_04f3);
    let exponent = ((shifted >> 23) as i32).wrapping_sub(bias) as f32;
    let m = f32::from_bits((shifted & FRACTION).wrapping_add(0x3f35_04f3));

    // ln(1 + f) = 2 artanh(s) = 2s + s·R(s²) for s = f / (2 + f); and 2s = f − s·f, where f is exact.
    let f = m - 1.0;
    let g = f + 2.0;
    let s = f / g;
    let w = s * s;
    let [c0, c1, c2] = LN;
    let p = (f - ((c2 * w + c1) * w + c0) * w) * s;
    let low = exponent * LN_2_LOW;
    let p = f - (p - low);
    let high = exponent * LN_2_HIGH;
    let value = (high + p).to_bits();

    // What is not in 1..INFINITY: infinity and NaN stay, zeros and what is negative have values of their own.
    let before = bits.wrapping_sub(1);
    let special = mask(top, before | (INFINITY - 2).wrapping_sub(before));
    let zero = mask(top, (bits & MAGNITUDE).wrapping_sub(1));
    let limit = choose(zero, MINUS_INFINITY, bits | (mask(top, bits) & NAN));
    f32::from_bits(choose(special, limit, value))
}

/// `eˣ`: off by at most 1 ulp, subnormal results included; +∞ from 88.722_84 on, 0 below −103.972_08.
#[inline]
pub fn exp(x: f32) -> f32 {
    exp_by(TOP, x)
}

#[inline(always)]
pub(in crate::ops) fn exp_by(top: u32, x: f32) -> f32 {
    // 1.5 · 2²³: adding it leaves the nearest integer in the low bits of the sum.
    const ROUND: f32 = 12582912.0;
    const ROUND_BITS: u32 = 0x4b40_0000;
    const LIMIT: u32 = 0x42d0_0000; // 104

    // Beyond ±104 nothing changes any more; NaN is put back at the end.
    let bits = x.to_bits();
    let magnitude = bits & MAGNITUDE;
    let limited = choose(mask(top, magnitude.wrapping_sub(LIMIT)), magnitude, LIMIT);
    let a = f32::from_bits(limited | (bits & SIGN));

    // x = n·ln 2 + r with |r| ≤ ½ ln 2.
    let sum = a * core::f32::consts::LOG2_E + ROUND;
    let n = sum - ROUND;
    let high = n * LN_2_HIGH;
    let low = n * LN_2_LOW;
    let r = a - high - low;

    // eʳ = 1 + (r + r²·P(r)).
    let [c0, c1, c2, c3, c4] = EXP;
    let p = ((((c4 * r + c3) * r + c2) * r + c1) * r + c0) * r * r + r + 1.0;

    // Times 2ⁿ as two powers of two: the first product is exact, the second rounds once, if at all.
    let biased = sum.to_bits().wrapping_sub(ROUND_BITS - 2 * 127);
    let half = biased >> 1;
    let value = p * f32::from_bits(half << 23);
    let value = value * f32::from_bits(biased.wrapping_sub(half) << 23);

    let not_a_number = mask(top, INFINITY.wrapping_sub(magnitude));
    f32::from_bits(value.to_bits() | (not_a_number & NAN))
}

/// Arctangent: off by at most 2.1 ulp; odd.
#[inline]
pub fn atan(x: f32) -> f32 {
    atan_by(TOP, x)
}

#[inline(always)]
pub(in crate::ops) fn atan_by(top: u32, x: f32) -> f32 {
    let bits = x.to_bits();
    let magnitude = bits & MAGNITUDE;
    let a = f32::from_bits(magnitude);

    // arctan a = π/4 + arctan((a − 1) / (a + 1)) = π/2 + arctan(−1 / a): whichever leaves a small argument.
    let low = mask(top, magnitude.wrapping_sub(0x3ed4_13cd)); // √2 − 1
    let high = mask(top, 0x401a_827a_u32.wrapping_sub(magnitude)); // √2 + 1
    let pick = |of_low: f32, of_middle: f32, of_high: f32| {
        f32::from_bits(choose(low, of_low.to_bits(), choose(high, of_high.to_bits(), of_middle.to_bits())))
    };
    let [[quarter, quarter_rest], [half, half_rest]] = QUARTERS;
    let above = pick(a, a - 1.0, -1.0);
    let below = pick(1.0, a + 1.0, a);
    let t = above / below;
    let offset = pick(0.0, quarter, half);
    let rest = pick(0.0, quarter_rest, half_rest);

    let [c0, c1, c2, c3] = ATAN;
    let s = t * t;
    let p = t + ((((c3 * s + c2) * s + c1) * s + c0) * s * t + rest);
    let value = offset + p;
    f32::from_bits(value.to_bits() | (bits & SIGN))
}

/// Hyperbolic tangent: off by at most 1.5 ulp; odd, and never beyond ±1.
#[inline]
pub fn tanh(x: f32) -> f32 {
    tanh_by(TOP, x)
}

#[inline(always)]
pub(in crate::ops) fn tanh_by(top: u32, x: f32) -> f32 {
    let bits = x.to_bits();
    let magnitude = bits & MAGNITUDE;
    let a = f32::from_bits(magnitude);

    // 1 − 2 / (e²ᵃ + 1), where that does not cancel.
    let grown = exp_by(top, a + a);
    let part = 2.0 / (grown + 1.0);
    let far = 1.0 - part;

    let [c0, c1, c2, c3] = TANH;
    let s = a * a;
    let p = (((c3 * s + c2) * s + c1) * s + c0) * s * a;
    let near = a + p;

    let small = mask(top, magnitude.wrapping_sub(0x3f0c_cccd)); // 0.55
    f32::from_bits(choose(small, near.to_bits(), far.to_bits()) | (bits & SIGN))
}
