//! The profile `constant-time`: every distinct operation once, then every team's choice by masks, then a chase of fixed
//! length from the root to an action. Comparisons are made on integers, by masks that LLVM does not know for such
//! (`tpg_runtime::ops::constant_time`): it has no condition to make a branch or an IT block of. Where there are
//! many teams, they are in several functions, each of which returns what its teams decide.

use super::expression::Printer;
use super::{Parts, vertex, vertex_type};
use crate::emit::layout;
use crate::ir::{Module, NodeId};
use crate::passes::functions::{self, Function};
use askama::Template;
use std::ops::Range;
use tpg_graph::ScalarType;
use tpg_runtime::ops::constant_time as ct;

/// All teams in one function.
#[derive(Template)]
#[template(path = "rust/constant_time.rs", escape = "none")]
struct Whole<'a> {
    decided: &'a str,
    teams: usize,
    /// The names of the teams' choices, and the actions; then, what makes a place of every number of so many bits: numbers
    /// that differ, for many zeros would be a call of `memset`.
    next: Vec<String>,
    size: usize,
    vertex: &'a str,
    depth: usize,
}

/// The functions' results, a row each.
#[derive(Template)]
#[template(path = "rust/constant_time_rows.rs", escape = "none")]
struct Rows<'a> {
    rows: Vec<String>,
    row: usize,
    teams: usize,
    vertex: &'a str,
    depth: usize,
}

/// The functions.
#[derive(Template)]
#[template(path = "rust/constant_time_items.rs", escape = "none")]
struct Items<'a> {
    functions: Vec<FunctionView>,
    row: usize,
    themselves: Vec<String>,
    scalar: &'a str,
    state_length: usize,
    vertex: &'a str,
}

struct FunctionView {
    decided: String,
    next: Vec<String>,
}

/// What decides for the teams of a function.
#[derive(Template)]
#[template(path = "rust/constant_time_teams.rs", escape = "none")]
struct Teams<'a> {
    scalar: &'a str,
    statements: Vec<String>,
    keys: Vec<KeyView>,
    teams: Vec<TeamView>,
    vertex: &'a str,
}

/// The key of a bid: an integer in the order of bids.
struct KeyView {
    name: String,
    value: String,
}

struct TeamView {
    label: u32,
    number: usize,
    first: EdgeView,
    others: Vec<EdgeView>,
}

struct EdgeView {
    key: String,
    to: usize,
}

/// Renders the profile.
pub(super) fn render(printer: &Printer<'_>, module: &Module) -> Parts {
    let functions = functions::of(module);
    let teams = module.teams.len();
    let vertices = teams + printer.graph.actions().len();
    let (vertex, depth) = (vertex_type(printer.graph, module), module.depth);
    if let [function] = &functions[..] {
        let size = vertices.next_power_of_two();
        let decided = decided(printer, module, function);
        let whole = Whole { decided: &decided, teams, next: next(0..size, teams), size, vertex, depth };
        return Parts { body: whole.render().expect("the template renders"), items: String::new() };
    }
    let row = functions[0].teams.len();
    let count = vertices.div_ceil(row).next_power_of_two();
    let calls = (0..functions.len()).map(|number| format!("teams_{number}(s)"));
    let rows = calls.chain((functions.len()..count).map(|number| format!("themselves({})", number * row))).collect();
    let rows = Rows { rows, row, teams, vertex, depth };
    let function = |function: &Function| FunctionView {
        // A function is a level further out than a method.
        decided: decided(printer, module, function).replace("        ", "    "),
        next: next(function.teams.start..function.teams.start + row, teams),
    };
    let items = Items {
        functions: functions.iter().map(function).collect(),
        row,
        themselves: (0..row).map(|place| format!("first | {place}")).collect(),
        scalar: printer.graph.scalar().name(),
        state_length: printer.graph.state_length(),
        vertex,
    };
    let [body, items] = [rows.render(), items.render()].map(|text| text.expect("the template renders"));
    Parts { body, items }
}

/// What vertices lead to: teams, to what is decided there; others, to themselves.
fn next(vertices: Range<usize>, teams: usize) -> Vec<String> {
    vertices.map(|vertex| if vertex < teams { format!("t{vertex}") } else { vertex.to_string() }).collect()
}

fn decided(printer: &Printer<'_>, module: &Module, function: &Function) -> String {
    let teams = Teams {
        scalar: printer.graph.scalar().name(),
        statements: function.operations.iter().map(|&id| printer.statement(id)).collect(),
        keys: function.bids.iter().map(|&id| KeyView { name: key(id), value: key_value(printer, id) }).collect(),
        teams: function.teams.clone().map(|number| team_view(module, number)).collect(),
        vertex: vertex_type(printer.graph, module),
    };
    teams.render().expect("the template renders").trim_matches('\n').to_owned()
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

fn team_view(module: &Module, number: usize) -> TeamView {
    let team = &module.teams[number];
    let mut edges = team
        .edges
        .iter()
        .map(|edge| EdgeView { key: key(module.bidders[edge.bidder].value), to: vertex(module, edge.to) });
    let first = edges.next().expect("a team has an edge");
    TeamView { label: team.label, number, first, others: edges.collect() }
}
