//! The kernels in `f64`. On a core without doubles each operation is a call, but there is no loop all the same.

use core::f64::consts::{FRAC_PI_2, FRAC_PI_4};

/// Everything but the sign.
pub(in crate::ops) const MAGNITUDE: u64 = 0x7fff_ffff_ffff_ffff;
pub(in crate::ops) const SIGN: u64 = 0x8000_0000_0000_0000;
pub(in crate::ops) const FRACTION: u64 = 0x000f_ffff_ffff_ffff;
/// The least normal number, and also the bit below which the exponent begins.
pub(in crate::ops) const LEAST_NORMAL: u64 = 0x0010_0000_0000_0000;
const INFINITY: u64 = 0x7ff0_0000_0000_0000;
const MINUS_INFINITY: u64 = 0xfff0_0000_0000_0000;
const NAN: u64 = 0x7ff8_0000_0000_0000;

/// The bits of 2/π: 64 zeros, then those behind the binary point.
pub const TWO_OVER_PI: [u32; 39] = [
    0x0000_0000,
    0x0000_0000,
    0xa2f9_836e,
    0x4e44_1529,
    0xfc27_57d1,
    0xf534_ddc0,
    0xdb62_9599,
    0x3c43_9041,
    0xfe51_63ab,
    0xdebb_c561,
    0xb724_6e3a,
    0x424d_d2e0,
    0x0649_2eea,
    0x09d1_921c,
    0xfe1d_eb1c,
    0xb129_a73e,
    0xe882_35f5,
    0x2ebb_4484,
    0xe99c_7026,
    0xb45f_7e41,
    0x3991_d639,
    0x8353_39f4,
    0x9c84_5f8b,
    0xbdf9_283b,
    0x1ff8_97ff,
    0xde05_980f,
    0xef2f_118b,
    0x5a0a_6d1f,
    0x6d36_7ecf,
    0x27cb_09b7,
    0x4f46_3f66,
    0x9e5f_ea2d,
    0x7527_bac7,
    0xebe5_f17b,
    0x3d07_39f7,
    0x8a52_92ea,
    0x6bfb_5fb1,
    0x1f8d_5d08,
    0x5603_3046,
];

/// `floor(π/2 · 2⁶³)`.
pub const HALF_PI: u64 = 0xc90f_daa2_2168_c234;

/// Row 0: `sin r = r + r·s·P(s)`, row 1: `cos r = 1 + 1·s·P(s)`, both for `s = r²`, `|r| ≤ π/4`;
/// relative errors of the polynomials 1.2e-19 and 5.7e-20.
pub const CIRCLE: [[f64; 7]; 2] = [
    [
        -0.16666666666666666,
        0.0083333333333331,
        -0.00019841269841057126,
        2.7557319129292577e-6,
        -2.505208597648223e-8,
        1.6056249611106226e-10,
        -7.484908692307725e-13,
    ],
    [
        -0.5,
        0.041666666666666595,
        -0.0013888888888873348,
        2.480158728900809e-5,
        -2.755731421905481e-7,
        2.087570568855178e-9,
        -1.1358764799839055e-11,
    ],
];

/// ln 2, the first part short enough that its product with an exponent is exact.
pub const LN_2_HIGH: f64 = 0.6931471805601177;
/// The rest of ln 2 behind [`LN_2_HIGH`].
pub const LN_2_LOW: f64 = -1.7239444525614835e-13;

/// `ln((1 + s) / (1 − s)) = 2·s + s·w·P(w)` for `w = s²`, from the constant term on.
pub const LN: [f64; 7] = [
    0.6666666666666734,
    0.3999999999941674,
    0.2857142874200941,
    0.22222198605607052,
    0.18183562917324905,
    0.15314080455230586,
    0.14795705382583219,
];

/// `eʳ = 1 + (r + r²·P(r))` for `|r| ≤ ½ ln 2`, from the constant term on.
pub const EXP: [f64; 10] = [
    0.5000000000000011,
    0.16666666666666424,
    0.041666666666526936,
    0.008333333333487038,
    0.0013888888944362959,
    0.00019841269522593547,
    2.480149241561441e-5,
    2.7557572053764215e-6,
    2.763047317939756e-7,
    2.5004611754833166e-8,
];

/// `arctan t = t + t·s·P(s)` for `s = t²`, `|t| ≤ √2 − 1`.
pub const ATAN: [f64; 10] = [
    -0.3333333333333015,
    0.19999999999088877,
    -0.14285714195251434,
    0.11111106653086021,
    -0.09090782399126085,
    0.07690068094282802,
    -0.06641119271625745,
    0.05692528390008857,
    -0.043590632806563986,
    0.021259438808884975,
];

