//! The shape of GEGELATI's own C, for `--style gegelati`: a function for each program and each team, an array of bids, a
//! switch. Nothing is optimised: it is what the profiles are measured against.

use super::expression::Printer;
use super::walk;
use crate::emit::syntax::Syntax;
use crate::ir::{Bidder, Module, Node, NodeId};
use askama::Template;

#[derive(Template)]
#[template(path = "c/gegelati.c", escape = "none")]
struct Gegelati<'a> {
    prefix: &'a str,
    scalar: &'a str,
    vertex: String,
    programs: Vec<ProgramView>,
    teams: Vec<TeamView>,
    /// The entry point.
    walk: String,
}

struct ProgramView {
    label: u32,
    statements: Vec<String>,
    result: String,
}

struct TeamView {
    label: u32,
    programs: Vec<u32>,
    next: String,
}

/// Renders the body.
pub(super) fn render(printer: &Printer<'_>, module: &Module<'_>, upper: &str) -> String {
    let gegelati = Gegelati {
        prefix: printer.prefix,
        scalar: printer.scalar(),
        vertex: printer.vertex_type(module.vertices()),
        programs: module.bidders.iter().map(|bidder| program(printer, module, bidder)).collect(),
        teams: (module.teams.iter())
            .map(|team| TeamView {
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
        walk: walk::render(printer, module, upper),
    };
    gegelati.render().expect("the template renders")
}

fn program(printer: &Printer<'_>, module: &Module<'_>, bidder: &Bidder) -> ProgramView {
    let operations: Vec<NodeId> = module.operations_of(bidder.value);
    debug_assert!(operations.iter().all(|&id| matches!(module.node(id), Node::Operation(..))));
    ProgramView {
        label: bidder.label,
        statements: operations.iter().map(|&id| printer.statement(id)).collect(),
        result: printer.value(bidder.value),
    }
}
