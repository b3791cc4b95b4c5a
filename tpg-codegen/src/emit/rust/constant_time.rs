//! The profile `constant-time`: every distinct operation once, then every team's choice by masks, then a chase of fixed
//! length from the root to an action. Comparisons are made on integers, by masks that LLVM does not know for such
//! (`tpg_runtime::ops::constant_time`): it has no condition to make a branch or an IT block of.

use super::expression::Printer;
use super::{Parts, vertex, vertex_type};
use crate::emit::layout;
use crate::graph::ScalarType;
use crate::ir::{Module, NodeId, Team};
use askama::Template;
use tpg_runtime::ops::constant_time as ct;

#[derive(Template)]
#[template(path = "rust/constant_time.rs", escape = "none")]
struct ConstantTime<'a> {
    scalar: &'a str,
    statements: Vec<String>,
    keys: Vec<KeyView>,
    teams: Vec<TeamView>,
    /// The names of the teams' choices, and the actions; then, what makes a place of every number of so many bits: numbers
    /// that differ, for many zeros would be a call of `memset`.
    next: Vec<String>,
    size: usize,
    vertex: &'a str,
    depth: usize,
}

/// The key of a bid: an integer in the order of bids.
struct KeyView {
    name: String,
    value: String,
}

struct TeamView {
    label: u32,
    first: EdgeView,
    others: Vec<EdgeView>,
}

struct EdgeView {
    key: String,
    to: usize,
}

/// Renders the profile.
pub(super) fn render(printer: &Printer<'_>, module: &Module) -> Parts {
    let computed = (0..).map(NodeId).zip(&module.nodes).filter(|(_, node)| node.is_computed());
    let used = module.teams.len() + printer.graph.actions().len();
    let size = used.next_power_of_two();
    let mut bids: Vec<NodeId> = module.bidders.iter().map(|bidder| bidder.value).collect();
    bids.sort_unstable();
    bids.dedup();
    let constant_time = ConstantTime {
        scalar: printer.graph.scalar().name(),
        keys: bids.iter().map(|&id| KeyView { name: key(id), value: key_value(printer, id) }).collect(),
        statements: computed.map(|(id, _)| printer.statement(id)).collect(),
        teams: module.teams.iter().map(|team| team_view(module, team)).collect(),
        next: (0..module.teams.len())
            .map(|team| format!("t{team}"))
            .chain((module.teams.len()..size).map(|vertex| vertex.to_string()))
            .collect(),
        size,
        vertex: vertex_type(printer.graph, module),
        depth: module.depth,
    };
    Parts { body: constant_time.render().expect("the template renders"), items: String::new() }
}

/// A constant's key is known here; the compiler, to whom masks say nothing, would compute it each time.
fn key_value(printer: &Printer<'_>, bid: NodeId) -> String {
    let value = printer.value(bid);
    match (printer.nodes[bid.index()].as_constant(), printer.graph.scalar()) {
        (None, _) => format!("ct.key({value});"),
        (Some(bid), ScalarType::F32) => {
            format!("{}_i32; // {value}", ct::ConstantTime::<f32>::default().key(bid as f32))
        }
        (Some(bid), ScalarType::F64) => format!("{}_i64; // {value}", ct::ConstantTime::<f64>::default().key(bid)),
    }
}

fn key(bid: NodeId) -> String {
    format!("k{}", bid.0)
}

fn team_view(module: &Module, team: &Team) -> TeamView {
    let mut edges = team
        .edges
        .iter()
        .map(|edge| EdgeView { key: key(module.bidders[edge.bidder].value), to: vertex(module, edge.to) });
    let first = edges.next().expect("a team has an edge");
    TeamView { label: team.label, first, others: edges.collect() }
}
