//! The shape of GEGELATI's own C, for `--style gegelati`: a function for each program and each team, an array of bids, a
//! switch. Nothing is optimised: it is what the profiles are measured against.

use super::expression::Printer;
use crate::emit::block::Block;
use crate::emit::syntax::Syntax;
use crate::ir::{Bidder, Module};
use askama::Template;

#[derive(Template)]
#[template(path = "c/gegelati.c", escape = "none")]
struct Gegelati<'a> {
    printer: &'a Printer<'a>,
    vertex: String,
    programs: Vec<ProgramView>,
    teams: Vec<GegelatiTeamView>,
}

struct ProgramView {
    label: u32,
    statements: Vec<String>,
    result: String,
}

struct GegelatiTeamView {
    label: u32,
    programs: Vec<u32>,
    next: String,
}

/// Renders the body.
pub(super) fn render(printer: &Printer<'_>, module: &Module<'_>) -> String {
    let gegelati = Gegelati {
        printer,
        vertex: printer.vertex_type(module.vertices()),
        programs: module.bidders.iter().map(|bidder| program(printer, bidder)).collect(),
        teams: (module.teams.iter())
            .map(|team| GegelatiTeamView {
                label: team.label,
                programs: team.edges.iter().map(|edge| module.bidders[edge.bidder].label).collect(),
                next: team
                    .edges
                    .iter()
                    .map(|edge| format!("{}U", module.vertex(edge.to)))
                    .collect::<Vec<_>>()
                    .join(", "),
            })
            .collect(),
    };
    gegelati.render().expect("the template renders")
}

fn program(printer: &Printer<'_>, bidder: &Bidder) -> ProgramView {
    let mut block = Block::new(printer, [(bidder.value, None)]);
    ProgramView { label: bidder.label, statements: block.statements(bidder.value), result: block.value(bidder.value) }
}
