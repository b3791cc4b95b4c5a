//! The static functions that expressions call. An unused one would be a warning, so only those that are called are there.

use super::constant_time;
use super::expression::{Printer, literal};
use crate::ir::Node;
use crate::passes::{bound, estimate};
use askama::Template;
use std::collections::BTreeSet;
use tpg_graph::{MathsProvider, ScalarType};
use tpg_runtime::ops::Instruction;

#[derive(Template)]
#[template(path = "c/helpers.c", escape = "none")]
struct Helpers<'a> {
    prefix: &'a str,
    scalar: &'a str,
    f64: bool,
    own: bool,
    uses_sin: bool,
    uses_cos: bool,
    uses_ln: bool,
    uses_exp: bool,
    /// Whether comparisons are made on integers.
    branch_free: bool,
    compares: bool,
    selects: bool,
    key: &'a str,
    top: u32,
    sign: &'a str,
    infinity: &'a str,
    minus_infinity: &'a str,
    uses_negate_if_less: bool,
    uses_min: bool,
    uses_max: bool,
    short_ln: Option<String>,
    short_exp: Option<ShortExp>,
    signed: &'a str,
    ln_estimate: Option<LnEstimate>,
    exp_estimate: Option<ExpEstimate>,
}

/// The exponential where it is neither 0 nor infinite.
struct ShortExp {
    call: String,
    infinite_above: String,
    zero_below: String,
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

/// Renders what `nodes` call.
pub(super) fn render(printer: &Printer<'_>, branch_free: bool) -> String {
    let used: BTreeSet<Instruction> = (printer.nodes.iter())
        .filter_map(|node| if let Node::Operation(instruction, _) = *node { Some(instruction) } else { None })
        .collect();
    let bounded: BTreeSet<Instruction> = (printer.nodes.iter())
        .filter_map(|node| if let Node::Upper(instruction, _) = *node { Some(instruction) } else { None })
        .collect();
    let scalar = printer.graph.scalar();
    let number = |value: f64| literal(scalar, value);
    let own = printer.graph.maths() == MathsProvider::Own;
    let uses = |instruction| used.contains(&instruction);
    let short = !own && printer.short_cuts;
    let (infinite_above, zero_below) = bound::beyond_exponentials(scalar);
    let estimate = estimate::of(scalar);
    // The order of a number's bits: what is negative upside down, below what is positive.
    let (key, top, sign, infinity, minus_infinity) = match scalar {
        ScalarType::F32 => ("uint32_t", 31, "0x80000000U", "0xff800000U", "0x007fffffU"),
        ScalarType::F64 => ("uint64_t", 63, "0x8000000000000000ULL", "0xfff0000000000000ULL", "0x000fffffffffffffULL"),
    };
    let helpers = Helpers {
        branch_free,
        compares: constant_time::compares(printer.nodes),
        selects: uses(Instruction::Min) || uses(Instruction::Max),
        key,
        top,
        sign,
        infinity,
        minus_infinity,
        prefix: printer.prefix,
        scalar: printer.scalar(),
        f64: scalar == ScalarType::F64,
        own,
        uses_sin: uses(Instruction::Sin),
        uses_cos: uses(Instruction::Cos),
        uses_ln: uses(Instruction::Ln),
        uses_exp: uses(Instruction::Exp),
        uses_negate_if_less: uses(Instruction::NegateIfLess),
        uses_min: uses(Instruction::Min),
        uses_max: uses(Instruction::Max),
        short_ln: (short && uses(Instruction::Ln)).then(|| printer.of_scalar("log")),
        short_exp: (short && uses(Instruction::Exp)).then(|| ShortExp {
            call: printer.of_scalar("exp"),
            infinite_above: number(infinite_above),
            zero_below: number(zero_below),
        }),
        signed: if scalar == ScalarType::F64 { "int64_t" } else { "int32_t" },
        ln_estimate: bounded
            .contains(&Instruction::Ln)
            .then(|| LnEstimate { scale: number(estimate.ln_scale), offset: number(estimate.ln_offset) }),
        exp_estimate: bounded.contains(&Instruction::Exp).then(|| ExpEstimate {
            from: number(estimate.exp_between.0),
            to: number(estimate.exp_between.1),
            scale: number(estimate.exp_scale),
            offset: format!("{:#x}U{}", estimate.exp_offset, if scalar == ScalarType::F64 { "LL" } else { "" }),
            below: number(estimate.exp_below),
            infinite_above: number(estimate.exp_infinite_above),
        }),
    };
    helpers.render().expect("the template renders")
}
