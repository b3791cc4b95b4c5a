//! The outputs of an only leaf: straight code.

use super::expression::Printer;
use super::leaves;
use crate::emit::block::Block;
use crate::emit::interface::OutputView;
use crate::emit::syntax::Syntax;
use crate::shape::Formula;
use askama::Template;

#[derive(Template)]
#[template(path = "c/formula.c", escape = "none")]
pub(super) struct CStraight<'a> {
    pub(super) printer: &'a Printer<'a>,
    pub(super) reads_state: bool,
    pub(super) statements: Vec<String>,
    /// The value of each output, limited.
    pub(super) answers: Vec<(String, String)>,
}

impl CStraight<'_> {
    pub(super) fn text(&self) -> String {
        self.render().expect("the template renders")
    }
}

/// Renders the body.
pub(super) fn render(printer: &Printer<'_>, formula: &Formula, outputs: &[OutputView]) -> String {
    let reads = formula.values.iter().zip(outputs).map(|(&value, output)| (value, Some(output.variable.clone())));
    let mut block = Block::new(printer, reads);
    let statements = formula.values.iter().flat_map(|&value| block.statements(value)).collect();
    let answers = outputs.iter().zip(&formula.values).map(|(output, &id)| {
        let is_constant = printer.nodes[id.index()].as_constant().is_some();
        let value = block.value(id);
        let limited = if is_constant { value } else { leaves::limited(printer, output, &value) };
        (output.field.clone(), limited)
    });
    CStraight { printer, reads_state: printer.reads_state(&formula.values), statements, answers: answers.collect() }
        .text()
}
