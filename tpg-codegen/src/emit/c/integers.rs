//! A program in integers: straight code for a leaf, teams as in the profile `fast`, or a loop over a table of sums.

use super::expression::CPrinter;
use super::fast::Walk;
use super::formula::CStraight;
use crate::emit::helpers::called;
use crate::emit::integers::{Dense, DenseTable, Work};
use crate::emit::interface::OutputView;
use crate::emit::leaves::LeafView;
use crate::emit::syntax::Syntax;
use crate::integers::Integers;
use crate::ir::{NodeId, reached};
use crate::program::Program;
use askama::Template;

/// The rule of a choice, for readers.
const RULE: &str = "The highest bid wins; of equal bids, the last.";

#[derive(Template)]
#[template(path = "integers/helpers.c", escape = "none")]
struct CIntegerHelpers<'a> {
    prefix: &'a str,
    upper: &'a str,
    table: Option<DenseTable>,
}

/// Renders the body, and what stands before it: a table, and the functions that it calls.
pub(super) fn render(
    printer: &CPrinter<'_>,
    program: &Program<'_>,
    integers: &Integers,
    outputs: &[OutputView],
) -> (String, String) {
    let (module, work) = (&program.module, Work::new(program, integers));
    let dense = Dense::find(module, integers);
    let answers = |values: &[NodeId]| {
        let (statements, values) = work.leaf(values, outputs);
        (statements, outputs.iter().map(|output| output.field.clone()).zip(values).collect::<Vec<_>>())
    };
    let body = match (&dense, module.only_leaf()) {
        (Some(dense), _) => format!("{}\n{{\n{}}}\n", printer.entry().head, dense.body(&work, printer.prefix)),
        (None, Some(leaf)) => {
            let (statements, answers) = answers(&leaf.values);
            CStraight { printer, reads_state: printer.reads_state(&leaf.values), statements, answers }.text()
        }
        (None, None) => {
            let leaves = reached(&module.leaves).map(|(number, leaf)| {
                let (mut statements, answers) = answers(&leaf.values);
                statements.extend(answers.iter().map(|(field, value)| format!("action->{field} = {value};")));
                let reads_state = printer.reads_state(&leaf.values);
                LeafView { label: leaf.label, number, statements, values: Vec::new(), reads_state }
            });
            let choosing = module.teams.iter().filter(|team| team.edges.iter().any(|edge| edge.to != team.edges[0].to));
            let bidders = choosing.flat_map(|team| &team.edges).map(|edge| &module.bidders[edge.bidder]);
            let values = bidders.map(|bidder| bidder.value).collect();
            let (leaves, in_place) = (leaves.collect(), Vec::new());
            let walk =
                Walk { printer, module, rule: RULE, place: "uint_fast8_t", values, outputs: &[], leaves, in_place };
            walk.text(|team, to| work.team(team, to))
        }
    };
    let upper = &printer.upper();
    let table = dense.map(|dense| dense.table());
    let helpers = CIntegerHelpers { prefix: printer.prefix, upper, table };
    (called(&helpers.render().expect("the template renders"), &body), body)
}
