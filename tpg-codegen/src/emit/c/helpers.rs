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
    /// Choose by masks.
    branch_free: bool,
    /// The masks' functions are so few calls that all are inlined.
    inlined: bool,
    upper: &'a str,
    storage: &'a str,
    /// Teams choose among bids.
    decides: bool,
    /// Masks choose.
    chooses: bool,
    compares: bool,
    finds_nan: bool,
    /// Bids that may be NaN are compared.
    numbers: bool,
    selects: bool,
    key: &'a str,
    top: u32,
    /// The place of the exponent's lowest bit, counted from the top.
    exponent_end: u32,
    sign: &'a str,
    infinity: &'a str,
    /// Numbers are kept from the compiler.
    hides: bool,
    uses_negate_if_less: bool,
    uses_min: bool,
    uses_max: bool,
    uses_fmod: bool,
    uses_gate: bool,
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

/// Calls of masks that are inlined at most: flash is not for nothing.
const FEW: usize = 24;

/// Renders what nodes and the body call.
pub(super) fn render(printer: &Printer<'_>, branch_free: bool, body: &str, upper: &str) -> String {
    let calls = Calls::of(printer.nodes);
    let is_called = |name: &str| body.contains(&format!("{}_{name}(", printer.prefix));
    let decides = is_called("challenge");
    let clamps = is_called("clamp");
    let numbers = is_called("number");
    let picks = is_called("pick");
    let compares = decides || calls.any(&[Instruction::NegateIfLess, Instruction::Min, Instruction::Max]);
    let masks = ["challenge", "number", "clamp", "pick", "min", "max", "negate_if_less", "gate"];
    let calls_of = |name: &&str| body.matches(&format!("{}_{name}(", printer.prefix)).count();
    let inlined = branch_free && masks.iter().map(calls_of).sum::<usize>() <= FEW && (compares || clamps || picks);
    let scalar = printer.graph.scalar();
    let provider = printer.graph.maths();
    let uses = |instruction| calls.any(&[instruction]);
    let short = provider == MathsProvider::System && printer.short_cuts;
    let maths = [Instruction::Sin, Instruction::Cos, Instruction::Tan, Instruction::Ln, Instruction::Exp];
    let calls_maths = provider == MathsProvider::Own && calls.any(&maths);
    let (infinite_above, zero_below) = bound::beyond_exponentials(scalar);
    let (key, top, exponent_end, sign, infinity) = match scalar {
        ScalarType::F32 => ("uint32_t", 31, 9, "0x80000000U", "0x7f800000U"),
        ScalarType::F64 => ("uint64_t", 63, 12, "0x8000000000000000ULL", "0x7ff0000000000000ULL"),
    };
    let helpers = Helpers {
        branch_free,
        inlined,
        upper,
        storage: &if inlined { format!("{upper}_INLINE") } else { "static".to_owned() },
        decides,
        clamps,
        picks,
        chooses: compares || clamps || picks || calls.any(&[Instruction::Fmod, Instruction::Gate]),
        compares,
        finds_nan: numbers || clamps,
        numbers,
        selects: decides || clamps || picks || calls.any(&[Instruction::Min, Instruction::Max, Instruction::Gate]),
        key,
        top,
        exponent_end,
        sign,
        infinity,
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
        hides: is_called("hidden"),
        uses_negate_if_less: uses(Instruction::NegateIfLess),
        uses_min: uses(Instruction::Min),
        uses_max: uses(Instruction::Max),
        uses_fmod: uses(Instruction::Fmod),
        uses_gate: uses(Instruction::Gate),
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
