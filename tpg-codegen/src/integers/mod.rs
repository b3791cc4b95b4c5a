//! A graph of whole numbers in integers: C and Rust without floats, by proof.
//!
//! A graph whose sources and outputs are [counts](tpg_graph::Counts) computes in `f64`, which holds whole numbers exactly. The analysis
//! here shows for every value that it is a whole number, for every state there is, and how great it can be. What fits `int32_t` is
//! computed in it, what does not in `int64_t`; nothing wraps or saturates, so the integers are the interpreter's. A value that may be
//! a fraction, or is too great for an `f64` to be exact, is refused: there is no way back to floats.

mod form;
mod whole;

pub(crate) use form::{Form, forms};
pub(crate) use whole::{Unfit, Whole};

use crate::formula;
use crate::ir::{Module, Node, NodeId, reached};
use tpg_graph::error::InputError;
use tpg_graph::{Counts, Graph, Input, ScalarType, SourceDocument};

/// A module whose every value is whole.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct Integers {
    /// The interval of each node.
    pub values: Vec<Whole>,
    /// Each node as a sum.
    pub forms: Vec<Form>,
    /// Dense sums are tables.
    pub tables: bool,
}

impl Integers {
    /// The interval of a node.
    pub(crate) fn interval(&self, id: NodeId) -> Whole {
        self.values[id.index()]
    }

    /// The number of values that need 64 bits.
    pub(crate) fn wide(&self) -> usize {
        self.values.iter().filter(|whole| !whole.fits(32)).count()
    }
}

/// The interval of every node.
pub(crate) fn analyse(file: &str, module: &Module<'_>) -> Result<Vec<Whole>, InputError> {
    let refuse = |path: String, found: String, accepted: &str| Err(InputError::new(file, path, found, accepted));
    let graph = module.graph;
    if graph.scalar() != ScalarType::F64 {
        return refuse("$.scalar".to_owned(), "f32".to_owned(), "f64, which holds every whole number to 2^53");
    }
    let limits = declared(file, graph)?;
    let mut values: Vec<Whole> = Vec::with_capacity(module.nodes.len());
    for (place, node) in module.nodes.iter().enumerate() {
        let value = match *node {
            Node::Input(input) => Ok(limits[input.index()]),
            Node::Constant(bits) => Whole::exactly(f64::from_bits(bits)),
            Node::Operation(instruction, [a, b]) => Whole::apply(instruction, values[a.index()], values[b.index()]),
            Node::Upper(..) => Err(Unfit::NotWhole),
        };
        match value {
            Ok(value) => values.push(value),
            Err(unfit) => {
                let id = NodeId(place as u32);
                let formula = formula::text(module, id);
                let (why, accepted) = match unfit {
                    Unfit::NotWhole => {
                        ("may be a fraction".to_owned(), "whole numbers: quotient(a, b) divides and rounds down")
                    }
                    Unfit::TooGreat(most) => (format!("can reach {most}"), "magnitudes up to 2^53"),
                    Unfit::ByZero => (
                        "may divide by 0".to_owned(),
                        "a divisor that is never 0, or quotient(a, b), which says what that is",
                    ),
                };
                return refuse(user(module, id), format!("{formula}, which {why}"), accepted);
            }
        }
    }
    Ok(values)
}

/// The interval of each value of the state, and a check of the outputs.
fn declared(file: &str, graph: &Graph) -> Result<Vec<Whole>, InputError> {
    let refuse = |path: String, found: &str, accepted: &str| Err(InputError::new(file, path, found, accepted));
    let mut limits = Vec::new();
    let mut inputs = graph.inputs();
    for (place, source) in graph.observed().iter().enumerate() {
        if source.counts.is_empty() {
            let accepted = "\"counts\", the integers that it comes in: `tpg-codegen quantise` makes such a graph";
            return refuse(format!("$.sources[{place}]"), &format!("{:?} without counts", source.name), accepted);
        }
        for input in inputs.by_ref().take(source.counts.len()) {
            let [low, high] = graph.count_range(input, source_bits(source));
            limits.push(Whole { low: low as i64, high: high as i64 });
        }
    }
    let answered = graph.split_outputs().0.len();
    for (place, output) in graph.outputs().iter().enumerate() {
        let path = || match place.checked_sub(answered) {
            Some(place) => format!("$.memory[{place}]"),
            None => format!("$.outputs[{place}]"),
        };
        if place < answered && output.counts.is_none() {
            return refuse(path(), &format!("{:?} without counts", output.name), "\"counts\", the integers that it is");
        }
        let range = Whole::between(output.range.min, output.range.max).ok().filter(|range| range.fits(32));
        match range {
            Some(range) if place >= answered => limits.push(range),
            Some(_) => {}
            None => return refuse(path(), &output.range.to_string(), "whole numbers of 32 bits"),
        }
    }
    Ok(limits)
}

/// The program that needs a node, by its path in the file's terms.
fn user(module: &Module<'_>, id: NodeId) -> String {
    let needs = |value: NodeId| {
        value == id || module.operations_of(value).contains(&id) || {
            module.operations_of(value).iter().any(|operation| module.node(*operation).operands().contains(&id))
        }
    };
    let bidder = module.bidders.iter().find(|bidder| needs(bidder.value));
    let leaf = || {
        let (_, leaf) = reached(&module.leaves).find(|(_, leaf)| leaf.values.iter().any(|&value| needs(value)))?;
        let place = leaf.values.iter().position(|&value| needs(value))?;
        Some(format!("leaf {}, {}", leaf.label, module.graph.outputs()[place].name))
    };
    bidder.map(|bidder| format!("program {}", bidder.label)).or_else(leaf).unwrap_or_else(|| "$.programs".to_owned())
}

/// The type of a value of the state in bits: 8, 16 or 32.
pub(crate) fn input_bits(graph: &Graph, input: Input) -> u32 {
    source_bits(graph.source_of(input).0)
}

/// The type of a source's values in bits; 32 for memory.
pub(crate) fn source_bits(source: &SourceDocument) -> u32 {
    if source.counts.is_empty() { 32 } else { Counts::container_of(&source.counts) }
}

/// The type of an output in bits: 8, 16, or 32 for memory.
pub(crate) fn output_bits(output: &tpg_graph::Output) -> u32 {
    output.counts.map_or(32, |counts| counts.container())
}
