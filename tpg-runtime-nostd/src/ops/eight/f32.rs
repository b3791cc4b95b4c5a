//! Eight floats.

use super::super::own::f32::{self as own, CIRCLE, HALF_PI, TWO_OVER_PI};

const SIGN: u32 = 1 << 31;
const FRACTION: u32 = 0x007f_ffff;
const LEAST_NORMAL: u32 = 0x0080_0000;
/// The first 192 bits of [`TWO_OVER_PI`], whose words overlap.
const WINDOW: [u64; 3] = [bits(0), bits(8), bits(16)];
/// 2³⁰: from there on, other bits of 2/π matter.
const MOST: f32 = 1073741824.0;

const fn bits(byte: usize) -> u64 {
    (TWO_OVER_PI[byte] as u64) << 32 | TWO_OVER_PI[byte + 4] as u64
}

/// Replaces each number by its sine.
#[inline(always)]
pub(in crate::ops) fn sines(numbers: &mut [f32; 8]) {
    if any_is_large(numbers) {
        return numbers.iter_mut().for_each(|x| *x = own::sin(*x));
    }
    for x in numbers {
        let bits = x.to_bits();
        *x = f32::from_bits(circle(bits & !SIGN, 0x2000_0000) ^ (bits & SIGN));
    }
}

/// Replaces each number by its cosine.
#[inline(always)]
pub(in crate::ops) fn cosines(numbers: &mut [f32; 8]) {
    if any_is_large(numbers) {
        return numbers.iter_mut().for_each(|x| *x = own::cos(*x));
    }
    for x in numbers {
        *x = f32::from_bits(circle(x.to_bits() & !SIGN, 0x6000_0000));
    }
}

/// Infinities and NaN are not large: they become NaN in any case.
#[inline(always)]
fn any_is_large(numbers: &[f32; 8]) -> bool {
    numbers.iter().fold(false, |any, x| any | ((x.abs() >= MOST) & (x.abs() < f32::INFINITY)))
}

/// As the function of that name in [`own`], which explains it: of numbers below 2³⁰, without tables.
#[inline(always)]
fn circle(magnitude: u32, offset: u32) -> u32 {
    let exponent = (magnitude >> 23).max(125) - 125;
    let mantissa = u64::from(((magnitude & FRACTION) | LEAST_NORMAL) << (exponent & 7));

    // Below 2³⁰ the shift is 0, 8, 16 or 24; of infinities and NaN it is anything.
    let up = u64::from(exponent & 0x38);
    let next = |place: usize| (WINDOW[place] << up) | ((WINDOW[place + 1] >> 1) >> (63 - up));
    let (first, second) = (next(0), next(1));
    let high = mantissa.wrapping_mul(first >> 32) << 32;
    let middle = mantissa.wrapping_mul(first & 0xffff_ffff);
    let low = mantissa.wrapping_mul(second >> 32) >> 32;
    let angle = high.wrapping_add(middle).wrapping_add(low);

    let turn = ((angle >> 32) as u32).wrapping_add(offset);
    let distance = (turn & 0x3fff_ffff).wrapping_sub(0x2000_0000);
    let negative = all_ones(distance);
    let distance_high = u64::from(distance ^ negative);
    let distance_low = u64::from((angle as u32) ^ negative);

    let radians = distance_high.wrapping_mul(HALF_PI).wrapping_add(distance_low.wrapping_mul(HALF_PI) >> 32);
    let upper = (radians >> 37) as u32 as f32;
    let lower = (radians >> 5) as u32 as f32;
    let reduced = (upper * 5.9604645e-8 + lower * 1.3877788e-17).to_bits() | (distance & SIGN);

    let small = all_ones(magnitude.wrapping_sub(0x3f40_0000));
    let r = f32::from_bits(choose(small, magnitude, reduced));
    let odd = all_ones(turn << 1);
    let base = f32::from_bits(choose(odd, 1.0_f32.to_bits(), r.to_bits()));
    let s = r * r;
    let mut p = 0.0;
    for place in (0..4).rev() {
        let coefficient = choose(odd, CIRCLE[1][place].to_bits(), CIRCLE[0][place].to_bits());
        // Of the first, 0 + c is c.
        p = (p + f32::from_bits(coefficient)) * s;
    }
    let zero = f32::from_bits(magnitude) * 0.0;
    (base + (p * base + zero)).to_bits() ^ (turn & SIGN)
}

/// All ones where the top bit is set, else 0.
#[inline(always)]
fn all_ones(bits: u32) -> u32 {
    0_u32.wrapping_sub(bits >> 31)
}

/// `a` where the mask is all ones, `b` where it is 0.
#[inline(always)]
fn choose(mask: u32, a: u32, b: u32) -> u32 {
    b ^ ((a ^ b) & mask)
}

#[cfg(test)]
mod tests {
    use super::{cosines, own, sines};
    use std::vec::Vec;

    /// Every 997th number there is.
    #[test]
    fn eight_at_once_have_the_bits_of_one() {
        let numbers: Vec<f32> = (0..=u32::MAX).step_by(997).map(f32::from_bits).collect();
        for eight in numbers.as_chunks::<8>().0 {
            for (at_once, one) in [(sines as fn(&mut [f32; 8]), own::sin as fn(f32) -> f32), (cosines, own::cos)] {
                let mut found = *eight;
                at_once(&mut found);
                let is_same = |(found, x): (&f32, &f32)| {
                    found.to_bits() == one(*x).to_bits() || found.is_nan() && one(*x).is_nan()
                };
                assert!(found.iter().zip(eight).all(is_same), "{eight:?}");
            }
        }
    }
}
