//! The squashed Gaussian: an actor's output as a distribution over actions in −1..1.
//!
//! For each sample the actor outputs means and spreads, one of each per action component. With ε standard normal,
//!
//! - u = µ + σ·ε,
//! - a = tanh u,
//! - ln π(a) = Σ −ε²/2 − ln σ − ½ ln 2π − ln(1 − tanh² u).
//!
//! The last term is computed as 2·(ln 2 − u − softplus(−2u)), which does not overflow.

use serde::{Deserialize, Serialize};

/// The range of an actor's ln σ.
const LOG_SIGMA: [f32; 2] = [-5.0, 2.0];

/// The distribution defined by an actor with `2·actions` outputs: means first, then ln σ, clipped to −5..2.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
pub struct Gaussian {
    /// Number of action components.
    pub actions: usize,
}

/// Actions sampled for a batch.
#[derive(Clone, Debug, Default)]
pub struct Samples {
    /// tanh u, one column per sample.
    pub actions: Vec<f32>,
    /// ln π of each sample.
    pub log_densities: Vec<f32>,
    /// σ, one column per sample; negative where the spread was clipped and passes no gradient.
    sigma: Vec<f32>,
}

impl Gaussian {
    /// Samples one action per column; `noise` holds ε, one column per sample.
    ///
    /// # Panics
    /// If the size of `noise` does not match `outputs`.
    pub fn sample(self, outputs: &[f32], noise: &[f32], samples: &mut Samples) {
        assert_eq!(outputs.len(), 2 * noise.len(), "noise for another batch");
        let [low, high] = LOG_SIGMA;
        let constant = (0.5 * (2.0 * std::f64::consts::PI).ln()) as f32;
        samples.actions.clear();
        samples.log_densities.clear();
        samples.sigma.clear();
        for (output, noise) in outputs.chunks_exact(2 * self.actions).zip(noise.chunks_exact(self.actions)) {
            let (means, spreads) = output.split_at(self.actions);
            let (mut log_density, mut product) = (0.0, 1.0);
            for ((&mean, &spread), &noise) in means.iter().zip(spreads).zip(noise) {
                let inside = low < spread && spread < high;
                let clipped = if spread > high {
                    high
                } else if spread > low {
                    spread
                } else {
                    low
                };
                let sigma = libm::expf(clipped);
                let u = mean + sigma * noise;
                // With e = exp(−2|u|): |tanh u| = (1 − e)/(1 + e), softplus(−2u) = max(−2u, 0) + ln(1 + e). All 1 + e
                // are at most 2, so one logarithm of their product per sample suffices.
                let (magnitude, over) = if u > 0.0 { (u, 0.0) } else { (-u, -2.0 * u) };
                let e = libm::expf(-2.0 * magnitude);
                let squashed = (1.0 - e) / (1.0 + e);
                samples.actions.push(if u > 0.0 { squashed } else { -squashed });
                samples.sigma.push(if inside { sigma } else { -sigma });
                product *= 1.0 + e;
                let room = 2.0 * (std::f32::consts::LN_2 - u - over);
                log_density += -noise * noise / 2.0 - clipped - constant - room;
            }
            samples.log_densities.push(log_density + 2.0 * libm::logf(product));
        }
    }

