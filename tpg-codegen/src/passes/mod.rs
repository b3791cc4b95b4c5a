//! Passes that make generated code small and fast without changing its behaviour.
//!
//! Every pass is exact, for every state there is, NaN and infinities included: the compiled policy takes the
//! interpreter's action. Three have no module here, because [`Module::lower`] performs them: **reachability** (teams are
//! found from the root), **intron removal** (dead lines leave no node) and **value numbering** (equal expressions are one
//! node, whichever programs compute them).

pub(crate) mod arithmetic;
pub(crate) mod bound;
pub(crate) mod bytecode;
pub(crate) mod cases;
mod collect;
mod duplicates;
pub(crate) mod estimate;
mod fold;
mod hopeless;
pub(crate) mod interval;
pub(crate) mod schedule;
mod teams;
#[cfg(test)]
mod tests;
mod zeros;

use crate::ir::{Module, Team};
use arithmetic::Arithmetic;
use std::collections::BTreeSet;
use tpg_graph::Graph;

/// Lowers a graph and optimises it.
pub(crate) fn optimise(graph: &Graph) -> Module<'_> {
    let arithmetic = Arithmetic::new(graph);
    let mut module = Module::lower(graph);
    fold::run(&mut module, arithmetic);
    zeros::run(&mut module, arithmetic);
    // Each round can make the next one find more; a round that finds nothing is the last.
    loop {
        let before = (module.teams.len(), module.edges());
        duplicates::run(&mut module);
        let intervals = interval::analyse(&module);
        hopeless::run(&mut module, &intervals);
        teams::run(&mut module);
        collect::run(&mut module);
        if (module.teams.len(), module.edges()) == before {
            break;
        }
    }
    drop_idle_bids(&mut module);
    module
}

/// Removes bids that decide nothing: those of teams with one edge, and all where there is only one leaf.
fn drop_idle_bids(module: &mut Module<'_>) {
    let decides = |team: &&Team| team.edges.len() > 1 && module.only_leaf().is_none();
    let deciding = module.teams.iter().filter(decides).flat_map(|team| &team.edges).map(|edge| edge.bidder);
    let deciding: BTreeSet<usize> = deciding.collect();
    let zero = module.constant(0.0);
    for (place, bidder) in module.bidders.iter_mut().enumerate() {
        if !deciding.contains(&place) {
            bidder.value = zero;
        }
    }
    collect::run(module);
}
