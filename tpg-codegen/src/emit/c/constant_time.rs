//! The profile `constant-time`: every distinct operation once, every team's choice by masks, a chase of fixed length
//! without a loop. Comparisons are made on integers, so that no compiler has a reason to branch. Where there are many teams,
//! they are in several functions, which are called one after another.

use super::expression::Printer;
use super::vertex;
use crate::ir::{Module, Node, NodeId};
use crate::passes::functions::{self, Function};
use askama::Template;
use tpg_graph::ScalarType;
use tpg_runtime::ops::Instruction;

#[derive(Template)]
#[template(path = "c/constant_time.c", escape = "none")]
struct ConstantTime<'a> {
    prefix: &'a str,
    upper: &'a str,
    key: &'a str,
    vertex: &'a str,
    /// What decides for the teams of a function.
    functions: Vec<String>,
    /// The vertices that are actions.
    actions: Vec<String>,
    depth: usize,
}

/// Some teams, and what they need.
#[derive(Template)]
#[template(path = "c/constant_time_teams.c", escape = "none")]
struct Teams<'a> {
    prefix: &'a str,
    key: &'a str,
    vertex: &'a str,
    reads_state: bool,
    statements: Vec<String>,
    keys: Vec<KeyView>,
    teams: Vec<TeamView>,
}

/// The key of a bid: an integer in the order of bids.
struct KeyView {
    name: String,
    value: String,
}

struct TeamView {
    label: u32,
    number: usize,
    edges: Vec<EdgeView>,
}

struct EdgeView {
    key: String,
    to: String,
}

/// Renders the body.
pub(super) fn render(printer: &Printer<'_>, module: &Module, upper: &str) -> String {
    let functions = functions::of(module);
    let constant_time = ConstantTime {
        prefix: printer.prefix,
        upper,
        key: key_type(printer),
        vertex: super::vertex_type(printer.graph, module),
        functions: functions.iter().map(|function| teams(printer, module, function)).collect(),
        actions: (module.teams.len()..).take(printer.graph.actions().len()).map(|place| format!("{place}U")).collect(),
        depth: module.depth,
    };
    constant_time.render().expect("the template renders")
}

fn key_type(printer: &Printer<'_>) -> &'static str {
    if printer.graph.scalar() == ScalarType::F64 { "uint64_t" } else { "uint32_t" }
}

fn teams(printer: &Printer<'_>, module: &Module, function: &Function) -> String {
    let key = |id: NodeId| format!("k{}", id.0);
    let team = |number: usize| TeamView {
        label: module.teams[number].label,
        number,
        edges: (module.teams[number].edges.iter())
            .map(|edge| EdgeView { key: key(module.bidders[edge.bidder].value), to: vertex(module, edge.to) })
            .collect(),
    };
    let read = function.operations.iter().flat_map(|&id| module.nodes[id.index()].operands()).chain(&function.bids);
    let teams = Teams {
        prefix: printer.prefix,
        key: key_type(printer),
        vertex: super::vertex_type(printer.graph, module),
        reads_state: read.into_iter().any(|&id| matches!(module.node(id), Node::Input(_))),
        statements: function.operations.iter().map(|&id| printer.statement(id)).collect(),
        keys: function.bids.iter().map(|&id| KeyView { name: key(id), value: printer.value(id) }).collect(),
        teams: function.teams.clone().map(team).collect(),
    };
    teams.render().expect("the template renders").trim_end().to_owned()
}

/// Whether the helpers for comparisons on integers are needed before the others.
pub(super) fn compares(nodes: &[Node]) -> bool {
    let compares = |i| matches!(i, Instruction::NegateIfLess | Instruction::Min | Instruction::Max);
    nodes.iter().any(|node| matches!(*node, Node::Operation(instruction, _) if compares(instruction)))
}
