//! Means with their standard deviation.

/// A mean with the population's standard deviation, as in the paper.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Spread {
    /// The mean.
    pub mean: f64,
    /// The standard deviation; 0 for a single value.
    pub sd: f64,
}

impl Spread {
    /// Computes mean and standard deviation of values.
    pub fn of(values: &[f64]) -> Self {
        let count = values.len().max(1) as f64;
        let mean = values.iter().sum::<f64>() / count;
        let variance = values.iter().map(|value| (value - mean) * (value - mean)).sum::<f64>() / count;
        Self { mean, sd: variance.sqrt() }
    }
}
