//! The kernels in plain Rust, which define what all others compute.

use crate::activations::pairs;
use crate::{Kind, ROWS};

/// `a` + the products of the signed halves of two words: the instruction SMLAD.
#[inline(always)]
const fn dual(x: u32, y: u32, a: i32) -> i32 {
    let low = (x as i16 as i32).wrapping_mul(y as i16 as i32);
    let high = ((x as i32) >> 16).wrapping_mul((y as i32) >> 16);
    a.wrapping_add(low).wrapping_add(high)
}

/// Bytes 0 and 2, sign-extended to halves: the instruction SXTB16.
#[inline(always)]
const fn even_bytes(word: u32) -> u32 {
    (word as i8 as u16 as u32) | (((word >> 16) as i8 as u16 as u32) << 16)
}

/// The accumulators of a block's rows; zeros for a block that is too short for its biases.
#[inline]
pub fn accumulate(kind: Kind, block: &[u32], inputs: &[u32]) -> [i32; ROWS] {
    let Some((biases, weights)) = block.split_first_chunk::<ROWS>() else { return [0; ROWS] };
    let mut sums = biases.map(|bias| bias as i32);
    let inputs = inputs.as_chunks::<2>().0;
    match kind {
        Kind::W8A16 => {
            for (words, [first, second]) in weights.as_chunks::<ROWS>().0.iter().zip(inputs) {
                for (sum, &word) in sums.iter_mut().zip(words) {
                    *sum = dual(even_bytes(word), *first, *sum);
                    *sum = dual(even_bytes(word.rotate_right(8)), *second, *sum);
                }
            }
        }
        Kind::W16A16 => {
            for (words, [first, second]) in weights.as_chunks::<{ 2 * ROWS }>().0.iter().zip(inputs) {
                let (left, right) = words.split_at(ROWS);
                for ((sum, &left), &right) in sums.iter_mut().zip(left).zip(right) {
                    *sum = dual(right, *second, dual(left, *first, *sum));
                }
            }
        }
    }
    sums
}

/// Accumulators times their multipliers; zeros for a block without multipliers.
#[inline(always)]
pub fn rescale(kind: Kind, block: &[u32], inputs: &[u32], accumulators: [i32; ROWS]) -> [i32; ROWS] {
    let after = kind.block(inputs.len()) - ROWS;
    let Some(multipliers) = block.get(after..).and_then(|rest| rest.first_chunk::<ROWS>()) else { return [0; ROWS] };
    let mut outputs = accumulators;
    for (output, &multiplier) in outputs.iter_mut().zip(multipliers) {
        let multiplier = multiplier as i32;
        *output = if cfg!(tpg_thumb1) { by_halves(*output, multiplier) } else { rounded(*output, multiplier) };
    }
    outputs
}

/// The upper word of a product, rounded: the instruction SMMULR.
#[inline(always)]
const fn rounded(a: i32, b: i32) -> i32 {
    ((a as i64 * b as i64 + (1 << 31)) >> 32) as i32
}

/// The same by four products of halves, for a core that has no upper words: its library's 64-bit product takes twice the time.
#[inline(always)]
const fn by_halves(a: i32, b: i32) -> i32 {
    let ((a_low, a_high), (b_low, b_high)) = ((a & 0xffff, a >> 16), (b & 0xffff, b >> 16));
    // A product of a signed and an unsigned half leaves room for a half.
    let first = a_high * b_low + ((a_low as u32 * b_low as u32) >> 16) as i32;
    let second = a_low * b_high + (first & 0xffff);
    a_high * b_high + (first >> 16) + (second >> 16) + (second >> 15 & 1)
}

/// Outputs behind their ReLU, as inputs of a next layer.
#[inline(always)]
pub(crate) fn clip(outputs: [i32; ROWS]) -> [u32; 2] {
    pairs(outputs.map(|output| output.clamp(0, 32767)))
}

/// One block of a hidden layer.
#[inline]
pub fn hidden(kind: Kind, block: &[u32], inputs: &[u32]) -> [u32; 2] {
    clip(rescale(kind, block, inputs, accumulate(kind, block, inputs)))
}

#[cfg(test)]
mod tests {
    use super::{by_halves, rounded};
    use proptest::prelude::*;

    #[test]
    fn extreme_products_by_halves() {
        let extreme =
            [i32::MIN, i32::MIN + 1, -0x1_0001, -0x8000, -1, 0, 1, 0x7fff, 0x8000, 0xffff, 0x1_0000, 0x7fff_8000];
        for a in extreme.into_iter().chain([i32::MAX]) {
            for b in extreme.into_iter().chain([i32::MAX]) {
                assert_eq!(by_halves(a, b), rounded(a, b), "{a} · {b}");
            }
        }
    }

    proptest! {
        #[test]
        fn products_by_halves(a: i32, b: i32) {
            prop_assert_eq!(by_halves(a, b), rounded(a, b));
        }
    }
}
