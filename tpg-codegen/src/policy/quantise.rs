//! From a trained network's numbers to integers.
//!
//! Each row of weights has a scale of its own. Its greatest magnitude becomes the greatest of its kind, or as great as the
//! accumulator allows: the sum of magnitudes times the greatest activation, and the bias, must fit 31 bits.
//!
//! Each hidden layer has one scale: twice the greatest activation that calibration saw becomes 32767, so that an activation may
//! double before it is clipped.
//!
//! Weights and biases are rounded to nearest, halves away from zero. On 300 random networks of up to four hidden layers,
//! with weights as training begins with, a value is this far from that of floating point, in parts of its range:
//!
//! | kind | at most | the test's bound |
//! | --- | --- | --- |
//! | `w8a16` | 0.020 | 0.03 |
//! | `w16a16` | 0.0007 | 0.001 |

use super::network::QuantisedLayer;
use tpg_runtime::net::{INPUT_ONE, Kind, PREFERENCE_ONE};

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

/// A reason not to put a network into integers.
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
    /// A hidden layer never fired in calibration.
    #[error("layer {layer}: calibration saw no activation")]
    Silent {
        /// Counted from 0.
        layer: usize,
    },
    /// A layer that does not fit the one before it, its own numbers, or the outputs.
    #[error("layer {layer}: its sizes do not fit")]
    Shape {
        /// Counted from 0; the number of layers where the last one does not fit the outputs.
        layer: usize,
    },
    /// A network that is refused as a file would be.
    #[error("{0}")]
    Refused(String),
}

/// The scale of the last layer's outputs.
pub(super) enum LastLayer {
    /// One number for all: preferences.
    One(f64),
    /// Any, the same for all outputs: only their order counts.
    Free {
        /// The greatest magnitude that calibration saw.
        greatest: f32,
    },
    /// A power of two for each output, up to these exponents.
    Exponents {
        /// The finest scale.
        most: Vec<u8>,
    },
}

/// Layers in integers whose outputs are preferences; `greatest` holds the greatest activation that calibration saw behind
/// each hidden layer.
///
/// # Errors
/// If a number does not fit.
///
/// # Panics
/// If `greatest` does not hold one number for each hidden layer.
pub fn quantise(layers: &[FloatLayer], greatest: &[f32], kind: Kind) -> Result<Vec<QuantisedLayer>, QuantiseError> {
    quantise_layers(layers, greatest, kind, &LastLayer::One(f64::from(PREFERENCE_ONE))).map(|(layers, _)| layers)
}

/// Layers in integers, and the exponents of the last one's outputs.
pub(super) fn quantise_layers(
    layers: &[FloatLayer],
    greatest: &[f32],
    kind: Kind,
    last: &LastLayer,
) -> Result<(Vec<QuantisedLayer>, Vec<u8>), QuantiseError> {
    assert_eq!(greatest.len() + 1, layers.len(), "one activation for each hidden layer");
    let mut input_one = f64::from(INPUT_ONE);
    let mut quantised = Vec::with_capacity(layers.len());
    let mut exponents = Vec::new();
    for (index, layer) in layers.iter().enumerate() {
        check_finite(index, layer)?;
        let scales = scales(layer, kind, input_one);
        // An accumulator must be multiplied by less than 1/2 (`Rescale::multiplier`).
        let finest = |scale: f64| 0.499 * input_one * scale;
        let all = finest(scales.iter().copied().fold(f64::MAX, f64::min));
        let output_ones: Vec<f64> = match (greatest.get(index), last) {
            (Some(&greatest), _) if greatest > 0.0 && greatest.is_finite() => {
                let wanted = f64::from(i16::MAX) / (2.0 * f64::from(greatest));
                vec![wanted.min(all); scales.len()]
            }
            (Some(_), _) => return Err(QuantiseError::Silent { layer: index }),
            (None, LastLayer::One(one)) => vec![*one; scales.len()],
            (None, LastLayer::Free { greatest }) => {
                let wanted = f64::from(i16::MAX) / (2.0 * f64::from(greatest.max(f32::MIN_POSITIVE)));
                vec![wanted.min(all); scales.len()]
            }
            (None, LastLayer::Exponents { most }) => {
                let exponent = |(&scale, &most): (&f64, &u8)| finest(scale).log2().floor().clamp(0.0, f64::from(most));
                exponents = scales.iter().zip(most).map(exponent).map(|exponent| exponent as u8).collect();
                exponents.iter().map(|&exponent| 2f64.powi(exponent.into())).collect()
            }
        };
        quantised.push(rows(layer, input_one, &scales, &output_ones));
        input_one = output_ones.first().copied().unwrap_or(1.0);
    }
    Ok((quantised, exponents))
}

