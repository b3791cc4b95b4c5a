//! A network in floating point: a multilayer perceptron with a ReLU behind every hidden layer.

use super::meaning::{Input, Output, ValueOutput};
use super::network::QuantisedPolicy;
use super::quantise::{FloatLayer, LastLayer, QuantiseError, quantise_layers};
use FloatOutput::*;
use tpg_runtime::net::{Kind, Squash};

/// A value that an output becomes.
#[derive(Clone, Debug, PartialEq)]
pub struct FloatValue {
    /// Its name.
    pub name: String,
    /// The lowest value.
    pub min: f32,
    /// The highest value.
    pub max: f32,
    /// From an output to the value: behind tanh an output of −∞ is `min` and one of ∞ is `max`; behind clamp an output is
    /// the value itself, clipped to the range.
    pub squash: Squash,
}

/// The meaning of a network's outputs.
#[derive(Clone, Debug, PartialEq)]
pub enum FloatOutput {
    /// A value each: the means of a tanh-squashed Gaussian over a box of actions, say.
    Values(Vec<FloatValue>),
    /// The greatest output is the action: the actions' names.
    Argmax(Vec<String>),
}

/// A network in floating point with the meaning of its inputs and outputs.
///
/// ```
/// use tpg_codegen::policy::{FloatLayer, FloatNetwork, FloatOutput, FloatValue, Input, to_words};
/// use tpg_runtime::net::{Kind, Model, Squash};
///
/// // A pendulum's torque from cos, sin and speed: 2·tanh(−3·sin − 0.5·speed/8).
/// let speed = Input { name: "speed".into(), offset: 0.0, scale: 1.0 / 8.0 };
/// let torque = FloatValue { name: "torque".into(), min: -2.0, max: 2.0, squash: Squash::Tanh };
/// let network = FloatNetwork {
///     inputs: vec![Input::plain("cos"), Input::plain("sin"), speed],
///     layers: vec![FloatLayer { inputs: 3, weights: vec![0.0, -3.0, -0.5], bias: vec![0.0] }],
///     output: FloatOutput::Values(vec![torque]),
/// };
/// let states = [vec![1.0, 0.0, 0.0], vec![0.9, 0.4, -2.0]];
/// let policy = network.quantise(&states, Kind::W8A16, "of the weights' file".into())?;
///
/// let words = to_words(&policy)?;
/// let model = Model::parse(&words).expect("what was packed");
/// let mut torque = [0.0];
/// assert!(model.values(&states[1], &mut vec![0; model.scratch()], &mut torque));
/// assert_eq!(torque[..], policy.values(&states[1]));
/// assert!((f64::from(torque[0]) - network.answer(&states[1])[0]).abs() < 0.02);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Clone, Debug, PartialEq)]
pub struct FloatNetwork {
    /// The inputs, in order.
    pub inputs: Vec<Input>,
    /// First to last: one to five.
    pub layers: Vec<FloatLayer>,
    /// The meaning of the outputs.
    pub output: FloatOutput,
}

impl FloatNetwork {
    /// The network in integers, calibrated on states: activations may grow to twice those of the states before they are
    /// clipped.
    ///
    /// # Errors
    /// If the layers do not fit each other, a number does not fit, or no state makes a hidden layer fire.
    pub fn quantise(
        &self,
        states: &[Vec<f32>],
        kind: Kind,
        source_sha256: String,
    ) -> Result<QuantisedPolicy, QuantiseError> {
        self.check()?;
        let mut greatest = vec![0.0f32; self.layers.len()];
        for state in states {
            let activations = self.activations(state);
            for (greatest, values) in greatest.iter_mut().zip(&activations) {
                *greatest = values.iter().fold(*greatest, |most, value| most.max(value.abs() as f32));
            }
        }
        let last = greatest.pop().unwrap_or(0.0);
        let mut layers = self.layers.clone();
        let last = match &self.output {
            Argmax(_) => LastLayer::Free { greatest: last },
            Values(values) => {
                if let Some(layer) = layers.last_mut() {
                    values.iter().enumerate().for_each(|(row, value)| value.normalise(layer, row));
                }
                LastLayer::Exponents { most: values.iter().map(FloatValue::most).collect() }
            }
        };
        let (layers, exponents) = quantise_layers(&layers, &greatest, kind, &last)?;
        let output = match &self.output {
            Argmax(names) => Output::Argmax(names.clone()),
            Values(values) => {
                Output::Values(values.iter().zip(exponents).map(|(value, exponent)| value.output(exponent)).collect())
            }
        };
        QuantisedPolicy::new(source_sha256, self.inputs.clone(), output, kind, layers)
            .map_err(|error| QuantiseError::Refused(error.to_string()))
    }

