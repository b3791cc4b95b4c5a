//! From a trained network's numbers to integers.
//!
//! Each row of weights has a scale of its own: its greatest magnitude becomes 127. Each hidden layer has one scale: twice
//! the greatest activation that calibration saw becomes 32767, so that an activation may double before it is clipped.
//! Weights and biases are rounded to nearest, halves away from zero.

use super::QuantisedLayer;
use tpg_runtime::sac::fixed::{FEATURE_ONE, PREFERENCE_ONE};

/// A linear layer in floating point.
#[derive(Clone, Debug, PartialEq)]
pub struct FloatLayer {
    /// Values in.
    pub inputs: usize,
    /// Row-major, outputs × inputs.
    pub weights: Vec<f32>,
    /// One a row.
    pub bias: Vec<f32>,
}

/// Why a network cannot be put into integers.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
pub enum QuantiseError {
    /// A weight or a bias is not finite.
    #[error("layer {layer}, row {row}: a number that is not finite")]
    NotFinite {
        /// Counted from 0.
        layer: usize,
        /// Counted from 0.
        row: usize,
    },
    /// A bias is so much greater than the weights that it does not fit the accumulator.
    #[error("layer {layer}, row {row}: a bias of {bias} does not fit 32 bits")]
    Bias {
        /// Counted from 0.
        layer: usize,
        /// Counted from 0.
        row: usize,
        /// In units of the accumulator.
        bias: f64,
    },
    /// A hidden layer never fired in calibration.
    #[error("layer {layer}: calibration saw no activation")]
    Silent {
        /// Counted from 0.
        layer: usize,
    },
}

/// Layers in integers; `greatest` holds the greatest activation that calibration saw behind each hidden layer.
///
/// # Errors
/// If a number does not fit.
///
/// # Panics
/// If `greatest` does not hold one number for each hidden layer.
pub fn quantise(layers: &[FloatLayer], greatest: &[f32]) -> Result<Vec<QuantisedLayer>, QuantiseError> {
    assert_eq!(greatest.len() + 1, layers.len(), "one activation for each hidden layer");
    let mut input_one = f64::from(FEATURE_ONE);
    let mut quantised = Vec::with_capacity(layers.len());
    for (index, layer) in layers.iter().enumerate() {
        let output_one = match greatest.get(index) {
            Some(&greatest) if greatest > 0.0 && greatest.is_finite() => {
                f64::from(i16::MAX) / (2.0 * f64::from(greatest))
            }
            Some(_) => return Err(QuantiseError::Silent { layer: index }),
            None => f64::from(PREFERENCE_ONE),
        };
        quantised.push(rows(index, layer, input_one, output_one)?);
        input_one = output_one;
    }
    Ok(quantised)
}

fn rows(index: usize, layer: &FloatLayer, input_one: f64, output_one: f64) -> Result<QuantisedLayer, QuantiseError> {
    let (inputs, outputs) = (layer.inputs, layer.bias.len());
    let mut quantised =
        QuantisedLayer { inputs, outputs, weights: vec![], bias: vec![], factor: vec![], shift: vec![] };
    for (row, (weights, &bias)) in layer.weights.chunks_exact(inputs).zip(&layer.bias).enumerate() {
        if weights.iter().chain([&bias]).any(|value| !value.is_finite()) {
            return Err(QuantiseError::NotFinite { layer: index, row });
        }
        let greatest = weights.iter().fold(0.0f64, |greatest, &weight| greatest.max(f64::from(weight.abs())));
        // A row without weights answers its bias: any scale will do.
        let weight_one = if greatest > 0.0 { 127.0 / greatest } else { 1.0 };
        let accumulator_one = input_one * weight_one;
        let bias = (f64::from(bias) * accumulator_one).round();
        if bias.abs() > f64::from(i32::MAX) {
            return Err(QuantiseError::Bias { layer: index, row, bias });
        }
        let (factor, shift) = factor_and_shift(output_one / accumulator_one);
        quantised.weights.extend(weights.iter().map(|&weight| (f64::from(weight) * weight_one).round() as i8));
        quantised.bias.push(bias as i32);
        quantised.factor.push(factor);
        quantised.shift.push(shift);
    }
    Ok(quantised)
}

/// The ratio as factor/2^shift: 15 bits of it where the shift has room.
fn factor_and_shift(ratio: f64) -> (i16, u8) {
    let mut shift = 1;
    while shift < 47 && (ratio * 2f64.powi(shift + 1)).round() <= f64::from(i16::MAX) {
        shift += 1;
    }
    let factor = (ratio * 2f64.powi(shift)).round().min(f64::from(i16::MAX));
    (factor as i16, shift as u8)
}

#[cfg(test)]
mod tests {
    use super::super::QuantisedPolicy;
    use super::*;
    use tpg_runtime::sac::{Actions, FEATURES, Mask};

