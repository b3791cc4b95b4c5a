//! The functions that expressions of the profile `fast` call.

use super::expression::RustPrinter;
use crate::emit::helpers::called;
use crate::emit::syntax::Syntax;
use crate::passes::bound;
use crate::passes::estimate;
use askama::Template;
use tpg_graph::MathsProvider;

#[derive(Template)]
#[template(path = "rust/helpers.rs", escape = "none")]
struct RustHelpers<'a> {
    printer: &'a RustPrinter<'a>,
    scalar: &'a str,
    zero: String,
    /// Calls of the platform's logarithm and exponential handle the simple cases themselves.
    short: bool,
    /// Above the first number, an exponential is infinite; below the second, it is 0.
    beyond: (f64, f64),
    provider: &'a str,
    /// The functions that are called as they are.
    plain: &'a [&'a str],
}

impl RustHelpers<'_> {
    fn literal(&self, value: &f64) -> String {
        self.printer.literal(*value)
    }
}

/// Renders what items call.
pub(super) fn render(printer: &RustPrinter<'_>, items: &str) -> String {
    let scalar = printer.graph.scalar();
    let short = printer.graph.maths() == MathsProvider::System;
    let plain = ["sin", "cos", "tan", "atan", "tanh", "ln", "exp"];
    let helpers = RustHelpers {
        printer,
        scalar: scalar.name(),
        zero: printer.literal(0.0),
        short,
        beyond: bound::beyond_exponentials(scalar),
        provider: printer.provider(),
        plain: &plain[..if short { 5 } else { 7 }],
    };
    called(&helpers.render().expect("the template renders"), items)
}
