//! Which teams share a function. Some passes of compilers take more than linear time in the size of a function, so where
//! there are many teams, they are in several.

use crate::ir::{Module, NodeId, needed};
use std::collections::BTreeSet;
use std::ops::Range;

/// Teams of one function, where all are in it.
const TEAMS: usize = 64;
/// Teams of one function, where there are more.
const SOME_TEAMS: usize = 32;

/// How many of `teams` teams, in the order in which a profile has them, are in one function.
pub(crate) fn together(teams: usize) -> usize {
    if teams <= TEAMS { TEAMS } else { SOME_TEAMS }
}

/// Some teams, and all that they need.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Function {
    /// By their places in the module.
    pub teams: Range<usize>,
    /// What they bid, each once.
    pub bids: BTreeSet<NodeId>,
    /// What must be computed for that, operands before operations.
    pub operations: BTreeSet<NodeId>,
}

/// All teams of a module, in its order. What teams of two functions need is in both.
pub(crate) fn of(module: &Module<'_>) -> Vec<Function> {
    let all = module.teams.len();
    let together = together(all);
    let function = |start: usize| {
        let teams = start..all.min(start + together);
        let edges = module.teams[teams.clone()].iter().flat_map(|team| &team.edges);
        let bids: BTreeSet<NodeId> = edges.map(|edge| module.bidders[edge.bidder].value).collect();
        let operations = bids.iter().flat_map(|&bid| needed(&module.nodes, bid, |_| true)).collect();
        Function { teams, bids, operations }
    };
    (0..all).step_by(together).map(function).collect()
}
