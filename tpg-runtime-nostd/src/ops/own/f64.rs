//! The kernels in `f64`. On a core without doubles each operation is a call, but there is no loop all the same.

use core::f64::consts::{FRAC_PI_2, FRAC_PI_4};

/// The power of two by which subnormal numbers are scaled up.
const SCALE: u64 = 54;
/// The bits of √½.
const ROOT_OF_HALF: u64 = 0x3fe6_a09e_667f_3bcd;
/// `eˣ` is +∞ from 709.782_712_893_384_1 on, 0 below −745.133_219_101_941_2.
const EXP_LIMIT: f64 = 746.0;
/// The bits of √2 − 1, of √2 + 1, and of 0.55.
const ATAN_LOW: u64 = 0x3fda_8279_99fc_ef32;
const ATAN_HIGH: u64 = 0x4003_504f_333f_9de6;
const TANH_NEAR: u64 = 0x3fe1_9999_9999_999a;

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

kernels!(f64, u64, [c0 c1 c2 c3 c4 c5 c6], [c0 c1 c2 c3 c4 c5 c6 c7 c8 c9], [c0 c1 c2 c3 c4 c5 c6 c7 c8 c9], [c0 c1 c2 c3 c4 c5 c6 c7 c8 c9]);

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
fn circle(top: u32, magnitude: u64, offset: u64) -> u64 {
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

    wave(top, magnitude, [angle_high, angle_low], offset, multiply_high, |turn| CIRCLE[((turn >> 62) & 1) as usize])
}

/// The bits of `sin(a + offset − ⅛ turn)`, `a` given by its bits and as an angle in units of 2⁻¹²⁶ quadrants; `multiply_high` returns the
/// upper half of a product, and `row` the row of [`CIRCLE`] for a quadrant, which is in the top two bits.
#[inline(always)]
pub(in crate::ops) fn wave(
    top: u32,
    magnitude: u64,
    [angle_high, angle_low]: [u64; 2],
    offset: u64,
    multiply_high: impl Fn(u64, u64) -> u64,
    row: impl FnOnce(u64) -> [f64; 7],
) -> u64 {
    // The quadrant, and the signed distance from its middle with its sign taken off. (Ones' complement: a unit is lost.)
    let turn = angle_high.wrapping_add(offset);
    let distance = (turn & 0x3fff_ffff_ffff_ffff).wrapping_sub(0x2000_0000_0000_0000);
    let negative = mask(top, distance);
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
    let small = mask(top, magnitude.wrapping_sub(0x3fe8_0000_0000_0000));
    let r = f64::from_bits(choose(small, magnitude, reduced));

    // Odd quadrants are the cosine's.
    let base = f64::from_bits(choose(mask(top, turn << 1), 1.0_f64.to_bits(), r.to_bits()));
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
