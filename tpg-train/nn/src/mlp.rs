//! A multi-layer perceptron with its parameters in one flat vector.

use super::vectors::vectorised;
use super::{Factor, Finish, Scratch, multiply};
use serde::{Deserialize, Serialize};

/// The sizes of a network. A hidden layer is linear, then ReLU; the last layer is linear.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, Deserialize)]
pub struct Shape {
    /// Number of inputs.
    pub inputs: usize,
    /// Units of each hidden layer.
    pub hidden: Vec<usize>,
    /// Number of outputs.
    pub outputs: usize,
}

/// Offsets of one layer's parameters in the flat vector.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
struct MlpLayer {
    inputs: usize,
    outputs: usize,
    /// Weights, column-major `outputs` × `inputs`.
    weight: usize,
    bias: usize,
}

impl MlpLayer {
    fn weight<'a>(&self, parameters: &'a [f32]) -> Factor<'a> {
        Factor::new(&parameters[self.weight..][..self.inputs * self.outputs], self.outputs, self.inputs)
    }

    fn bias<'a>(&self, parameters: &'a [f32]) -> &'a [f32] {
        &parameters[self.bias..][..self.outputs]
    }
}

impl Shape {
    fn layers(&self) -> Vec<MlpLayer> {
        let mut at = 0;
        let mut inputs = self.inputs;
        let sizes = self.hidden.iter().chain([&self.outputs]);
        sizes
            .map(|&outputs| {
                let (weight, bias) = (at, at + inputs * outputs);
                let layer = MlpLayer { inputs, outputs, weight, bias };
                (at, inputs) = (bias + outputs, outputs);
                layer
            })
            .collect()
    }

    /// Returns the number of parameters of a network of this shape.
    pub fn parameters(&self) -> usize {
        self.layers().last().map_or(0, |last| last.bias + last.outputs)
    }
}

/// A network: its shape and its parameters. Each layer has weights (column-major, outputs × inputs) and a bias.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Mlp {
    shape: Shape,
    layers: Vec<MlpLayer>,
    parameters: Vec<f32>,
}

/// Values that a forward pass keeps for the backward pass: those between the layers, for one batch.
#[derive(Clone, Debug)]
pub struct Tape {
    batch: usize,
    /// The input of each layer: the network's input, then each hidden layer's output.
    inputs: Vec<Vec<f32>>,
    output: Vec<f32>,
    /// Gradients of the backward pass; swapped layer by layer.
    gradient: [Vec<f32>; 2],
    scratch: Scratch,
}

impl Tape {
    /// Creates an empty tape for batches of `batch` samples.
    pub fn new(shape: &Shape, batch: usize) -> Self {
        let zeros = |rows: usize| vec![0.0; rows * batch];
        let widest = shape.hidden.iter().chain([&shape.inputs, &shape.outputs]).copied().max().unwrap_or(0);
        Self {
            batch,
            inputs: [&shape.inputs].into_iter().chain(&shape.hidden).map(|&rows| zeros(rows)).collect(),
            output: zeros(shape.outputs),
            gradient: [zeros(widest), zeros(widest)],
            scratch: Scratch::default(),
        }
    }

    /// Returns the network's input, one column per sample, to be filled before [`Mlp::forward`].
    pub fn input_mut(&mut self) -> &mut [f32] {
        self.inputs.first_mut().map_or(&mut [], Vec::as_mut_slice)
    }

    /// Returns the output of a hidden layer, one column per sample.
    ///
    /// # Panics
    /// If there is no such layer.
    pub fn activations(&self, layer: usize) -> &[f32] {
        &self.inputs[layer + 1]
    }

    /// Returns the network's output, one column per sample.
    pub fn output(&self) -> &[f32] {
        &self.output
    }
}

impl Mlp {
    /// Creates a network with weights and biases uniform in ±1/√inputs, as in PyTorch's `Linear`.
    pub fn random(shape: Shape, mut unit: impl FnMut() -> f64) -> Self {
        let mut parameters = vec![0.0; shape.parameters()];
        let layers = shape.layers();
        for layer in &layers {
            let bound = 1.0 / (layer.inputs as f64).sqrt();
            for parameter in &mut parameters[layer.weight..layer.bias + layer.outputs] {
                *parameter = ((2.0 * unit() - 1.0) * bound) as f32;
            }
        }
        Self { shape, layers, parameters }
    }

    /// Creates a network from given parameters; `None` if their number does not match the shape.
    pub fn from_parameters(shape: Shape, parameters: Vec<f32>) -> Option<Self> {
        (parameters.len() == shape.parameters()).then(|| Self { layers: shape.layers(), shape, parameters })
    }

    /// Returns the shape.
    pub fn shape(&self) -> &Shape {
        &self.shape
    }

    /// Returns the flat parameters.
    pub fn parameters(&self) -> &[f32] {
        &self.parameters
    }

