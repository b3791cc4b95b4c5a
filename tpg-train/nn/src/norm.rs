//! LayerNorm, with gain and shift, and its gradient.

use super::Real;
use super::sum::sum;
use super::vectors::vectorised;

const EPSILON: f64 = 1e-5;

/// Applies LayerNorm column by column; stores mean and 1/√(variance + ε) in `moments`.
pub(super) fn normalise<T: Real>(out: &mut [T], moments: &mut [[T; 2]], values: &[T], gain: &[T], shift: &[T]) {
    let (size, count) = (gain.len(), T::of(gain.len() as f64));
    let columns = out.chunks_exact_mut(size).zip(values.chunks_exact(size));
    vectorised(
        #[inline(always)]
        || {
            for ((out, values), moments) in columns.zip(moments) {
                let mean = sum([values], |[value]| value) / count;
                let variance = sum([values], |[value]| (value - mean) * (value - mean)) / count;
                let inverse = T::one() / (variance + T::of(EPSILON)).root();
                *moments = [mean, inverse];
                for ((out, &value), (&gain, &shift)) in out.iter_mut().zip(values).zip(gain.iter().zip(shift)) {
                    *out = (value - mean) * inverse * gain + shift;
                }
            }
        },
    );
}

/// Converts the gradient with respect to LayerNorm's output into that with respect to its input, in place. `by_norm`,
/// if given, is overwritten with the gradient with respect to gain and shift.
pub(super) fn denormalise<T: Real>(
    gradient: &mut [T],
    by_norm: Option<&mut [T]>,
    values: &[T],
    moments: &[[T; 2]],
    gain: &[T],
) {
    let (size, count) = (gain.len(), T::of(gain.len() as f64));
    if let Some(by_norm) = by_norm {
        by_norm.fill(T::zero());
        let (by_gain, by_shift) = by_norm.split_at_mut(size);
        let columns = gradient.chunks_exact(size).zip(values.chunks_exact(size)).zip(moments);
        vectorised(
            #[inline(always)]
            || {
                for ((gradient, values), &[mean, inverse]) in columns {
                    let sums = by_gain.iter_mut().zip(by_shift.iter_mut());
                    for ((by_gain, by_shift), (&gradient, &value)) in sums.zip(gradient.iter().zip(values)) {
                        *by_gain += gradient * ((value - mean) * inverse);
                        *by_shift += gradient;
                    }
                }
            },
        );
    }
    let columns = gradient.chunks_exact_mut(size).zip(values.chunks_exact(size)).zip(moments);
    vectorised(
        #[inline(always)]
        || {
            for ((gradient, values), &[mean, inverse]) in columns {
                let mean_slope = sum([gradient, gain], |[slope, gain]| slope * gain) / count;
                let along =
                    sum([gradient, gain, values], |[slope, gain, value]| slope * gain * ((value - mean) * inverse))
                        / count;
                for ((gradient, &value), &gain) in gradient.iter_mut().zip(values).zip(gain) {
                    let normal = (value - mean) * inverse;
                    *gradient = (*gradient * gain - mean_slope - normal * along) * inverse;
                }
            }
        },
    );
}
