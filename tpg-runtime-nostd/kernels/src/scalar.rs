//! The kernels for RV32, which multiplies one pair at a time: a weight is loaded and extended by one instruction, and an
//! activation once for four rows.
//!
//! With the multiplication and the addition behind it that is three instructions a product, all that such a core can do. Words that are
//! shifted, as in [`portable`](crate::portable), cost one or two more. Four columns a turn: with eight a compiler runs out of registers.
//! Words must lie in memory with their lowest byte first.

use crate::portable::{clip, rescale};
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

/// A function that accumulates a block whose biases are split off.
type Accumulate = fn([i32; ROWS], &[u32], &[u32]) -> [i32; ROWS];

#[inline(always)]
fn split_off(block: &[u32], inputs: &[u32], accumulate: Accumulate) -> [i32; ROWS] {
    match block.split_first_chunk::<ROWS>() {
        Some((biases, weights)) => accumulate(biases.map(|bias| bias as i32), weights, inputs),
        None => [0; ROWS],
    }
}

/// The accumulators of a block's rows.
#[inline]
pub(crate) fn accumulate(kind: Kind, block: &[u32], inputs: &[u32]) -> [i32; ROWS] {
    match kind {
        Kind::W8A16 => split_off(block, inputs, w8a16),
        Kind::W16A16 => split_off(block, inputs, w16a16),
    }
}

/// A hidden layer.
#[inline]
pub(crate) fn layer(kind: Kind, blocks: &[u32], inputs: &[u32], outputs: &mut [u32]) {
    // A loop for each kind, so that none asks which it is.
    match kind {
        Kind::W8A16 => each(Kind::W8A16, blocks, inputs, outputs, w8a16),
        Kind::W16A16 => each(Kind::W16A16, blocks, inputs, outputs, w16a16),
    }
}

#[inline(always)]
fn each(kind: Kind, blocks: &[u32], inputs: &[u32], outputs: &mut [u32], accumulate: Accumulate) {
    for (block, outputs) in blocks.chunks_exact(kind.block(inputs.len())).zip(outputs.as_chunks_mut::<2>().0) {
        *outputs = clip(rescale(kind, block, inputs, split_off(block, inputs, accumulate)));
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
