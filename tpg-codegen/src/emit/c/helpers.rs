//! The static functions that expressions call. Only those that are called: an unused one would be a warning.

use super::expression::Printer;
use super::own::OwnMaths;
use crate::emit::helpers::called;
use crate::emit::syntax::Syntax;
use crate::passes::bound;
use crate::passes::estimate::{self, Estimate};
use askama::Template;
use std::collections::BTreeSet;
use tpg_graph::{MathsProvider, ScalarType};
use tpg_runtime::ops::{BY_ZERO, ZERO_BY_ZERO};

#[derive(Template)]
#[template(path = "c/helpers.c", escape = "none")]
struct CHelpers<'a> {
    printer: &'a Printer<'a>,
    f64: bool,
    own: Option<OwnMaths>,
    called: BTreeSet<&'a str>,
    /// Choose by masks.
    branch_free: bool,
    /// The masks' functions are so few calls that all are inlined.
    inlined: bool,
    storage: &'a str,
    /// Calls of the platform's logarithm and exponential handle the simple cases themselves.
    short: bool,
    /// Above the first number, an exponential is infinite; below the second, it is 0.
    beyond: (f64, f64),
    estimate: Estimate,
    /// The quotients by 0 of a positive number, of a negative one, and of 0.
    by_zero: [String; 3],
    /// The literal in place of NaN, where every output has the same.
    same_nan: Option<String>,
}

impl CHelpers<'_> {
    fn calls(&self, name: &str) -> bool {
        self.called.contains(name)
    }

    fn has_root(&self) -> bool {
        self.calls("sqrt") && self.printer.root() != self.printer.function("sqrt")
    }

    fn any(&self, names: &[&str]) -> bool {
        names.iter().any(|name| self.calls(name))
    }

    fn literal(&self, value: &f64) -> String {
        self.printer.literal(*value)
    }

    fn finds_nan(&self) -> bool {
        self.any(&["number", "clamp"])
    }

    fn compares(&self) -> bool {
        self.any(&["challenge", "negate_if_less", "min", "max", "quotient"])
    }

    fn compares_bids(&self) -> bool {
        self.any(&["take", "take_at"])
    }

    fn selects(&self) -> bool {
        self.any(&["challenge", "clamp", "pick", "min", "max", "gate", "quotient"])
    }
}

/// Functions that only a body calls.
const OF_BODIES: [&str; 9] = ["can", "can_at", "challenge", "clamp", "hidden", "number", "pick", "take", "take_at"];
/// Functions of masks.
const MASKS: [&str; 9] = ["challenge", "number", "clamp", "pick", "min", "max", "negate_if_less", "gate", "quotient"];
/// The maximum number of calls of masks that are inlined, for they take flash.
const FEW: usize = 24;

/// Renders what nodes and the body call.
pub(super) fn render(printer: &Printer<'_>, body: &str) -> String {
    let branch_free = printer.branch_free;
    let count = |name: &str| body.matches(&format!("{}_{name}(", printer.prefix)).count();
    let mut called = called(printer.nodes);
    called.extend(OF_BODIES.into_iter().filter(|name| count(name) > 0));
    let is_own = printer.graph.maths() == MathsProvider::Own;
    if is_own && called.contains("tan") {
        called.extend(["sin", "cos"]);
    }
    if is_own && called.contains("tanh") {
        called.insert("exp");
    }
    let calls_own = is_own && ["sin", "cos", "ln", "exp", "atan"].iter().any(|name| called.contains(name));
    let scalar = printer.graph.scalar();
    let mut helpers = CHelpers {
        printer,
        f64: scalar == ScalarType::F64,
        own: calls_own.then(|| OwnMaths::new(printer)),
        called,
        branch_free,
        inlined: false,
        storage: "static",
        short: !is_own && printer.short_cuts,
        beyond: bound::beyond_exponentials(scalar),
        estimate: estimate::numbers(scalar),
        by_zero: [BY_ZERO, -BY_ZERO, ZERO_BY_ZERO].map(|whole| printer.literal(scalar.round(whole.into()))),
        same_nan: printer.same_nan().map(|nan| printer.literal(nan)),
    };
    let inline = printer.upper() + "_INLINE";
    let chooses = helpers.compares() || helpers.any(&["clamp", "pick"]);
    if branch_free && chooses && MASKS.iter().map(|name| count(name)).sum::<usize>() <= FEW {
        (helpers.inlined, helpers.storage) = (true, &inline);
    }
    helpers.render().expect("the template renders")
}
