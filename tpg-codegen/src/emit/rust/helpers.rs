//! The functions that expressions of the profile `fast` call.

use super::expression::{Printer, literal};
use crate::ir::Node;
use crate::passes::{bound, estimate};
use askama::Template;
use std::collections::BTreeSet;
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

struct LnEstimate {
    scale: String,
    offset: String,
}

struct ExpEstimate {
    from: String,
    to: String,
    scale: String,
    offset: String,
    below: String,
    infinite_above: String,
}

/// Renders what the printer's nodes call.
pub(super) fn render(printer: &Printer<'_>) -> String {
    let scalar = printer.graph.scalar();
    let short = printer.short_cuts && printer.graph.maths() == MathsProvider::System;
    let uses = |wanted| printer.nodes.iter().any(|node| matches!(*node, Node::Operation(i, _) if i == wanted));
    let bounded: BTreeSet<Instruction> = (printer.nodes.iter())
        .filter_map(|node| if let Node::Upper(instruction, _) = *node { Some(instruction) } else { None })
        .collect();
    let number = |value: f64| literal(scalar, value);
    let (infinite_above, zero_below) = bound::beyond_exponentials(scalar);
    let estimate = estimate::of(scalar);
    let single = scalar == ScalarType::F32;
    let helpers = Helpers {
        scalar: scalar.name(),
        zero: number(0.0),
        short_ln: short && uses(Instruction::Ln),
        short_exp: short && uses(Instruction::Exp),
        infinite_above: number(infinite_above),
        zero_below: number(zero_below),
        provider: printer.provider(),
        plain: [Instruction::Sin, Instruction::Cos, Instruction::Ln, Instruction::Exp]
            .into_iter()
            .filter(|&instruction| printer.short_cuts && uses(instruction))
            .filter(|instruction| !short || matches!(instruction, Instruction::Sin | Instruction::Cos))
            .map(Instruction::name)
            .collect(),
        signed: if single { "i32" } else { "i64" },
        unsigned: if single { "u32" } else { "u64" },
        ln_estimate: bounded
            .contains(&Instruction::Ln)
            .then(|| LnEstimate { scale: number(estimate.ln_scale), offset: number(estimate.ln_offset) }),
        exp_estimate: bounded.contains(&Instruction::Exp).then(|| ExpEstimate {
            from: number(estimate.exp_between.0),
            to: number(estimate.exp_between.1),
            scale: number(estimate.exp_scale),
            offset: format!("{:#x}", estimate.exp_offset),
            below: number(estimate.exp_below),
            infinite_above: number(estimate.exp_infinite_above),
        }),
    };
    helpers.render().expect("the template renders")
}
