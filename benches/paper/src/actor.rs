//! The paper's trained actors: 13 values, two layers of 256 with ReLU and LayerNorm, means and spreads of four actions.

use super::torch_random::TorchRandom;
use serde::Deserialize;
use std::fs;
use std::path::Path;
use tpg_arm::observation::Observation;
use tpg_arm::{JOINTS, Move};
use tpg_graph::error::{InputError, Place};

/// Number of inputs of an actor.
pub const INPUTS: usize = 13;
const UNITS: usize = 256;
const SPREAD: (f32, f32) = (1e-6, 1.0);
const NORM_EPSILON: f64 = 1e-5;

/// Name, rows and columns (0: a vector) of each part, in the order of the file.
const LAYOUT: [(&str, usize, usize); 12] = [
    ("fc1.weight", UNITS, INPUTS),
    ("fc1.bias", UNITS, 0),
    ("ln1.weight", UNITS, 0),
    ("ln1.bias", UNITS, 0),
    ("fc2.weight", UNITS, UNITS),
    ("fc2.bias", UNITS, 0),
    ("ln2.weight", UNITS, 0),
    ("ln2.bias", UNITS, 0),
    ("mu.weight", JOINTS, UNITS),
    ("mu.bias", JOINTS, 0),
    ("sigma.weight", JOINTS, UNITS),
    ("sigma.bias", JOINTS, 0),
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
    layout: Vec<ActorPart>,
    state_order: String,
}

#[derive(Deserialize)]
struct ActorPart {
    name: String,
    shape: Vec<usize>,
    offset: usize,
}

/// A recorded actor.
#[derive(Clone, Debug)]
pub struct RecordedActor {
    order: Order,
    /// The parts in the order of [`LAYOUT`].
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
        let refuse = |path: &Path, place: String, found: String, accepted: String| {
            InputError::new(path.display().to_string(), Place::Path(place), found, accepted)
        };
        let described: Description = serde_json::from_str(&text).map_err(|error| {
            refuse(description, "$".to_owned(), error.to_string(), "layout, state_order".to_owned())
        })?;
        let order = match described.state_order.as_str() {
            order if order.starts_with("target/100,diff/100,hand/100") => Order::DifferenceFirst,
            order if order.starts_with("target/100,hand/100,diff/100") => Order::HandFirst,
            order => {
                let accepted = "target/100,diff/100,hand/100,motors or target/100,hand/100,diff/100,motors";
                return Err(refuse(description, "$.state_order".to_owned(), order.to_owned(), accepted.to_owned()));
            }
        };
        let bytes = fs::read(weights).map_err(|error| InputError::io(weights, &error, "an actor's weights"))?;
        let numbers: Vec<f32> = bytes.chunks_exact(4).map(|b| f32::from_le_bytes([b[0], b[1], b[2], b[3]])).collect();
        let mut parts: [Vec<f32>; LAYOUT.len()] = Default::default();
        for ((name, shape), part) in Self::layout().zip(&mut parts) {
            let place = format!("$.layout.{name}");
            let found = described.layout.iter().find(|part| part.name == name);
            let found = found.filter(|part| part.shape == shape).ok_or_else(|| {
                refuse(description, place.clone(), "no such part".to_owned(), format!("shape {shape:?}"))
            })?;
            let length = shape.iter().product::<usize>();
            let values = numbers.get(found.offset..).and_then(|from| from.get(..length)).ok_or_else(|| {
                refuse(weights, place.clone(), format!("{} numbers", numbers.len()), format!("{length} more"))
            })?;
            *part = values.to_vec();
        }
        Ok(Self { order, parts })
    }

    /// Returns the name and shape of each part, in the order of the file.
    pub fn layout() -> impl Iterator<Item = (&'static str, Vec<usize>)> {
        LAYOUT
            .into_iter()
            .map(|(name, rows, columns)| (name, if columns == 0 { vec![rows] } else { vec![rows, columns] }))
    }

    /// Returns the actor's input, computed in `f64` and then rounded.
    pub fn state(&self, seen: &Observation<f64>) -> [f32; INPUTS] {
        let parts = match self.order {
            Order::DifferenceFirst => [seen.target, seen.difference, seen.hand],
            Order::HandFirst => [seen.target, seen.hand, seen.difference],
        };
        let lengths = parts.into_iter().flatten().map(|mm| mm / 100.0);
        let [base, others @ ..] = seen.pose.0.map(f64::from);
        let motors = [base / 2048.0 - 1.0].into_iter().chain(others.map(|ticks| ticks / 1024.0 - 2.0));
        let mut state = [0.0; INPUTS];
        state.iter_mut().zip(lengths.chain(motors)).for_each(|(slot, value)| *slot = value as f32);
        state
    }

    /// Computes means and clipped spreads.
    pub fn forward(&self, state: &[f32; INPUTS]) -> ([f32; JOINTS], [f32; JOINTS]) {
        let [w1, b1, g1, s1, w2, b2, g2, s2, wm, bm, ws, bs] = &self.parts;
        let first = hidden(w1, b1, g1, s1, state);
        let second = hidden(w2, b2, g2, s2, &first);
        let head = |weights: &[f32], bias: &[f32]| -> [f32; JOINTS] {
            std::array::from_fn(|row| dot(&weights[row * UNITS..][..UNITS], &second) + bias[row])
        };
        (head(wm, bm), head(ws, bs).map(|sigma| sigma.clamp(SPREAD.0, SPREAD.1)))
    }

    /// Samples an action as a move: tanh(µ + σ·ε), in steps of three ticks, halves rounded to even.
    pub fn act(&self, seen: &Observation<f64>, random: &mut TorchRandom) -> Move {
        let (mean, spread) = self.forward(&self.state(seen));
        Move(std::array::from_fn(|joint| {
            let action = (random.normal() * spread[joint] + mean[joint]).tanh();
            // An action of exactly ±1 gives two steps, as in the artifact.
            3 * (action * 3.0 / 2.0).round_ties_even() as i8
        }))
    }
}

/// Applies Linear, ReLU and LayerNorm.
fn hidden(weights: &[f32], bias: &[f32], gain: &[f32], shift: &[f32], input: &[f32]) -> Vec<f32> {
    let rows = weights.chunks_exact(input.len()).zip(bias);
    let mut values: Vec<f32> = rows.map(|(row, bias)| (dot(row, input) + bias).max(0.0)).collect();
    let count = values.len() as f64;
    let mean = values.iter().map(|&value| f64::from(value)).sum::<f64>() / count;
    let variance = values.iter().map(|&value| (f64::from(value) - mean).powi(2)).sum::<f64>() / count;
    let inverse = 1.0 / (variance + NORM_EPSILON).sqrt();
    for ((value, gain), shift) in values.iter_mut().zip(gain).zip(shift) {
        *value = ((f64::from(*value) - mean) * inverse) as f32 * gain + shift;
    }
    values
}

/// Computes a dot product in eight partial sums: no recorded decision depends on the order.
fn dot(a: &[f32], b: &[f32]) -> f32 {
    let (a_lanes, b_lanes) = (a.chunks_exact(8), b.chunks_exact(8));
    let rest: f32 = a_lanes.remainder().iter().zip(b_lanes.remainder()).map(|(x, y)| x * y).sum();
    let mut sums = [0.0f32; 8];
    for (x, y) in a_lanes.zip(b_lanes) {
        for lane in 0..8 {
            sums[lane] += x[lane] * y[lane];
        }
    }
    sums.into_iter().sum::<f32>() + rest
}
