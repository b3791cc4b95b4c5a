//! The profile `small`: the policy as tables, and one small evaluator.
//!
//! An instruction is an operation and two places of a frame, which holds the state, then the constants, then one result
//! after another: where a result goes needs no bits. Instructions are packed into the least integer that holds them,
//! 16 bits for up to 64 places.

use super::expression::{Printer, literal};
use crate::ir::Module;
use crate::passes::bytecode::{self, Bytecode};
use askama::Template;

#[derive(Template)]
#[template(path = "c/small.c", escape = "none")]
struct Small<'a> {
    prefix: &'a str,
    upper: &'a str,
    scalar: &'a str,
    f64: bool,
    lowest: &'a str,
    code: Table,
    programs: Table,
    bidders: Table,
    targets: Table,
    teams: Table,
    constants: Vec<String>,
    state_length: usize,
    first_result: usize,
    frame: usize,
    operand_bits: u32,
    operand_mask: u32,
    /// Whether any operation reads a second place.
    two_operands: bool,
    cases: Vec<CaseView>,
}

struct Table {
    kind: &'static str,
    length: usize,
    lines: Vec<String>,
}

struct CaseView {
    number: u32,
    expression: String,
}

/// Renders the body.
pub(super) fn render(printer: &Printer<'_>, module: &Module, upper: &str) -> String {
    let graph = printer.graph;
    let Bytecode { code, programs, bidders, targets, teams, constants, first_result, frame, operand_bits, used } =
        bytecode::encode(graph, module);
    let f64 = graph.scalar() == tpg_graph::ScalarType::F64;
    let small = Small {
        prefix: printer.prefix,
        upper,
        scalar: printer.scalar(),
        f64,
        lowest: if f64 { "DBL_MAX" } else { "FLT_MAX" },
        code: table(&code),
        programs: table(&programs),
        bidders: table(&bidders),
        targets: table(&targets),
        teams: table(&teams),
        constants: constants.iter().map(|&constant| literal(graph.scalar(), constant)).collect(),
        state_length: graph.state_length(),
        first_result,
        frame,
        operand_bits,
        operand_mask: (1 << operand_bits) - 1,
        two_operands: used.iter().flatten().any(|instruction| instruction.arity() == 2),
        cases: (used.iter())
            .map(|&operation| CaseView {
                number: bytecode::number(operation),
                expression: operation.map_or_else(
                    || "a".to_owned(),
                    |instruction| printer.instruction(instruction, &["a".to_owned(), "b".to_owned()]),
                ),
            })
            .collect(),
    };
    small.render().expect("the template renders")
}

/// A table in the least type that holds it.
fn table(values: &[u64]) -> Table {
    let (kind, suffix) = match values.iter().copied().max().unwrap_or(0) {
        0..=0xff => ("uint8_t", "U"),
        0x100..=0xffff => ("uint16_t", "U"),
        0x1_0000..=0xffff_ffff => ("uint32_t", "U"),
        _ => ("uint64_t", "ULL"),
    };
    let line = |values: &[u64]| values.iter().map(|value| format!("{value}{suffix}")).collect::<Vec<_>>().join(", ");
    Table { kind, length: values.len(), lines: values.chunks(12).map(line).collect() }
}