    fn check(&self) -> Result<(), QuantiseError> {
        let mut inputs = self.inputs.len();
        for (layer, FloatLayer { inputs: found, weights, bias }) in self.layers.iter().enumerate() {
            if *found != inputs || weights.len() != inputs * bias.len() || inputs == 0 || bias.is_empty() {
                return Err(QuantiseError::Shape { layer });
            }
            inputs = bias.len();
        }
        let outputs = match &self.output {
            Values(values) => values.len(),
            Argmax(names) => names.len(),
        };
        if inputs == outputs { Ok(()) } else { Err(QuantiseError::Shape { layer: self.layers.len() }) }
    }

    /// The values behind each layer, ReLU included, in `f64`.
    fn activations(&self, state: &[f32]) -> Vec<Vec<f64>> {
        let input = |(input, &value): (&Input, &f32)| f64::from((value - input.offset) * input.scale);
        let mut values: Vec<f64> = self.inputs.iter().zip(state).map(input).collect();
        let mut all = Vec::with_capacity(self.layers.len());
        for (index, layer) in self.layers.iter().enumerate() {
            let rows = layer.weights.chunks_exact(layer.inputs).zip(&layer.bias);
            let sum = |(row, &bias): (&[f32], &f32)| {
                row.iter().zip(&values).map(|(&weight, value)| f64::from(weight) * value).sum::<f64>() + f64::from(bias)
            };
            let hidden = index + 1 < self.layers.len();
            values = rows.map(sum).map(|sum| if hidden { sum.max(0.0) } else { sum }).collect();
            all.push(values.clone());
        }
        all
    }

    /// The values that a state answers with in `f64`; for an argmax, the outputs themselves.
    pub fn answer(&self, state: &[f32]) -> Vec<f64> {
        let outputs = self.activations(state).pop().unwrap_or_default();
        match &self.output {
            Argmax(_) => outputs,
            Values(values) => values.iter().zip(outputs).map(|(value, output)| value.squashed(output)).collect(),
        }
    }
}

impl FloatValue {
    fn middle_and_half(&self) -> [f64; 2] {
        let [min, max] = [self.min, self.max].map(f64::from);
        [(min + max) / 2.0, (max - min) / 2.0]
    }

    fn squashed(&self, output: f64) -> f64 {
        let [middle, half] = self.middle_and_half();
        match self.squash {
            Squash::Tanh => middle + half * output.tanh(),
            Squash::Clamp => output.clamp(f64::from(self.min), f64::from(self.max)),
        }
    }

    /// Lets a row of the last layer answer with a fraction of half the range.
    fn normalise(&self, layer: &mut FloatLayer, row: usize) {
        if self.squash == Squash::Tanh {
            return;
        }
        let [middle, half] = self.middle_and_half();
        let divide = |value: f64| if half == 0.0 { 0.0 } else { (value / half) as f32 };
        for weight in &mut layer.weights[row * layer.inputs..(row + 1) * layer.inputs] {
            *weight = divide(f64::from(*weight));
        }
        layer.bias[row] = divide(f64::from(layer.bias[row]) - middle);
    }

    /// The greatest exponent of its output.
    fn most(&self) -> u8 {
        match self.squash {
            Squash::Tanh => 11,
            Squash::Clamp => 14,
        }
    }

    fn output(&self, exponent: u8) -> ValueOutput {
        ValueOutput { name: self.name.clone(), min: self.min, max: self.max, squash: self.squash, exponent }
    }
}
