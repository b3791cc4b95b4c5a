//! The leaves of a policy with outputs.

use super::expression::RustPrinter;
use crate::emit::interface::OutputView;
use crate::emit::layout::array;
use crate::emit::leaves::{LeafView, view};
use crate::emit::syntax::Syntax;
use crate::ir::Module;

/// The values, each limited to its output's range, as an array in the body of a method; `value` names an output's.
pub(super) fn limited(
    printer: &RustPrinter<'_>,
    outputs: &[OutputView],
    value: impl Fn(&OutputView) -> String,
) -> String {
    answer(printer, outputs.iter().map(|output| (value(output), Some(output.limits.join(", ")))).collect())
}

/// An array of values in the body of a method, some of them limited.
fn answer(printer: &RustPrinter<'_>, values: Vec<(String, Option<String>)>) -> String {
    let is_single = values.len() == 1;
    let element = |(value, limits): (String, Option<String>)| match limits {
        Some(limits) => printer.clamp(&value, &limits, is_single),
        None => value,
    };
    array(&values.into_iter().map(element).collect::<Vec<_>>(), 8)
}

/// The name of an output's value in the array `out`.
pub(super) fn element(output: &OutputView) -> String {
    format!("out[{}]", output.place)
}

/// The body of a policy that has nothing to decide.
pub(super) fn formula(printer: &RustPrinter<'_>, module: &Module<'_>, outputs: &[OutputView]) -> String {
    let ids = module.only_leaf().map_or(&[][..], |leaf| &leaf.values);
    let masks = printer.branch_free.then(|| masks(printer));
    let LeafView { statements, values, .. } = view(printer, ids, outputs, false);
    let limited = outputs.iter().zip(ids).zip(values).map(|((output, id), value)| {
        let is_constant = printer.nodes[id.index()].as_constant().is_some();
        (value, (!is_constant).then(|| output.limits.join(", ")))
    });
    let answer = answer(printer, limited.collect());
    let lines = masks.into_iter().chain(statements).chain([answer]);
    lines.map(|line| format!("        {line}\n")).collect()
}

/// The statement that makes the masks of the profile `constant-time`.
pub(super) fn masks(printer: &RustPrinter<'_>) -> String {
    format!("let ct = ConstantTime::<{}>::default();", printer.scalar())
}