    /// Returns the flat parameters for an optimiser to change.
    pub fn parameters_mut(&mut self) -> &mut [f32] {
        &mut self.parameters
    }

    /// Returns weights (row-major, outputs × inputs) and bias of each layer, first to last.
    pub fn weights(&self) -> Vec<(Vec<f32>, Vec<f32>)> {
        let row_major = |layer: &MlpLayer| {
            let weights = &self.parameters[layer.weight..][..layer.inputs * layer.outputs];
            let rows = 0..layer.outputs;
            let row = |o: usize| weights.iter().skip(o).step_by(layer.outputs).copied();
            (rows.flat_map(row).collect(), layer.bias(&self.parameters).to_vec())
        };
        self.layers.iter().map(row_major).collect()
    }

    /// Moves every parameter towards another network's by the fraction `rate` (Polyak averaging).
    ///
    /// # Panics
    /// If the shapes differ.
    pub fn follow(&mut self, other: &Self, rate: f32) {
        assert_eq!(self.shape, other.shape, "networks of different shapes");
        let pairs = self.parameters.iter_mut().zip(&other.parameters);
        vectorised(
            #[inline(always)]
            || pairs.for_each(|(own, &others)| *own += rate * (others - *own)),
        );
    }

    /// Computes the output for the batch in the tape's input, and keeps what [`backward`](Self::backward) needs.
    ///
    /// # Panics
    /// If the tape was made for a different shape.
    pub fn forward(&self, tape: &mut Tape) {
        let last = self.shape.hidden.len();
        let scratch = &mut tape.scratch;
        for (index, layer) in self.layers.iter().enumerate() {
            let (before, after) = tape.inputs.split_at_mut(index + 1);
            let mut input = Factor::new(&before[index], layer.inputs, tape.batch);
            if index > 0 {
                // About half of a ReLU's outputs are zero.
                input = input.sparse();
            }
            let (weight, bias) = (layer.weight(&self.parameters), layer.bias(&self.parameters));
            if index == last {
                return multiply(&mut tape.output, weight, input, Finish::Bias(bias), scratch);
            }
            multiply(&mut after[0], weight, input, Finish::Rectified(bias), scratch);
        }
    }

    /// Propagates the gradient of a loss with respect to the output back through the last batch of
    /// [`forward`](Self::forward).
    ///
    /// `gradients`, if given, is overwritten with the gradient with respect to the parameters (in their order, summed
    /// over the batch); `by_input`, if given, with the gradient with respect to the last inputs, as many as it has
    /// rows.
    ///
    /// # Panics
    /// If the sizes do not match.
    pub fn backward(
        &self,
        tape: &mut Tape,
        by_output: &[f32],
        mut gradients: Option<&mut [f32]>,
        by_input: Option<&mut [f32]>,
    ) {
        assert_eq!(by_output.len(), self.shape.outputs * tape.batch, "a gradient of another size");
        let [current, next] = &mut tape.gradient;
        current[..by_output.len()].copy_from_slice(by_output);
        let (batch, scratch) = (tape.batch, &mut tape.scratch);
        for (index, layer) in self.layers.iter().enumerate().rev() {
            let mut gradient = Factor::new(&current[..layer.outputs * batch], layer.outputs, batch);
            if let Some(all) = gradients.as_deref_mut() {
                let input = Factor::new(&tape.inputs[index], layer.inputs, batch);
                let by_weight = &mut all[layer.weight..layer.bias];
                multiply(by_weight, gradient, input.transposed(), Finish::Plain, scratch);
                sum_columns(&mut all[layer.bias..][..layer.outputs], gradient.values());
            } else {
                // A loss that moves no parameters may ignore samples: each is judged by one of two critics.
                gradient = gradient.sparse();
            }
            if index > 0 {
                // The gradient passes the previous layer's ReLU in the same step.
                let finish = Finish::Where(&tape.inputs[index]);
                let weight = layer.weight(&self.parameters).transposed();
                multiply(&mut next[..layer.inputs * batch], weight, gradient, finish, scratch);
                std::mem::swap(current, next);
            }
        }
        if let (Some(by_input), Some(first)) = (by_input, self.layers.first()) {
            let rows = by_input.len() / batch;
            let weights = &self.parameters[..first.bias][(first.inputs - rows) * first.outputs..];
            let weight = Factor::new(weights, first.outputs, rows).transposed();
            let gradient = Factor::new(&current[..first.outputs * batch], first.outputs, batch).sparse();
            multiply(by_input, weight, gradient, Finish::Plain, scratch);
        }
    }
}

/// Sets `sums` to the sum of all columns, added first to last.
fn sum_columns(sums: &mut [f32], columns: &[f32]) {
    vectorised(
        #[inline(always)]
        || {
            sums.fill(0.0);
            for column in columns.chunks_exact(sums.len()) {
                sums.iter_mut().zip(column).for_each(|(sum, &value)| *sum += value);
            }
        },
    );
}