/// π/4 and π/2, and what is missing from each.
pub const QUARTERS: [[f64; 2]; 2] = [[FRAC_PI_4, 3.061616997868383e-17], [FRAC_PI_2, 6.123233995736766e-17]];

/// `tanh a = a + a·s·P(s)` for `s = a²`, `|a| ≤ 0.55`.
pub const TANH: [f64; 10] = [
    -0.3333333333333231,
    0.1333333333316823,
    -0.05396825387584104,
    0.021869485969040346,
    -0.008863194425735858,
    0.003591719057288698,
    -0.0014532135485340425,
    0.0005791273666274685,
    -0.00021028641902203225,
    5.1010280057259665e-5,
];

/// Sine of `x` radians: off by at most 1.7e-16, and by at most 1.5 ulp, for every finite `x`; odd, and never beyond ±1.
pub fn sin(x: f64) -> f64 {
    let bits = x.to_bits();
    let of_magnitude = circle(bits & MAGNITUDE, 0x2000_0000_0000_0000);
    f64::from_bits(of_magnitude ^ (bits & SIGN))
}

/// Cosine of `x` radians: off by at most 1.7e-16, and by at most 1.5 ulp, for every finite `x`; even, and never
/// beyond ±1.
pub fn cos(x: f64) -> f64 {
    f64::from_bits(circle(x.to_bits() & MAGNITUDE, 0x6000_0000_0000_0000))
}

/// Tangent of `x` radians: sine by cosine, off by at most 3.5 ulp for every finite `x`; odd.
pub fn tan(x: f64) -> f64 {
    sin(x) / cos(x)
}

/// All ones where the top bit is set, else 0. Masks rather than conditions, where a compiler would branch.
#[inline(always)]
pub(in crate::ops) fn mask(bits: u64) -> u64 {
    0_u64.wrapping_sub(bits >> 63)
}

/// `a` where the mask is all ones, `b` where it is 0.
#[inline(always)]
pub(in crate::ops) fn choose(mask: u64, a: u64, b: u64) -> u64 {
    b ^ ((a ^ b) & mask)
}

/// The upper half of a product.
fn multiply_high(a: u64, b: u64) -> u64 {
    (u128::from(a).wrapping_mul(u128::from(b)) >> 64) as u64
}

/// 64 bits of 2/π from a bit of the table on.
fn window(bit: u32) -> u64 {
    let word = (bit >> 5) as usize;
    let shift = bit & 31;
    let first = u64::from(TWO_OVER_PI[word]) << 32;
    let second = u64::from(TWO_OVER_PI[word + 1]);
    let third = u64::from(TWO_OVER_PI[word + 2]);
    ((first | second) << shift) | ((third << shift) >> 32)
}

/// The bits of `sin(a + offset − ⅛ turn)`, `a` given by its bits and the offset in 2⁻⁶⁴ turns.
///
/// With an eighth of a turn added, the quadrant nearest to the angle is in the top two bits of the sum.
fn circle(magnitude: u64, offset: u64) -> u64 {
    // a = mantissa · 2^(exponent + 1021 − 1075). Everything below ¼ is taken for something in [¼, ½): only the quadrant
    // of such an angle is used, and that is right.
    let exponent = ((magnitude >> 52) as u32).saturating_sub(1021);
    let mantissa = (magnitude & FRACTION) | LEAST_NORMAL;

    // a · 2/π modulo 4 in units of 2⁻¹²⁶: the product of the mantissa with those 192 bits of 2/π that matter. Higher
    // ones would add whole turns, lower ones less than a unit.
    let first = window(exponent + 8);
    let second = window(exponent + 72);
    let third = window(exponent + 136);
    let below = multiply_high(mantissa, third);
    let angle_low = mantissa.wrapping_mul(second).wrapping_add(below);
    let carry = u64::from(angle_low < below);
    let angle_high = mantissa.wrapping_mul(first).wrapping_add(multiply_high(mantissa, second)).wrapping_add(carry);

    wave(magnitude, [angle_high, angle_low], offset, multiply_high, |turn| CIRCLE[((turn >> 62) & 1) as usize])
}

