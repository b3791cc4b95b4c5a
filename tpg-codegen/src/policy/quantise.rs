//! From a trained network's numbers to integers.
//!
//! Each row of weights has a scale of its own. With 8 bits its greatest magnitude becomes 127; with 16 bits it becomes as
//! great as 32767 and the accumulator allow: 32768 times the sum of magnitudes, and the bias, must fit 31 bits.
//!
//! Each hidden layer has one scale. With 16 bits twice the greatest activation that calibration saw becomes 32767, so
//! that an activation may double before it is clipped; with 8 bits, which leave no room, the greatest becomes 127.
//!
//! Weights and biases are rounded to nearest, halves away from zero.

use super::{QuantisedLayer, layer_kind};
use tpg_arm::sac::fixed::{FEATURE_ONE, PREFERENCE_ONE};
use tpg_arm::sac::packed::Kind;

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
pub fn quantise(layers: &[FloatLayer], greatest: &[f32], kind: Kind) -> Result<Vec<QuantisedLayer>, QuantiseError> {
    assert_eq!(greatest.len() + 1, layers.len(), "one activation for each hidden layer");
    let layer_kind = |index| layer_kind(kind, index, layers.len());
    let mut input_one = match layer_kind(0) {
        Kind::W8A16 | Kind::W16A16 => f64::from(FEATURE_ONE),
        Kind::W8A8 => f64::from(FEATURE_ONE) / 128.0, // `clip_to_i8`
    };
    let mut quantised = Vec::with_capacity(layers.len());
    for (index, layer) in layers.iter().enumerate() {
        let output_one = match greatest.get(index) {
            Some(&greatest) if greatest > 0.0 && greatest.is_finite() => {
                let next = layer_kind(index + 1);
                let room = if next == Kind::W8A8 { 1.0 } else { 2.0 };
                let wanted = f64::from(next.activation()) / (room * f64::from(greatest));
                // What an accumulator is multiplied by must be below 1/2 (`Rescale::multiplier`).
                let finest = scales(layer, layer_kind(index), input_one).fold(f64::MAX, f64::min);
                wanted.min(0.499 * input_one * finest)
            }
            Some(_) => return Err(QuantiseError::Silent { layer: index }),
            None => f64::from(PREFERENCE_ONE),
        };
        quantised.push(rows(index, layer, layer_kind(index), [input_one, output_one])?);
        input_one = output_one;
    }
    Ok(quantised)
}

fn rows(
    index: usize,
    layer: &FloatLayer,
    kind: Kind,
    [input_one, output_one]: [f64; 2],
) -> Result<QuantisedLayer, QuantiseError> {
    let (inputs, outputs) = (layer.inputs, layer.bias.len());
    let mut quantised =
        QuantisedLayer { inputs, outputs, weights: vec![], bias: vec![], factor: vec![], shift: vec![] };
    let scales = scales(layer, kind, input_one);
    for (row, ((weights, &bias), weight_one)) in
        layer.weights.chunks_exact(inputs).zip(&layer.bias).zip(scales).enumerate()
    {
        if weights.iter().chain([&bias]).any(|value| !value.is_finite()) {
            return Err(QuantiseError::NotFinite { layer: index, row });
        }
        let accumulator_one = input_one * weight_one;
        let bias = (f64::from(bias) * accumulator_one).round();
        if bias.abs() > f64::from(i32::MAX) {
            return Err(QuantiseError::Bias { layer: index, row, bias });
        }
        let (factor, shift) = factor_and_shift(output_one / accumulator_one);
        quantised.weights.extend(weights.iter().map(|&weight| (f64::from(weight) * weight_one).round() as i16));
        quantised.bias.push(bias as i32);
        quantised.factor.push(factor);
        quantised.shift.push(shift);
    }
    Ok(quantised)
}

/// What a weight of 1 becomes, row by row.
fn scales(layer: &FloatLayer, kind: Kind, input_one: f64) -> impl Iterator<Item = f64> {
    layer.weights.chunks_exact(layer.inputs).zip(&layer.bias).map(move |(weights, &bias)| {
        let magnitudes = weights.iter().map(|&weight| f64::from(weight.abs()));
        let greatest = magnitudes.clone().fold(0.0, f64::max);
        if greatest == 0.0 {
            1.0 // a row without weights answers its bias: any scale will do
        } else if kind == Kind::W16A16 {
            // In units of 32768: what the accumulator holds, less what rounding may add to weights and bias.
            let most = 65_534.0 - weights.len() as f64 / 2.0;
            let wanted = magnitudes.sum::<f64>() + f64::from(bias.abs()) * input_one / 32_768.0;
            (f64::from(i16::MAX) / greatest).min(most / wanted)
        } else {
            127.0 / greatest
        }
    })
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
    use tpg_arm::sac::{Actions, FEATURES, Mask};

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
        // Half a step of an 8-bit weight is 0.4 % of the row's greatest: some hundredths over three layers; features in
        // steps of 1/32 and activations of 7 bits are some times as coarse.
        for (kind, bound) in [(Kind::W8A16, 0.03), (Kind::W16A16, 0.001), (Kind::W8A8, 0.15)] {
            let quantised = quantise(&layers, &greatest, kind).expect("ordinary numbers");
            let policy = QuantisedPolicy::new(String::new(), Actions::Fine, Mask::None, false, kind, quantised);
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
            for (integer, wanted) in policy.preferences(&features).into_iter().zip(wanted) {
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
        let policy = QuantisedPolicy::new(String::new(), Actions::Fine, Mask::None, false, Kind::W16A16, quantised);
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
        let mut layers = example();
        layers[0].bias[3] = 1e9;
        assert!(matches!(
            quantise(&layers, &[1.0, 1.0], Kind::W8A16),
            Err(QuantiseError::Bias { layer: 0, row: 3, .. })
        ));
        assert_eq!(quantise(&example(), &[1.0, 0.0], Kind::W8A16), Err(QuantiseError::Silent { layer: 1 }));
    }

    #[test]
    fn a_file_that_could_overflow_is_refused() {
        let quantised = quantise(&example(), &[1.0, 1.0], Kind::W8A16).expect("ordinary numbers");
        let mut policy = QuantisedPolicy::new(String::new(), Actions::Fine, Mask::None, false, Kind::W8A16, quantised)
            .expect("sound");
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
