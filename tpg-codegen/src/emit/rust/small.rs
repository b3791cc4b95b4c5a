//! The profile `small`: the policy as tables, and one small evaluator.

use super::parts::Parts;
use super::{expression::Printer, leaves};
use crate::emit::interface::OutputView;
use crate::emit::layout;
use crate::emit::syntax::Syntax;
use crate::emit::table::{Table, cases, table};
use crate::ir::Module;
use crate::passes::bytecode::Bytecode;
use askama::Template;

#[derive(Template)]
#[template(path = "rust/small.rs", escape = "none")]
struct RustSmall<'a> {
    scalar: &'a str,
    zero: String,
    /// The type that instructions are taken apart in.
    wide: &'a str,
    tables: Vec<(&'a str, &'a str, Table)>,
    constants: Vec<String>,
    bytecode: &'a Bytecode,
    operand_mask: u32,
    cases: Vec<(u32, String)>,
}

#[derive(Template)]
#[template(path = "rust/small_body.rs", escape = "none")]
struct SmallBody<'a> {
    scalar: &'a str,
    zero: String,
    frame: usize,
    constants: bool,
    teams: usize,
    outputs: &'a [OutputView],
    limited: String,
}

/// Renders the profile.
pub(super) fn render(printer: &Printer<'_>, module: &Module<'_>, code: &Bytecode, outputs: &[OutputView]) -> Parts {
    let zero = printer.literal(0.0);
    let body = SmallBody {
        scalar: printer.scalar(),
        zero: zero.clone(),
        frame: code.frame,
        constants: !code.constants.is_empty(),
        teams: module.teams.len(),
        outputs,
        limited: leaves::limited(printer, outputs, |output| output.variable.clone()),
    };
    let table = |values: &[u64]| table(printer, values);
    let mut tables = vec![
        ("CODE", "Instructions: from the highest bits, an operation and two places.", table(&code.code)),
        ("PROGRAMS", "Where each program begins, and where the last ends.", table(&code.programs)),
        ("BIDDERS", "The program of each edge.", table(&code.bidders)),
        ("TARGETS", "Where each edge leads: teams from 0, the root; the actions follow.", table(&code.targets)),
        ("TEAMS", "Where each team's edges begin, and where the last team's end.", table(&code.teams)),
    ];
    if !outputs.is_empty() {
        tables.push(("LEAVES", "The program of each output of each leaf.", table(&code.leaves)));
    }
    let small = RustSmall {
        scalar: printer.scalar(),
        zero,
        wide: if code.operand_bits * 2 + 4 > 32 { "u64" } else { "u32" },
        tables,
        constants: code.constants.iter().map(|&constant| printer.literal(constant)).collect(),
        bytecode: code,
        operand_mask: (1 << code.operand_bits) - 1,
        cases: cases(printer, code),
    };
    Parts { body: body.render().expect("the template renders"), items: small.render().expect("the template renders") }
}