/// The bits of `sin(a + offset − ⅛ turn)`, `a` given by its bits and as an angle in units of 2⁻¹²⁶ quadrants; `multiply_high` returns the
/// upper half of a product, and `row` the row of [`CIRCLE`] for a quadrant, which is in the top two bits.
#[inline(always)]
pub(in crate::ops) fn wave(
    magnitude: u64,
    [angle_high, angle_low]: [u64; 2],
    offset: u64,
    multiply_high: impl Fn(u64, u64) -> u64,
    row: impl FnOnce(u64) -> [f64; 7],
) -> u64 {
    // The quadrant, and the signed distance from its middle with its sign taken off. (Ones' complement: a unit is lost.)
    let turn = angle_high.wrapping_add(offset);
    let distance = (turn & 0x3fff_ffff_ffff_ffff).wrapping_sub(0x2000_0000_0000_0000);
    let negative = mask(distance);
    let distance_high = distance ^ negative;
    let distance_low = angle_low ^ negative;

    // Times π/2, in units of 2⁻¹²⁵ radians, then to a float with one rounding that counts: the upper 53 bits are exact.
    let below = multiply_high(distance_low, HALF_PI);
    let radians_low = distance_high.wrapping_mul(HALF_PI).wrapping_add(below);
    let carry = u64::from(radians_low < below);
    let radians_high = multiply_high(distance_high, HALF_PI).wrapping_add(carry);
    let upper = (radians_high >> 8) as f64;
    let lower = ((radians_high << 56) | (radians_low >> 8)) as f64;
    let upper = upper * 1.1102230246251565e-16; // 2⁻⁵³
    let lower = lower * 6.018531076210112e-36; // 2⁻¹¹⁷
    let reduced = (upper + lower).to_bits() | (distance & SIGN);

    // What is below ¾ needs no reduction, and must not lose its own bits to one.
    let small = mask(magnitude.wrapping_sub(0x3fe8_0000_0000_0000));
    let r = f64::from_bits(choose(small, magnitude, reduced));

    // Odd quadrants are the cosine's.
    let base = f64::from_bits(choose(mask(turn << 1), 1.0_f64.to_bits(), r.to_bits()));
    let [c0, c1, c2, c3, c4, c5, c6] = row(turn);
    let s = r * r;
    let p = ((((((c6 * s + c5) * s + c4) * s + c3) * s + c2) * s + c1) * s + c0) * s * base;

    // Zero, unless infinity or NaN make it NaN.
    let zero = f64::from_bits(magnitude) * 0.0;
    let p = p + zero;
    let value = base + p;

    // The lower half turn is negative.
    value.to_bits() ^ (turn & SIGN)
}

/// Natural logarithm: off by at most 0.96 ulp; of ±0 it is −∞, of a negative number NaN.
#[inline]
pub fn ln(x: f64) -> f64 {
    let bits = x.to_bits();

    // x = m · 2^exponent with √½ ≤ m < √2, a subnormal number being scaled up first.
    let scaled = (x * 18014398509481984.0).to_bits();
    let small = mask(bits.wrapping_sub(LEAST_NORMAL));
    let normal = choose(small, scaled, bits);
    let bias = 1023 + (54 & small) as i32;
    let shifted = normal.wrapping_add(0x3ff0_0000_0000_0000 - 0x3fe6_a09e_667f_3bcd);
    let exponent = f64::from(((shifted >> 52) as i32).wrapping_sub(bias));
    let m = f64::from_bits((shifted & FRACTION).wrapping_add(0x3fe6_a09e_667f_3bcd));

    // ln(1 + f) = 2 artanh(s) = 2s + s·R(s²) for s = f / (2 + f); and 2s = f − s·f, where f is exact.
    let f = m - 1.0;
    let g = f + 2.0;
    let s = f / g;
    let w = s * s;
    let [c0, c1, c2, c3, c4, c5, c6] = LN;
    let p = (f - ((((((c6 * w + c5) * w + c4) * w + c3) * w + c2) * w + c1) * w + c0) * w) * s;
    let low = exponent * LN_2_LOW;
    let p = f - (p - low);
    let high = exponent * LN_2_HIGH;
    let value = (high + p).to_bits();

    // What is not in 1..INFINITY: infinity and NaN stay, zeros and what is negative have values of their own.
    let before = bits.wrapping_sub(1);
    let special = mask(before | (INFINITY - 2).wrapping_sub(before));
    let zero = mask((bits & MAGNITUDE).wrapping_sub(1));
    let limit = choose(zero, MINUS_INFINITY, bits | (mask(bits) & NAN));
    f64::from_bits(choose(special, limit, value))
}

