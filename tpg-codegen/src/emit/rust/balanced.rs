//! The profile `balanced`: tables of teams over native bids, each distinct one an arm of one `match`.

use super::expression::Printer;
use super::leaves;
use super::parts::Parts;
use crate::emit::cases::{self, CaseView, FunctionView};
use crate::emit::interface::OutputView;
use crate::emit::layout;
use crate::emit::leaves::{LeafView, views};
use crate::emit::syntax::Syntax;
use crate::emit::table::{Table, table};
use crate::ir::Module;
use crate::passes::cases::Cases;
use askama::Template;

#[derive(Template)]
#[template(path = "rust/balanced_walk.rs", escape = "none")]
struct BalancedWalk<'a> {
    /// The name of each table, a comment, and the values.
    tables: Vec<(&'a str, &'a str, Table)>,
    scalar: &'a str,
    state_length: usize,
    places: bool,
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
pub(super) fn render(printer: &Printer<'_>, module: &Module<'_>, cases: &Cases, outputs: &[OutputView]) -> Parts {
    let places = !cases.places.is_empty();
    let reached = crate::ir::reached(&cases.leaves);
    let body = BalancedBody {
        teams: module.teams.len(),
        leaves: reached.map(|(number, leaf)| (number, leaf.label)).collect(),
        limited: leaves::limited(printer, outputs, leaves::element),
    };
    let table = |values: &[u64]| table(printer, values);
    let mut tables = vec![
        ("BIDDERS", "The bid of each edge.", table(&cases.bidders)),
        ("TARGETS", "Where each edge leads: teams from 0, the root; the actions follow.", table(&cases.targets)),
        ("TEAMS", "Where each team's edges begin, and where the last team's end.", table(&cases.teams)),
    ];
    if places {
        tables.push(("PLACES", "The place of each edge in its team, which decides ties.", table(&cases.places)));
        tables.push(("OTHERWISE", "Where each team leads if no bid wins.", table(&cases.otherwise)));
    }
    let walk = BalancedWalk {
        tables,
        scalar: printer.scalar(),
        state_length: printer.graph.state_length(),
        places,
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
