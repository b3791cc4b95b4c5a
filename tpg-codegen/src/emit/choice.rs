//! The choices of teams in constant time.

use crate::ir::{Module, NodeId};

/// A bid as teams compare it.
pub(super) struct KeyView {
    pub(super) name: String,
    pub(super) value: String,
}

/// A team.
pub(super) struct TeamView {
    pub(super) label: u32,
    pub(super) number: usize,
    pub(super) edges: Vec<EdgeView>,
}

/// An edge: its bid as it is compared, and the vertex it leads to.
pub(super) struct EdgeView {
    pub(super) key: String,
    pub(super) to: usize,
}

/// The name of a bid's key.
pub(super) fn key(bid: NodeId) -> String {
    format!("k{}", bid.0)
}

/// A team by its number; `key` names a bid as it is compared.
pub(super) fn team(module: &Module<'_>, number: usize, key: impl Fn(NodeId) -> String) -> TeamView {
    let team = &module.teams[number];
    let edges = (team.edges.iter())
        .map(|edge| EdgeView { key: key(module.bidders[edge.bidder].value), to: module.vertex(edge.to) })
        .collect();
    TeamView { label: team.label, number, edges }
}
