//! The profile `balanced`: tables of teams over native bids, each distinct one an arm of one `match`.

use super::expression::RustPrinter;
use super::leaves;
use super::parts::Parts;
use crate::emit::cases::{self, CaseView, FunctionView};
use crate::emit::interface::OutputView;
use crate::emit::layout;
use crate::emit::leaves::{LeafView, views};
use crate::emit::syntax::Syntax;
use crate::ir::Module;
use crate::passes::cases::Cases;
use askama::Template;

#[derive(Template)]
#[template(path = "rust/balanced_walk.rs", escape = "none")]
struct BalancedWalk<'a> {
    printer: &'a RustPrinter<'a>,
    cases: &'a Cases,
    bids: Vec<CaseView>,
    functions: Vec<FunctionView>,
    depth: usize,
    leaves: Vec<LeafView>,
    outputs: usize,
}

#[derive(Template)]
#[template(path = "rust/balanced_body.rs", escape = "none")]
struct BalancedBody {
    teams: usize,
    leaves: Vec<(usize, u32)>,
    limited: String,
}

/// Renders the profile.
pub(super) fn render(printer: &RustPrinter<'_>, module: &Module<'_>, cases: &Cases, outputs: &[OutputView]) -> Parts {
    let reached = crate::ir::reached(&cases.leaves);
    let body = BalancedBody {
        teams: module.teams.len(),
        leaves: reached.map(|(number, leaf)| (number, leaf.label)).collect(),
        limited: leaves::limited(printer, outputs, leaves::element),
    };
    let walk = BalancedWalk {
        printer,
        cases,
        // Every bid is hidden after it was computed, a 0 with the others.
        bids: cases::bids(printer, cases, |zero| (None, zero.to_owned())),
        functions: cases::functions(printer, cases),
        leaves: views(printer, &cases.leaves, outputs, false),
        outputs: outputs.len(),
        depth: module.depth,
    };
    let items = layout::indent(&walk.render().expect("the template renders"));
    Parts { body: body.render().expect("the template renders"), items }
}
