//! The kernels for RV32, which multiplies one pair at a time: a weight is loaded and extended by one instruction, and an
//! activation once for four rows.
//!
//! With the multiplication and the addition behind it that is three instructions a product, all that such a core can do. Words that are
//! shifted, as in [`portable`](crate::portable), cost one or two more. Four columns a turn: with eight a compiler runs out of registers.
//! Words must lie in memory with their lowest byte first.

use crate::{Kind, ROWS};

/// Words as bytes in memory.
#[expect(unsafe_code, reason = "a view of numbers as smaller ones, which no safe function of core gives")]
#[inline(always)]
fn bytes(words: &[u32]) -> &[i8] {
    // SAFETY: any bits are an `i8`.
    unsafe { words.align_to::<i8>() }.1
}

/// Words as their halves in memory.
#[expect(unsafe_code, reason = "a view of numbers as smaller ones, which no safe function of core gives")]
#[inline(always)]
fn halves(words: &[u32]) -> &[i16] {
    // SAFETY: any bits are an `i16`.
    unsafe { words.align_to::<i16>() }.1
}

/// The accumulators of a block's rows.
#[inline(always)]
pub(crate) fn accumulate(kind: Kind, block: &[u32], inputs: &[u32]) -> [i32; ROWS] {
    let Some((biases, weights)) = block.split_first_chunk::<ROWS>() else { return [0; ROWS] };
    let sums = biases.map(|bias| bias as i32);
    match kind {
        Kind::W8A16 => w8a16(sums, weights, inputs),
        Kind::W16A16 => w16a16(sums, weights, inputs),
    }
}

#[inline(always)]
fn w8a16(mut sums: [i32; ROWS], weights: &[u32], inputs: &[u32]) -> [i32; ROWS] {
    let inputs = halves(inputs).as_chunks::<4>().0;
    for (rows, &[a, b, c, d]) in bytes(weights).as_chunks::<{ 4 * ROWS }>().0.iter().zip(inputs) {
        for (sum, &[e, f, g, h]) in sums.iter_mut().zip(rows.as_chunks::<4>().0) {
            for (weight, input) in [e, g, f, h].into_iter().zip([a, b, c, d]) {
                *sum = product(i32::from(weight), i32::from(input), *sum);
            }
        }
    }
    sums
}

#[inline(always)]
fn w16a16(mut sums: [i32; ROWS], weights: &[u32], inputs: &[u32]) -> [i32; ROWS] {
    let inputs = halves(inputs).as_chunks::<4>().0;
    for (rows, &[a, b, c, d]) in halves(weights).as_chunks::<{ 4 * ROWS }>().0.iter().zip(inputs) {
        let (left, right) = rows.split_at(2 * ROWS);
        let rows = left.as_chunks::<2>().0.iter().zip(right.as_chunks::<2>().0);
        for (sum, (&[e, f], &[g, h])) in sums.iter_mut().zip(rows) {
            for (weight, input) in [e, f, g, h].into_iter().zip([a, b, c, d]) {
                *sum = product(i32::from(weight), i32::from(input), *sum);
            }
        }
    }
    sums
}

#[inline(always)]
const fn product(weight: i32, input: i32, sum: i32) -> i32 {
    sum.wrapping_add(weight.wrapping_mul(input))
}
