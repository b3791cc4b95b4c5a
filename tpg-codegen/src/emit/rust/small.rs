//! The profile `small`: the policy as tables, and one small evaluator.

use super::Parts;
use super::expression::{Printer, literal};
use crate::emit::layout;
use crate::ir::Module;
use crate::passes::bytecode::{self, Bytecode};
use askama::Template;

#[derive(Template)]
#[template(path = "rust/small.rs", escape = "none")]
struct Small<'a> {
    scalar: &'a str,
    zero: String,
    /// The type that instructions are taken apart in.
    wide: &'a str,
    tables: Vec<(&'a str, &'a str, Table)>,
    constants: Vec<String>,
    first_result: usize,
    frame: usize,
    operand_bits: u32,
    operand_mask: u32,
    cases: Vec<(u32, String)>,
}

#[derive(Template)]
#[template(path = "rust/small_body.rs", escape = "none")]
struct Body<'a> {
    scalar: &'a str,
    zero: String,
    frame: usize,
    constants: bool,
    teams: usize,
}

struct Table {
    kind: &'static str,
    values: Vec<String>,
}

/// Renders the profile.
pub(super) fn render(printer: &Printer<'_>, module: &Module) -> Parts {
    let graph = printer.graph;
    let Bytecode { code, programs, bidders, targets, teams, constants, first_result, frame, operand_bits, used } =
        bytecode::encode(graph, module);
    let zero = literal(graph.scalar(), 0.0);
    let body = Body {
        scalar: graph.scalar().name(),
        zero: zero.clone(),
        frame,
        constants: !constants.is_empty(),
        teams: module.teams.len(),
    };
    let operands = ["a".to_owned(), "b".to_owned()];
    let small = Small {
        scalar: graph.scalar().name(),
        zero,
        wide: if operand_bits * 2 + 4 > 32 { "u64" } else { "u32" },
        tables: vec![
            ("CODE", "Instructions: from the highest bits, an operation and two places.", table(&code)),
            ("PROGRAMS", "Where each program begins, and where the last ends.", table(&programs)),
            ("BIDDERS", "The program of each edge.", table(&bidders)),
            ("TARGETS", "Where each edge leads: teams from 0, the root; the actions follow.", table(&targets)),
            ("TEAMS", "Where each team's edges begin, and where the last team's end.", table(&teams)),
        ],
        constants: constants.iter().map(|&constant| literal(graph.scalar(), constant)).collect(),
        first_result,
        frame,
        operand_bits,
        operand_mask: (1 << operand_bits) - 1,
        cases: (used.iter())
            .map(|&operation| {
                let expression =
                    operation.map_or_else(|| "a".to_owned(), |instruction| printer.instruction(instruction, &operands));
                (bytecode::number(operation), expression)
            })
            .collect(),
    };
    Parts { body: body.render().expect("the template renders"), items: small.render().expect("the template renders") }
}

/// A table in the least type that holds it.
fn table(values: &[u64]) -> Table {
    let kind = match values.iter().copied().max().unwrap_or(0) {
        0..=0xff => "u8",
        0x100..=0xffff => "u16",
        0x1_0000..=0xffff_ffff => "u32",
        _ => "u64",
    };
    Table { kind, values: values.iter().map(u64::to_string).collect() }
}
