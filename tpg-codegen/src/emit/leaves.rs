//! The leaves of a policy with outputs, in syntax that C and Rust share.

use super::syntax::Syntax;
use crate::ir::{Leaf, NodeId, needed, reached};
use std::collections::BTreeSet;

/// A leaf: the statements that compute its values, and the values before they are limited.
pub(super) struct LeafView {
    pub(super) label: u32,
    /// The leaf's number.
    pub(super) number: usize,
    pub(super) statements: Vec<String>,
    pub(super) values: Vec<String>,
    pub(super) reads_state: bool,
}

/// Views the leaves that walks end at.
pub(super) fn views(syntax: &impl Syntax, leaves: &[Leaf]) -> Vec<LeafView> {
    let view = |(number, leaf): (usize, &Leaf)| {
        let operations: BTreeSet<NodeId> =
            leaf.values.iter().flat_map(|&value| needed(syntax.nodes(), value, |_| true)).collect();
        LeafView {
            label: leaf.label,
            number,
            statements: operations.iter().map(|&id| syntax.statement(id)).collect(),
            values: leaf.values.iter().map(|&value| syntax.value(value)).collect(),
            reads_state: syntax.reads_state(operations.iter().chain(&leaf.values)),
        }
    };
    reached(leaves).map(view).collect()
}
