//! The leaves of a policy with outputs.

use super::expression::Printer;
use crate::emit::interface::OutputView;
use crate::emit::layout::array;
use crate::emit::syntax::Syntax;
use crate::ir::{Leaf, NodeId, needed, reached};
use crate::program::Formula;
use std::collections::BTreeSet;

/// A leaf: the statements that compute its values, and the values.
pub(super) struct LeafView {
    pub(super) label: u32,
    pub(super) statements: Vec<String>,
    pub(super) values: Vec<String>,
}

/// Views the leaves that walks end at.
pub(super) fn views(printer: &Printer<'_>, leaves: &[Leaf]) -> Vec<LeafView> {
    let view = |(_, leaf): (usize, &Leaf)| LeafView {
        label: leaf.label,
        statements: statements(printer, &leaf.values),
        values: leaf.values.iter().map(|&value| printer.value(value)).collect(),
    };
    reached(leaves).map(view).collect()
}

/// The statements that some values need.
fn statements(printer: &Printer<'_>, values: &[NodeId]) -> Vec<String> {
    let operations = values.iter().flat_map(|&value| needed(printer.nodes, value, |_| true));
    operations.collect::<BTreeSet<_>>().into_iter().map(|id| printer.statement(id)).collect()
}

/// The values of variables, each limited to its output's range, as an array.
pub(super) fn limited(printer: &Printer<'_>, outputs: &[OutputView]) -> String {
    let limited = |output: &OutputView| printer.clamp(&output.variable(), &output.limits);
    format!("[{}]", outputs.iter().map(limited).collect::<Vec<_>>().join(", "))
}

/// The pattern of the outputs' variables.
pub(super) fn variables(outputs: &[OutputView]) -> String {
    format!("[{}]", outputs.iter().map(OutputView::variable).collect::<Vec<_>>().join(", "))
}

/// The body of a policy that has nothing to decide.
pub(super) fn formula(printer: &Printer<'_>, formula: &Formula, outputs: &[OutputView]) -> String {
    let masks = printer.branch_free.then(|| masks(printer));
    let limited = outputs.iter().zip(&formula.values).map(|(output, &value)| {
        let is_constant = printer.nodes[value.index()].as_constant().is_some();
        let value = printer.value(value);
        if is_constant { value } else { printer.clamp(&value, &output.limits) }
    });
    let answer = array(&limited.collect::<Vec<_>>(), 8);
    let statements = formula.operations.iter().map(|&id| printer.statement(id));
    let lines = masks.into_iter().chain(statements).chain([answer]);
    lines.map(|line| format!("        {line}\n")).collect()
}

/// The statement that makes the masks of the profile `constant-time`.
pub(super) fn masks(printer: &Printer<'_>) -> String {
    format!("let ct = ConstantTime::<{}>::default();", printer.scalar())
}
