//! The profile `constant-time`: every distinct operation once, every team's choice by masks, a chase of fixed length
//! without a loop. A comparison is the sign of a difference, taken from its bits, so that no compiler has a reason to branch.
//! A graph of one team has nothing to chase. Where there are many teams, they are in several functions, which are called one
//! after another.

use super::entry::Entry;
use super::expression::Printer;
use super::leaves;
use crate::emit::choice::{self, KeyView, TeamView};
use crate::emit::interface::OutputView;
use crate::emit::leaves::{LeafView, views};
use crate::emit::syntax::Syntax;
use crate::ir::{Module, Node, NodeId};
use crate::passes::functions::{self, Function};
use askama::Template;
use std::collections::BTreeSet;

#[derive(Template)]
#[template(path = "c/constant_time.c", escape = "none")]
struct ConstantTime<'a> {
    entry: Entry,
    prefix: &'a str,
    upper: &'a str,
    vertex: &'a str,
    /// The only team chooses among the ends.
    only: bool,
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
    scalar: &'a str,
    vertex: &'a str,
    only: bool,
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
        entry: Entry::new(printer),
        prefix: printer.prefix,
        upper,
        vertex,
        only: module.teams.len() == 1,
        functions: functions.iter().map(|function| teams(printer, module, function, vertex)).collect(),
        ends: (module.teams.len()..module.vertices()).map(|place| format!("{place}U")).collect(),
        depth: module.depth,
        outputs,
        leaves: views(printer, &module.leaves),
        statements: functions::leaf_operations(module, functions).into_iter().map(|id| printer.statement(id)).collect(),
        assignments: leaves::assignments(printer, outputs),
        scalar: printer.scalar(),
    };
    constant_time.render().expect("the template renders")
}

fn teams(printer: &Printer<'_>, module: &Module<'_>, function: &Function, vertex: &str) -> String {
    let read = function.operations.iter().flat_map(|&id| module.nodes[id.index()].operands()).chain(&function.bids);
    let challengers = challengers(module, function);
    let key = |bid: NodeId| if challengers.contains(&bid) { choice::key(bid) } else { printer.value(bid) };
    let teams = Teams {
        prefix: printer.prefix,
        scalar: printer.scalar(),
        vertex,
        only: module.teams.len() == 1,
        reads_state: read.into_iter().any(|&id| matches!(module.node(id), Node::Input(_))),
        statements: function.operations.iter().map(|&id| printer.statement(id)).collect(),
        keys: challengers.iter().map(|&id| KeyView { name: choice::key(id), value: printer.value(id) }).collect(),
        teams: function.teams.clone().map(|number| choice::team(module, number, key)).collect(),
    };
    teams.render().expect("the template renders").trim_end().to_owned()
}

/// The bids that must not be NaN: those that challenge another. A team's first may be, for it loses to whatever follows; and
/// a constant is a number.
fn challengers(module: &Module<'_>, function: &Function) -> BTreeSet<NodeId> {
    let behind_first = module.teams[function.teams.clone()].iter().flat_map(|team| team.edges.iter().skip(1));
    let bids = behind_first.map(|edge| module.bidders[edge.bidder].value);
    bids.filter(|&bid| module.node(bid).as_constant().is_none()).collect()
}
