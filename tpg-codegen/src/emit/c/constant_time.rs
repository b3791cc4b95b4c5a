//! The profile `constant-time`: every distinct operation once, every team's choice by masks, a chase of fixed length
//! without a loop. A comparison is the sign of a difference, taken from its bits, so that no compiler has a reason to branch.
//! A graph of one team has nothing to chase.

use super::expression::CPrinter;
use super::leaves;
use crate::emit::choice::{self, ChoiceView, KeyView};
use crate::emit::interface::OutputView;
use crate::emit::leaves::LeafView;
use crate::emit::syntax::Syntax;
use crate::ir::{Module, NodeId, reached};
use askama::Template;
use std::collections::BTreeSet;

#[derive(Template)]
#[template(path = "c/constant_time.c", escape = "none")]
struct CConstantTime<'a> {
    printer: &'a CPrinter<'a>,
    vertex: &'a str,
    /// The only team chooses among the ends.
    only: bool,
    reads_state: bool,
    /// The statements of what is bid.
    bids: Vec<String>,
    keys: Vec<KeyView>,
    teams: Vec<ChoiceView>,
    /// The vertices that are actions or leaves.
    ends: Vec<String>,
    depth: usize,
    outputs: &'a [OutputView],
    leaves: Vec<LeafView>,
    /// The statements of all leaves.
    statements: Vec<String>,
    assignments: Vec<String>,
}

/// Renders the body.
pub(super) fn render(printer: &CPrinter<'_>, module: &Module<'_>, outputs: &[OutputView]) -> String {
    let names = choice::names(module);
    let (bids, challengers) = (module.deciding_bids(), challengers(module));
    // A challenger is read once, to make it comparable; another bid has a name.
    let named = bids.iter().map(|bid| (*bid, (!challengers.contains(bid)).then(|| names[bid].clone())));
    let mut block = choice::block(printer, named, &module.leaves);
    let (mut of_bids, mut keys) = (Vec::new(), Vec::new());
    for &bid in &bids {
        if challengers.contains(&bid) {
            let (before, value) = block.argument(bid, || format!("{}_value", names[&bid]));
            of_bids.extend(before);
            keys.push(KeyView { name: names[&bid].clone(), value });
        } else {
            of_bids.extend(block.statements(bid));
        }
    }
    let key = |bid: NodeId| if challengers.contains(&bid) { names[&bid].clone() } else { block.value(bid) };
    let teams = (0..module.teams.len()).map(|number| choice::team(module, number, key)).collect();
    let (statements, leaves) = choice::leaves(&mut block, &module.leaves, outputs);
    let constant_time = CConstantTime {
        printer,
        vertex: &printer.vertex_type(module.vertices()),
        only: module.teams.len() == 1,
        reads_state: printer.reads_state(bids.iter().chain(reached(&module.leaves).flat_map(|(_, leaf)| &leaf.values))),
        bids: of_bids,
        keys,
        teams,
        ends: (module.teams.len()..module.vertices()).map(|place| format!("{place}U")).collect(),
        depth: module.depth,
        outputs,
        leaves,
        statements,
        assignments: leaves::assignments(printer, outputs),
    };
    constant_time.render().expect("the template renders")
}

/// The bids that must not be NaN: those that challenge another. A team's first may be, for it loses to whatever follows; and
/// a constant is a number.
fn challengers(module: &Module<'_>) -> BTreeSet<NodeId> {
    let behind_first = module.teams.iter().flat_map(|team| team.edges.iter().skip(1));
    let bids = behind_first.map(|edge| module.bidders[edge.bidder].value);
    bids.filter(|&bid| module.node(bid).as_constant().is_none()).collect()
}
