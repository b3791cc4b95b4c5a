//! The static functions that expressions call. Only those that are called: an unused one would be a warning.

use super::expression::CPrinter;
use crate::emit::helpers::called;
use crate::emit::syntax::Syntax;
use crate::passes::bound;
use crate::passes::estimate;
use askama::Template;
use tpg_graph::{MathsProvider, ScalarType};
use tpg_runtime::ops::own::{f32 as single, f64 as double};
use tpg_runtime::ops::{BY_ZERO, ZERO_BY_ZERO};

#[derive(Template)]
#[template(path = "c/helpers.c", escape = "none")]
struct CHelpers<'a> {
    printer: &'a CPrinter<'a>,
    f64: bool,
    is_own: bool,
    /// Choose by masks.
    branch_free: bool,
    /// The masks' functions are so few calls that all are inlined.
    inlined: bool,
    storage: &'a str,
    /// Calls of the platform's logarithm and exponential handle the simple cases themselves.
    short: bool,
    /// Above the first number, an exponential is infinite; below the second, it is 0.
    beyond: (f64, f64),
    /// The quotients by 0 of a positive number, of a negative one, and of 0.
    by_zero: [String; 3],
    /// The literal in place of NaN, where every output has the same.
    same_nan: Option<String>,
}

impl CHelpers<'_> {
    fn literal(&self, value: &f64) -> String {
        self.printer.literal(*value)
    }
}

/// Functions of masks: those that choose, then the others.
const MASKS: [&str; 9] = ["challenge", "negate_if_less", "min", "max", "quotient", "clamp", "pick", "number", "gate"];
/// The maximum number of calls of masks that are inlined, for they take flash.
const FEW: usize = 24;

/// Renders what the body calls.
pub(super) fn render(printer: &CPrinter<'_>, body: &str) -> String {
    let count = |names: &[&str]| -> usize {
        names.iter().map(|name| body.matches(&format!("{}_{name}(", printer.prefix)).count()).sum()
    };
    let scalar = printer.graph.scalar();
    let is_own = printer.graph.maths() == MathsProvider::Own;
    let inlined = printer.branch_free && count(&MASKS[..7]) > 0 && count(&MASKS) <= FEW;
    let inline = printer.upper() + "_INLINE";
    let helpers = CHelpers {
        printer,
        f64: scalar == ScalarType::F64,
        is_own,
        branch_free: printer.branch_free,
        inlined,
        storage: if inlined { &inline } else { "static" },
        short: !is_own && printer.short_cuts,
        beyond: bound::beyond_exponentials(scalar),
        by_zero: [BY_ZERO, -BY_ZERO, ZERO_BY_ZERO].map(|whole| printer.literal(scalar.round(whole.into()))),
        same_nan: printer.same_nan().map(|nan| printer.literal(nan)),
    };
    called(&helpers.render().expect("the template renders"), body)
}
