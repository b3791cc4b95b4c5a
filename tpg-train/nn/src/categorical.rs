//! The categorical distribution: an actor's outputs as preferences among named actions.
//!
//! For each sample the actor outputs a preference x for each action, and π(i) = exp(xᵢ)/Σ exp(xⱼ). There are few enough
//! actions to sum over all of them, so that learning needs no draw.

use super::Real;

/// Computes π and ln π of one sample from its preferences. The greatest preference is taken off first, so that nothing overflows.
///
/// ```
/// let (mut probabilities, mut logarithms) = ([0.0; 3], [0.0; 3]);
/// tpg_nn::softmax(&[1000.0, 1000.0, -1000.0], &mut probabilities, &mut logarithms);
/// assert_eq!(probabilities, [0.5, 0.5, 0.0]);
/// assert_eq!(logarithms[2], -2000.0 - 2f64.ln());
/// ```
///
/// # Panics
/// If the lengths differ.
pub fn softmax<T: Real>(preferences: &[T], probabilities: &mut [T], logarithms: &mut [T]) {
    assert!(probabilities.len() == preferences.len() && logarithms.len() == preferences.len(), "other actions");
    let Some(&first) = preferences.first() else { return };
    let greatest = preferences.iter().fold(first, |greatest, &x| if x > greatest { x } else { greatest });
    let mut sum = T::zero();
    for (probability, &x) in probabilities.iter_mut().zip(preferences) {
        *probability = (x - greatest).exponential();
        sum += *probability;
    }
    let logarithm = sum.logarithm();
    for ((probability, log), &x) in probabilities.iter_mut().zip(logarithms).zip(preferences) {
        *probability /= sum;
        *log = x - greatest - logarithm;
    }
}

/// Computes the gradient of Σ π(i)·(α ln π(i) − q(i)) with respect to a sample's preferences, times `scale`. Returns that sum.
///
/// # Panics
/// If the lengths differ.
pub fn softmax_backward<T: Real>(
    (probabilities, logarithms): (&[T], &[T]),
    q: &[T],
    alpha: T,
    scale: T,
    gradient: &mut [T],
) -> T {
    let count = probabilities.len();
    assert!(logarithms.len() == count && q.len() == count && gradient.len() == count, "other actions");
    let each = |i: usize| alpha * logarithms[i] - q[i];
    let sum = (0..count).fold(T::zero(), |sum, i| sum + probabilities[i] * each(i));
    for (i, slope) in gradient.iter_mut().enumerate() {
        *slope = scale * probabilities[i] * (each(i) - sum);
    }
    sum
}

#[cfg(test)]
mod tests {
    use super::*;
    use tpg_engine::random::{Purpose, Stream};

    #[test]
    fn gradients_equal_finite_differences() {
        let mut random = Stream::new(1, 0, Purpose::Test, 23);
        let mut draw = || -> [f64; 5] { std::array::from_fn(|_| random.normal()) };
        let (preferences, q) = (draw(), draw());
        let loss = |preferences: &[f64], gradient: &mut [f64]| {
            let (mut probabilities, mut logarithms) = ([0.0; 5], [0.0; 5]);
            softmax(preferences, &mut probabilities, &mut logarithms);
            assert!((probabilities.iter().sum::<f64>() - 1.0).abs() < 1e-12);
            softmax_backward((&probabilities, &logarithms), &q, 0.3, 1.0, gradient)
        };
        let mut gradient = [0.0; 5];
        loss(&preferences, &mut gradient);
        for index in 0..5 {
            let at = |by: f64| {
                let mut moved = preferences;
                moved[index] += by;
                loss(&moved, &mut [0.0; 5])
            };
            let slope = (at(1e-6) - at(-1e-6)) / 2e-6;
            assert!((gradient[index] - slope).abs() < 1e-7, "{index}: {slope}");
        }
    }
}
