//! Covariance matrix adaptation: a search for real numbers whose directions and step sizes follow what succeeded.
//!
//! The algorithm is Hansen's (“The CMA Evolution Strategy: A Tutorial”), with the Cholesky factor of the covariance in
//! place of its eigenvectors (Krause, Arbonès and Igel 2016): products and square roots have the same bits on every
//! machine. A diagonal covariance learns faster by the factor (n + 2) / 3 (Ros and Hansen 2008), which pays where a run has few
//! generations for each number.

use super::config::Covariance;
use nalgebra::{Cholesky, DMatrix, DVector};
use serde::{Deserialize, Serialize};
use tpg_engine::random::Stream;
use tpg_graph::error::Finding;

/// The search distribution, and the paths that its mean has taken.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Cma {
    /// Number of updates so far.
    updates: u32,
    /// Mean of the distribution.
    mean: Vec<f64>,
    /// Step size.
    deviation: f64,
    /// Covariance: its diagonal, or all of it, column after column.
    covariance: Vec<f64>,
    /// Evolution path of the covariance.
    path: Vec<f64>,
    /// Evolution path of the step size, in the coordinates of the samples' normal numbers.
    step_path: Vec<f64>,
}

impl Cma {
    /// Starts at 0, with the same deviation in every direction.
    pub fn new(numbers: usize, deviation: f64, kind: Covariance) -> Self {
        let covariance = match kind {
            Covariance::Full => DMatrix::<f64>::identity(numbers, numbers).as_slice().to_vec(),
            Covariance::Diagonal => vec![1.0; numbers],
        };
        let zeros = vec![0.0; numbers];
        Self { updates: 0, mean: zeros.clone(), deviation, covariance, path: zeros.clone(), step_path: zeros }
    }

    /// Returns Hansen's number of samples of a generation: 4 + ⌊3 ln n⌋.
    pub fn usual_samples(numbers: usize) -> usize {
        4 + (3.0 * libm::log(numbers as f64)) as usize
    }

    /// Returns the mean of the distribution.
    pub fn mean(&self) -> &[f64] {
        &self.mean
    }

    /// Draws the samples of a generation.
    pub fn samples(&self, count: usize, stream: &mut Stream) -> Vec<Vec<f64>> {
        let factor = self.factor();
        let mut sample = || {
            let step = factor.times(DVector::from_fn(self.mean.len(), |_, _| stream.normal()));
            self.mean.iter().zip(&step).map(|(mean, step)| mean + self.deviation * step).collect()
        };
        (0..count).map(|_| sample()).collect()
    }

    /// Moves the distribution towards the better half of a generation's samples, which are given best first in groups of
    /// equals, whose sizes are given.
    ///
    /// # Panics
    /// If there are fewer than 2 samples.
    pub fn update(&mut self, samples: &[Vec<f64>], groups: &[usize]) {
        let n = self.mean.len() as f64;
        let weights = weights(samples.len(), groups);
        let parents = weights.iter().take_while(|&&weight| weight > 0.0).count();
        let effective = 1.0 / weights.iter().map(|weight| weight * weight).sum::<f64>();
        let path_rate = (4.0 + effective / n) / (n + 4.0 + 2.0 * effective / n);
        let step_rate = (effective + 2.0) / (n + effective + 5.0);
        let faster = if self.is_diagonal() { (n + 2.0) / 3.0 } else { 1.0 };
        let rank_one = (faster * 2.0 / ((n + 1.3) * (n + 1.3) + effective)).min(1.0);
        let of_parents = faster * 2.0 * (effective - 2.0 + 1.0 / effective) / ((n + 2.0) * (n + 2.0) + effective);
        let rank_many = of_parents.min(1.0 - rank_one);
        let damping = 1.0 + 2.0 * (((effective - 1.0) / (n + 1.0)).sqrt() - 1.0).max(0.0) + step_rate;
        let expected = n.sqrt() * (1.0 - 1.0 / (4.0 * n) + 1.0 / (21.0 * n * n));

        let mean = DVector::from_column_slice(&self.mean);
        let steps: Vec<DVector<f64>> = (samples.iter().take(parents))
            .map(|sample| (DVector::from_column_slice(sample) - &mean) / self.deviation)
            .collect();
        let step =
            (steps.iter().zip(&weights)).fold(DVector::zeros(mean.len()), |sum, (step, &weight)| sum + step * weight);
        let white = self.factor().whitened(&step);
        self.mean = (mean + &step * self.deviation).as_slice().to_vec();

        self.updates += 1;
        let scaled = (step_rate * (2.0 - step_rate) * effective).sqrt();
        for (path, white) in self.step_path.iter_mut().zip(&white) {
            *path = (1.0 - step_rate) * *path + scaled * white;
        }
        let length = self.step_path.iter().map(|value| value * value).sum::<f64>().sqrt();
        let settled = (1.0 - libm::pow(1.0 - step_rate, 2.0 * f64::from(self.updates))).sqrt();
        let is_short = length / settled / expected < 1.4 + 2.0 / (n + 1.0);
        let scaled = if is_short { (path_rate * (2.0 - path_rate) * effective).sqrt() } else { 0.0 };
        for (path, step) in self.path.iter_mut().zip(&step) {
            *path = (1.0 - path_rate) * *path + scaled * step;
        }
        self.learn_covariance(&steps, &weights, rank_one, rank_many);
        // The factor is bounded so that no stroke of luck ends in infinity.
        self.deviation *= libm::exp((step_rate / damping * (length / expected - 1.0)).clamp(-1.0, 1.0));
        self.deviation = self.deviation.clamp(1e-12, 1e6);
    }

