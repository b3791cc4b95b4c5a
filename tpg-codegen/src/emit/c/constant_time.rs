//! The profile `constant-time`: every distinct operation once, every team's choice by masks, a chase of fixed length
//! without a loop. Comparisons are made on integers, so that no compiler has a reason to branch.

use super::expression::Printer;
use super::vertex;
use crate::graph::ScalarType;
use crate::ir::{Module, Node, NodeId};
use askama::Template;
use tpg_runtime::ops::Instruction;

#[derive(Template)]
#[template(path = "c/constant_time.c", escape = "none")]
struct ConstantTime<'a> {
    prefix: &'a str,
    upper: &'a str,
    key: &'a str,
    vertex: &'a str,
    reads_state: bool,
    statements: Vec<String>,
    keys: Vec<KeyView>,
    teams: Vec<TeamView>,
    /// The vertices that are actions.
    actions: Vec<String>,
    depth: usize,
}

/// The key of a bid: an integer in the order of bids.
struct KeyView {
    name: String,
    value: String,
}

struct TeamView {
    label: u32,
    edges: Vec<EdgeView>,
}

struct EdgeView {
    key: String,
    to: String,
}

/// Renders the body.
pub(super) fn render(printer: &Printer<'_>, module: &Module, upper: &str) -> String {
    let computed = (0..).map(NodeId).zip(&module.nodes).filter(|(_, node)| node.is_computed());
    let mut bids: Vec<NodeId> = module.bidders.iter().map(|bidder| bidder.value).collect();
    bids.sort_unstable();
    bids.dedup();
    let key = |id: NodeId| format!("k{}", id.0);
    let constant_time = ConstantTime {
        prefix: printer.prefix,
        upper,
        key: if printer.graph.scalar() == ScalarType::F64 { "uint64_t" } else { "uint32_t" },
        vertex: super::vertex_type(printer.graph, module),
        reads_state: module.nodes.iter().any(|node| matches!(node, Node::Input(_))),
        statements: computed.map(|(id, _)| printer.statement(id)).collect(),
        keys: bids.iter().map(|&id| KeyView { name: key(id), value: printer.value(id) }).collect(),
        teams: (module.teams.iter())
            .map(|team| TeamView {
                label: team.label,
                edges: (team.edges.iter())
                    .map(|edge| EdgeView { key: key(module.bidders[edge.bidder].value), to: vertex(module, edge.to) })
                    .collect(),
            })
            .collect(),
        actions: (module.teams.len()..).take(printer.graph.actions().len()).map(|place| format!("{place}U")).collect(),
        depth: module.depth,
    };
    constant_time.render().expect("the template renders")
}

/// Whether the helpers for comparisons on integers are needed before the others.
pub(super) fn compares(nodes: &[Node]) -> bool {
    let compares = |i| matches!(i, Instruction::NegateIfLess | Instruction::Min | Instruction::Max);
    nodes.iter().any(|node| matches!(*node, Node::Operation(instruction, _) if compares(instruction)))
}