fn check_finite(index: usize, layer: &FloatLayer) -> Result<(), QuantiseError> {
    for (row, (weights, bias)) in layer.weights.chunks_exact(layer.inputs).zip(&layer.bias).enumerate() {
        if weights.iter().chain([bias]).any(|value| !value.is_finite()) {
            return Err(QuantiseError::NotFinite { layer: index, row });
        }
    }
    Ok(())
}

fn rows(layer: &FloatLayer, input_one: f64, scales: &[f64], output_ones: &[f64]) -> QuantisedLayer {
    let (inputs, outputs) = (layer.inputs, layer.bias.len());
    let mut quantised =
        QuantisedLayer { inputs, outputs, weights: vec![], bias: vec![], factor: vec![], shift: vec![] };
    let rows = layer.weights.chunks_exact(inputs).zip(&layer.bias).zip(scales.iter().zip(output_ones));
    for ((weights, &bias), (&scale, &output_one)) in rows {
        // A row whose weights are all but nothing beside what is asked of it: a multiplier has 32 bits behind its point.
        let weight_one = scale.min(output_one / input_one * 0.999 * 2f64.powi(18));
        let accumulator_one = input_one * weight_one;
        let (factor, shift) = factor_and_shift(output_one / accumulator_one);
        quantised.weights.extend(weights.iter().map(|&weight| (f64::from(weight) * weight_one).round() as i16));
        quantised.bias.push((f64::from(bias) * accumulator_one).round() as i32);
        quantised.factor.push(factor);
        quantised.shift.push(shift);
    }
    quantised
}

