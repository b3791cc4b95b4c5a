//! The comparison of engines with the interpreter.

use serde::Serialize;
use std::io;
use tpg_graph::Graph;
use tpg_graph::engine::Engine;
use tpg_graph::image::Vision;
use tpg_graph::interpret::{self, Answer};
use tpg_graph::states;

/// States per batch: bounds memory, does not affect results.
const BATCH: usize = 8192;

/// The comparison of an engine with the interpreter.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct Comparison {
    /// The engine.
    pub engine: String,
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
    let mut comparisons: Vec<Comparison> = (engines.iter())
        .map(|engine| Comparison { engine: engine.name().to_owned(), states: 0, differences: 0, first: None })
        .collect();
    let length = states::batch(graph.state_length(), BATCH);
    for (batch, start) in (0..count).step_by(length).enumerate() {
        // Each batch has its own stream, so that a run of more states begins with the states of a shorter one.
        let seed = seed.wrapping_add((batch as u64) << 32);
        let mut states = states::sample(graph, length.min(count - start), seed);
        states::replace_by_special(graph, &mut states, seed);
        let expected = interpret::answers(graph, &states);
        for (engine, comparison) in engines.iter_mut().zip(&mut comparisons) {
            let mut found = Vec::new();
            engine.answer(&states, &mut found)?;
            comparison.add(graph.state_length(), start, &states, &expected, &found, graph.has_counts());
        }
    }
    Ok(comparisons)
}

/// Compares what an engine reads from images with what the features mean, on `count` images drawn with `seed`.
///
/// # Errors
/// When the engine's process dies.
pub(super) fn compare_looks(
    vision: &Vision,
    engine: &mut dyn Engine,
    count: usize,
    seed: u64,
) -> io::Result<Comparison> {
    let mut comparison = Comparison { engine: engine.name().to_owned(), states: 0, differences: 0, first: None };
    for image in vision.sample(count, seed) {
        let state = vision.state(&image);
        let values: Vec<f64> = image.into_iter().map(f64::from).collect();
        let mut found = Vec::new();
        engine.answer(&values, &mut found)?;
        comparison.add(values.len(), comparison.states, &values, &[Answer::Values(state)], &found, false);
    }
    Ok(comparison)
}

impl Comparison {
    fn add(
        &mut self,
        length: usize,
        start: usize,
        states: &[f64],
        expected: &[Answer],
        found: &[Answer],
        is_whole: bool,
    ) {
        self.states += expected.len();
        let rows = states.chunks_exact(length).zip(expected.iter().zip(found));
        // A whole number has no −0.
        let same = |e: &Answer, f: &Answer| e.same_bits(f) || is_whole && e == f;
        for (index, (state, (expected, found))) in rows.enumerate().filter(|(_, (_, (e, f)))| !same(e, f)) {
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
