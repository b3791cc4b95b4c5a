//! The sidecar of a `.dot` file: everything about a graph that the `.dot` format leaves out.

use crate::model::{ActionDocument, Effect, Graph, OutputDocument, SourceDocument};
use std::fmt::Write as _;

/// Returns the text of the sidecar, with which [`dot`](super::dot) reads back as the same graph.
pub fn text(graph: &Graph) -> String {
    let document = graph.to_document();
    let instructions: Vec<String> = document.instructions.iter().map(|name| string(name)).collect();
    let provenance = serde_json::to_string(&document.provenance).expect("provenance has only strings as keys");
    let mut out = String::from("# What the .dot file next to this one leaves out.\n\n");
    let mut put = |text: std::fmt::Arguments<'_>| out.write_fmt(text).expect("writing to a string never fails");
    put(format_args!("scalar = \"{}\"\n", document.scalar.name()));
    put(format_args!("maths = \"{}\"\n", document.maths.name()));
    put(format_args!("registers = {}\n\n", document.registers));
    put(format_args!("# In the order of the environment.\nsources = [\n"));
    document.sources.iter().for_each(|each| put(format_args!("    {},\n", source(each))));
    put(format_args!("]\n\n# In the order of their numbers.\ninstructions = [{}]\n\n", instructions.join(", ")));
    if document.outputs.is_empty() {
        put(format_args!("# By the labels of their nodes.\nactions = [\n"));
        document.actions.iter().for_each(|each| put(format_args!("    {},\n", action(each))));
    } else {
        put(format_args!("# By the numbers in the labels of action nodes.\noutputs = [\n"));
        document.outputs.iter().for_each(|each| put(format_args!("    {},\n", output(each))));
    }
    put(format_args!("]\n\n# Where the graph comes from, as in graph.json.\nprovenance = {}\n", string(&provenance)));
    out
}

fn source(source: &SourceDocument) -> String {
    let range = |[min, max]: &[f64; 2]| format!("[{min:?}, {max:?}]");
    let ranges = match source.ranges.as_slice() {
        [first, others @ ..] if others.iter().all(|other| range(other) == range(first)) => {
            format!("range = {}", range(first))
        }
        ranges => format!("ranges = [{}]", ranges.iter().map(range).collect::<Vec<_>>().join(", ")),
    };
    let (name, unit) = (string(&source.name), string(&source.unit));
    format!("{{ name = {name}, length = {}, unit = {unit}, {ranges} }}", source.length)
}

fn output(OutputDocument { name, unit, min, max, nan, .. }: &OutputDocument) -> String {
    let (name, unit) = (string(name), string(unit));
    format!("{{ name = {name}, unit = {unit}, min = {min:?}, max = {max:?}, nan = {nan:?} }}")
}

fn action(action: &ActionDocument) -> String {
    let name = string(&action.name);
    if let Some(asked) = &action.ask {
        return format!("{{ id = {}, name = {name}, ask = {} }}", action.id, string(asked));
    }
    match &action.effect {
        Some(Effect { name: effect, values }) if effect == Effect::MOVE => {
            format!("{{ id = {}, name = {name}, move = {} }}", action.id, numbers(values))
        }
        Some(Effect { name: effect, values }) => {
            let effect = format!("{{ name = {}, values = {} }}", string(effect), numbers(values));
            format!("{{ id = {}, name = {name}, effect = {effect} }}", action.id)
        }
        None => format!("{{ id = {}, name = {name} }}", action.id),
    }
}

/// Formats numbers; whole numbers are written without a fraction.
fn numbers(values: &[f64]) -> String {
    let number = |value: &f64| if value.fract() == 0.0 { format!("{value:.0}") } else { format!("{value:?}") };
    format!("[{}]", values.iter().map(number).collect::<Vec<_>>().join(", "))
}

/// Quotes a string for TOML.
fn string(text: &str) -> String {
    toml::Value::from(text).to_string()
}
