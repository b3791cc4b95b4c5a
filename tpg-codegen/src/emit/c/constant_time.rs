//! The profile `constant-time`: every distinct operation once, every team's choice by masks, a chase of fixed length
//! without a loop. Comparisons are made on integers, so that no compiler has a reason to branch. Where there are many teams,
//! they are in several functions, which are called one after another.

use super::entry::Entry;
use super::expression::Printer;
use super::leaves::{self, LeafView};
use crate::emit::choice::{self, KeyView, TeamView};
use crate::emit::interface::OutputView;
use crate::emit::syntax::Syntax;
use crate::ir::{Module, Node};
use crate::passes::functions::{self, Function};
use askama::Template;
use std::collections::BTreeSet;
use tpg_graph::ScalarType;

#[derive(Template)]
#[template(path = "c/constant_time.c", escape = "none")]
struct ConstantTime<'a> {
    entry: Entry,
    prefix: &'a str,
    upper: &'a str,
    key: &'a str,
    vertex: &'a str,
    /// The bodies of the functions: the choices of their teams.
    functions: Vec<String>,
    /// The vertices that are actions or leaves.
    ends: Vec<String>,
    depth: usize,
    outputs: &'a [OutputView],
    leaves: Vec<LeafView>,
    /// The statements of all leaves, where they are not among those of the only function.
    statements: Vec<String>,
    assignments: Vec<String>,
    scalar: &'a str,
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

/// Renders the body.
pub(super) fn render(
    printer: &Printer<'_>,
    module: &Module<'_>,
    functions: &[Function],
    outputs: &[OutputView],
    upper: &str,
) -> String {
    let vertex = &printer.vertex_type(module.vertices());
    let constant_time = ConstantTime {
        entry: Entry::of(printer),
        prefix: printer.prefix,
        upper,
        key: key_type(printer),
        vertex,
        functions: functions.iter().map(|function| teams(printer, module, function, vertex)).collect(),
        ends: (module.teams.len()..module.vertices()).map(|place| format!("{place}U")).collect(),
        depth: module.depth,
        outputs,
        leaves: leaves::views(printer, &module.leaves, outputs, &BTreeSet::new()),
        statements: functions::of_leaves(module, functions).into_iter().map(|id| printer.statement(id)).collect(),
        assignments: leaves::assignments(printer, outputs),
        scalar: printer.scalar(),
    };
    constant_time.render().expect("the template renders")
}

fn key_type(printer: &Printer<'_>) -> &'static str {
    if printer.graph.scalar() == ScalarType::F64 { "uint64_t" } else { "uint32_t" }
}

fn teams(printer: &Printer<'_>, module: &Module<'_>, function: &Function, vertex: &str) -> String {
    let read = function.operations.iter().flat_map(|&id| module.nodes[id.index()].operands()).chain(&function.bids);
    let teams = Teams {
        prefix: printer.prefix,
        key: key_type(printer),
        vertex,
        reads_state: read.into_iter().any(|&id| matches!(module.node(id), Node::Input(_))),
        statements: function.operations.iter().map(|&id| printer.statement(id)).collect(),
        keys: function.bids.iter().map(|&id| KeyView { name: choice::key(id), value: printer.value(id) }).collect(),
        teams: function.teams.clone().map(|number| choice::team(module, number)).collect(),
    };
    teams.render().expect("the template renders").trim_end().to_owned()
}