#[cfg(test)]
mod tests {
    use super::*;
    use tpg_engine::random::{Purpose, Stream};

    fn shape() -> Shape {
        Shape { inputs: 7, hidden: vec![9, 8], outputs: 3 }
    }

    /// Computes Σ c·out over a batch of 6 in `f64`, number by number; parameters are column-major, as in [`Mlp`].
    fn loss(parameters: &[f64], input: &[f64], coefficients: &[f64]) -> f64 {
        let sizes = [7, 9, 8, 3];
        let of_sample = |(sample, coefficients): (&[f64], &[f64])| {
            let (mut values, mut rest) = (sample.to_vec(), parameters);
            for (layer, size) in sizes.windows(2).enumerate() {
                let (weights, after) = rest.split_at(size[0] * size[1]);
                let (bias, after) = after.split_at(size[1]);
                let sum = |row: usize| {
                    let terms = values.iter().zip(weights.iter().skip(row).step_by(size[1]));
                    bias[row] + terms.map(|(value, weight)| value * weight).sum::<f64>()
                };
                let sums = (0..size[1]).map(sum);
                values = if layer == 2 { sums.collect() } else { sums.map(|sum| sum.max(0.0)).collect() };
                rest = after;
            }
            values.iter().zip(coefficients).map(|(value, c)| value * c).sum::<f64>()
        };
        input.chunks_exact(7).zip(coefficients.chunks_exact(3)).map(of_sample).sum()
    }

    #[test]
    fn gradients_equal_finite_differences() {
        let mut random = Stream::new(1, 0, Purpose::Test, 20);
        let mut network = Mlp::random(shape(), || random.unit());
        for parameter in network.parameters_mut() {
            *parameter += 0.1 * random.normal() as f32;
        }
        let mut draw = |count: usize| -> Vec<f32> { (0..count).map(|_| random.normal() as f32).collect() };
        let (input, coefficients) = (draw(7 * 6), draw(3 * 6));
        let mut tape = Tape::new(network.shape(), 6);
        tape.input_mut().copy_from_slice(&input);
        network.forward(&mut tape);
        let mut by_parameters = vec![f32::NAN; network.parameters().len()];
        let mut by_input = vec![f32::NAN; input.len()];
        network.backward(&mut tape, &coefficients, Some(&mut by_parameters), Some(&mut by_input));
        let wide = |values: &[f32]| -> Vec<f64> { values.iter().copied().map(f64::from).collect() };
        let (parameters, input, coefficients) = (wide(network.parameters()), wide(&input), wide(&coefficients));
        let out = wide(tape.output());
        let sum: f64 = out.iter().zip(&coefficients).map(|(out, c)| out * c).sum();
        assert!((sum - loss(&parameters, &input, &coefficients)).abs() < 1e-5);
        let check = |gradient: f32, at: &dyn Fn(f64) -> f64| {
            let slope = (at(1e-6) - at(-1e-6)) / 2e-6;
            assert!((f64::from(gradient) - slope).abs() < 1e-5 * (1.0 + slope.abs()), "{gradient} {slope}");
        };
        for (index, &gradient) in by_parameters.iter().enumerate() {
            check(gradient, &|by| {
                let mut moved = parameters.clone();
                moved[index] += by;
                loss(&moved, &input, &coefficients)
            });
        }
        for (index, &gradient) in by_input.iter().enumerate() {
            check(gradient, &|by| {
                let mut moved = input.clone();
                moved[index] += by;
                loss(&parameters, &moved, &coefficients)
            });
        }
    }

    #[test]
    fn the_gradient_by_the_input_does_not_need_the_one_by_the_parameters() {
        let mut random = Stream::new(1, 0, Purpose::Test, 21);
        let network = Mlp::random(shape(), || random.unit());
        let input: Vec<f32> = (0..7 * 6).map(|_| random.normal() as f32).collect();
        let gradient = |wanted: bool| {
            let mut tape = Tape::new(network.shape(), 6);
            tape.input_mut().copy_from_slice(&input);
            network.forward(&mut tape);
            let (mut all, mut by_input) = (vec![0.0; network.parameters().len()], vec![0.0; input.len()]);
            let all = wanted.then_some(&mut all[..]);
            network.backward(&mut tape, &[1.0; 18], all, Some(&mut by_input));
            by_input
        };
        assert_eq!(gradient(true), gradient(false));
    }

    #[test]
    fn a_wrong_number_of_parameters_is_refused() {
        assert_eq!(shape().parameters(), 7 * 9 + 9 + 9 * 8 + 8 + 8 * 3 + 3);
        assert!(Mlp::from_parameters(shape(), vec![0.0; 5]).is_none());
    }
}
