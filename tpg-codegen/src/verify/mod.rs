//! Compiles generated code and compares it with the interpreter, state by state.

mod batch;
mod build;
mod process;
mod proof;

pub use batch::Batch;
pub(crate) use build::c_compiler;
pub use build::{BuildError, Workshop, c_command, compile, runtime_library, rustc};
pub use process::Process;
pub use proof::{Proof, Stage, Unproven};

use crate::passes::interval::Assumption;
use serde::Serialize;
use std::io;
use tpg_graph::engine::{Engine, Reference};
use tpg_graph::interpret::Answer;
use tpg_graph::states;
use tpg_graph::{Graph, Range};

/// States per batch: bounds memory, does not affect results.
const BATCH: usize = 8192;

/// The comparison of an engine with the interpreter.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct Comparison {
    /// The engine.
    pub engine: String,
    /// The assumption that the states satisfy.
    pub assumption: Assumption,
    /// States compared.
    pub states: usize,
    /// States with another answer: another action, or other bits of an output.
    pub differences: usize,
    /// The first of them.
    pub first: Option<Difference>,
}

/// A state on which an engine and the interpreter disagree.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct Difference {
    /// The state's number in the run.
    pub index: usize,
    /// Its values, as text: JSON has no NaN.
    pub state: Vec<String>,
    /// The interpreter's answer.
    pub expected: Answer,
    /// The engine's answer.
    pub found: Answer,
}

/// Runs engines beside the interpreter on `count` states drawn with `seed`.
///
/// # Errors
/// When an engine's process dies.
pub fn compare(graph: &Graph, engines: &mut [&mut dyn Engine], count: usize, seed: u64) -> io::Result<Vec<Comparison>> {
    compare_under(Assumption::Nothing, graph, engines, count, seed)
}

/// As [`compare`], on states that satisfy an assumption.
///
/// # Errors
/// When an engine's process dies.
pub fn compare_under(
    assumption: Assumption,
    graph: &Graph,
    engines: &mut [&mut dyn Engine],
    count: usize,
    seed: u64,
) -> io::Result<Vec<Comparison>> {
    let mut reference = Reference::new(graph);
    let mut comparisons: Vec<Comparison> = (engines.iter())
        .map(|engine| Comparison {
            engine: engine.name().to_owned(),
            assumption,
            states: 0,
            differences: 0,
            first: None,
        })
        .collect();
    let length = states::batch(graph.state_length(), BATCH);
    for (batch, start) in (0..count).step_by(length).enumerate() {
        // Each batch has its own stream, so that a run of more states begins with the states of a shorter one.
        let mut states = states::sample(graph, length.min(count - start), seed.wrapping_add((batch as u64) << 32));
        if assumption == Assumption::DeclaredRanges {
            move_into_ranges(graph, &mut states);
        }
        let mut expected = Vec::new();
        reference.answer(&states, &mut expected)?;
        for (engine, comparison) in engines.iter_mut().zip(&mut comparisons) {
            let mut found = Vec::new();
            engine.answer(&states, &mut found)?;
            comparison.add(graph, start, &states, &expected, &found);
        }
    }
    Ok(comparisons)
}

/// Moves values to the nearer end of their declared range, NaN to the lower one.
fn move_into_ranges(graph: &Graph, states: &mut [f64]) {
    let ranges: Vec<Range> = graph.state_ranges().collect();
    for state in states.chunks_exact_mut(ranges.len()) {
        for (value, &Range { min, max }) in state.iter_mut().zip(&ranges) {
            // The ends are rounded as the assumption rounds them.
            *value = graph.scalar().round(if value.is_nan() { min } else { value.clamp(min, max) });
        }
    }
}

impl Comparison {
    fn add(&mut self, graph: &Graph, start: usize, states: &[f64], expected: &[Answer], found: &[Answer]) {
        self.states += expected.len();
        let rows = states.chunks_exact(graph.state_length()).zip(expected.iter().zip(found));
        for (index, (state, (expected, found))) in rows.enumerate().filter(|(_, (_, (e, f)))| !e.same_bits(f)) {
            self.differences += 1;
            self.first.get_or_insert_with(|| Difference {
                index: start + index,
                state: state.iter().map(|value| format!("{value:?}")).collect(),
                expected: expected.clone(),
                found: found.clone(),
            });
        }
    }
}

#[cfg(test)]
mod tests {
    use super::move_into_ranges;
    use tpg_graph::sample::{self, Shape};
    use tpg_graph::{Range, states};

    #[test]
    fn states_that_keep_the_declared_ranges_reach_their_ends() {
        for seed in 0..20 {
            let graph = sample::graph(&Shape::random(seed), seed);
            let mut states = states::sample(&graph, 500, seed);
            move_into_ranges(&graph, &mut states);
            let round = |value| graph.scalar().round(value);
            let ranges: Vec<Range> = graph.state_ranges().collect();
            for (place, &Range { min, max }) in ranges.iter().enumerate() {
                let (min, max) = (round(min), round(max));
                let values: Vec<f64> = states.iter().copied().skip(place).step_by(ranges.len()).collect();
                assert!(values.iter().all(|value| (min..=max).contains(value)), "graph {seed}, value {place}");
                assert!(values.contains(&min) && values.contains(&max), "graph {seed}, value {place}");
            }
        }
    }
}
