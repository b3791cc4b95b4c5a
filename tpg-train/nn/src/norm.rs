//! LayerNorm, with gain and shift.

use super::Real;
use super::sum::sum;
use super::vectors::vectorised;

const EPSILON: f64 = 1e-5;

/// Applies LayerNorm column by column, in place.
pub(super) fn normalise<T: Real>(values: &mut [T], gain: &[T], shift: &[T]) {
    let count = T::nearest(gain.len() as f64);
    vectorised(
        #[inline(always)]
        || {
            for column in values.chunks_exact_mut(gain.len()) {
                let mean = sum([column], |[value]| value) / count;
                let variance = sum([column], |[value]| (value - mean) * (value - mean)) / count;
                let inverse = T::one() / (variance + T::nearest(EPSILON)).root();
                for (value, (&gain, &shift)) in column.iter_mut().zip(gain.iter().zip(shift)) {
                    *value = (*value - mean) * inverse * gain + shift;
                }
            }
        },
    );
}
