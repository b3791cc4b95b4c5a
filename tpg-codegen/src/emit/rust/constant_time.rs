//! The profile `constant-time`: every distinct operation once, then every team's choice by selects, then a chase of fixed
//! length from the root to an action. There is no branch; LLVM may make instructions that run or not, in the same time (on a
//! Cortex-M4, IT blocks).

use super::expression::Printer;
use super::{Parts, vertex, vertex_type};
use crate::emit::layout;
use crate::ir::{Module, NodeId, Team};
use askama::Template;

#[derive(Template)]
#[template(path = "rust/constant_time.rs", escape = "none")]
struct ConstantTime<'a> {
    statements: Vec<String>,
    teams: Vec<TeamView>,
    /// The names of the teams' choices, and the actions; then, whatever makes a place of every number of so many bits.
    next: Vec<String>,
    size: usize,
    vertex: &'a str,
    depth: usize,
}

struct TeamView {
    label: u32,
    first: EdgeView,
    others: Vec<EdgeView>,
}

struct EdgeView {
    bid: String,
    to: usize,
}

/// Renders the profile.
pub(super) fn render(printer: &Printer<'_>, module: &Module) -> Parts {
    let computed = (0..).map(NodeId).zip(&module.nodes).filter(|(_, node)| node.is_computed());
    let used = module.teams.len() + printer.graph.actions().len();
    let size = used.next_power_of_two();
    let constant_time = ConstantTime {
        statements: computed.map(|(id, _)| printer.statement(id)).collect(),
        teams: module.teams.iter().map(|team| team_view(printer, module, team)).collect(),
        next: (0..module.teams.len())
            .map(|team| format!("t{team}"))
            .chain((module.teams.len()..used).map(|action| action.to_string()))
            .chain((used..size).map(|_| "0".to_owned()))
            .collect(),
        size,
        vertex: vertex_type(printer.graph, module),
        depth: module.depth,
    };
    Parts { body: constant_time.render().expect("the template renders"), items: String::new() }
}

fn team_view(printer: &Printer<'_>, module: &Module, team: &Team) -> TeamView {
    let mut edges = team
        .edges
        .iter()
        .map(|edge| EdgeView { bid: printer.value(module.bidders[edge.bidder].value), to: vertex(module, edge.to) });
    let first = edges.next().expect("a team has an edge");
    TeamView { label: team.label, first, others: edges.collect() }
}
