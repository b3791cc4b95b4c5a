//! The functions that expressions of the profile `fast` call.

use super::expression::Printer;
use crate::emit::helpers::{Calls, ExpEstimate, LnEstimate};
use crate::emit::syntax::Syntax;
use crate::passes::bound;
use askama::Template;
use tpg_graph::{MathsProvider, ScalarType};
use tpg_runtime::ops::Instruction;

#[derive(Template)]
#[template(path = "rust/helpers.rs", escape = "none")]
struct Helpers<'a> {
    scalar: &'a str,
    zero: String,
    short_ln: bool,
    short_exp: bool,
    infinite_above: String,
    zero_below: String,
    provider: &'a str,
    /// The functions that are called as they are.
    plain: Vec<&'static str>,
    signed: &'a str,
    unsigned: &'a str,
    ln_estimate: Option<LnEstimate>,
    exp_estimate: Option<ExpEstimate>,
}

/// Renders what the printer's nodes call.
pub(super) fn render(printer: &Printer<'_>) -> String {
    let scalar = printer.graph.scalar();
    let short = printer.short_cuts && printer.graph.maths() == MathsProvider::System;
    let calls = Calls::of(printer.nodes);
    let uses = |instruction| calls.any(&[instruction]);
    let (infinite_above, zero_below) = bound::beyond_exponentials(scalar);
    let single = scalar == ScalarType::F32;
    let helpers = Helpers {
        scalar: scalar.name(),
        zero: printer.literal(0.0),
        short_ln: short && uses(Instruction::Ln),
        short_exp: short && uses(Instruction::Exp),
        infinite_above: printer.literal(infinite_above),
        zero_below: printer.literal(zero_below),
        provider: printer.provider(),
        plain: [Instruction::Sin, Instruction::Cos, Instruction::Tan, Instruction::Ln, Instruction::Exp]
            .into_iter()
            .filter(|&instruction| printer.short_cuts && uses(instruction))
            .filter(|instruction| !short || !matches!(instruction, Instruction::Ln | Instruction::Exp))
            .map(Instruction::name)
            .collect(),
        signed: if single { "i32" } else { "i64" },
        unsigned: if single { "u32" } else { "u64" },
        ln_estimate: calls.ln_estimate(printer),
        exp_estimate: calls.exp_estimate(printer, ""),
    };
    helpers.render().expect("the template renders")
}
