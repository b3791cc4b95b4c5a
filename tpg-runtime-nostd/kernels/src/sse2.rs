//! The kernels on x86-64, where SSE2 is always there: four rows in one register.

use crate::portable::{clip, rescale};
use crate::{Kind, ROWS};
use core::arch::x86_64::{
    __m128i, _mm_add_epi32, _mm_cvtsi128_si64, _mm_madd_epi16, _mm_set_epi32, _mm_set1_epi32, _mm_slli_epi16,
    _mm_srai_epi16, _mm_unpackhi_epi64,
};

/// The accumulators of a block's rows.
#[inline]
#[expect(unsafe_code, reason = "a call of functions that need SSE2")]
pub(crate) fn accumulate(kind: Kind, block: &[u32], inputs: &[u32]) -> [i32; ROWS] {
    // SAFETY: SSE2 is part of x86-64.
    unsafe { with_sse2(kind, block, inputs) }
}

#[inline]
#[target_feature(enable = "sse2")]
fn with_sse2(kind: Kind, block: &[u32], inputs: &[u32]) -> [i32; ROWS] {
    let Some((biases, weights)) = block.split_first_chunk::<ROWS>() else { return [0; ROWS] };
    let inputs = inputs.as_chunks::<2>().0;
    let mut sums = load(biases);
    match kind {
        Kind::W8A16 => {
            for (words, &[first, second]) in weights.as_chunks::<ROWS>().0.iter().zip(inputs) {
                let words = load(words);
                sums = dual(_mm_srai_epi16::<8>(_mm_slli_epi16::<8>(words)), first, sums);
                sums = dual(_mm_srai_epi16::<8>(words), second, sums);
            }
        }
        Kind::W16A16 => {
            for (words, &[first, second]) in weights.as_chunks::<{ 2 * ROWS }>().0.iter().zip(inputs) {
                let [left, right] = words.as_chunks::<ROWS>().0 else { break };
                sums = dual(load(left), first, sums);
                sums = dual(load(right), second, sums);
            }
        }
    }
    let (low, high) = (_mm_cvtsi128_si64(sums), _mm_cvtsi128_si64(_mm_unpackhi_epi64(sums, sums)));
    [low as i32, (low >> 32) as i32, high as i32, (high >> 32) as i32]
}

/// One block of a hidden layer.
#[inline]
pub(crate) fn hidden(kind: Kind, block: &[u32], inputs: &[u32]) -> [u32; 2] {
    clip(rescale(kind, block, inputs, accumulate(kind, block, inputs)))
}

#[inline]
#[target_feature(enable = "sse2")]
fn load(&[a, b, c, d]: &[u32; ROWS]) -> __m128i {
    _mm_set_epi32(d as i32, c as i32, b as i32, a as i32)
}

/// The one product that PMADDWD and SMLAD could disagree on, (−2¹⁵)² twice, is 2³¹ modulo 2³² in both.
#[inline]
#[target_feature(enable = "sse2")]
fn dual(weights: __m128i, inputs: u32, sums: __m128i) -> __m128i {
    _mm_add_epi32(sums, _mm_madd_epi16(weights, _mm_set1_epi32(inputs as i32)))
}
