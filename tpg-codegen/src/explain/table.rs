//! The bids of a policy as a table: for programs that compute them and have no graph.

use crate::ir::{Edge, Module, Node, NodeId, Successor};
use crate::options::{Language, Options};
use crate::program::compile;
use serde::{Serialize, Serializer};
use std::collections::BTreeMap;
use tpg_graph::Graph;
use tpg_runtime::ops::Instruction;

/// The bids of a policy: every value once, operands before operations, and the edges of each team, the root first.
///
/// ```
/// use tpg_codegen::Options;
/// use tpg_codegen::report::Bids;
/// use tpg_graph::sample::{self, Shape};
///
/// let graph = sample::graph(&Shape::default(), 7);
/// let bids = Bids::of(&graph, &Options::new("arm".parse()?));
/// assert!(bids.teams.iter().flatten().all(|&(value, _)| value < bids.values.len()));
/// # Ok::<(), String>(())
/// ```
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct Bids {
    /// The values.
    pub values: Vec<Value>,
    /// The place of each edge's bid among the values, and its destination.
    pub teams: Vec<Vec<(usize, Destination)>>,
}

/// A value that bids are made of.
#[derive(Clone, Copy, Debug, PartialEq, Serialize)]
#[serde(rename_all = "snake_case")]
pub enum Value {
    /// A value of the state, by its place.
    Input(usize),
    /// A number.
    Constant(#[serde(serialize_with = "shortest")] f64),
    /// An instruction on two earlier values, by their places.
    #[serde(untagged)]
    Operation(#[serde(serialize_with = "name")] Instruction, usize, usize),
}

/// A destination of a bid.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize)]
#[serde(rename_all = "snake_case")]
pub enum Destination {
    /// The place of a team.
    Team(usize),
    /// An action or leaf.
    End(u16),
}

fn name<S: Serializer>(instruction: &Instruction, serializer: S) -> Result<S::Ok, S::Error> {
    serializer.serialize_str(instruction.name())
}

/// Writes a number that is an `f32` in that type's digits.
fn shortest<S: Serializer>(number: &f64, serializer: S) -> Result<S::Ok, S::Error> {
    let narrow = *number as f32;
    if f64::from(narrow) == *number { serializer.serialize_f32(narrow) } else { serializer.serialize_f64(*number) }
}

impl Bids {
    /// Makes the table of the optimised graph that C is made of.
    pub fn of(graph: &Graph, options: &Options) -> Self {
        let program = compile(graph, options, Language::C);
        let module = &program.module;
        let places = places(module);
        let value = |id: &NodeId| match module.node(*id) {
            Node::Constant(bits) => Value::Constant(f64::from_bits(bits)),
            Node::Input(input) => Value::Input(input.index()),
            Node::Operation(instruction, [a, b]) => {
                let b = if instruction.arity() == 1 { a } else { b };
                Value::Operation(instruction, places[&a], places[&b])
            }
            Node::Upper(..) => unreachable!("a module has no bounds before it is scheduled"),
        };
        let edge = |edge: &Edge| {
            let to = match edge.to {
                Successor::Team(team) => Destination::Team(team),
                Successor::Action(end) => Destination::End(end.0),
            };
            (places[&module.bidders[edge.bidder].value], to)
        };
        Self {
            values: places.keys().map(value).collect(),
            teams: module.teams.iter().map(|team| team.edges.iter().map(edge).collect()).collect(),
        }
    }
}

/// The nodes that bids need, numbered in order: operands before operations.
fn places(module: &Module<'_>) -> BTreeMap<NodeId, usize> {
    let mut open: Vec<NodeId> =
        module.teams.iter().flat_map(|team| &team.edges).map(|edge| module.bidders[edge.bidder].value).collect();
    let mut places = BTreeMap::new();
    while let Some(id) = open.pop() {
        if places.insert(id, 0).is_none() {
            open.extend(module.node(id).operands());
        }
    }
    places.values_mut().zip(0..).for_each(|(place, number)| *place = number);
    places
}
