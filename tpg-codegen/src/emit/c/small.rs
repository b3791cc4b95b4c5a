//! The profile `small`: the policy as tables, and one small evaluator.
//!
//! An instruction is an operation and two places of a frame, which holds the state, then the constants, then one result
//! after another: where a result goes needs no bits. Instructions are packed into the least integer that holds them,
//! 16 bits for up to 64 places.

use super::expression::CPrinter;
use super::leaves;
use crate::emit::interface::OutputView;
use crate::emit::syntax::Syntax;
use crate::passes::bytecode::Bytecode;
use askama::Template;

#[derive(Template)]
#[template(path = "c/small.c", escape = "none")]
struct CSmall<'a> {
    printer: &'a CPrinter<'a>,
    bytecode: &'a Bytecode,
    constants: Vec<String>,
    /// Minus infinity, where it is the last constant: not every compiler takes it in a table.
    minus_infinity: Option<String>,
    /// Some operation reads a second operand.
    two_operands: bool,
    cases: Vec<(u32, String)>,
    outputs: &'a [OutputView],
    /// The assignment of each output, by its place in a leaf.
    assignments: Vec<String>,
}

/// Renders the body.
pub(super) fn render(printer: &CPrinter<'_>, bytecode: &Bytecode, outputs: &[OutputView]) -> String {
    // The constants are sorted by their bits, of which minus infinity has the highest.
    let constants = bytecode.constants.strip_suffix(&[f64::NEG_INFINITY]).unwrap_or(&bytecode.constants);
    let small = CSmall {
        printer,
        bytecode,
        constants: constants.iter().map(|&constant| printer.literal(constant)).collect(),
        minus_infinity: (constants.len() < bytecode.constants.len()).then(|| printer.literal(f64::NEG_INFINITY)),
        two_operands: bytecode.used.iter().flatten().any(|instruction| instruction.arity() == 2),
        cases: printer.cases(bytecode),
        outputs,
        assignments: outputs.iter().map(|output| assignment(printer, output)).collect(),
    };
    small.render().expect("the template renders")
}

fn assignment(printer: &CPrinter<'_>, output: &OutputView) -> String {
    let program = format!("programs[{}]", output.place);
    let value = format!("{}_run(frame, {program})", printer.prefix);
    format!("action->{} = {};", output.field, leaves::limited(printer, output, &value))
}
