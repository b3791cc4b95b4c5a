//! Eight doubles.

use super::super::own::f64::{self as own, CIRCLE, HALF_PI, TWO_OVER_PI};

const SIGN: u64 = 1 << 63;
const FRACTION: u64 = 0x000f_ffff_ffff_ffff;
const LEAST_NORMAL: u64 = 0x0010_0000_0000_0000;
const ONE: u64 = 0x3ff0_0000_0000_0000;
/// The first 192 bits of 2/π behind the binary point.
const WINDOW: [u64; 3] = [bits(2), bits(4), bits(6)];
/// 2⁵⁴: from there on, other bits of 2/π matter.
const MOST: f64 = 18014398509481984.0;

const fn bits(word: usize) -> u64 {
    (TWO_OVER_PI[word] as u64) << 32 | TWO_OVER_PI[word + 1] as u64
}

/// Replaces each number by its sine.
#[inline(always)]
pub(in crate::ops) fn sines(numbers: &mut [f64; 8]) {
    if any_is_large(numbers) {
        return numbers.iter_mut().for_each(|x| *x = own::sin(*x));
    }
    for x in numbers {
        let bits = x.to_bits();
        *x = f64::from_bits(circle(bits & !SIGN, 0x2000_0000_0000_0000) ^ (bits & SIGN));
    }
}

/// Replaces each number by its cosine.
#[inline(always)]
pub(in crate::ops) fn cosines(numbers: &mut [f64; 8]) {
    if any_is_large(numbers) {
        return numbers.iter_mut().for_each(|x| *x = own::cos(*x));
    }
    for x in numbers {
        *x = f64::from_bits(circle(x.to_bits() & !SIGN, 0x6000_0000_0000_0000));
    }
}

/// Infinities and NaN are not large: they become NaN in any case.
#[inline(always)]
fn any_is_large(numbers: &[f64; 8]) -> bool {
    numbers.iter().fold(false, |any, x| any | ((x.abs() >= MOST) & (x.abs() < f64::INFINITY)))
}

/// As the function of that name in [`own`], which explains it: of numbers below 2⁵⁴, without a table and without products of
/// 128 bits.
#[inline(always)]
fn circle(magnitude: u64, offset: u64) -> u64 {
    let exponent = (magnitude >> 52).max(1021) - 1021;
    let mantissa = (magnitude & FRACTION) | LEAST_NORMAL;

    // Below 2⁵⁴ the shifts are between 8 and 63; of infinities and NaN they are anything.
    let (up, down) = ((8 + exponent) & 63, 56_u64.wrapping_sub(exponent) & 63);
    let first = WINDOW[0] >> down;
    let second = (WINDOW[0] << up) | (WINDOW[1] >> down);
    let third = (WINDOW[1] << up) | (WINDOW[2] >> down);
    let below = multiply_high(mantissa, third);
    let angle_low = mantissa.wrapping_mul(second).wrapping_add(below);
    let carry = u64::from(angle_low < below);
    let angle_high = mantissa.wrapping_mul(first).wrapping_add(multiply_high(mantissa, second)).wrapping_add(carry);

    let turn = angle_high.wrapping_add(offset);
    let distance = (turn & 0x3fff_ffff_ffff_ffff).wrapping_sub(0x2000_0000_0000_0000);
    let negative = all_ones(distance);
    let distance_high = distance ^ negative;
    let distance_low = angle_low ^ negative;

    let below = multiply_high(distance_low, HALF_PI);
    let radians_low = distance_high.wrapping_mul(HALF_PI).wrapping_add(below);
    let carry = u64::from(radians_low < below);
    let radians_high = multiply_high(distance_high, HALF_PI).wrapping_add(carry);
    let upper = (radians_high >> 8) as f64;
    let lower = ((radians_high << 56) | (radians_low >> 8)) as f64;
    let reduced = (upper * 1.1102230246251565e-16 + lower * 6.018531076210112e-36).to_bits() | (distance & SIGN);

    let small = all_ones(magnitude.wrapping_sub(0x3fe8_0000_0000_0000));
    let r = f64::from_bits(choose(small, magnitude, reduced));
    let odd = all_ones(turn << 1);
    let base = f64::from_bits(choose(odd, ONE, r.to_bits()));
    let s = r * r;
    let mut p = 0.0;
    for place in (0..7).rev() {
        let coefficient = choose(odd, CIRCLE[1][place].to_bits(), CIRCLE[0][place].to_bits());
        // Of the first, 0 + c is c.
        p = (p + f64::from_bits(coefficient)) * s;
    }
    let zero = f64::from_bits(magnitude) * 0.0;
    (base + (p * base + zero)).to_bits() ^ (turn & SIGN)
}

/// All ones where the top bit is set, else 0.
#[inline(always)]
fn all_ones(bits: u64) -> u64 {
    0_u64.wrapping_sub(bits >> 63)
}

/// `a` where the mask is all ones, `b` where it is 0.
#[inline(always)]
fn choose(mask: u64, a: u64, b: u64) -> u64 {
    b ^ ((a ^ b) & mask)
}

/// The upper half of a product, from products of 32 bits.
#[inline(always)]
fn multiply_high(a: u64, b: u64) -> u64 {
    const LOW: u64 = 0xffff_ffff;
    let [a_low, a_high, b_low, b_high] = [a & LOW, a >> 32, b & LOW, b >> 32];
    let first = a_high * b_low + ((a_low * b_low) >> 32);
    let second = a_low * b_high + (first & LOW);
    a_high * b_high + (first >> 32) + (second >> 32)
}

#[cfg(test)]
mod tests {
    use super::{cosines, own, sines};

    /// Numbers of every exponent, close to multiples of ⅛ turn, and what is no number.
    #[test]
    fn eight_at_once_have_the_bits_of_one() {
        let mut numbers =
            [0.0, f64::INFINITY, f64::MIN_POSITIVE, 5e-324, f64::NAN, 0.75, 18014398509481984.0, f64::MAX].to_vec();
        let mut seed = 1_u64;
        for exponent in 0..0x7ff {
            for _ in 0..40 {
                seed = seed.wrapping_mul(6364136223846793005).wrapping_add(1442695040888963407);
                numbers.push(f64::from_bits(seed >> 12 | exponent << 52));
            }
        }
        for eighth in 0..20_000 {
            let near = f64::from(eighth) * core::f64::consts::FRAC_PI_4;
            numbers.extend([near.next_down(), near, near.next_up()]);
        }
        numbers.extend(numbers.clone().iter().map(|x| -x));
        for eight in numbers.as_chunks::<8>().0 {
            for (at_once, one) in [(sines as fn(&mut [f64; 8]), own::sin as fn(f64) -> f64), (cosines, own::cos)] {
                let mut found = *eight;
                at_once(&mut found);
                let is_same = |(found, x): (&f64, &f64)| {
                    found.to_bits() == one(*x).to_bits() || found.is_nan() && one(*x).is_nan()
                };
                assert!(found.iter().zip(eight).all(is_same), "{eight:?}");
            }
        }
    }
}
