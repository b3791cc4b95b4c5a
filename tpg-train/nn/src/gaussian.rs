//! The squashed Gaussian: an actor's output as a distribution over actions in −1..1.
//!
//! For each sample the actor outputs means and spreads, one of each per action component. With ε standard normal,
//!
//! - u = µ + σ·ε,
//! - a = tanh u,
//! - ln π(a) = Σ −ε²/2 − ln σ − ½ ln 2π − ln(1 − tanh² u).
//!
//! The last term is computed as 2·(ln 2 − u − softplus(−2u)), which does not overflow.

use super::Real;
use serde::{Deserialize, Serialize};

/// Meaning of the second half of an actor's outputs.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
#[serde(rename_all = "kebab-case")]
pub enum Spread {
    /// ln σ, clipped to −5..2.
    LogSigma,
    /// σ itself, clipped to 1e-6..1, as in the paper.
    Sigma,
}

impl Spread {
    fn range(self) -> (f64, f64) {
        match self {
            Self::LogSigma => (-5.0, 2.0),
            Self::Sigma => (1e-6, 1.0),
        }
    }
}

/// The distribution defined by an actor with `2·actions` outputs: means first, then spreads.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Gaussian {
    /// Number of action components.
    pub actions: usize,
    /// Meaning of the second half of the outputs.
    pub spread: Spread,
}

/// Actions sampled for a batch.
#[derive(Clone, Debug, Default)]
pub struct Samples<T> {
    /// tanh u, one column per sample.
    pub actions: Vec<T>,
    /// ln π of each sample.
    pub log_densities: Vec<T>,
    /// σ, one column per sample; negative where the spread was clipped and passes no gradient.
    sigma: Vec<T>,
}

impl Gaussian {
    /// Samples one action per column; `noise` holds ε, one column per sample.
    ///
    /// # Panics
    /// If the size of `noise` does not match `outputs`.
    pub fn sample<T: Real>(self, outputs: &[T], noise: &[T], samples: &mut Samples<T>) {
        T::sample(self, outputs, noise, samples);
    }

    pub(super) fn compute_sample<T: Real>(self, outputs: &[T], noise: &[T], samples: &mut Samples<T>) {
        assert_eq!(outputs.len(), 2 * noise.len(), "noise for another batch");
        let (low, high) = self.spread.range();
        let (low, high) = (T::nearest(low), T::nearest(high));
        let constant = T::nearest(0.5 * (2.0 * std::f64::consts::PI).ln());
        let two = T::nearest(2.0);
        samples.actions.clear();
        samples.log_densities.clear();
        samples.sigma.clear();
        for (output, noise) in outputs.chunks_exact(2 * self.actions).zip(noise.chunks_exact(self.actions)) {
            let (means, spreads) = output.split_at(self.actions);
            let (mut log_density, mut product) = (T::zero(), T::one());
            for ((&mean, &spread), &noise) in means.iter().zip(spreads).zip(noise) {
                let inside = low < spread && spread < high;
                let clipped = if spread > high {
                    high
                } else if spread > low {
                    spread
                } else {
                    low
                };
                let (sigma, log_sigma) = match self.spread {
                    Spread::LogSigma => (clipped.exponential(), clipped),
                    Spread::Sigma => (clipped, clipped.logarithm()),
                };
                let u = mean + sigma * noise;
                // With e = exp(−2|u|): |tanh u| = (1 − e)/(1 + e), softplus(−2u) = max(−2u, 0) + ln(1 + e). All 1 + e
                // are at most 2, so one logarithm of their product per sample suffices.
                let (magnitude, over) = if u > T::zero() { (u, T::zero()) } else { (-u, -two * u) };
                let e = (-two * magnitude).exponential();
                let squashed = (T::one() - e) / (T::one() + e);
                samples.actions.push(if u > T::zero() { squashed } else { -squashed });
                samples.sigma.push(if inside { sigma } else { -sigma });
                product *= T::one() + e;
                let room = two * (T::nearest(std::f64::consts::LN_2) - u - over);
                log_density += -noise * noise / two - log_sigma - constant - room;
            }
            samples.log_densities.push(log_density + two * product.logarithm());
        }
    }

