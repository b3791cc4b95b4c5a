//! The kernels in `f32`. No operation is wider than `f32` and `u64`: a Cortex-M4F runs all of it in hardware.

use core::f32::consts::{FRAC_PI_2, FRAC_PI_4};

/// The power of two by which subnormal numbers are scaled up.
const SCALE: u32 = 23;
/// The bits of √½.
const ROOT_OF_HALF: u32 = 0x3f35_04f3;
/// `eˣ` is +∞ from 88.722_84 on, 0 below −103.972_08.
const EXP_LIMIT: f32 = 104.0;
/// The bits of √2 − 1, of √2 + 1, and of 0.55.
const ATAN_LOW: u32 = 0x3ed4_13cd;
const ATAN_HIGH: u32 = 0x401a_827a;
const TANH_NEAR: u32 = 0x3f0c_cccd;

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

kernels!(f32, u32, [c0 c1 c2], [c0 c1 c2 c3 c4], [c0 c1 c2 c3], [c0 c1 c2 c3]);

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
