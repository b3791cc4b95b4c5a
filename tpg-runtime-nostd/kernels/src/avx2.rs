//! The kernels on x86-64 with AVX2, which is looked for once: two blocks, and of each two groups of four columns, at once.

use crate::{Kind, ROWS};
use core::arch::x86_64::{
    __m128i, __m256i, _mm_add_epi32, _mm_cvtsi128_si64, _mm_max_epi32, _mm_packs_epi32, _mm_set_epi32,
    _mm_setzero_si128, _mm_unpackhi_epi64, _mm256_add_epi32, _mm256_add_epi64, _mm256_broadcastsi128_si256,
    _mm256_castsi256_si128, _mm256_cvtepi32_epi64, _mm256_extracti128_si256, _mm256_madd_epi16, _mm256_mul_epi32,
    _mm256_permutevar8x32_epi32, _mm256_set_epi32, _mm256_set1_epi64x, _mm256_setzero_si256, _mm256_shuffle_epi8,
    _mm256_slli_epi16, _mm256_srai_epi16,
};

cpufeatures::new!(avx2, "avx2");

/// A hidden layer, as [`crate::hidden`]; `false` where the machine has no AVX2 or blocks or columns do not come in pairs.
#[expect(unsafe_code, reason = "a call of functions that need AVX2")]
pub(crate) fn layer(kind: Kind, blocks: &[u32], inputs: &[u32], outputs: &mut [u32]) -> bool {
    let block = kind.block(inputs.len());
    // Said so that the compiler sees it too: chunks of no words would be a way to panic.
    let Some(pair) = block.checked_mul(2).filter(|&pair| pair > 0) else { return false };
    if !avx2::get() || !inputs.len().is_multiple_of(4) || !blocks.len().is_multiple_of(pair) {
        return false;
    }
    for (blocks, outputs) in blocks.chunks_exact(pair).zip(outputs.as_chunks_mut::<4>().0) {
        let Some((upper, lower)) = blocks.split_at_checked(block) else { continue };
        // SAFETY: AVX2 was found.
        *outputs = unsafe { two_blocks(kind, [upper, lower], inputs) };
    }
    true
}

/// The outputs of two blocks behind their ReLU, as the next layer's inputs.
#[inline]
#[target_feature(enable = "avx2")]
fn two_blocks(kind: Kind, blocks: [&[u32]; 2], inputs: &[u32]) -> [u32; 4] {
    let [a, b] = accumulate(kind, blocks, inputs);
    let [upper, lower] = blocks.map(|block| block.last_chunk::<ROWS>().unwrap_or(&[0; ROWS]));
    let (a, b) = (rescale(a, upper), rescale(b, lower));
    // Above 32767 the packing clips, below 0 the maximum.
    let zero = _mm_setzero_si128();
    let words = _mm_packs_epi32(_mm_max_epi32(a, zero), _mm_max_epi32(b, zero));
    let [first, second] = [_mm_cvtsi128_si64(words), _mm_cvtsi128_si64(_mm_unpackhi_epi64(words, words))];
    [first as u32, (first >> 32) as u32, second as u32, (second >> 32) as u32]
}

/// Accumulators times their multipliers, as `portable::rescale`.
#[inline]
#[target_feature(enable = "avx2")]
fn rescale(sums: __m128i, multipliers: &[u32; ROWS]) -> __m128i {
    let products = _mm256_mul_epi32(_mm256_cvtepi32_epi64(sums), _mm256_cvtepi32_epi64(quad(multipliers)));
    let rounded = _mm256_add_epi64(products, _mm256_set1_epi64x(1 << 31));
    // The upper halves of the four numbers, side by side.
    let upper = _mm256_permutevar8x32_epi32(rounded, _mm256_set_epi32(7, 7, 7, 7, 7, 5, 3, 1));
    _mm256_castsi256_si128(upper)
}

/// The accumulators of two blocks' rows.
#[inline]
#[target_feature(enable = "avx2")]
fn accumulate(kind: Kind, blocks: [&[u32]; 2], inputs: &[u32]) -> [__m128i; 2] {
    let inputs = inputs.as_chunks::<4>().0;
    let [upper, lower] = blocks.map(|block| block.split_first_chunk::<ROWS>().unwrap_or((&[0; ROWS], &[])));
    let mut sums = [_mm256_setzero_si256(); 2];
    match kind {
        Kind::W8A16 => {
            let weights = upper.1.as_chunks::<8>().0.iter().zip(lower.1.as_chunks::<8>().0);
            for ((upper, lower), input) in weights.zip(inputs) {
                let (first, second) = (spread(input, 0, 2), spread(input, 1, 3));
                for (sum, words) in sums.iter_mut().zip([upper, lower]) {
                    let words = load(words);
                    let odd = _mm256_srai_epi16::<8>(words);
                    let even = _mm256_srai_epi16::<8>(_mm256_slli_epi16::<8>(words));
                    *sum = dual(odd, second, dual(even, first, *sum));
                }
            }
        }
        Kind::W16A16 => {
            let weights = upper.1.as_chunks::<16>().0.iter().zip(lower.1.as_chunks::<16>().0);
            for ((upper, lower), input) in weights.zip(inputs) {
                let (first, second) = (spread(input, 0, 1), spread(input, 2, 3));
                for (sum, words) in sums.iter_mut().zip([upper, lower]) {
                    let [left, right] = words.as_chunks::<8>().0 else { continue };
                    *sum = dual(load(right), second, dual(load(left), first, *sum));
                }
            }
        }
    }
    [(sums[0], upper.0), (sums[1], lower.0)].map(|(sum, biases)| {
        let halves = _mm_add_epi32(_mm256_castsi256_si128(sum), _mm256_extracti128_si256::<1>(sum));
        _mm_add_epi32(halves, quad(biases))
    })
}

/// Word `low` four times, then word `high` four times.
#[inline]
#[target_feature(enable = "avx2")]
fn spread(words: &[u32; 4], low: i32, high: i32) -> __m256i {
    // The places of a word's four bytes.
    let [low, high] = [low, high].map(|word| 0x0302_0100 + 0x0404_0404 * word);
    let bytes = _mm256_set_epi32(high, high, high, high, low, low, low, low);
    _mm256_shuffle_epi8(_mm256_broadcastsi128_si256(quad(words)), bytes)
}

#[inline]
#[target_feature(enable = "avx2")]
fn quad(&[a, b, c, d]: &[u32; 4]) -> __m128i {
    _mm_set_epi32(d as i32, c as i32, b as i32, a as i32)
}

#[inline]
#[target_feature(enable = "avx2")]
fn load(&[a, b, c, d, e, f, g, h]: &[u32; 8]) -> __m256i {
    _mm256_set_epi32(h as i32, g as i32, f as i32, e as i32, d as i32, c as i32, b as i32, a as i32)
}

/// The one product that PMADDWD and SMLAD could disagree on, (−2¹⁵)² twice, is 2³¹ modulo 2³² in both.
#[inline]
#[target_feature(enable = "avx2")]
fn dual(weights: __m256i, inputs: __m256i, sums: __m256i) -> __m256i {
    _mm256_add_epi32(sums, _mm256_madd_epi16(weights, inputs))
}
