//! The leaves of a policy with outputs, in syntax that C and Rust share.

use super::block::Block;
use super::interface::OutputView;
use super::syntax::Syntax;
use crate::ir::{Leaf, NodeId, reached};

/// A leaf: the statements that compute its values, and the values before they are limited.
pub(super) struct LeafView {
    pub(super) label: u32,
    /// The leaf's number.
    pub(super) number: usize,
    pub(super) statements: Vec<String>,
    pub(super) values: Vec<String>,
    pub(super) reads_state: bool,
}

/// Views the leaves that walks end at, as [`view`].
pub(super) fn views(syntax: &impl Syntax, leaves: &[Leaf], outputs: &[OutputView], assigns: bool) -> Vec<LeafView> {
    let view = |(number, leaf): (usize, &Leaf)| LeafView {
        label: leaf.label,
        number,
        ..view(syntax, &leaf.values, outputs, assigns)
    };
    reached(leaves).map(view).collect()
}

/// Views an only leaf. Where a language `assigns` the outputs' variables, an expression is the value of one; otherwise it has that
/// name.
pub(super) fn view(syntax: &impl Syntax, values: &[NodeId], outputs: &[OutputView], assigns: bool) -> LeafView {
    let name = |output: &OutputView| (!assigns).then(|| output.variable.clone());
    let mut block = Block::new(syntax, values.iter().zip(outputs).map(|(&value, output)| (value, name(output))));
    LeafView {
        label: 0,
        number: 0,
        statements: values.iter().flat_map(|&value| block.statements(value)).collect(),
        values: values.iter().map(|&value| block.value(value)).collect(),
        reads_state: syntax.reads_state(values),
    }
}
