//! The profile `constant-time`: every distinct operation once, then every team's choice by selects, then a bounded chase
//! from the root to an action. The time does not depend on the state.

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
    /// The names of the teams' choices.
    next: Vec<String>,
    vertex: &'a str,
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
    let constant_time = ConstantTime {
        statements: computed.map(|(id, _)| printer.statement(id)).collect(),
        teams: module.teams.iter().map(|team| team_view(printer, module, team)).collect(),
        next: (0..module.teams.len()).map(|team| format!("t{team}")).collect(),
        vertex: vertex_type(printer.graph, module),
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
