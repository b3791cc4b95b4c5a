//! The leaves of a policy with outputs, where code first decides on a leaf and then computes its outputs.

use super::entry::Entry;
use super::expression::Printer;
use crate::emit::interface::OutputView;
use crate::emit::syntax::Syntax;
use crate::ir::{Leaf, NodeId, needed, reached};
use askama::Template;
use std::collections::BTreeSet;

/// A leaf: the statements that compute its values, and the values.
pub(super) struct LeafView {
    pub(super) label: u32,
    /// The leaf's number.
    pub(super) number: usize,
    pub(super) statements: Vec<String>,
    /// The outputs' variables and their values.
    pub(super) values: Vec<(String, String)>,
    pub(super) reads_state: bool,
}

/// Views the leaves that walks end at. Values that are `shared` have variables already.
pub(super) fn views(
    printer: &Printer<'_>,
    leaves: &[Leaf],
    outputs: &[OutputView],
    shared: &BTreeSet<NodeId>,
) -> Vec<LeafView> {
    let view = |(number, leaf): (usize, &Leaf)| {
        let operations: BTreeSet<NodeId> =
            leaf.values.iter().flat_map(|&value| needed(printer.nodes, value, |_| true)).collect();
        let statement =
            |&id: &NodeId| if shared.contains(&id) { printer.assignment(id) } else { printer.statement(id) };
        let values = outputs.iter().zip(&leaf.values);
        LeafView {
            label: leaf.label,
            number,
            statements: operations.iter().map(statement).collect(),
            values: values.map(|(output, &value)| (output.variable(), printer.value(value))).collect(),
            reads_state: printer.reads_state(operations.iter().chain(&leaf.values)),
        }
    };
    reached(leaves).map(view).collect()
}

/// A value, limited to its output's range.
pub(super) fn limited(printer: &Printer<'_>, output: &OutputView, value: &str) -> String {
    format!("{}_clamp({value}, {})", printer.prefix, output.limits)
}

/// The assignments that finish an answer: each output's variable, limited.
pub(super) fn assignments(printer: &Printer<'_>, outputs: &[OutputView]) -> Vec<String> {
    let assign =
        |output: &OutputView| format!("action->{} = {};", output.field, limited(printer, output, &output.variable()));
    outputs.iter().map(assign).collect()
}

#[derive(Template)]
#[template(path = "c/leaves.c", escape = "none")]
struct Leaves<'a> {
    entry: Entry,
    prefix: &'a str,
    scalar: &'a str,
    leaves: Vec<LeafView>,
    variables: Vec<String>,
    assignments: Vec<String>,
}

/// Renders the entry point over a static function that decides on a leaf.
pub(super) fn render(printer: &Printer<'_>, leaves: &[Leaf], outputs: &[OutputView]) -> String {
    let leaves = Leaves {
        entry: Entry::of(printer),
        prefix: printer.prefix,
        scalar: printer.scalar(),
        leaves: views(printer, leaves, outputs, &BTreeSet::new()),
        variables: outputs.iter().map(OutputView::variable).collect(),
        assignments: assignments(printer, outputs),
    };
    leaves.render().expect("the template renders")
}
