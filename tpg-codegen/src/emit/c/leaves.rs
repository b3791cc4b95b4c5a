//! The leaves of a policy with outputs, where code first decides on a leaf and then computes its outputs.

use super::expression::CPrinter;
use crate::emit::interface::OutputView;
use crate::emit::leaves::{LeafView, views};
use crate::emit::syntax::Syntax;
use crate::ir::Leaf;
use askama::Template;

/// A value, limited to its output's range. Where every output has the same value in place of NaN, the function knows it.
pub(super) fn limited(printer: &CPrinter<'_>, output: &OutputView, value: &str) -> String {
    let known = usize::from(printer.same_nan().is_some());
    format!("{}_clamp({value}, {})", printer.prefix, output.limits[..output.limits.len() - known].join(", "))
}

/// The assignments that finish an answer: each output's variable, limited.
pub(super) fn assignments(printer: &CPrinter<'_>, outputs: &[OutputView]) -> Vec<String> {
    let assign =
        |output: &OutputView| format!("action->{} = {};", output.field, limited(printer, output, &output.variable));
    outputs.iter().map(assign).collect()
}

#[derive(Template)]
#[template(path = "c/leaves.c", escape = "none")]
struct Leaves<'a> {
    printer: &'a CPrinter<'a>,
    leaves: Vec<LeafView>,
    outputs: &'a [OutputView],
    assignments: Vec<String>,
}

/// Renders the entry point over a static function that decides on a leaf.
pub(super) fn render(printer: &CPrinter<'_>, leaves: &[Leaf], outputs: &[OutputView]) -> String {
    let leaves = Leaves {
        printer,
        outputs,
        leaves: views(printer, leaves, outputs, true),
        assignments: assignments(printer, outputs),
    };
    leaves.render().expect("the template renders")
}
