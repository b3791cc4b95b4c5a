//! A program in integers: the expression of a leaf, or a function for each team as in the profile `fast`.

use super::expression::RustPrinter;
use super::fast::RustFast;
use super::parts::Parts;
use crate::emit::helpers::called;
use crate::emit::integers::{Work, answer_bits, state_bits};
use crate::emit::interface::OutputView;
use crate::emit::layout;
use crate::emit::leaves::LeafView;
use crate::emit::team::Destinations;
use crate::integers::Integers;
use crate::ir::reached;
use crate::program::Program;
use askama::Template;

#[derive(Template)]
#[template(path = "integers/helpers.rs", escape = "none")]
struct RustIntegerHelpers;

/// Renders the body and its items.
pub(super) fn render(
    printer: &RustPrinter<'_>,
    program: &Program<'_>,
    integers: &Integers,
    outputs: &[OutputView],
) -> Parts {
    let (module, work) = (&program.module, Work::new(program, integers));
    let (body, items) = match module.only_leaf() {
        Some(leaf) => {
            let (statements, values) = work.leaf(&leaf.values, outputs);
            let lines = statements.into_iter().chain([layout::array(&values, 8)]);
            (lines.map(|line| format!("        {line}\n")).collect(), String::new())
        }
        None => {
            let leaves = reached(&module.leaves).map(|(number, leaf)| {
                let (statements, values) = work.leaf(&leaf.values, outputs);
                LeafView { label: leaf.label, number, statements, values, reads_state: true }
            });
            let answer = match outputs.len() {
                0 => "u16".to_owned(),
                count => format!("[i{}; {count}]", answer_bits(program.graph())),
            };
            let kind = &format!("i{}", state_bits(program.graph()));
            let view = |team: usize, to: &Destinations<'_, String>| work.team(team, to);
            let (decision, items) = RustFast::text(printer, module, kind, answer, leaves.collect(), view);
            (format!("        {decision}"), items)
        }
    };
    let helpers = called(&RustIntegerHelpers.render().expect("the template renders"), &format!("{body}\n{items}"));
    Parts { body, items: layout::indent(&(items + "\n" + &helpers)) }
}