    /// Moves the covariance towards its evolution path and the given steps.
    fn learn_covariance(&mut self, steps: &[DVector<f64>], weights: &[f64], rank_one: f64, rank_many: f64) {
        let kept = 1.0 - rank_one - rank_many;
        let path = DVector::from_column_slice(&self.path);
        let seen = || (steps.iter().zip(weights)).map(|(step, weight)| (rank_many * weight, step));
        if self.is_diagonal() {
            for (place, variance) in self.covariance.iter_mut().enumerate() {
                let own = kept * *variance + rank_one * path[place] * path[place];
                *variance = seen().fold(own, |sum, (share, step)| sum + share * step[place] * step[place]);
            }
        } else {
            let mut covariance = self.matrix() * kept;
            covariance.ger(rank_one, &path, &path, 1.0);
            for (share, step) in seen() {
                covariance.ger(share, step, step, 1.0);
            }
            self.covariance = covariance.as_slice().to_vec();
        }
    }

    /// True if only the diagonal of the covariance is learned.
    fn is_diagonal(&self) -> bool {
        self.covariance.len() == self.mean.len()
    }

    fn matrix(&self) -> DMatrix<f64> {
        DMatrix::from_column_slice(self.mean.len(), self.mean.len(), &self.covariance)
    }

    /// Returns the factor of the covariance; that of its diagonal if rounding has made it indefinite.
    fn factor(&self) -> Factor {
        let diagonal = |variances: DVector<f64>| Factor::Diagonal(variances.map(|value| value.max(1e-24).sqrt()));
        if self.is_diagonal() {
            return diagonal(DVector::from_column_slice(&self.covariance));
        }
        let matrix = self.matrix();
        let variances = matrix.diagonal();
        Cholesky::new(matrix).map_or_else(|| diagonal(variances), |factor| Factor::Full(factor.unpack()))
    }

    /// Checks a search that was read from a file.
    ///
    /// # Errors
    /// Another number of numbers, or one that is not finite.
    pub(super) fn check(&self, numbers: usize, kind: Covariance) -> Result<(), Finding> {
        let covariance = match kind {
            Covariance::Full => numbers * numbers,
            Covariance::Diagonal => numbers,
        };
        let lengths = [
            ("mean", &self.mean, numbers),
            ("covariance", &self.covariance, covariance),
            ("path", &self.path, numbers),
            ("step_path", &self.step_path, numbers),
        ];
        for (key, values, length) in lengths {
            if values.len() != length || values.iter().any(|value| !value.is_finite()) {
                return Err(Finding::new(key, format!("{} numbers", values.len()), format!("{length} finite numbers")));
            }
        }
        Finding::range("deviation", self.deviation, 1e-12, 1e6)
    }
}

/// A matrix whose product with its transpose is a covariance.
enum Factor {
    /// A lower triangular one.
    Full(DMatrix<f64>),
    /// The square roots of a diagonal.
    Diagonal(DVector<f64>),
}

impl Factor {
    /// Returns the product with normal numbers: a step.
    fn times(&self, normal: DVector<f64>) -> DVector<f64> {
        match self {
            Self::Full(factor) => factor * normal,
            Self::Diagonal(roots) => roots.component_mul(&normal),
        }
    }

    /// Returns the normal numbers that a step was made from.
    fn whitened(&self, step: &DVector<f64>) -> DVector<f64> {
        match self {
            Self::Full(factor) => factor.solve_lower_triangular(step).unwrap_or_else(|| step.clone()),
            Self::Diagonal(roots) => step.component_div(roots),
        }
    }
}

