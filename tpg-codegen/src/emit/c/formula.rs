//! The outputs of an only leaf: straight code.

use super::entry::Entry;
use super::expression::Printer;
use super::leaves;
use crate::emit::interface::OutputView;
use crate::emit::syntax::Syntax;
use crate::program::Formula;
use askama::Template;

#[derive(Template)]
#[template(path = "c/formula.c", escape = "none")]
struct Straight {
    entry: Entry,
    reads_state: bool,
    statements: Vec<String>,
    /// The value of each output, limited.
    answers: Vec<(String, String)>,
}

/// Renders the body.
pub(super) fn render(printer: &Printer<'_>, formula: &Formula, outputs: &[OutputView]) -> String {
    let answers = outputs.iter().zip(&formula.values).map(|(output, &value)| {
        let is_constant = printer.nodes[value.index()].as_constant().is_some();
        let value = printer.value(value);
        let limited = if is_constant { value } else { leaves::limited(printer, output, &value) };
        (output.field.clone(), limited)
    });
    let straight = Straight {
        entry: Entry::new(printer),
        reads_state: printer.reads_state(formula.operations.iter().chain(&formula.values)),
        statements: formula.operations.iter().map(|&id| printer.statement(id)).collect(),
        answers: answers.collect(),
    };
    straight.render().expect("the template renders")
}
