//! The paper's trained actors: 13 values, two layers of 256 with ReLU and LayerNorm, means and spreads of four actions.
//!
//! As a [`Policy`] an actor is the network that the paper's hybrids are compared with. It is this project's layout of the network in
//! `f32`, and does not wait for a framework.

use serde::Deserialize;
use std::fs;
use std::path::Path;
use tpg_arm::kinematics::Lattice;
use tpg_arm::observation::Observation;
use tpg_arm::{JOINTS, Move};
use tpg_engine::random::{Purpose, Stream};
use tpg_graph::error::{InputError, Place};
use tpg_runtime::policy::Policy;

/// Number of inputs of an actor.
pub const INPUTS: usize = 13;
const UNITS: usize = 256;
const LANES: usize = 8;
/// Length of an actor's state: its inputs, and zeros up to whole lanes.
pub const STATE: usize = INPUTS.next_multiple_of(LANES);
const SPREAD: (f32, f32) = (1e-6, 1.0);
const NORM_EPSILON: f32 = 1e-5;

/// Rows and columns of each part in the order of the file, a vector as one column: weights and biases of `fc1`, `ln1`, `fc2`, `ln2`,
/// `mu` and `sigma`.
pub(crate) const LAYOUT: [(usize, usize); 12] = [
    (UNITS, INPUTS),
    (UNITS, 1),
    (UNITS, 1),
    (UNITS, 1),
    (UNITS, UNITS),
    (UNITS, 1),
    (UNITS, 1),
    (UNITS, 1),
    (JOINTS, UNITS),
    (JOINTS, 1),
    (JOINTS, UNITS),
    (JOINTS, 1),
];

/// Order of an actor's inputs: the artifact swapped two parts for random starts.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Order {
    /// Target, target − hand, hand, motors.
    DifferenceFirst,
    /// Target, hand, target − hand, motors.
    HandFirst,
}

/// Content of the description file of an actor.
#[derive(Deserialize)]
struct Description {
    state_order: String,
}

/// A recorded actor.
#[derive(Clone, Debug)]
pub struct RecordedActor {
    order: Order,
    /// The parts in the order of [`LAYOUT`]; rows of the first are as long as a state.
    parts: [Vec<f32>; LAYOUT.len()],
}

impl RecordedActor {
    /// Reads weights (`f32`, little endian) and their description.
    ///
    /// # Errors
    /// If a file cannot be read, or the actor does not have the paper's shape.
    pub fn read(weights: &Path, description: &Path) -> Result<Self, InputError> {
        let text = fs::read_to_string(description)
            .map_err(|error| InputError::io(description, &error, "an actor's description"))?;
        let file = description.display().to_string();
        let described: Description = serde_json::from_str(&text)
            .map_err(|error| InputError::new(&file, Place::Whole, error.to_string(), "an object with state_order"))?;
        let order = match described.state_order.as_str() {
            order if order.starts_with("target/100,diff/100,hand/100") => Order::DifferenceFirst,
            order if order.starts_with("target/100,hand/100,diff/100") => Order::HandFirst,
            order => {
                let accepted = "target/100,diff/100,hand/100,motors or target/100,hand/100,diff/100,motors";
                return Err(InputError::new(file, "$.state_order", order, accepted));
            }
        };
        let bytes = fs::read(weights).map_err(|error| InputError::io(weights, &error, "an actor's weights"))?;
        let count = LAYOUT.iter().map(|(rows, columns)| rows * columns).sum::<usize>();
        if bytes.len() != 4 * count {
            let (file, found) = (weights.display().to_string(), format!("{} bytes", bytes.len()));
            return Err(InputError::new(file, Place::Whole, found, format!("{count} numbers, f32 in little endian")));
        }
        let mut numbers = bytes.as_chunks().0.iter().map(|&number| f32::from_le_bytes(number));
        let mut parts = LAYOUT.map(|(rows, columns)| numbers.by_ref().take(rows * columns).collect::<Vec<f32>>());
        parts[0] =
            parts[0].chunks_exact(INPUTS).flat_map(|row| row.iter().chain(&[0.0; STATE - INPUTS])).copied().collect();
        Ok(Self { order, parts })
    }

