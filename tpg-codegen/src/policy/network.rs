//! A network in integers, checked.

use super::meaning::{self, Input, Output};
use serde::{Deserialize, Serialize};
use std::ops::Deref;
use tpg_graph::error::InputError;
use tpg_runtime::net::{HIDDEN, Kind, LAST, LAYERS, LayerRows, Rescale, WIDTH, Weights, accumulate, contract, integer};

/// The rule by which accumulators are rescaled.
pub const ROUNDING: &str = "(acc * factor + 2^(shift - 1)) >> shift in 64 bits, then clipped";

/// A network in integers: everything that decides its behaviour.
#[derive(Clone, Debug, PartialEq)]
pub struct QuantisedPolicy {
    /// SHA-256 of the weights it was made from, in hexadecimal.
    pub source_sha256: String,
    /// The inputs, in order.
    pub inputs: Vec<Input>,
    /// The meaning of the outputs.
    pub output: Output,
    /// The name of its [`Kind`].
    pub kind: String,
    /// First to last; all but the last have a ReLU behind them.
    pub layers: Vec<QuantisedLayer>,
}

/// A layer, and what its place in the network makes of it.
pub(super) struct Layer<'a> {
    pub(super) layer: &'a QuantisedLayer,
    pub(super) kind: Kind,
    /// The lowest output; the highest is `i16::MAX`.
    pub(super) low: i16,
}

impl Deref for Layer<'_> {
    type Target = QuantisedLayer;

    fn deref(&self) -> &QuantisedLayer {
        self.layer
    }
}

impl Layer<'_> {
    /// The outputs for some inputs.
    pub(super) fn forward(&self, inputs: &[i16]) -> Vec<i16> {
        let rows = self.rows().zip(&self.bias).zip(self.rescales());
        let output = |((weights, &bias), rescale): ((&[i16], &i32), Rescale)| {
            rescale.apply(accumulate(bias, weights, inputs), self.low)
        };
        rows.map(output).collect()
    }

    pub(super) fn bytes(&self) -> usize {
        self.kind.bits() / 8 * self.weights.len() + 4 * self.bias.len() + 2 * self.factor.len() + self.shift.len()
    }
}

/// One layer in integers.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct QuantisedLayer {
    /// Values in.
    pub inputs: usize,
    /// Values out.
    pub outputs: usize,
    /// Row-major, outputs × inputs.
    pub weights: Vec<i16>,
    /// In units of the accumulators.
    pub bias: Vec<i32>,
    /// The factor of each row's accumulator.
    pub factor: Vec<i16>,
    /// The shift behind it, in bits.
    pub shift: Vec<u8>,
}

impl QuantisedLayer {
    /// The weights of each output.
    pub(super) fn rows(&self) -> impl Iterator<Item = &[i16]> {
        self.weights.chunks_exact(self.inputs)
    }

    /// The way from each row's accumulator to its output.
    pub(super) fn rescales(&self) -> Vec<Rescale> {
        self.factor.iter().zip(&self.shift).map(|(&factor, &shift)| Rescale { factor, shift }).collect()
    }
}

impl QuantisedPolicy {
    /// A network of layers, checked.
    ///
    /// # Errors
    /// If the layers do not fit each other, the inputs or the outputs, or an accumulator could overflow.
    pub fn new(
        source_sha256: String,
        inputs: Vec<Input>,
        output: Output,
        kind: Kind,
        layers: Vec<QuantisedLayer>,
    ) -> Result<Self, InputError> {
        let policy = Self { source_sha256, inputs, output, kind: kind.name().to_owned(), layers };
        policy.check("<quantised>")?;
        Ok(policy)
    }

