//! A multi-layer perceptron with its parameters in one flat vector.

use super::vectors::vectorised;
use super::{Factor, Finish, Real, Scratch, multiply};
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
#[derive(Clone, Copy, Debug, PartialEq)]
struct MlpLayer {
    inputs: usize,
    outputs: usize,
    /// Weights, column-major `outputs` × `inputs`.
    weight: usize,
    bias: usize,
}

impl MlpLayer {
    fn weight<'a, T: Real>(&self, parameters: &'a [T]) -> Factor<'a, T> {
        Factor::new(&parameters[self.weight..][..self.inputs * self.outputs], self.outputs, self.inputs)
    }

    fn bias<'a, T>(&self, parameters: &'a [T]) -> &'a [T] {
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

    /// Returns the number of weight multiplications per sample.
    pub fn multiplications(&self) -> usize {
        self.layers().iter().map(|layer| layer.inputs * layer.outputs).sum()
    }
}

/// A network: its shape and its parameters. Each layer has weights (column-major, outputs × inputs) and a bias.
#[derive(Clone, Debug, PartialEq)]
pub struct Mlp<T> {
    shape: Shape,
    layers: Vec<MlpLayer>,
    parameters: Vec<T>,
}

/// Values that a forward pass keeps for the backward pass: those between the layers, for one batch.
#[derive(Clone, Debug)]
pub struct Tape<T> {
    batch: usize,
    /// The input of each layer: the network's input, then each hidden layer's output.
    inputs: Vec<Vec<T>>,
    output: Vec<T>,
    /// Gradients of the backward pass; swapped layer by layer.
    gradient: [Vec<T>; 2],
    scratch: Scratch<T>,
}

impl<T: Real> Tape<T> {
    /// Creates an empty tape for batches of `batch` samples.
    pub fn new(shape: &Shape, batch: usize) -> Self {
        let zeros = |rows: usize| vec![T::zero(); rows * batch];
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
    pub fn input_mut(&mut self) -> &mut [T] {
        self.inputs.first_mut().map_or(&mut [], Vec::as_mut_slice)
    }

    /// Returns the output of a hidden layer, one column per sample.
    ///
    /// # Panics
    /// If there is no such layer.
    pub fn activations(&self, layer: usize) -> &[T] {
        &self.inputs[layer + 1]
    }

    /// Returns the network's output, one column per sample.
    pub fn output(&self) -> &[T] {
        &self.output
    }
}

impl<T: Real> Mlp<T> {
    /// Creates a network with weights and biases uniform in ±1/√inputs, as in PyTorch's `Linear`.
    pub fn random(shape: Shape, mut unit: impl FnMut() -> f64) -> Self {
        let mut parameters = vec![T::zero(); shape.parameters()];
        let layers = shape.layers();
        for layer in &layers {
            let bound = 1.0 / (layer.inputs as f64).sqrt();
            for parameter in &mut parameters[layer.weight..layer.bias + layer.outputs] {
                *parameter = T::nearest((2.0 * unit() - 1.0) * bound);
            }
        }
        Self { shape, layers, parameters }
    }

    /// Creates a network from given parameters; `None` if their number does not match the shape.
    pub fn from_parameters(shape: Shape, parameters: Vec<T>) -> Option<Self> {
        (parameters.len() == shape.parameters()).then(|| Self { layers: shape.layers(), shape, parameters })
    }

    /// Returns the shape.
    pub fn shape(&self) -> &Shape {
        &self.shape
    }

    /// Returns the flat parameters.
    pub fn parameters(&self) -> &[T] {
        &self.parameters
    }

    /// Returns the flat parameters for an optimiser to change.
    pub fn parameters_mut(&mut self) -> &mut [T] {
        &mut self.parameters
    }

    /// Returns weights (row-major, outputs × inputs) and bias of each layer, first to last.
    pub fn weights(&self) -> Vec<(Vec<T>, Vec<T>)> {
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
    pub fn follow(&mut self, other: &Self, rate: T) {
        T::follow(self, other, rate);
    }

    pub(super) fn compute_follow(&mut self, other: &Self, rate: T) {
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
    pub fn forward(&self, tape: &mut Tape<T>) {
        T::forward(self, tape);
    }

    pub(super) fn compute_forward(&self, tape: &mut Tape<T>) {
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
        tape: &mut Tape<T>,
        by_output: &[T],
        gradients: Option<&mut [T]>,
        by_input: Option<&mut [T]>,
    ) {
        T::backward(self, tape, by_output, gradients, by_input);
    }

    pub(super) fn compute_backward(
        &self,
        tape: &mut Tape<T>,
        by_output: &[T],
        mut gradients: Option<&mut [T]>,
        by_input: Option<&mut [T]>,
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
fn sum_columns<T: Real>(sums: &mut [T], columns: &[T]) {
    vectorised(
        #[inline(always)]
        || {
            sums.fill(T::zero());
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

    /// Σ c·out over a batch of 6, with fixed coefficients c.
    fn loss(network: &Mlp<f64>, input: &[f64], coefficients: &[f64]) -> (f64, Tape<f64>) {
        let mut tape = Tape::new(network.shape(), 6);
        tape.input_mut().copy_from_slice(input);
        network.forward(&mut tape);
        (tape.output().iter().zip(coefficients).map(|(&out, &c)| out * c).sum(), tape)
    }

    #[test]
    fn gradients_equal_finite_differences() {
        let mut random = Stream::new(1, 0, Purpose::Test, 20);
        let mut network = Mlp::<f64>::random(shape(), || random.unit());
        for parameter in network.parameters_mut() {
            *parameter += 0.1 * random.normal();
        }
        let input: Vec<f64> = (0..7 * 6).map(|_| random.normal()).collect();
        let coefficients: Vec<f64> = (0..3 * 6).map(|_| random.normal()).collect();
        let (_, mut tape) = loss(&network, &input, &coefficients);
        let mut by_parameters = vec![f64::NAN; network.parameters().len()];
        let mut by_input = vec![f64::NAN; input.len()];
        network.backward(&mut tape, &coefficients, Some(&mut by_parameters), Some(&mut by_input));
        let step = 1e-6;
        let slope = |up: f64, down: f64| (up - down) / (2.0 * step);
        for (index, &gradient) in by_parameters.iter().enumerate() {
            let at = |by: f64| {
                let mut moved = network.clone();
                moved.parameters_mut()[index] += by;
                loss(&moved, &input, &coefficients).0
            };
            let slope = slope(at(step), at(-step));
            assert!((gradient - slope).abs() < 1e-7 * (1.0 + slope.abs()), "parameter {index}: {gradient} {slope}");
        }
        for (index, &gradient) in by_input.iter().enumerate() {
            let at = |by: f64| {
                let mut moved = input.clone();
                moved[index] += by;
                loss(&network, &moved, &coefficients).0
            };
            let slope = slope(at(step), at(-step));
            assert!((gradient - slope).abs() < 1e-7 * (1.0 + slope.abs()), "input {index}: {gradient} {slope}");
        }
    }

    #[test]
    fn the_gradient_by_the_input_does_not_need_the_one_by_the_parameters() {
        let mut random = Stream::new(1, 0, Purpose::Test, 21);
        let network = Mlp::<f32>::random(shape(), || random.unit());
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
        assert_eq!(shape().multiplications(), 7 * 9 + 9 * 8 + 8 * 3);
        assert!(Mlp::from_parameters(shape(), vec![0.0f32; 5]).is_none());
    }
}
