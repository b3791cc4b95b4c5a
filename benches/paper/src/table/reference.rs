//! The network that the paper compares with, 13-256-256-4 in `f32` with LayerNorm, optimised for speed: rows in eight
//! partial sums, which compilers vectorise. Its time does not depend on its weights.

use std::cell::RefCell;
use tpg_arm::observation::Observation;
use tpg_arm::{JOINTS, Move};
use tpg_engine::random::{Purpose, Stream};
use tpg_runtime::policy::Policy;

const INPUTS: usize = 13;
const UNITS: usize = 256;
const LANES: usize = 8;

/// The network, with random weights.
#[derive(Debug)]
pub struct Reference {
    /// Weights of the first layer; inputs are padded with zeros to whole lanes.
    first: Vec<f32>,
    second: Vec<f32>,
    last: Vec<f32>,
    hidden: RefCell<[[f32; UNITS]; 2]>,
}

const PADDED: usize = INPUTS.next_multiple_of(LANES);

impl Reference {
    /// Creates the network with random weights of the given seed.
    pub fn random(seed: u64) -> Self {
        let mut random = Stream::new(seed, 0, Purpose::Weights, 0);
        let mut weights = |rows: usize, columns: usize| {
            let bound = 1.0 / (columns as f64).sqrt();
            (0..rows * columns).map(|_| ((2.0 * random.unit() - 1.0) * bound) as f32).collect()
        };
        Self {
            first: weights(UNITS, PADDED),
            second: weights(UNITS, UNITS),
            last: weights(JOINTS, UNITS),
            hidden: RefCell::new([[0.0; UNITS]; 2]),
        }
    }

    /// Computes the paper's four outputs.
    pub fn forward(&self, inputs: &[f32; PADDED]) -> [f32; JOINTS] {
        let mut hidden = self.hidden.borrow_mut();
        let [first, second] = &mut *hidden;
        layer(&self.first, inputs, first);
        layer(&self.second, first, second);
        std::array::from_fn(|joint| dot(&self.last[joint * UNITS..][..UNITS], second))
    }
}

impl Policy for Reference {
    type State = Observation<f32>;
    type Action = Move;

    fn decide(&self, seen: &Observation<f32>) -> Move {
        let lengths = seen.target.into_iter().chain(seen.difference).chain(seen.hand).map(|mm| mm / 100.0);
        let motors = seen.pose.0.map(|ticks| f32::from(ticks) / 1024.0 - 2.0);
        let mut inputs = [0.0; PADDED];
        inputs.iter_mut().zip(lengths.chain(motors)).for_each(|(slot, value)| *slot = value);
        // Tests |tanh µ| > 1/3 without computing the tanh.
        Move(self.forward(&inputs).map(|mean| if mean > 0.3466 { 3 } else { -3 * i8::from(mean < -0.3466) }))
    }
}

/// Applies Linear, ReLU and LayerNorm (with gain 1 and shift 0).
fn layer(weights: &[f32], inputs: &[f32], outputs: &mut [f32; UNITS]) {
    for (output, row) in outputs.iter_mut().zip(weights.chunks_exact(inputs.len())) {
        *output = dot(row, inputs).max(0.0);
    }
    let mean = outputs.iter().sum::<f32>() / UNITS as f32;
    let variance = outputs.iter().map(|value| (value - mean) * (value - mean)).sum::<f32>() / UNITS as f32;
    let inverse = 1.0 / (variance + 1e-5).sqrt();
    outputs.iter_mut().for_each(|value| *value = (*value - mean) * inverse);
}

fn dot(a: &[f32], b: &[f32]) -> f32 {
    let mut sums = [0.0f32; LANES];
    for (a, b) in a.chunks_exact(LANES).zip(b.chunks_exact(LANES)) {
        for lane in 0..LANES {
            sums[lane] += a[lane] * b[lane];
        }
    }
    sums.into_iter().sum()
}
