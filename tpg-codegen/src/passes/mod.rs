//! What makes generated code small and fast without changing what it does.
//!
//! Every pass is exact, for every state there is, NaN and infinities included: the compiled policy takes the
//! interpreter's action. Two of them need no module here, for [`Module::lower`] does them by the way it works:
//! **reachability** (teams are found from the root) and **intron removal** (lines that do not reach register 0 leave no
//! node); and so is **value numbering**: equal expressions are one node, whichever programs compute them.
//!
//! With [`Assumption::DeclaredRanges`] the passes believe the ranges that the graph declares. Then, and only then, a state
//! outside of them may get another action (still one of the graph's, and nothing undefined).

pub mod arithmetic;
pub mod bound;
pub mod bytecode;
mod collect;
mod duplicates;
pub mod estimate;
mod fold;
mod hopeless;
pub mod interval;
pub mod schedule;
mod teams;

use crate::graph::Graph;
use crate::ir::{Module, Node};
use arithmetic::Arithmetic;
use interval::Assumption;
use serde::Serialize;

/// What the passes removed.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize)]
pub struct Removed {
    /// Operations that were constant, or equal to one of their operands, or of no use to any bid.
    pub operations: usize,
    /// Edges that bid the same as a later one of their team.
    pub duplicate_bids: usize,
    /// Edges whose bid provably never wins.
    pub hopeless_bids: usize,
    /// Teams whose edges all lead to one place.
    pub teams_without_choice: usize,
    /// Teams that decide like another.
    pub twin_teams: usize,
    /// Teams that nothing leads to any more.
    pub unreachable_teams: usize,
}

/// Lowers a graph and optimises it.
pub fn optimise(graph: &Graph, assumption: Assumption) -> (Module, Removed) {
    let arithmetic = Arithmetic { scalar: graph.scalar(), maths: graph.maths() };
    let mut module = Module::lower(graph);
    let mut removed = Removed::default();
    let before = operations(&module);
    fold::run(&mut module, arithmetic);
    // Each round can make the next one find more; a round that finds nothing is the last.
    loop {
        let duplicates = duplicates::run(&mut module);
        let intervals = interval::analyse(graph, &module, assumption);
        let hopeless = hopeless::run(&mut module, &intervals);
        let teams = teams::run(&mut module);
        collect::run(&mut module);
        removed.duplicate_bids += duplicates;
        removed.hopeless_bids += hopeless;
        removed.teams_without_choice += teams.bypassed;
        removed.twin_teams += teams.merged;
        removed.unreachable_teams += teams.unreachable;
        if duplicates + hopeless + teams.bypassed + teams.merged + teams.unreachable == 0 {
            break;
        }
    }
    removed.operations = before - operations(&module);
    (module, removed)
}

fn operations(module: &Module) -> usize {
    module.nodes.iter().filter(|node| matches!(node, Node::Operation(..))).count()
}