    /// Checks what the types leave open, and proves that no accumulator can overflow.
    pub(super) fn check(&self, file: &str) -> Result<(), InputError> {
        let refuse = |path: &str, found: String, accepted: String| Err(InputError::new(file, path, found, accepted));
        if Kind::from_name(&self.kind).is_none() {
            let accepted = Kind::ALL.map(Kind::name).join(", ");
            return refuse("$.kind", format!("{:?}", self.kind), accepted);
        }
        meaning::check_inputs(file, &self.inputs)?;
        self.output.check(file)?;
        let mut inputs = self.inputs.len();
        for (index, layer) in self.described().into_iter().enumerate() {
            let path = |field: &str| format!("$.layers[{index}].{field}");
            let sizes =
                [layer.inputs, layer.outputs.saturating_mul(layer.inputs), layer.outputs, layer.outputs, layer.outputs];
            let lengths = [inputs, layer.weights.len(), layer.bias.len(), layer.factor.len(), layer.shift.len()];
            if sizes != lengths || layer.inputs == 0 || layer.outputs == 0 {
                return refuse(
                    &path("inputs"),
                    format!("{sizes:?}"),
                    format!("the sizes of what is there, {lengths:?}"),
                );
            }
            if layer.inputs > WIDTH || layer.outputs > WIDTH {
                return refuse(
                    &path("inputs"),
                    format!("{} to {}", layer.inputs, layer.outputs),
                    format!("up to {WIDTH}"),
                );
            }
            let (least, greatest) = layer.kind.weights();
            if let Some(weight) = layer.weights.iter().find(|weight| !(least..=greatest).contains(weight)) {
                return refuse(
                    &path("weights"),
                    weight.to_string(),
                    format!("{least} to {greatest}, as {}", self.kind),
                );
            }
            let rescale = layer.rescales();
            let weights = Weights::I16(&layer.weights);
            let rows =
                LayerRows { inputs: layer.inputs, kind: layer.kind, weights, bias: &layer.bias, rescale: &rescale };
            for row in 0..layer.outputs {
                let worst = rows.worst_accumulator(row);
                if worst > i64::from(i32::MAX) {
                    let found = format!("row {row} can reach {worst}");
                    return refuse(&path("weights"), found, format!("accumulators up to {}", i32::MAX));
                }
                if layer.factor[row] < 0 || !(1..=47).contains(&layer.shift[row]) {
                    let found = format!("row {row}: {} and {}", layer.factor[row], layer.shift[row]);
                    return refuse(&path("shift"), found, "a factor from 0 and a shift of 1 to 47".to_owned());
                }
            }
            inputs = layer.outputs;
        }
        if !(1..=LAYERS).contains(&self.layers.len()) {
            return refuse("$.layers", format!("{} layers", self.layers.len()), format!("1 to {LAYERS}"));
        }
        match self.output.count() {
            Some(count) if count != inputs => {
                refuse("$.layers", format!("{inputs} outputs"), format!("{count}, as \"output\" names"))
            }
            _ => Ok(()),
        }
    }

    /// The widths of weights and activations.
    pub fn kind(&self) -> Kind {
        Kind::from_name(&self.kind).unwrap_or(Kind::W8A16)
    }

    /// The layers, first to last: what everything that runs or prints the network is made from.
    pub(super) fn described(&self) -> Vec<Layer<'_>> {
        let low = |index| if index + 1 == self.layers.len() { LAST } else { HIDDEN };
        let layer = |(index, layer)| Layer { layer, kind: self.kind(), low: low(index) };
        self.layers.iter().enumerate().map(layer).collect()
    }

    /// Tests for inputs that the network does not see as they are.
    pub(super) fn is_scaled(&self) -> bool {
        !self.inputs.iter().all(Input::is_plain)
    }

    /// Tests for a network that answers with the number of its greatest output.
    pub(super) fn is_choice(&self) -> bool {
        matches!(self.output, Output::Argmax(_))
    }

    /// The checksum of the inputs' names.
    pub(super) fn contract(&self) -> u32 {
        contract(&self.inputs.iter().map(|input| input.name.as_str()).collect::<Vec<_>>())
    }

    /// The inputs of a state, in multiples of 1/4096.
    pub fn integers(&self, state: &[f32]) -> Vec<i16> {
        self.inputs.iter().zip(state).map(|(input, value)| integer((value - input.offset) * input.scale)).collect()
    }

    /// The outputs, for inputs in multiples of 1/4096.
    pub fn outputs(&self, inputs: &[i16]) -> Vec<i32> {
        let mut values = inputs.to_vec();
        for layer in self.described() {
            values = layer.forward(&values);
        }
        values.into_iter().map(i32::from).collect()
    }

    /// The values that a state answers with; none for a network that answers otherwise.
    pub fn values(&self, state: &[f32]) -> Vec<f32> {
        let outputs = self.outputs(&self.integers(state));
        self.output.values().iter().zip(outputs).map(|(value, output)| value.of(output)).collect()
    }

    /// The number of the greatest output for a state, of equals the first.
    pub fn choose(&self, state: &[f32]) -> usize {
        let outputs = self.outputs(&self.integers(state));
        (0..outputs.len()).rev().max_by_key(|&output| outputs[output]).unwrap_or(0)
    }

    /// Bytes of its constants on a target.
    pub fn bytes(&self) -> usize {
        self.described().iter().map(Layer::bytes).sum()
    }

    /// Multiplications of a weight that one decision costs.
    pub fn multiplications(&self) -> usize {
        self.layers.iter().map(|layer| layer.weights.len()).sum()
    }
}
