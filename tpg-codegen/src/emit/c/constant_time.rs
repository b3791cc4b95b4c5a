//! The profile `constant-time`: every distinct operation once, every team's choice by masks, a chase of fixed length
//! without a loop. A comparison is the sign of a difference, taken from its bits, so that no compiler has a reason to branch.
//! A graph of one team has nothing to chase. Where there are many teams, they are in several functions, which are called one
//! after another.

use super::entry::Entry;
use super::expression::Printer;
use super::leaves;
use crate::emit::block::Block;
use crate::emit::choice::{self, KeyView, TeamView};
use crate::emit::interface::OutputView;
use crate::emit::leaves::LeafView;
use crate::emit::syntax::Syntax;
use crate::ir::{Leaf, Module, NodeId, reached};
use crate::passes::functions::Function;
use askama::Template;
use std::collections::{BTreeMap, BTreeSet};

#[derive(Template)]
#[template(path = "c/constant_time.c", escape = "none")]
struct CConstantTime<'a> {
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
struct CConstantTimeTeams<'a> {
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
    let names = choice::names(module);
    let blocks: Vec<_> = functions
        .iter()
        .map(|function| {
            let leaves = if functions.len() == 1 { &module.leaves[..] } else { &[] };
            teams(printer, module, function, &names, vertex, leaves)
        })
        .collect();
    let (functions, mut blocks): (Vec<String>, Vec<_>) = blocks.into_iter().unzip();
    let mut block = match blocks.pop() {
        Some(block) if functions.len() == 1 => block,
        _ => choice::block(printer, [], &module.leaves),
    };
    let (statements, leaves) = choice::leaves(&mut block, &module.leaves, outputs);
    let constant_time = CConstantTime {
        entry: Entry::new(printer),
        prefix: printer.prefix,
        upper,
        vertex,
        only: module.teams.len() == 1,
        functions,
        ends: (module.teams.len()..module.vertices()).map(|place| format!("{place}U")).collect(),
        depth: module.depth,
        outputs,
        leaves,
        statements,
        assignments: leaves::assignments(printer, outputs),
        scalar: printer.scalar(),
    };
    constant_time.render().expect("the template renders")
}

fn teams<'a>(
    printer: &'a Printer<'a>,
    module: &Module<'_>,
    function: &Function,
    names: &BTreeMap<NodeId, String>,
    vertex: &str,
    leaves: &[Leaf],
) -> (String, Block<'a, Printer<'a>>) {
    let challengers = challengers(module, function);
    // A challenger is read once, to make it comparable; another bid has a name.
    let bids = function.bids.iter().map(|bid| (*bid, (!challengers.contains(bid)).then(|| names[bid].clone())));
    let mut block = choice::block(printer, bids, leaves);
    let (mut statements, mut keys) = (Vec::new(), Vec::new());
    for &bid in &function.bids {
        if challengers.contains(&bid) {
            let (before, value) = block.argument(bid, || format!("{}_value", names[&bid]));
            statements.extend(before);
            keys.push(KeyView { name: names[&bid].clone(), value });
        } else {
            statements.extend(block.statements(bid));
        }
    }
    let key = |bid: NodeId| if challengers.contains(&bid) { names[&bid].clone() } else { block.value(bid) };
    let teams = CConstantTimeTeams {
        prefix: printer.prefix,
        scalar: printer.scalar(),
        vertex,
        only: module.teams.len() == 1,
        reads_state: printer
            .reads_state(function.bids.iter().chain(reached(leaves).flat_map(|(_, leaf)| &leaf.values))),
        statements,
        keys,
        teams: function.teams.clone().map(|number| choice::team(module, number, key)).collect(),
    };
    (teams.render().expect("the template renders").trim_end().to_owned(), block)
}

/// The bids that must not be NaN: those that challenge another. A team's first may be, for it loses to whatever follows; and
/// a constant is a number.
fn challengers(module: &Module<'_>, function: &Function) -> BTreeSet<NodeId> {
    let behind_first = module.teams[function.teams.clone()].iter().flat_map(|team| team.edges.iter().skip(1));
    let bids = behind_first.map(|edge| module.bidders[edge.bidder].value);
    bids.filter(|&bid| module.node(bid).as_constant().is_none()).collect()
}