    /// Computes the gradient of a loss with respect to the actor's outputs, through actions and densities of `samples`.
    ///
    /// `by_actions` is the loss's gradient with respect to the actions, `by_density` with respect to each sample's
    /// log-density.
    ///
    /// # Panics
    /// If the sizes do not match.
    pub fn backward<T: Real>(
        self,
        samples: &Samples<T>,
        noise: &[T],
        by_actions: &[T],
        by_density: T,
        by_outputs: &mut [T],
    ) {
        T::sample_backward(self, samples, noise, by_actions, by_density, by_outputs);
    }

    pub(super) fn compute_backward<T: Real>(
        self,
        samples: &Samples<T>,
        noise: &[T],
        by_actions: &[T],
        by_density: T,
        by_outputs: &mut [T],
    ) {
        assert!(by_actions.len() == noise.len() && by_outputs.len() == 2 * noise.len(), "another batch");
        let columns = by_outputs.chunks_exact_mut(2 * self.actions).enumerate();
        for (sample, column) in columns {
            let (by_means, by_spreads) = column.split_at_mut(self.actions);
            for i in 0..self.actions {
                let at = sample * self.actions + i;
                let (action, sigma) = (samples.actions[at], samples.sigma[at]);
                // d ln π / du = 2 tanh u; da/du = 1 − tanh² u.
                let by_u = by_actions[at] * (T::one() - action * action) + by_density * T::nearest(2.0) * action;
                by_means[i] = by_u;
                by_spreads[i] = if sigma < T::zero() {
                    T::zero()
                } else {
                    match self.spread {
                        Spread::LogSigma => by_u * sigma * noise[at] - by_density,
                        Spread::Sigma => by_u * noise[at] - by_density / sigma,
                    }
                };
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use tpg_engine::random::{Purpose, Stream};

    /// Σ c·a + w·ln π, over a batch.
    fn loss(gaussian: Gaussian, outputs: &[f64], noise: &[f64], c: &[f64], w: f64) -> f64 {
        let mut samples = Samples::default();
        gaussian.sample(outputs, noise, &mut samples);
        let actions: f64 = samples.actions.iter().zip(c).map(|(a, c)| a * c).sum();
        actions + w * samples.log_densities.iter().sum::<f64>()
    }

    #[test]
    fn gradients_equal_finite_differences() {
        for spread in [Spread::LogSigma, Spread::Sigma] {
            let gaussian = Gaussian { actions: 4, spread };
            let mut random = Stream::new(1, 0, Purpose::Test, 22);
            let mut draw = |count: usize| -> Vec<f64> { (0..count).map(|_| random.normal()).collect() };
            let (mut outputs, noise, c) = (draw(8 * 10), draw(4 * 10), draw(4 * 10));
            outputs[4] = 3.0; // clipped above, in both readings
            outputs[5] = -6.0; // clipped below
            let mut samples = Samples::default();
            gaussian.sample(&outputs, &noise, &mut samples);
            let mut gradient = vec![f64::NAN; outputs.len()];
            gaussian.backward(&samples, &noise, &c, 0.3, &mut gradient);
            for index in 0..outputs.len() {
                let at = |by: f64| {
                    let mut moved = outputs.clone();
                    moved[index] += by;
                    loss(gaussian, &moved, &noise, &c, 0.3)
                };
                let slope = (at(1e-6) - at(-1e-6)) / 2e-6;
                assert!((gradient[index] - slope).abs() < 1e-5 * (1.0 + slope.abs()), "{spread:?} {index}: {slope}");
            }
        }
    }

    #[test]
    fn the_density_integrates_to_one() {
        // One component: sum π(a) da over a fine grid of a, with ε recovered from a.
        let (mean, log_sigma) = (0.4f64, -0.7f64);
        let gaussian = Gaussian { actions: 1, spread: Spread::LogSigma };
        let step = 1e-4;
        let total: f64 = (-9999..=9999)
            .map(|i| {
                let noise = ((f64::from(i) * step).atanh() - mean) / log_sigma.exp();
                let mut samples = Samples::default();
                gaussian.sample(&[mean, log_sigma], &[noise], &mut samples);
                samples.log_densities[0].exp() * step
            })
            .sum();
        assert!((total - 1.0).abs() < 1e-3, "{total}");
    }

    #[test]
    fn far_out_means_stay_finite() {
        let gaussian = Gaussian { actions: 1, spread: Spread::LogSigma };
        for mean in [-1e4f32, -50.0, 50.0, 1e4] {
            let mut samples = Samples::default();
            gaussian.sample(&[mean, -2.0], &[0.5], &mut samples);
            assert!(samples.log_densities[0].is_finite() && samples.actions[0].abs() <= 1.0);
        }
    }
}