/// A weight of 1 in integers, row by row.
fn scales(layer: &FloatLayer, kind: Kind, input_one: f64) -> Vec<f64> {
    // The greatest weight of the kind and input, and what an accumulator holds in units of that input.
    let (most_weight, most_input, most_sum) = (f64::from(kind.weights().1), 32_768.0, 65_536.0);
    let scale = |(weights, &bias): (&[f32], &f32)| {
        let magnitudes = weights.iter().map(|&weight| f64::from(weight.abs()));
        let greatest = magnitudes.clone().fold(0.0, f64::max);
        // Less what rounding may add to weights and bias.
        let most = most_sum - 2.0 - weights.len() as f64 / 2.0;
        let wanted = magnitudes.sum::<f64>() + f64::from(bias.abs()) * input_one / most_input;
        match (greatest == 0.0, wanted == 0.0) {
            (_, true) => 1.0, // a row that answers 0: any scale will do
            (true, false) => most / wanted,
            (false, false) => (most_weight / greatest).min(most / wanted),
        }
    };
    layer.weights.chunks_exact(layer.inputs).zip(&layer.bias).map(scale).collect()
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
    use super::super::{Input, Output, Preferences, QuantisedPolicy};
    use super::*;
    use tpg_graph::error::InputError;

    const FEATURES: usize = 38;

    fn policy(kind: Kind, layers: Vec<QuantisedLayer>) -> Result<QuantisedPolicy, InputError> {
        let inputs = (0..FEATURES).map(|number| Input::plain(&format!("input {number}"))).collect();
        let preferences = Preferences { actions: "fine".to_owned(), mask: "none".to_owned(), may_rest: false };
        QuantisedPolicy::new(String::new(), inputs, Output::Preferences(preferences), kind, layers)
    }

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
        // Half a step of an 8-bit weight is 0.4 % of the row's greatest: some hundredths over three layers.
        for (kind, bound) in [(Kind::W8A16, 0.03), (Kind::W16A16, 0.001)] {
            let quantised = quantise(&layers, &greatest, kind).expect("ordinary numbers");
            let policy = policy(kind, quantised);
            let policy = policy.expect("sound");
            let worst = worst_difference(&policy, &layers, &inputs);
            assert!(worst < bound, "{kind:?}: {worst}");
            assert_eq!(policy.to_json().contains("kind"), kind != Kind::W8A16);
            assert_eq!(QuantisedPolicy::from_json("text", &policy.to_json()), Ok(policy));
        }
    }

    fn worst_difference(policy: &QuantisedPolicy, layers: &[FloatLayer], inputs: &[Vec<f32>]) -> f32 {
        let mut worst = 0.0f32;
        for input in inputs {
            let (wanted, _) = float(layers, input);
            let features: Vec<i16> = input.iter().map(|value| (value * 4096.0).round() as i16).collect();
            for (integer, wanted) in policy.outputs(&features).into_iter().zip(wanted) {
                worst = worst.max((integer as f32 / 2048.0 - wanted).abs());
            }
        }
        worst
    }

    #[test]
    fn sixteen_bits_use_the_accumulator_and_never_overflow_it() {
        let mut layers = example();
        layers[0].weights[..FEATURES].fill(0.5); // no accumulator but for much smaller weights
        layers[0].bias[1] = 1000.0;
        let quantised = quantise(&layers, &[1.0, 1.0], Kind::W16A16).expect("ordinary numbers");
        let policy = policy(Kind::W16A16, quantised);
        let layer = &policy.expect("sound").layers[0];
        let sum: i32 = layer.weights[..FEATURES].iter().map(|&weight| i32::from(weight).abs()).sum();
        assert!((64_000..=65_535).contains(&sum), "{sum}");
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
        assert_eq!(quantise(&layers, &[1.0, 1.0], Kind::W8A16), Err(QuantiseError::NotFinite { layer: 1, row: 2 }));
        assert_eq!(quantise(&example(), &[1.0, 0.0], Kind::W8A16), Err(QuantiseError::Silent { layer: 1 }));
    }

    #[test]
    fn a_bias_that_dwarfs_the_weights_saturates_its_output() {
        for kind in Kind::ALL {
            let mut layers = example();
            layers[2].bias[3] = 1e9;
            layers[2].weights[..6].fill(1e-9); // a row that is all but nothing
            let policy = policy(kind, quantise(&layers, &[1.0, 1.0], kind).expect("it fits")).expect("sound");
            let outputs = policy.outputs(&[1; FEATURES]);
            assert_eq!(outputs[3], i32::from(i16::MAX), "{kind:?}");
            assert!(outputs[0].abs() < 2048, "{kind:?}: {outputs:?}");
            assert!(policy.layers[2].rescales()[0].multiplier().is_some(), "{kind:?}");
        }
    }

    #[test]
    fn sizes_whose_product_has_no_number_are_refused() {
        let quantised = quantise(&example(), &[1.0, 1.0], Kind::W8A16).expect("ordinary numbers");
        let mut policy = policy(Kind::W8A16, quantised).expect("sound");
        for outputs in [1_609_289_134_218_752_345, usize::MAX, usize::MAX / FEATURES + 1] {
            policy.layers[0].outputs = outputs;
            let error = QuantisedPolicy::from_json("q.json", &policy.to_json()).expect_err("no such layer");
            assert!(error.to_string().contains("$.layers[0].inputs: [38, "), "{error}");
        }
    }

    #[test]
    fn a_file_that_could_overflow_is_refused() {
        let quantised = quantise(&example(), &[1.0, 1.0], Kind::W8A16).expect("ordinary numbers");
        let mut policy = policy(Kind::W8A16, quantised).expect("sound");
        policy.layers[0].bias[1] = i32::MAX;
        let error = QuantisedPolicy::from_json("q.json", &policy.to_json()).expect_err("an overflow");
        assert!(error.to_string().contains("layers[0]"), "{error}");
        policy.layers[0].bias[1] = 0;
        policy.layers[1].shift[0] = 99;
        assert!(QuantisedPolicy::from_json("q.json", &policy.to_json()).is_err());
        policy.layers[1].shift[0] = 9;
        policy.layers[1].weights[0] = 128;
        let error = QuantisedPolicy::from_json("q.json", &policy.to_json()).expect_err("no weight of 8 bits");
        assert!(error.to_string().contains("128"), "{error}");
        policy.layers[1].weights[0] = 0;
        policy.kind = "w4a4".to_owned();
        let error = QuantisedPolicy::from_json("q.json", &policy.to_json()).expect_err("no such kind");
        assert!(error.to_string().contains("w16a16"), "{error}");
        policy.kind = "w8a16".to_owned();
        policy.layers[1].weights.pop();
        assert!(QuantisedPolicy::from_json("q.json", &policy.to_json()).is_err());
    }
}