    /// Creates an actor with random weights: it takes as much time as any other.
    pub fn random(seed: u64) -> Self {
        let mut random = Stream::new(seed, 0, Purpose::Weights, 0);
        let parts = LAYOUT.map(|(rows, columns)| match columns {
            1 => vec![1.0; rows],
            INPUTS => (0..rows * STATE).map(|_| (2.0 * random.unit() - 1.0) as f32).collect(),
            _ => (0..rows * columns).map(|_| ((2.0 * random.unit() - 1.0) / (columns as f64).sqrt()) as f32).collect(),
        });
        Self { order: Order::DifferenceFirst, parts }
    }

    /// Returns the actor's input, computed in `f64` and then rounded.
    pub fn state<S: Lattice>(&self, seen: &Observation<S>) -> [f32; STATE] {
        let parts = match self.order {
            Order::DifferenceFirst => [seen.target, seen.difference, seen.hand],
            Order::HandFirst => [seen.target, seen.hand, seen.difference],
        };
        let lengths = parts.into_iter().flatten().map(|mm| mm.to_f64() / 100.0);
        let [base, others @ ..] = seen.pose.0.map(f64::from);
        let motors = [base / 2048.0 - 1.0].into_iter().chain(others.map(|ticks| ticks / 1024.0 - 2.0));
        let mut state = [0.0; STATE];
        state.iter_mut().zip(lengths.chain(motors)).for_each(|(slot, value)| *slot = value as f32);
        state
    }

    /// Computes means and clipped spreads.
    pub fn forward(&self, state: &[f32; STATE]) -> ([f32; JOINTS], [f32; JOINTS]) {
        let hidden = self.hidden(state);
        (self.head(8, &hidden), self.head(10, &hidden).map(|sigma| sigma.clamp(SPREAD.0, SPREAD.1)))
    }

    /// Computes the second layer's outputs.
    fn hidden(&self, state: &[f32; STATE]) -> [f32; UNITS] {
        let [w1, b1, g1, s1, w2, b2, g2, s2, ..] = &self.parts;
        layer(w2, b2, g2, s2, &layer(w1, b1, g1, s1, state))
    }

    /// Computes the outputs of the part at a place and of the one behind it, its bias.
    fn head(&self, place: usize, hidden: &[f32; UNITS]) -> [f32; JOINTS] {
        let (weights, bias) = (&self.parts[place], &self.parts[place + 1]);
        std::array::from_fn(|row| dot(&weights[row * UNITS..][..UNITS], hidden) + bias[row])
    }
}

impl Policy for RecordedActor {
    type State = Observation<f32>;
    type Action = Move;

    fn decide(&self, seen: &Observation<f32>) -> Move {
        let means = self.head(8, &self.hidden(&self.state(seen)));
        // Tests |tanh µ| > 1/3 without computing the tanh.
        Move(means.map(|mean| if mean > 0.3466 { 3 } else { -3 * i8::from(mean < -0.3466) }))
    }
}

/// Applies Linear, ReLU and LayerNorm.
fn layer(weights: &[f32], bias: &[f32], gain: &[f32], shift: &[f32], input: &[f32]) -> [f32; UNITS] {
    let mut values = [0.0; UNITS];
    for ((value, row), bias) in values.iter_mut().zip(weights.chunks_exact(input.len())).zip(bias) {
        *value = (dot(row, input) + bias).max(0.0);
    }
    let mean = values.iter().sum::<f32>() / UNITS as f32;
    let variance = values.iter().map(|value| (value - mean) * (value - mean)).sum::<f32>() / UNITS as f32;
    let inverse = 1.0 / (variance + NORM_EPSILON).sqrt();
    for ((value, gain), shift) in values.iter_mut().zip(gain).zip(shift) {
        *value = (*value - mean) * inverse * gain + shift;
    }
    values
}

/// Computes a dot product of whole lanes in partial sums: no recorded decision depends on the order.
fn dot(a: &[f32], b: &[f32]) -> f32 {
    let mut sums = [0.0f32; LANES];
    for (a, b) in a.chunks_exact(LANES).zip(b.chunks_exact(LANES)) {
        for lane in 0..LANES {
            sums[lane] += a[lane] * b[lane];
        }
    }
    sums.into_iter().sum()
}
