//! Counts in place of values, for graphs in integers.

use serde::{Deserialize, Serialize};
use tpg_graph::{Counts, Graph};
use tpg_runtime::scalar::Scalar;

/// The counts of the values that a graph reads and answers, if they are counts.
#[derive(Clone, Debug, Default, Serialize, Deserialize)]
pub struct Units {
    pub(crate) inputs: Vec<Option<Counts>>,
    pub(crate) outputs: Vec<Option<Counts>>,
}

impl Units {
    /// Returns those of a graph.
    pub fn of(graph: &Graph) -> Self {
        let inputs = graph.inputs().map(|input| graph.counts_of(input)).collect();
        Self { inputs, outputs: graph.outputs().iter().map(|output| output.counts).collect() }
    }

    /// True if nothing is a count.
    pub(crate) fn is_plain(&self) -> bool {
        self.inputs.iter().chain(&self.outputs).all(Option::is_none)
    }

    /// Puts the values of a state into counts.
    pub fn count<S: Scalar>(&self, state: &mut [S]) {
        convert(&self.inputs, state, Counts::count);
    }

    /// Puts the counts of an answer into values.
    pub fn value<S: Scalar>(&self, answer: &mut [S]) {
        convert(&self.outputs, answer, Counts::value);
    }
}

fn convert<S: Scalar>(counts: &[Option<Counts>], values: &mut [S], convert: fn(Counts, f64) -> f64) {
    for (value, counts) in values.iter_mut().zip(counts) {
        *value = counts.map_or(*value, |counts| S::from_f64(convert(counts, value.to_f64())));
    }
}