    /// A network 38-8-6-4 of numbers without a pattern, and its answer in floating point.
    fn example() -> Vec<FloatLayer> {
        let mut state = 1u32;
        let mut number = move || {
            state = state.wrapping_mul(1_664_525).wrapping_add(1_013_904_223);
            (state >> 8) as f32 / (1 << 24) as f32 - 0.5
        };
        [(FEATURES, 8), (8, 6), (6, 4)]
            .map(|(inputs, outputs)| FloatLayer {
                inputs,
                weights: (0..inputs * outputs).map(|_| number()).collect(),
                bias: (0..outputs).map(|_| number()).collect(),
            })
            .into()
    }

    fn float(layers: &[FloatLayer], input: &[f32]) -> (Vec<f32>, Vec<f32>) {
        let mut greatest = Vec::new();
        let mut values = input.to_vec();
        for (index, layer) in layers.iter().enumerate() {
            let rows = layer.weights.chunks_exact(layer.inputs).zip(&layer.bias);
            let sums = rows.map(|(row, bias)| row.iter().zip(&values).map(|(w, x)| w * x).sum::<f32>() + bias);
            let hidden = index + 1 < layers.len();
            values = sums.map(|sum| if hidden { sum.max(0.0) } else { sum }).collect();
            if hidden {
                greatest.push(values.iter().copied().fold(0.0, f32::max));
            }
        }
        (values, greatest)
    }

    #[test]
    fn integers_answer_nearly_what_the_numbers_did() {
        let layers = example();
        let inputs: Vec<Vec<f32>> =
            (0..200).map(|n| (0..FEATURES).map(|i| ((n * 37 + i * 11) % 41) as f32 / 20.0 - 1.0).collect()).collect();
        let seen = inputs.iter().map(|input| float(&layers, input).1);
        let greatest = seen.reduce(|a, b| a.iter().zip(&b).map(|(a, b)| a.max(*b)).collect()).expect("inputs");
        let quantised = quantise(&layers, &greatest).expect("ordinary numbers");
        let policy = QuantisedPolicy::new(String::new(), Actions::Fine, Mask::None, false, quantised).expect("sound");
        let mut worst = 0.0f32;
        for input in &inputs {
            let (wanted, _) = float(&layers, input);
            let features: Vec<i16> = input.iter().map(|value| (value * 4096.0).round() as i16).collect();
            for (integer, wanted) in policy.preferences(&features).into_iter().zip(wanted) {
                worst = worst.max((integer as f32 / 2048.0 - wanted).abs());
            }
        }
        // Half a step of a weight is 0.4 % of the row's greatest: some hundredths over three layers.
        assert!(worst < 0.03, "{worst}");
        assert_eq!(QuantisedPolicy::from_json("text", &policy.to_json()), Ok(policy));
    }

    #[test]
    fn ratios_keep_fifteen_bits() {
        for ratio in [1e-6, 0.001, 0.3, 1.0, 77.7] {
            let (factor, shift) = factor_and_shift(ratio);
            let error = f64::from(factor) / 2f64.powi(shift.into()) / ratio - 1.0;
            assert!(error.abs() < 1.0 / 16384.0, "{ratio}: {factor} {shift}");
        }
    }

    #[test]
    fn numbers_that_do_not_fit_are_refused() {
        let mut layers = example();
        layers[1].bias[2] = f32::NAN;
        assert_eq!(quantise(&layers, &[1.0, 1.0]), Err(QuantiseError::NotFinite { layer: 1, row: 2 }));
        let mut layers = example();
        layers[0].bias[3] = 1e9;
        assert!(matches!(quantise(&layers, &[1.0, 1.0]), Err(QuantiseError::Bias { layer: 0, row: 3, .. })));
        assert_eq!(quantise(&example(), &[1.0, 0.0]), Err(QuantiseError::Silent { layer: 1 }));
    }

    #[test]
    fn a_file_that_could_overflow_is_refused() {
        let quantised = quantise(&example(), &[1.0, 1.0]).expect("ordinary numbers");
        let mut policy =
            QuantisedPolicy::new(String::new(), Actions::Fine, Mask::None, false, quantised).expect("sound");
        policy.layers[0].bias[1] = i32::MAX;
        let error = QuantisedPolicy::from_json("q.json", &policy.to_json()).expect_err("an overflow");
        assert!(error.to_string().contains("layers[0]"), "{error}");
        policy.layers[0].bias[1] = 0;
        policy.layers[1].shift[0] = 99;
        assert!(QuantisedPolicy::from_json("q.json", &policy.to_json()).is_err());
        policy.layers[1].shift[0] = 9;
        policy.layers[1].weights.pop();
        assert!(QuantisedPolicy::from_json("q.json", &policy.to_json()).is_err());
    }
}
