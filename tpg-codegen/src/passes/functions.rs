//! The partition of teams into functions. Some compiler passes take superlinear time in the size of a function, so a large
//! graph gets several.

use crate::ir::{Module, NodeId, needed};
use std::collections::BTreeSet;
use std::ops::Range;

/// The most teams that are put into a single function.
const TEAMS: usize = 64;
/// Teams of each function of a larger graph.
const SOME_TEAMS: usize = 32;

/// The number of teams in each function of a graph of `teams` teams.
pub(crate) fn together(teams: usize) -> usize {
    if teams <= TEAMS { TEAMS } else { SOME_TEAMS }
}

/// Some teams, and the values they need.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(crate) struct Function {
    /// By their places in the module.
    pub teams: Range<usize>,
    /// The distinct bids that decide something.
    pub bids: BTreeSet<NodeId>,
    /// The operations that these need, operands before operations.
    pub operations: BTreeSet<NodeId>,
}

/// All teams of a module, in its order. Operations that several functions need are in each of them.
pub(crate) fn split(module: &Module<'_>) -> Vec<Function> {
    let all = module.teams.len();
    let together = together(all);
    let function = |start: usize| {
        let teams = start..all.min(start + together);
        // A team of one edge has nothing to decide.
        let deciding = module.teams[teams.clone()].iter().filter(|team| team.edges.len() > 1);
        let edges = deciding.flat_map(|team| &team.edges);
        let bids: BTreeSet<NodeId> = edges.map(|edge| module.bidders[edge.bidder].value).collect();
        let operations = bids.iter().flat_map(|&bid| needed(&module.nodes, bid, |_| true)).collect();
        Function { teams, bids, operations }
    };
    (0..all).step_by(together).map(function).collect()
}

/// The operations that leaves need and no function has computed: several functions hand nothing on.
pub(crate) fn leaf_operations(module: &Module<'_>, functions: &[Function]) -> BTreeSet<NodeId> {
    let is_missing = |id: NodeId| !matches!(functions, [only] if only.operations.contains(&id));
    let values = module.leaves.iter().flat_map(|leaf| &leaf.values);
    values.flat_map(|&value| needed(&module.nodes, value, is_missing)).collect()
}
