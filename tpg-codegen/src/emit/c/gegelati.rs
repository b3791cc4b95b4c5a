//! The shape of GEGELATI's own C, for `--style gegelati`: a function for each program and each team, an array of bids, a
//! switch. Nothing is optimised: it is what the profiles are measured against.

use super::expression::CPrinter;
use crate::emit::block::Block;
use crate::emit::syntax::Syntax;
use crate::ir::{Bidder, Module};
use askama::Template;

#[derive(Template)]
#[template(path = "c/gegelati.c", escape = "none")]
struct Gegelati<'a> {
    printer: &'a CPrinter<'a>,
    module: &'a Module<'a>,
    vertex: String,
    programs: Vec<ProgramView>,
}

struct ProgramView {
    label: u32,
    statements: Vec<String>,
    result: String,
}

/// Renders the body.
pub(super) fn render(printer: &CPrinter<'_>, module: &Module<'_>) -> String {
    let vertex = printer.vertex_type(module.vertices());
    let programs = module.bidders.iter().map(|bidder| program(printer, bidder)).collect();
    Gegelati { printer, module, vertex, programs }.render().expect("the template renders")
}

fn program(printer: &CPrinter<'_>, bidder: &Bidder) -> ProgramView {
    let mut block = Block::new(printer, [(bidder.value, None)]);
    ProgramView { label: bidder.label, statements: block.statements(bidder.value), result: block.value(bidder.value) }
}
