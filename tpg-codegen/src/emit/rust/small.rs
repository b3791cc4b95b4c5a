//! The profile `small`: the policy as tables, and one small evaluator.

use super::parts::Parts;
use super::{expression::RustPrinter, leaves};
use crate::emit::interface::OutputView;
use crate::emit::layout;
use crate::emit::syntax::Syntax;
use crate::ir::Module;
use crate::passes::bytecode::Bytecode;
use askama::Template;

#[derive(Template)]
#[template(path = "rust/small.rs", escape = "none")]
struct RustSmall<'a> {
    printer: &'a RustPrinter<'a>,
    /// The type that instructions are taken apart in.
    wide: &'a str,
    bytecode: &'a Bytecode,
    constants: Vec<String>,
    cases: Vec<(u32, String)>,
    outputs: &'a [OutputView],
}

#[derive(Template)]
#[template(path = "rust/small_body.rs", escape = "none")]
struct SmallBody<'a> {
    scalar: &'a str,
    zero: String,
    frame: usize,
    constants: bool,
    teams: usize,
    outputs: &'a [OutputView],
    limited: String,
}

/// Renders the profile.
pub(super) fn render(printer: &RustPrinter<'_>, module: &Module<'_>, code: &Bytecode, outputs: &[OutputView]) -> Parts {
    let body = SmallBody {
        scalar: printer.scalar(),
        zero: printer.literal(0.0),
        frame: code.frame,
        constants: !code.constants.is_empty(),
        teams: module.teams.len(),
        outputs,
        limited: leaves::limited(printer, outputs, |output| output.variable.clone()),
    };
    let small = RustSmall {
        printer,
        wide: if code.operand_bits * 2 + 4 > 32 { "u64" } else { "u32" },
        bytecode: code,
        constants: code.constants.iter().map(|&constant| printer.literal(constant)).collect(),
        cases: printer.cases(code),
        outputs,
    };
    Parts { body: body.render().expect("the template renders"), items: small.render().expect("the template renders") }
}
