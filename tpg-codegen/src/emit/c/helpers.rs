//! The static functions that expressions call. Only those that are called: an unused one would be a warning.

use super::expression::Printer;
use super::own::OwnMaths;
use crate::emit::helpers::{Calls, ExpEstimate, LnEstimate};
use crate::emit::syntax::Syntax;
use crate::passes::bound;
use askama::Template;
use tpg_graph::{MathsProvider, ScalarType};
use tpg_runtime::ops::Instruction;

#[derive(Template)]
#[template(path = "c/helpers.c", escape = "none")]
struct Helpers<'a> {
    prefix: &'a str,
    scalar: &'a str,
    f64: bool,
    own: Option<OwnMaths>,
    uses_sin: bool,
    uses_cos: bool,
    uses_tan: bool,
    uses_ln: bool,
    uses_exp: bool,
    /// Compare on integers.
    branch_free: bool,
    /// Teams choose among bids.
    decides: bool,
    /// Masks choose.
    chooses: bool,
    /// Numbers are compared as integers.
    orders: bool,
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
    uses_fmod: bool,
    uses_gate: bool,
    positive_infinity: &'a str,
    /// Outputs are limited.
    clamps: bool,
    /// Outputs of several leaves are chosen without a branch.
    picks: bool,
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

/// Renders what nodes and the body call.
pub(super) fn render(printer: &Printer<'_>, branch_free: bool, body: &str) -> String {
    let calls = Calls::of(printer.nodes);
    let is_called = |name: &str| body.contains(&format!("{}_{name}(", printer.prefix));
    let compares = calls.any(&[Instruction::NegateIfLess, Instruction::Min, Instruction::Max]);
    let orders = compares || is_called("challenge") || is_called("clamp");
    let scalar = printer.graph.scalar();
    let provider = printer.graph.maths();
    let uses = |instruction| calls.any(&[instruction]);
    let short = provider == MathsProvider::System && printer.short_cuts;
    let maths = [Instruction::Sin, Instruction::Cos, Instruction::Tan, Instruction::Ln, Instruction::Exp];
    let calls_maths = provider == MathsProvider::Own && calls.any(&maths);
    let (infinite_above, zero_below) = bound::beyond_exponentials(scalar);
    // The order of a number's bits: what is negative upside down, below what is positive.
    let (key, top, sign, infinity, minus_infinity) = match scalar {
        ScalarType::F32 => ("uint32_t", 31, "0x80000000U", "0xff800000U", "0x007fffffU"),
        ScalarType::F64 => ("uint64_t", 63, "0x8000000000000000ULL", "0xfff0000000000000ULL", "0x000fffffffffffffULL"),
    };
    let helpers = Helpers {
        branch_free,
        decides: is_called("challenge"),
        clamps: is_called("clamp"),
        picks: is_called("pick"),
        chooses: orders || is_called("pick") || calls.any(&[Instruction::Fmod, Instruction::Gate]),
        orders,
        compares,
        selects: is_called("clamp")
            || is_called("pick")
            || calls.any(&[Instruction::Min, Instruction::Max, Instruction::Gate]),
        key,
        top,
        sign,
        infinity,
        minus_infinity,
        prefix: printer.prefix,
        scalar: printer.scalar(),
        f64: scalar == ScalarType::F64,
        own: calls_maths.then(|| OwnMaths::of(printer)),
        // An own tangent is sine by cosine.
        uses_sin: calls.any(&[Instruction::Sin, Instruction::Tan]),
        uses_cos: calls.any(&[Instruction::Cos, Instruction::Tan]),
        uses_tan: uses(Instruction::Tan),
        uses_ln: uses(Instruction::Ln),
        uses_exp: uses(Instruction::Exp),
        uses_negate_if_less: uses(Instruction::NegateIfLess),
        uses_min: uses(Instruction::Min),
        uses_max: uses(Instruction::Max),
        uses_fmod: uses(Instruction::Fmod),
        uses_gate: uses(Instruction::Gate),
        positive_infinity: match scalar {
            ScalarType::F32 => "0x7f800000U",
            ScalarType::F64 => "0x7ff0000000000000ULL",
        },
        short_ln: (short && uses(Instruction::Ln)).then(|| printer.of_scalar("log")),
        short_exp: (short && uses(Instruction::Exp)).then(|| ShortExp {
            call: printer.of_scalar("exp"),
            infinite_above: printer.literal(infinite_above),
            zero_below: printer.literal(zero_below),
        }),
        signed: if scalar == ScalarType::F64 { "int64_t" } else { "int32_t" },
        ln_estimate: calls.ln_estimate(printer),
        exp_estimate: calls.exp_estimate(printer, if scalar == ScalarType::F64 { "ULL" } else { "U" }),
    };
    helpers.render().expect("the template renders")
}
