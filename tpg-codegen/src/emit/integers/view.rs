//! The interface of the C in integers: fields with the worth of a count, constants of actions, states of the self-test.

use super::comment::{with_unit, worth, worth_from};
use crate::emit::c::field::field;
use crate::emit::file::comment;
use crate::emit::interface::actions;
use crate::emit::vectors::Vectors;
use crate::integers::{output_bits, source_bits};
use tpg_graph::interpret::Answer;
use tpg_graph::{Counts, Graph};

/// A field of a structure.
pub(super) struct FieldView {
    pub(super) field: String,
    pub(super) kind: String,
    /// Values; 0 for one that is no array.
    pub(super) length: usize,
    /// The worth of a count.
    pub(super) meaning: Vec<String>,
    pub(super) initial: String,
}

impl FieldView {
    /// The member of the structure: a value, or an array of more than one.
    pub(super) fn member(&self) -> String {
        if self.length == 1 { self.field.clone() } else { format!("{}[{}]", self.field, self.length) }
    }
}

/// A state of the self-test, its memory, and the answer to it.
pub(super) struct VectorView {
    pub(super) state: String,
    pub(super) memory: String,
    pub(super) answer: String,
    pub(super) next: String,
}

/// The fields of a state.
pub(super) fn sources(graph: &Graph) -> Vec<FieldView> {
    let view = |source: &tpg_graph::Source| {
        let meaning = |(counts, range): (&Counts, &tpg_graph::Range)| {
            format!("{}: {range}", worth_from(counts, &comment(&source.unit)))
        };
        let mut meaning: Vec<String> = source.counts.iter().zip(&source.ranges).map(meaning).collect();
        if meaning.iter().all(|one| *one == meaning[0]) {
            meaning.truncate(1);
        }
        FieldView {
            field: field(graph, &source.name),
            kind: format!("int{}_t", source_bits(source)),
            length: source.ranges.len(),
            meaning,
            initial: String::new(),
        }
    };
    graph.observed().iter().map(view).collect()
}

/// The fields of an answer, or of a memory.
pub(super) fn outputs(graph: &Graph, of_memory: bool) -> Vec<FieldView> {
    let (answers, memory) = graph.split_outputs();
    let view = |output: &tpg_graph::Output| {
        let meaning = match output.counts {
            Some(counts) => {
                let [low, high] = [output.range.min, output.range.max].map(|end| counts.value(end));
                let unit = comment(&output.unit);
                let [low, high] = [low, high].map(|end| with_unit(&end.to_string(), &unit));
                let worth = worth(counts.scale, &unit);
                format!("{worth}: {} ({low}) to {} ({high})", output.range.min, output.range.max)
            }
            None => format!("{}; at first {}", output.range, output.nan),
        };
        FieldView {
            field: field(graph, &output.name),
            kind: format!("int{}_t", output_bits(output)),
            length: 0,
            meaning: vec![meaning],
            initial: output.nan.to_string(),
        }
    };
    (if of_memory { memory } else { answers }).iter().map(view).collect()
}

/// The states of the self-test.
pub(super) fn views(graph: &Graph, upper: &str, Vectors { states, answers, .. }: &Vectors) -> Vec<VectorView> {
    let constants = actions(graph, upper);
    let list = |values: &[f64]| values.iter().map(|value| whole(*value)).collect::<Vec<_>>().join(", ");
    (states.chunks_exact(graph.state_length()).zip(answers))
        .map(|(state, answer)| {
            let mut values = state.iter().copied();
            let members = graph.observed().iter().map(|source| {
                let values: Vec<f64> = values.by_ref().take(source.ranges.len()).collect();
                if let [value] = values[..] { whole(value) } else { format!("{{ {} }}", list(&values)) }
            });
            let state_text = format!("{{ {} }}", members.collect::<Vec<_>>().join(", "));
            let (answer, next) = match answer {
                Answer::Action(action) => (constants[usize::from(action.0)].0.clone(), String::new()),
                Answer::Values(values) => {
                    let (answer, next) = values.split_at(values.len() - graph.memory());
                    (format!("{{ {} }}", list(answer)), format!("{{ {} }}", list(next)))
                }
            };
            let memory = format!("{{ {} }}", list(&state[graph.observed_length()..]));
            VectorView { state: state_text, memory, answer, next }
        })
        .collect()
}

/// A whole number; 0 for −0.
fn whole(value: f64) -> String {
    match value as i64 {
        -2_147_483_648 => "INT32_MIN".to_owned(),
        value => value.to_string(),
    }
}
