//! The functions that expressions call.

use crate::ir::Node;
use std::collections::BTreeSet;
use tpg_runtime::ops::Instruction;

/// The names of the functions that some nodes call: instructions, and estimates of two.
pub(super) fn called(nodes: &[Node]) -> BTreeSet<&'static str> {
    let name = |node: &Node| match *node {
        Node::Operation(instruction, _) => Some(instruction.name()),
        Node::Upper(Instruction::Ln, _) => Some("ln_upper"),
        Node::Upper(..) => Some("exp_upper"),
        Node::Constant(_) | Node::Input(_) => None,
    };
    nodes.iter().filter_map(name).collect()
}