/// Returns the weights of samples, best first, which sum up to 1: those of the better half fall with the rank, and equals share
/// theirs.
///
/// # Panics
/// If there are fewer than 2 samples.
fn weights(samples: usize, groups: &[usize]) -> Vec<f64> {
    let parents = samples / 2;
    assert!(parents > 0, "at least two samples");
    let of_rank = |rank: usize| {
        if rank <= parents { libm::log(parents as f64 + 0.5) - libm::log(rank as f64) } else { 0.0 }
    };
    let weights: Vec<f64> = (1..=samples).map(of_rank).collect();
    let total: f64 = weights.iter().sum();
    let mut left = &weights[..];
    let mut shared = Vec::with_capacity(samples);
    for &size in groups {
        let (group, rest) = left.split_at(size);
        shared.extend(vec![group.iter().map(|weight| weight / total).sum::<f64>() / size as f64; size]);
        left = rest;
    }
    shared
}

#[cfg(test)]
mod tests {
    use super::{Cma, weights};
    use crate::evolution::config::Covariance;
    use tpg_engine::random::{Purpose, Stream};

    /// Minimises a function and returns the best value of the last generation.
    fn minimum(numbers: usize, generations: u64, kind: Covariance, value: impl Fn(&[f64]) -> f64) -> f64 {
        let mut cma = Cma::new(numbers, 0.5, kind);
        let mut best = f64::INFINITY;
        for generation in 0..generations {
            let mut stream = Stream::new(1, generation, Purpose::Test, 0);
            let mut samples = cma.samples(Cma::usual_samples(numbers), &mut stream);
            samples.sort_by(|a, b| value(a).total_cmp(&value(b)));
            best = value(&samples[0]);
            cma.update(&samples, &vec![1; samples.len()]);
        }
        best
    }

    #[test]
    fn it_finds_the_minimum_of_a_stretched_and_of_a_bent_valley() {
        let ellipsoid = |x: &[f64]| {
            let term = |(place, x): (usize, &f64)| 10f64.powf(4.0 * place as f64 / 7.0) * (x - 1.0) * (x - 1.0);
            x.iter().enumerate().map(term).sum()
        };
        assert!(minimum(8, 400, Covariance::Full, ellipsoid) < 1e-9);
        let rosenbrock =
            |x: &[f64]| x.windows(2).map(|x| 100.0 * (x[1] - x[0] * x[0]).powi(2) + (1.0 - x[0]).powi(2)).sum::<f64>();
        assert!(minimum(5, 600, Covariance::Full, rosenbrock) < 1e-9);
        // Variances alone are learned faster, and do not follow a bend.
        let [full, diagonal] = [Covariance::Full, Covariance::Diagonal].map(|kind| minimum(8, 150, kind, ellipsoid));
        assert!(diagonal < 1e-3 * full, "{diagonal} and {full}");
        assert!(minimum(5, 600, Covariance::Diagonal, rosenbrock) > 1e-9);
    }

    #[test]
    fn where_nothing_is_better_it_stays_finite() {
        let kinds = [Covariance::Full, Covariance::Diagonal];
        for (groups, kind) in [vec![1; 9], vec![9]].iter().flat_map(|groups| kinds.map(|kind| (groups, kind))) {
            let mut cma = Cma::new(6, 0.5, kind);
            for generation in 0..500 {
                let samples = cma.samples(9, &mut Stream::new(1, generation, Purpose::Test, 0));
                cma.update(&samples, groups);
            }
            assert_eq!(cma.check(6, kind), Ok(()));
        }
    }

    #[test]
    fn equals_share_the_weights_of_their_ranks() {
        let alone = weights(6, &[1; 6]);
        assert!(alone[0] > alone[1] && alone[1] > alone[2] && alone[3..] == [0.0; 3]);
        let shared = weights(6, &[1, 3, 2]);
        let third = (alone[1] + alone[2]) / 3.0;
        assert_eq!(shared, [alone[0], third, third, third, 0.0, 0.0]);
        assert!((shared.iter().sum::<f64>() - 1.0).abs() < 1e-12);
    }

    #[test]
    fn it_goes_on_where_it_was_written() {
        for (kind, other) in [(Covariance::Full, Covariance::Diagonal), (Covariance::Diagonal, Covariance::Full)] {
            let mut cma = Cma::new(4, 0.5, kind);
            for generation in 0..20 {
                let samples = cma.samples(8, &mut Stream::new(1, generation, Purpose::Test, 0));
                cma.update(&samples, &vec![1; samples.len()]);
            }
            let text = serde_json::to_string(&cma).expect("plain data");
            let read: Cma = serde_json::from_str(&text).expect("what was written");
            let draw = |cma: &Cma| cma.samples(8, &mut Stream::new(1, 99, Purpose::Test, 0));
            assert_eq!(draw(&read), draw(&cma));
            assert!(cma.check(4, kind).is_ok() && cma.check(5, kind).is_err() && cma.check(4, other).is_err());
            assert!(Cma { deviation: f64::NAN, ..cma }.check(4, kind).is_err());
        }
    }
}