    /// Computes the gradient of a loss with respect to the actor's outputs, through actions and densities of `samples`.
    ///
    /// `by_actions` is the loss's gradient with respect to the actions, `by_density` with respect to each sample's
    /// log-density.
    ///
    /// # Panics
    /// If the sizes do not match.
    pub fn backward(
        self,
        samples: &Samples,
        noise: &[f32],
        by_actions: &[f32],
        by_density: f32,
        by_outputs: &mut [f32],
    ) {
        assert!(by_actions.len() == noise.len() && by_outputs.len() == 2 * noise.len(), "another batch");
        let columns = by_outputs.chunks_exact_mut(2 * self.actions).enumerate();
        for (sample, column) in columns {
            let (by_means, by_spreads) = column.split_at_mut(self.actions);
            for i in 0..self.actions {
                let at = sample * self.actions + i;
                let (action, sigma) = (samples.actions[at], samples.sigma[at]);
                // d ln π / du = 2 tanh u; da/du = 1 − tanh² u.
                let by_u = by_actions[at] * (1.0 - action * action) + by_density * 2.0 * action;
                by_means[i] = by_u;
                by_spreads[i] = if sigma < 0.0 { 0.0 } else { by_u * sigma * noise[at] - by_density };
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use tpg_engine::random::{Purpose, Stream};

    /// Computes Σ c·a + w·ln π over a batch in `f64`, by the formulas.
    fn loss(outputs: &[f64], noise: &[f64], c: &[f64], w: f64) -> f64 {
        let [low, high] = LOG_SIGMA.map(f64::from);
        let columns = outputs.chunks_exact(8).zip(noise.chunks_exact(4)).zip(c.chunks_exact(4));
        let component = |mean: f64, spread: f64, noise: f64, c: f64| {
            let sigma = spread.clamp(low, high).exp();
            let u = mean + sigma * noise;
            let normal = -0.5 * noise * noise - sigma.ln() - 0.5 * std::f64::consts::TAU.ln();
            // 1 − tanh² u = 1 / cosh² u.
            c * u.tanh() + w * (normal + 2.0 * u.cosh().ln())
        };
        let column = |((output, noise), c): ((&[f64], &[f64]), &[f64])| -> f64 {
            (0..4).map(|i| component(output[i], output[4 + i], noise[i], c[i])).sum()
        };
        columns.map(column).sum()
    }

    #[test]
    fn gradients_equal_finite_differences() {
        let gaussian = Gaussian { actions: 4 };
        let mut random = Stream::new(1, 0, Purpose::Test, 22);
        let mut draw = |count: usize| -> Vec<f32> { (0..count).map(|_| random.normal() as f32).collect() };
        let (mut outputs, noise, c) = (draw(8 * 10), draw(4 * 10), draw(4 * 10));
        outputs[4] = 3.0; // clipped above
        outputs[5] = -6.0; // clipped below
        let mut samples = Samples::default();
        gaussian.sample(&outputs, &noise, &mut samples);
        let mut gradient = vec![f32::NAN; outputs.len()];
        gaussian.backward(&samples, &noise, &c, 0.3, &mut gradient);
        let wide = |values: &[f32]| -> Vec<f64> { values.iter().copied().map(f64::from).collect() };
        let (outputs, noise, c) = (wide(&outputs), wide(&noise), wide(&c));
        let (actions, densities) = (wide(&samples.actions), wide(&samples.log_densities));
        let sampled = actions.iter().zip(&c).map(|(a, c)| a * c).sum::<f64>() + 0.3 * densities.iter().sum::<f64>();
        assert!((sampled - loss(&outputs, &noise, &c, 0.3)).abs() < 1e-4);
        for index in 0..outputs.len() {
            let at = |by: f64| {
                let mut moved = outputs.clone();
                moved[index] += by;
                loss(&moved, &noise, &c, 0.3)
            };
            let (slope, found) = ((at(1e-6) - at(-1e-6)) / 2e-6, f64::from(gradient[index]));
            assert!((found - slope).abs() < 1e-4 * (1.0 + slope.abs()), "{index}: {found} {slope}");
        }
    }

    #[test]
    fn the_density_integrates_to_one() {
        // One component: sum π(a) da over a fine grid of a, with ε recovered from a.
        let (mean, log_sigma) = (0.4f64, -0.7f64);
        let gaussian = Gaussian { actions: 1 };
        let step = 1e-4;
        let total: f64 = (-9999..=9999)
            .map(|i| {
                let noise = ((f64::from(i) * step).atanh() - mean) / log_sigma.exp();
                let mut samples = Samples::default();
                gaussian.sample(&[mean as f32, log_sigma as f32], &[noise as f32], &mut samples);
                f64::from(samples.log_densities[0]).exp() * step
            })
            .sum();
        assert!((total - 1.0).abs() < 1e-3, "{total}");
    }

    #[test]
    fn far_out_means_stay_finite() {
        let gaussian = Gaussian { actions: 1 };
        for mean in [-1e4f32, -50.0, 50.0, 1e4] {
            let mut samples = Samples::default();
            gaussian.sample(&[mean, -2.0], &[0.5], &mut samples);
            assert!(samples.log_densities[0].is_finite() && samples.actions[0].abs() <= 1.0);
        }
    }
}
