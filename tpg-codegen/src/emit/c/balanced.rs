//! The profile `balanced`: tables of teams over native bids, each distinct one a case of one `switch`.

use super::expression::Printer;
use super::leaves;
use crate::emit::cases::{self, CaseView, FunctionView};
use crate::emit::interface::OutputView;
use crate::emit::syntax::Syntax;
use crate::emit::table::{Table, table};
use crate::passes::cases::Cases;
use askama::Template;

#[derive(Template)]
#[template(path = "c/balanced.c", escape = "none")]
struct Balanced<'a> {
    printer: &'a Printer<'a>,
    outputs: &'a [OutputView],
    /// The name of each table, a comment, and the values.
    tables: Vec<(&'a str, &'a str, Table)>,
    /// Ties are decided by a table of places.
    places: bool,
    /// Bids in order, each with its numbers: a sine and a cosine of the same argument begin the same.
    bids: Vec<(Vec<usize>, CaseView)>,
    functions: Vec<FunctionView>,
    reads_state: bool,
    over_teams: String,
}

/// Renders the body.
pub(super) fn render(printer: &Printer<'_>, cases: &Cases, outputs: &[OutputView]) -> String {
    let table = |values: &[u64]| table(printer, values);
    let of_edges = if outputs.is_empty() {
        "What each edge bids, and where it leads: teams are numbered from 0, the root, and the actions follow them."
    } else {
        "What each edge bids, and where it leads: teams are numbered from 0, the root, and the leaves follow them."
    };
    let places = !cases.places.is_empty();
    let mut tables = vec![("bidders", of_edges, table(&cases.bidders)), ("targets", "", table(&cases.targets))];
    if places {
        let of_places = "The edge's place in its team, which decides ties: cheap bids are computed first.";
        tables.push(("places", of_places, table(&cases.places)));
        tables.push(("otherwise", "Where each team leads if no bid wins.", table(&cases.otherwise)));
    }
    let of_teams = "Where each team's edges begin, and where the last team's end.";
    tables.push(("teams", of_teams, table(&cases.teams)));
    let balanced = Balanced {
        printer,
        outputs,
        tables,
        places,
        bids: grouped(cases::bids(printer, cases, |zero| {
            (Some(format!("const volatile {} constant = {zero};", printer.scalar())), "constant".to_owned())
        })),
        functions: cases::functions(printer, cases),
        reads_state: printer.reads_state(cases.bids.iter().map(|case| &case.value)),
        over_teams: if outputs.is_empty() { String::new() } else { leaves::render(printer, &cases.leaves, outputs) },
    };
    balanced.render().expect("the template renders")
}

/// Puts neighbours that read the same into one case.
fn grouped(bids: Vec<CaseView>) -> Vec<(Vec<usize>, CaseView)> {
    let mut groups: Vec<(Vec<usize>, CaseView)> = Vec::new();
    for (number, bid) in bids.into_iter().enumerate() {
        match groups.last_mut() {
            Some((numbers, same)) if *same == bid => numbers.push(number),
            _ => groups.push((vec![number], bid)),
        }
    }
    groups
}
