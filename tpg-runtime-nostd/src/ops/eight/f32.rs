//! Eight floats.

use super::super::own::f32::{self as own, CIRCLE, FRACTION, LEAST_NORMAL, MAGNITUDE, SIGN, TOP, TWO_OVER_PI};

/// The first 192 bits of [`TWO_OVER_PI`], whose words overlap.
const WINDOW: [u64; 3] = [bits(0), bits(8), bits(16)];
/// 2³⁰: from there on, other bits of 2/π matter.
const MOST: f32 = 1073741824.0;

const fn bits(byte: usize) -> u64 {
    (TWO_OVER_PI[byte] as u64) << 32 | TWO_OVER_PI[byte + 4] as u64
}

of_eight!(f32, u32);

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

    own::wave(TOP, magnitude, angle, offset, row)
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
