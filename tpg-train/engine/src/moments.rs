//! Mean and spread of numbers and of states.

use serde::{Deserialize, Serialize};

/// Mean and spread of some numbers.
///
/// ```
/// use tpg_engine::Sample;
///
/// let sample = Sample::new(&[1.0, 3.0, 5.0]);
/// assert_eq!((sample.mean, sample.sample_deviation()), (3.0, 2.0));
/// ```
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Sample {
    /// Number of numbers.
    pub count: usize,
    /// The mean; 0 without numbers.
    pub mean: f64,
    /// Sum of the squared distances from the mean.
    squares: f64,
}

impl Sample {
    /// Computes mean and spread.
    pub fn new(numbers: &[f64]) -> Self {
        let mean = numbers.iter().sum::<f64>() / numbers.len().max(1) as f64;
        let squares = numbers.iter().map(|number| (number - mean) * (number - mean)).sum();
        Self { count: numbers.len(), mean, squares }
    }

    /// Returns the standard deviation of the population (n); 0 for a single number.
    pub fn deviation(&self) -> f64 {
        (self.squares / self.count.max(1) as f64).sqrt()
    }

    /// Returns the standard deviation of the sample (n − 1); 0 for a single number.
    pub fn sample_deviation(&self) -> f64 {
        (self.squares / self.count.saturating_sub(1).max(1) as f64).sqrt()
    }

    /// Returns the 95 % interval of the mean, of ± 1.96 standard errors.
    pub fn interval(&self) -> [f64; 2] {
        let half = Z * self.sample_deviation() / (self.count.max(1) as f64).sqrt();
        [self.mean - half, self.mean + half]
    }
}

/// The 0.975 quantile of the normal distribution.
const Z: f64 = 1.959_963_984_540_054;

/// Returns Wilson's 95 % interval of a rate that was seen in `count` episodes.
///
/// ```
/// let [low, high] = tpg_engine::confidence(0.9, 100);
/// assert!((low - 0.8256).abs() < 1e-4 && (high - 0.9448).abs() < 1e-4);
/// ```
pub fn confidence(rate: f64, count: usize) -> [f64; 2] {
    let n = count.max(1) as f64;
    let middle = (rate + Z * Z / (2.0 * n)) / (1.0 + Z * Z / n);
    let half = Z / (1.0 + Z * Z / n) * (rate * (1.0 - rate) / n + Z * Z / (4.0 * n * n)).sqrt();
    [(middle - half).max(0.0), (middle + half).min(1.0)]
}

/// Returns the number below which a part of the numbers lies, interpolated; `None` without numbers.
///
/// ```
/// assert_eq!(tpg_engine::quantile(&[3.0, 1.0, 2.0, 5.0], 0.5), Some(2.5));
/// ```
pub fn quantile(numbers: &[f64], part: f64) -> Option<f64> {
    let mut sorted = numbers.to_vec();
    sorted.sort_by(f64::total_cmp);
    let last = sorted.len().checked_sub(1)?;
    let place = part * last as f64;
    let below = place as usize;
    let rest = place - below as f64;
    Some(sorted[below] + rest * (sorted[(below + 1).min(last)] - sorted[below]))
}

/// Mean and spread of each value of some states, without these (Welford 1962; merged as by Chan, Golub and LeVeque 1979).
///
/// ```
/// use tpg_engine::Moments;
///
/// let mut seen = Moments::new(2);
/// seen.push(&[1.0, 7.0]);
/// seen.push(&[5.0, 7.0]);
/// assert_eq!((seen.count(), seen.mean(0), seen.deviation(0)), (2, 3.0, Some(2.0)));
/// assert_eq!(seen.deviation(1), Some(0.0));
/// ```
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Moments {
    count: u64,
    means: Vec<f64>,
    /// Sums of the squared distances from the means.
    squares: Vec<f64>,
}

impl Moments {
    /// Creates the moments of no state of `length` values.
    pub fn new(length: usize) -> Self {
        Self { count: 0, means: vec![0.0; length], squares: vec![0.0; length] }
    }

    /// Returns the number of values of a state.
    pub fn length(&self) -> usize {
        self.means.len()
    }

    /// Returns the number of states.
    pub fn count(&self) -> u64 {
        self.count
    }

    /// Returns the mean of a value; 0 without states.
    pub fn mean(&self, place: usize) -> f64 {
        self.means[place]
    }

    /// Returns the standard deviation of a value, 0 or more; `None` without states.
    pub fn deviation(&self, place: usize) -> Option<f64> {
        (self.count > 0).then(|| (self.squares[place] / self.count as f64).sqrt())
    }

    /// Adds a state, unless one of its values is not finite.
    pub fn push(&mut self, state: &[f64]) {
        if !state.iter().all(|value| value.is_finite()) {
            return;
        }
        self.count += 1;
        for ((value, mean), squares) in state.iter().zip(&mut self.means).zip(&mut self.squares) {
            let distance = value - *mean;
            *mean += distance / self.count as f64;
            *squares += distance * (value - *mean);
        }
    }

    /// Adds the states of other moments of the same length.
    pub fn merge(&mut self, other: &Self) {
        if other.count == 0 {
            return;
        }
        let (own, others) = (self.count as f64, other.count as f64);
        self.count += other.count;
        let all = self.count as f64;
        let places = self.means.iter_mut().zip(&mut self.squares);
        for ((mean, squares), (of_other, more)) in places.zip(other.means.iter().zip(&other.squares)) {
            let distance = of_other - *mean;
            *mean += distance * (others / all);
            *squares += more + distance * distance * (own * (others / all));
        }
    }

    /// Returns the moments of some of the values, in the order of `places`.
    #[must_use]
    pub fn select(&self, places: impl Iterator<Item = usize> + Clone) -> Self {
        let chosen = |values: &[f64]| places.clone().map(|place| values[place]).collect();
        Self { count: self.count, means: chosen(&self.means), squares: chosen(&self.squares) }
    }
}

#[cfg(test)]
mod tests {
    use super::Moments;

    fn moments_of(states: &[[f64; 2]]) -> Moments {
        let mut moments = Moments::new(2);
        states.iter().for_each(|state| moments.push(state));
        moments
    }

    #[test]
    fn merged_moments_are_those_of_all_states() {
        let states = [[1.0, -3.0], [2.0, 1e3], [4.0, 0.5], [-9.0, 0.25], [0.0, 6.0]];
        let all = moments_of(&states);
        for cut in 0..=states.len() {
            let mut merged = moments_of(&states[..cut]);
            merged.merge(&moments_of(&states[cut..]));
            assert_eq!(merged.count(), 5);
            for place in 0..2 {
                assert!((merged.mean(place) - all.mean(place)).abs() < 1e-9, "cut {cut}");
                let [merged, all] = [&merged, &all].map(|moments| moments.deviation(place).expect("there are states"));
                assert!((merged - all).abs() < 1e-9, "cut {cut}");
            }
        }
    }

    #[test]
    fn a_state_that_is_not_finite_does_not_count() {
        assert_eq!(moments_of(&[[1.0, 2.0], [f64::NAN, 0.0], [0.0, f64::INFINITY]]), moments_of(&[[1.0, 2.0]]));
        assert_eq!(Moments::new(2).deviation(0), None);
    }

    #[test]
    fn values_are_selected() {
        let moments = moments_of(&[[1.0, 2.0], [3.0, 5.0]]);
        let (other, first) = (moments.select([1].into_iter()), moments.select([1, 0].into_iter()));
        assert_eq!((other.length(), other.mean(0), first.mean(1)), (1, 3.5, 2.0));
    }
}
