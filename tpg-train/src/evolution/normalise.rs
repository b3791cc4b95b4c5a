//! Weights of normalised inputs: less their mean, divided by their standard deviation, both over visited states.

use tpg_engine::Moments;

/// Minimum standard deviation of an input, in its unit: one that has hardly ever changed must not get a huge weight.
const MIN_DEVIATION: f64 = 1e-3;

/// Returns a sample's weights of inputs in the given units, and a constant, for each row: without normalisation by what was `seen`.
pub(super) fn unfolded(sample: &[f64], seen: &Moments, units: &[f64]) -> Vec<Vec<f64>> {
    let factor = |(place, unit): (usize, &f64)| {
        let deviation = seen.deviation(place).unwrap_or(*unit);
        unit / deviation.max(MIN_DEVIATION * unit)
    };
    let factors: Vec<f64> = units.iter().enumerate().map(factor).collect();
    let row = |weights: &[f64]| {
        let mut row: Vec<f64> = weights.iter().zip(&factors).map(|(weight, factor)| weight * factor).collect();
        let places = row.iter().zip(units).enumerate();
        row.push(-places.map(|(place, (weight, unit))| weight * seen.mean(place) / unit).sum::<f64>());
        row
    };
    sample.chunks_exact(units.len()).map(row).collect()
}

#[cfg(test)]
mod tests {
    use super::unfolded;
    use tpg_engine::Moments;

    #[test]
    fn unfolded_weights_give_the_normalised_sum() {
        let sample = [0.5, 2.0, -1.0, 1.0];
        let units = [4.0, 0.5];
        assert_eq!(
            unfolded(&sample, &Moments::new(2), &units),
            [[0.5, 2.0, 0.0], [-1.0, 1.0, 0.0]],
            "nothing seen: in units"
        );
        let mut seen = Moments::new(2);
        [[1.0, 7.0], [5.0, 7.0]].iter().for_each(|state| seen.push(state));
        // Mean 3 and deviation 2; the second input, always 7, has the least deviation.
        let state = [4.0, 7.001];
        for (row, weights) in unfolded(&sample, &seen, &units).iter().zip(sample.chunks_exact(2)) {
            let sum = row[0] * state[0] / units[0] + row[1] * state[1] / units[1] + row[2];
            let expected = weights[0] * (state[0] - 3.0) / 2.0 + weights[1] * (state[1] - 7.0) / 0.0005;
            assert!((sum - expected).abs() < 1e-9, "{sum} {expected}");
        }
    }
}
