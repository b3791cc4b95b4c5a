//! The outputs of an only leaf: straight code.

use super::expression::CPrinter;
use super::leaves;
use crate::emit::interface::OutputView;
use crate::emit::leaves::{LeafView, view};
use crate::ir::Module;
use askama::Template;

#[derive(Template)]
#[template(path = "c/formula.c", escape = "none")]
pub(super) struct CStraight<'a> {
    pub(super) printer: &'a CPrinter<'a>,
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
pub(super) fn render(printer: &CPrinter<'_>, module: &Module<'_>, outputs: &[OutputView]) -> String {
    let ids = module.only_leaf().map_or(&[][..], |leaf| &leaf.values);
    let LeafView { statements, values, reads_state, .. } = view(printer, ids, outputs, false);
    let answers = outputs.iter().zip(ids).zip(values).map(|((output, id), value)| {
        let is_constant = printer.nodes[id.index()].as_constant().is_some();
        (output.field.clone(), if is_constant { value } else { leaves::limited(printer, output, &value) })
    });
    CStraight { printer, reads_state, statements, answers: answers.collect() }.text()
}
