//! The outputs of an only leaf: straight code.

use super::expression::Printer;
use super::leaves;
use crate::emit::interface::OutputView;
use crate::emit::syntax::Syntax;
use crate::program::Formula;
use askama::Template;

#[derive(Template)]
#[template(path = "c/formula.c", escape = "none")]
struct Straight<'a> {
    prefix: &'a str,
    reads_state: bool,
    statements: Vec<String>,
    /// The value of each output, limited.
    answers: Vec<(String, String)>,
}

/// Renders the body.
pub(super) fn render(printer: &Printer<'_>, formula: &Formula, outputs: &[OutputView]) -> String {
    let answers = outputs.iter().zip(&formula.values).map(|(output, &value)| {
        let limited = match printer.nodes[value.index()].as_constant() {
            Some(_) => printer.literal_of(value),
            None => leaves::limited(printer, output, &printer.value(value)),
        };
        (output.name.clone(), limited)
    });
    let straight = Straight {
        prefix: printer.prefix,
        reads_state: printer.reads_state(formula.operations.iter().chain(&formula.values)),
        statements: formula.operations.iter().map(|&id| printer.statement(id)).collect(),
        answers: answers.collect(),
    };
    straight.render().expect("the template renders")
}
