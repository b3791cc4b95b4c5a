//! The choices of teams in constant time.

use super::block::Block;
use super::interface::OutputView;
use super::leaves::LeafView;
use super::syntax::Syntax;
use crate::ir::{Leaf, Module, NodeId, reached};
use std::collections::BTreeMap;

/// A bid as teams compare it.
pub(super) struct KeyView {
    pub(super) name: String,
    pub(super) value: String,
}

/// A team.
pub(super) struct ChoiceView {
    pub(super) label: u32,
    pub(super) number: usize,
    /// The bid of each edge as it is compared, and the vertex that it leads to.
    pub(super) edges: Vec<(String, usize)>,
}

/// The names of bids, each after the first program that bids it.
pub(super) fn names(module: &Module<'_>) -> BTreeMap<NodeId, String> {
    let mut names = BTreeMap::new();
    for bidder in &module.bidders {
        names.entry(bidder.value).or_insert_with(|| format!("bid_{}", bidder.label));
    }
    names
}

/// What code in constant time reads in a block: the bids, and the outputs of the leaves.
pub(super) fn block<'a, S: Syntax>(
    syntax: &'a S,
    bids: impl IntoIterator<Item = (NodeId, Option<String>)>,
    leaves: &[Leaf],
) -> Block<'a, S> {
    let outputs = reached(leaves).flat_map(|(_, leaf)| &leaf.values).map(|&value| (value, None));
    Block::new(syntax, bids.into_iter().chain(outputs))
}

/// The values of the leaves in a block, and the statements for them.
pub(super) fn leaves<S: Syntax>(
    block: &mut Block<'_, S>,
    leaves: &[Leaf],
    outputs: &[OutputView],
) -> (Vec<String>, Vec<LeafView>) {
    let mut statements = Vec::new();
    let mut views = Vec::new();
    for (number, leaf) in reached(leaves) {
        let mut values = Vec::new();
        for (&value, output) in leaf.values.iter().zip(outputs) {
            let (before, value) = block.argument(value, || format!("{}_{}", output.variable, leaf.label));
            statements.extend(before);
            values.push(value);
        }
        views.push(LeafView { label: leaf.label, number, statements: Vec::new(), values, reads_state: true });
    }
    (statements, views)
}

/// A team by its number; `key` names a bid as it is compared.
pub(super) fn team(module: &Module<'_>, number: usize, key: impl Fn(NodeId) -> String) -> ChoiceView {
    let team = &module.teams[number];
    let edges =
        (team.edges.iter()).map(|edge| (key(module.bidders[edge.bidder].value), module.vertex(edge.to))).collect();
    ChoiceView { label: team.label, number, edges }
}
