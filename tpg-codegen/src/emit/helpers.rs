//! The functions that expressions call.

use crate::ir::Node;
use std::collections::BTreeSet;

/// The names of the functions that some nodes call: instructions.
pub(super) fn called(nodes: &[Node]) -> BTreeSet<&'static str> {
    let name = |node: &Node| match *node {
        Node::Operation(instruction, _) => Some(instruction.name()),
        Node::Constant(_) | Node::Input(_) => None,
    };
    nodes.iter().filter_map(name).collect()
}
