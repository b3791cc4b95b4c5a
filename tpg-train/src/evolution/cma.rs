//! Covariance matrix adaptation with a diagonal covariance: a search for real numbers whose step sizes follow what succeeded.
//!
//! The algorithm is Hansen's (“The CMA Evolution Strategy: A Tutorial”) with the variance of each number alone, learned faster by the
//! factor (n + 2) / 3 (Ros and Hansen 2008): a run has few generations for each number.

use serde::{Deserialize, Serialize};
use tpg_engine::random::Stream;

/// The search distribution, and the paths that its mean has taken.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub(super) struct Cma {
    /// Number of updates so far.
    updates: u32,
    /// Mean of the distribution.
    mean: Vec<f64>,
    /// Step size.
    deviation: f64,
    /// Variance of each number, in units of the step size.
    variances: Vec<f64>,
    /// Evolution path of the variances.
    path: Vec<f64>,
    /// Evolution path of the step size, in the coordinates of the samples' normal numbers.
    step_path: Vec<f64>,
}

impl Cma {
    /// Starts at 0, with the same standard deviation in every direction.
    pub(super) fn new(numbers: usize, deviation: f64) -> Self {
        let zeros = vec![0.0; numbers];
        Self {
            updates: 0,
            mean: zeros.clone(),
            deviation,
            variances: vec![1.0; numbers],
            path: zeros.clone(),
            step_path: zeros,
        }
    }

    /// Returns Hansen's number of samples of a generation: 4 + ⌊3 ln n⌋.
    pub(super) fn default_population(numbers: usize) -> usize {
        4 + (3.0 * libm::log(numbers as f64)) as usize
    }

    /// Returns the mean of the distribution.
    pub(super) fn mean(&self) -> &[f64] {
        &self.mean
    }

    /// Draws the samples of a generation.
    pub(super) fn samples(&self, count: usize, stream: &mut Stream) -> Vec<Vec<f64>> {
        let roots = self.roots();
        let mut sample = || {
            let numbers = self.mean.iter().zip(&roots);
            numbers.map(|(mean, root)| mean + self.deviation * root * stream.normal()).collect()
        };
        (0..count).map(|_| sample()).collect()
    }

    /// Draws pairs of opposite samples: `count` of them, or one more.
    pub(super) fn pairs(&self, count: usize, stream: &mut Stream) -> Vec<Vec<f64>> {
        let opposite =
            |sample: &Vec<f64>| self.mean.iter().zip(sample).map(|(mean, value)| 2.0 * mean - value).collect();
        let samples = self.samples(count.div_ceil(2), stream);
        samples.into_iter().flat_map(|sample| [opposite(&sample), sample]).collect()
    }

    /// Moves the distribution towards the better half of a generation's samples, which are given best first.
    ///
    /// # Panics
    /// If there are fewer than 2 samples.
    pub(super) fn update(&mut self, samples: &[Vec<f64>]) {
        let n = self.mean.len() as f64;
        let weights = weights(samples.len());
        let effective = 1.0 / weights.iter().map(|weight| weight * weight).sum::<f64>();
        let path_rate = (4.0 + effective / n) / (n + 4.0 + 2.0 * effective / n);
        let step_rate = (effective + 2.0) / (n + effective + 5.0);
        let faster = (n + 2.0) / 3.0;
        let rank_one = (faster * 2.0 / ((n + 1.3) * (n + 1.3) + effective)).min(1.0);
        let of_parents = faster * 2.0 * (effective - 2.0 + 1.0 / effective) / ((n + 2.0) * (n + 2.0) + effective);
        let rank_many = of_parents.min(1.0 - rank_one);
        let damping = 1.0 + 2.0 * (((effective - 1.0) / (n + 1.0)).sqrt() - 1.0).max(0.0) + step_rate;
        let expected = n.sqrt() * (1.0 - 1.0 / (4.0 * n) + 1.0 / (21.0 * n * n));

        let steps: Vec<(f64, Vec<f64>)> = (weights.into_iter().zip(samples))
            .map(|(weight, sample)| {
                let step = sample.iter().zip(&self.mean).map(|(sample, mean)| (sample - mean) / self.deviation);
                (weight, step.collect())
            })
            .collect();
        let step: Vec<f64> =
            (0..self.mean.len()).map(|place| steps.iter().map(|(weight, step)| weight * step[place]).sum()).collect();
        self.updates += 1;
        let scaled = (step_rate * (2.0 - step_rate) * effective).sqrt();
        let roots = self.roots();
        for (path, (step, root)) in self.step_path.iter_mut().zip(step.iter().zip(roots)) {
            *path = (1.0 - step_rate) * *path + scaled * step / root;
        }
        let length = self.step_path.iter().map(|value| value * value).sum::<f64>().sqrt();
        let settled = (1.0 - libm::pow(1.0 - step_rate, 2.0 * f64::from(self.updates))).sqrt();
        let is_short = length / settled / expected < 1.4 + 2.0 / (n + 1.0);
        let scaled = if is_short { (path_rate * (2.0 - path_rate) * effective).sqrt() } else { 0.0 };
        for (place, variance) in self.variances.iter_mut().enumerate() {
            let path = (1.0 - path_rate) * self.path[place] + scaled * step[place];
            let squares: f64 = steps.iter().map(|(weight, step)| weight * step[place] * step[place]).sum();
            *variance = (1.0 - rank_one - rank_many) * *variance + rank_one * path * path + rank_many * squares;
            self.path[place] = path;
            self.mean[place] += self.deviation * step[place];
        }
        // The factor is bounded so that no stroke of luck ends in infinity.
        self.deviation *= libm::exp((step_rate / damping * (length / expected - 1.0)).clamp(-1.0, 1.0));
        self.deviation = self.deviation.clamp(1e-12, 1e6);
    }

