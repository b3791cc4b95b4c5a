//! The comparison of a graph of counts with the graph that it was made from.

use serde::Serialize;
use tpg_graph::interpret::{self, Answer};
use tpg_graph::states::StateSet;
use tpg_graph::{Graph, Output};

/// The comparison on some states.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct Agreement {
    /// States compared.
    pub states: usize,
    /// Their origin.
    pub origin: String,
    /// States with the same action; of a policy with outputs, all.
    pub same: usize,
    /// Each output.
    pub outputs: Vec<OutputDifference>,
    /// The share of states with a value beyond its counts, and which values these are.
    pub saturated: f64,
    /// The values that are, with their shares.
    pub saturated_inputs: Vec<(String, f64)>,
}

/// The differences of an output, as shares of its range.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct OutputDifference {
    /// Its name.
    pub name: String,
    /// The mean difference.
    pub mean: f64,
    /// The greatest.
    pub greatest: f64,
    /// The share of states that differ by more than a thousandth.
    pub different: f64,
}

impl Agreement {
    /// Compares on states of values.
    pub fn new(graph: &Graph, counted: &Graph, set: &StateSet) -> Self {
        let length = graph.state_length();
        let ((answered, values), (_, kept)) = (graph.split_outputs(), counted.split_outputs());
        let names: Vec<String> = graph.inputs().map(|input| graph.input_label(input)).collect();
        let scale = |(value, counts): (&Output, &Output)| counts.range.magnitude() / value.range.magnitude();
        let memory: Vec<f64> = values.iter().zip(kept).map(scale).collect();
        let (mut same, mut saturated) = (0, 0);
        let mut of_inputs = vec![0_usize; length];
        let mut sums = vec![(0.0_f64, 0.0_f64, 0_usize); answered.len()];
        let mut counts = Vec::with_capacity(set.states.len());
        // An image gives whole numbers.
        let mut states = set.states.clone();
        for state in states.chunks_exact_mut(length) {
            for (input, value) in graph.inputs().zip(&mut *state) {
                *value = if graph.image_range(input).is_some() { value.round() } else { *value };
            }
            let mut beyond = false;
            for (place, (input, &value)) in graph.inputs().zip(&*state).enumerate() {
                let count = match counted.counts_of(input) {
                    Some(counts) => {
                        let count = counts.count(value);
                        if (counts.value(count) - value).abs() > 0.51 * counts.scale {
                            of_inputs[place] += 1;
                            beyond = true;
                        }
                        count
                    }
                    None => (value * memory[place + memory.len() - length]).round(),
                };
                counts.push(count);
            }
            saturated += usize::from(beyond);
        }
        let (floats, wholes) = (interpret::answers(graph, &states), interpret::answers(counted, &counts));
        let states = floats.len();
        for (float, whole) in floats.iter().zip(&wholes) {
            match (float, whole) {
                (Answer::Values(float), Answer::Values(whole)) => {
                    same += 1;
                    for (place, sum) in sums.iter_mut().enumerate() {
                        let (was, is) = (&graph.outputs()[place], &counted.outputs()[place]);
                        let value = is.counts.map_or(whole[place], |counts| counts.value(whole[place]));
                        let width = was.range.max - was.range.min;
                        let share = if width > 0.0 { (value - float[place]).abs() / width } else { 0.0 };
                        *sum = (sum.0 + share, sum.1.max(share), sum.2 + usize::from(share > 0.001));
                    }
                }
                (float, whole) => same += usize::from(float == whole),
            }
        }
        let share = |count: usize| count as f64 / states.max(1) as f64;
        let outputs =
            sums.into_iter().zip(graph.outputs()).map(|((sum, greatest, different), output)| OutputDifference {
                name: output.name.clone(),
                mean: sum / states.max(1) as f64,
                greatest,
                different: share(different),
            });
        let outputs = outputs.collect();
        let beyond = names.into_iter().zip(of_inputs).filter(|(_, count)| *count > 0);
        Self {
            states,
            origin: set.origin.clone(),
            same,
            outputs,
            saturated: share(saturated),
            saturated_inputs: beyond.map(|(name, count)| (name, share(count))).collect(),
        }
    }

    /// The share of actions that are the same in percent, rounded down: 100 means all.
    pub(super) fn percent(&self) -> f64 {
        (self.same as f64 / self.states.max(1) as f64 * 1e5).floor() / 1e3
    }
}
