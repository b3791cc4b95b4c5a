//! The profile `balanced`: tables of teams over native bids, each distinct one a case of one `switch`.

use super::expression::CPrinter;
use super::leaves;
use crate::emit::cases::{self, CaseView, FunctionView};
use crate::emit::interface::OutputView;
use crate::emit::syntax::Syntax;
use crate::passes::cases::Cases;
use askama::Template;

#[derive(Template)]
#[template(path = "c/balanced.c", escape = "none")]
struct CBalanced<'a> {
    printer: &'a CPrinter<'a>,
    cases: &'a Cases,
    outputs: &'a [OutputView],
    /// Bids in order, each with its numbers: a sine and a cosine of the same argument begin the same.
    bids: Vec<(Vec<usize>, CaseView)>,
    functions: Vec<FunctionView>,
    reads_state: bool,
    over_teams: String,
}

/// Renders the body.
pub(super) fn render(printer: &CPrinter<'_>, cases: &Cases, outputs: &[OutputView]) -> String {
    let balanced = CBalanced {
        printer,
        cases,
        outputs,
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
