//! Eight doubles.

use super::super::own::f64::{self as own, CIRCLE, FRACTION, LEAST_NORMAL, MAGNITUDE, SIGN, TOP, TWO_OVER_PI};

/// The first 192 bits of 2/π behind the binary point.
const WINDOW: [u64; 3] = [bits(2), bits(4), bits(6)];
/// 2⁵⁴: from there on, other bits of 2/π matter.
const MOST: f64 = 18014398509481984.0;

const fn bits(word: usize) -> u64 {
    (TWO_OVER_PI[word] as u64) << 32 | TWO_OVER_PI[word + 1] as u64
}

of_eight!(f64, u64);

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

    own::wave(TOP, magnitude, [angle_high, angle_low], offset, multiply_high, row)
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