/// `eˣ`: off by at most 1 ulp, subnormal results included; +∞ from 709.782_712_893_384_1 on, 0 below
/// −745.133_219_101_941_2.
#[inline]
pub fn exp(x: f64) -> f64 {
    // 1.5 · 2⁵²: adding it leaves the nearest integer in the low bits of the sum.
    const ROUND: f64 = 6755399441055744.0;
    const ROUND_BITS: u64 = 0x4338_0000_0000_0000;

    // Beyond ±746 nothing changes any more; NaN is put back at the end.
    let bits = x.to_bits();
    let magnitude = bits & MAGNITUDE;
    let limited = if magnitude < 0x4087_5000_0000_0000 { magnitude } else { 0x4087_5000_0000_0000 };
    let a = f64::from_bits(limited | (bits & SIGN));

    // x = n·ln 2 + r with |r| ≤ ½ ln 2.
    let sum = a * core::f64::consts::LOG2_E + ROUND;
    let n = sum - ROUND;
    let high = n * LN_2_HIGH;
    let low = n * LN_2_LOW;
    let r = a - high - low;

    // eʳ = 1 + (r + r²·P(r)).
    let [c0, c1, c2, c3, c4, c5, c6, c7, c8, c9] = EXP;
    let p =
        (((((((((c9 * r + c8) * r + c7) * r + c6) * r + c5) * r + c4) * r + c3) * r + c2) * r + c1) * r + c0) * r * r
            + r
            + 1.0;

    // Times 2ⁿ as two powers of two: the first product is exact, the second rounds once, if at all.
    let biased = sum.to_bits().wrapping_sub(ROUND_BITS - 2 * 1023);
    let half = biased >> 1;
    let value = p * f64::from_bits(half << 52);
    let value = value * f64::from_bits(biased.wrapping_sub(half) << 52);

    let not_a_number = mask(INFINITY.wrapping_sub(magnitude));
    f64::from_bits(value.to_bits() | (not_a_number & NAN))
}

/// Arctangent: off by at most 2.5 ulp; odd.
pub fn atan(x: f64) -> f64 {
    let bits = x.to_bits();
    let magnitude = bits & MAGNITUDE;
    let a = f64::from_bits(magnitude);

    // arctan a = π/4 + arctan((a − 1) / (a + 1)) = π/2 + arctan(−1 / a): whichever leaves a small argument.
    let low = mask(magnitude.wrapping_sub(0x3fda_8279_99fc_ef32)); // √2 − 1
    let high = mask(0x4003_504f_333f_9de6_u64.wrapping_sub(magnitude)); // √2 + 1
    let pick = |of_low: f64, of_middle: f64, of_high: f64| {
        f64::from_bits(choose(low, of_low.to_bits(), choose(high, of_high.to_bits(), of_middle.to_bits())))
    };
    let [[quarter, quarter_rest], [half, half_rest]] = QUARTERS;
    let above = pick(a, a - 1.0, -1.0);
    let below = pick(1.0, a + 1.0, a);
    let t = above / below;
    let offset = pick(0.0, quarter, half);
    let rest = pick(0.0, quarter_rest, half_rest);

    let [c0, c1, c2, c3, c4, c5, c6, c7, c8, c9] = ATAN;
    let s = t * t;
    let p = t
        + ((((((((((c9 * s + c8) * s + c7) * s + c6) * s + c5) * s + c4) * s + c3) * s + c2) * s + c1) * s + c0)
            * s
            * t
            + rest);
    let value = offset + p;
    f64::from_bits(value.to_bits() | (bits & SIGN))
}

/// Hyperbolic tangent: off by at most 2.5 ulp; odd, and never beyond ±1.
pub fn tanh(x: f64) -> f64 {
    let bits = x.to_bits();
    let magnitude = bits & MAGNITUDE;
    let a = f64::from_bits(magnitude);

    // 1 − 2 / (e²ᵃ + 1), where that does not cancel.
    let grown = exp(a + a);
    let part = 2.0 / (grown + 1.0);
    let far = 1.0 - part;

    let [c0, c1, c2, c3, c4, c5, c6, c7, c8, c9] = TANH;
    let s = a * a;
    let p =
        (((((((((c9 * s + c8) * s + c7) * s + c6) * s + c5) * s + c4) * s + c3) * s + c2) * s + c1) * s + c0) * s * a;
    let near = a + p;

    let small = mask(magnitude.wrapping_sub(0x3fe1_9999_9999_999a)); // 0.55
    f64::from_bits(choose(small, near.to_bits(), far.to_bits()) | (bits & SIGN))
}