    /// Returns the square roots of the variances, which rounding cannot make 0.
    fn roots(&self) -> Vec<f64> {
        self.variances.iter().map(|value| value.max(1e-24).sqrt()).collect()
    }
}

/// Returns the weights of the better half of samples, best first, which sum up to 1 and fall with the rank.
///
/// # Panics
/// If there are fewer than 2 samples.
fn weights(samples: usize) -> Vec<f64> {
    let parents = samples / 2;
    assert!(parents > 0, "at least two samples");
    let weights = (1..=parents).map(|rank| libm::log(parents as f64 + 0.5) - libm::log(rank as f64));
    let total: f64 = weights.clone().sum();
    weights.map(|weight| weight / total).collect()
}

#[cfg(test)]
mod tests {
    use super::{Cma, weights};
    use tpg_engine::random::{Purpose, Stream};

    /// Minimises a function and returns the best value of the last generation.
    fn minimum(numbers: usize, generations: u64, value: impl Fn(&[f64]) -> f64) -> f64 {
        let mut cma = Cma::new(numbers, 0.5);
        let mut best = f64::INFINITY;
        for generation in 0..generations {
            let mut stream = Stream::new(1, generation, Purpose::Test, 0);
            let mut samples = cma.samples(Cma::default_population(numbers), &mut stream);
            samples.sort_by(|a, b| value(a).total_cmp(&value(b)));
            best = value(&samples[0]);
            cma.update(&samples);
        }
        best
    }

    #[test]
    fn it_finds_the_minimum_of_a_stretched_valley() {
        let ellipsoid = |x: &[f64]| {
            let term = |(place, x): (usize, &f64)| 10f64.powf(4.0 * place as f64 / 7.0) * (x - 1.0) * (x - 1.0);
            x.iter().enumerate().map(term).sum()
        };
        let found = minimum(8, 250, ellipsoid);
        assert!(found < 1e-9, "{found}");
    }

    #[test]
    fn where_nothing_is_better_it_stays_finite_and_goes_on_where_it_was_written() {
        let mut cma = Cma::new(6, 0.5);
        for generation in 0..500 {
            let samples = cma.samples(9, &mut Stream::new(1, generation, Purpose::Test, 0));
            cma.update(&samples);
        }
        assert!(cma.mean.iter().chain(&cma.variances).all(|value| value.is_finite()));
        let read: Cma = serde_json::from_str(&serde_json::to_string(&cma).expect("plain data")).expect("as written");
        let draw = |cma: &Cma| cma.samples(8, &mut Stream::new(1, 99, Purpose::Test, 0));
        assert_eq!(draw(&read), draw(&cma));
    }

    #[test]
    fn weights_fall_and_sum_up_to_one() {
        let weights = weights(7);
        assert!(weights.len() == 3 && weights[0] > weights[1] && weights[1] > weights[2] && weights[2] > 0.0);
        assert!((weights.iter().sum::<f64>() - 1.0).abs() < 1e-12);
    }
}
