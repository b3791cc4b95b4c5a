//! The profile `small`: the policy as tables, and one small evaluator.
//!
//! An instruction is an operation and two places of a frame, which holds the state, then the constants, then one result
//! after another: where a result goes needs no bits. Instructions are packed into the least integer that holds them,
//! 16 bits for up to 64 places.

use super::expression::Printer;
use super::leaves;
use crate::emit::interface::OutputView;
use crate::emit::syntax::Syntax;
use crate::emit::table::{Table, cases, table};
use crate::passes::bytecode::Bytecode;
use askama::Template;

#[derive(Template)]
#[template(path = "c/small.c", escape = "none")]
struct CSmall<'a> {
    printer: &'a Printer<'a>,
    f64: bool,
    /// The name of each table that programs and teams read, a comment, and the values.
    of_programs: Vec<(&'a str, &'a str, Table)>,
    of_teams: Vec<(&'a str, &'a str, Table)>,
    /// The types of an instruction, and of a program in a leaf.
    instruction: String,
    leaf: String,
    constants: Vec<String>,
    /// Minus infinity, where it is the last constant: not every compiler takes it in a table.
    minus_infinity: Option<String>,
    state_length: usize,
    bytecode: &'a Bytecode,
    operand_mask: u32,
    /// Some operation reads a second operand.
    two_operands: bool,
    cases: Vec<(u32, String)>,
    outputs: &'a [OutputView],
    /// The assignment of each output, by its place in a leaf.
    assignments: Vec<String>,
}

/// Renders the body.
pub(super) fn render(printer: &Printer<'_>, code: &Bytecode, outputs: &[OutputView]) -> String {
    let graph = printer.graph;
    let f64 = graph.scalar() == tpg_graph::ScalarType::F64;
    let table = |values: &[u64]| table(printer, values);
    // The constants are sorted by their bits, of which minus infinity has the highest.
    let constants = code.constants.strip_suffix(&[f64::NEG_INFINITY]).unwrap_or(&code.constants);
    let of_edges = if outputs.is_empty() {
        "The program of each edge, and where it leads: teams are numbered from 0, the root, and the actions follow them."
    } else {
        "The program of each edge, and where it leads: teams are numbered from 0, the root, and the leaves follow them."
    };
    let (instructions, leaves) = (table(&code.code), table(&code.leaves));
    let (instruction, leaf) = (instructions.kind.clone(), leaves.kind.clone());
    let mut of_teams = vec![
        ("bidders", of_edges, table(&code.bidders)),
        ("targets", "", table(&code.targets)),
        ("teams", "Where each team's edges begin, and where the last team's end.", table(&code.teams)),
    ];
    if !outputs.is_empty() {
        of_teams.push(("leaves", "The program of each output of each leaf.", leaves));
    }
    let small = CSmall {
        printer,
        f64,
        of_programs: vec![
            ("code", "Instructions: operation, then the places of both operands.", instructions),
            ("programs", "Where each program begins, and where the last ends.", table(&code.programs)),
        ],
        of_teams,
        instruction,
        leaf,
        constants: constants.iter().map(|&constant| printer.literal(constant)).collect(),
        minus_infinity: (constants.len() < code.constants.len()).then(|| printer.literal(f64::NEG_INFINITY)),
        state_length: graph.state_length(),
        bytecode: code,
        operand_mask: (1 << code.operand_bits) - 1,
        two_operands: code.used.iter().flatten().any(|instruction| instruction.arity() == 2),
        cases: cases(printer, code),
        outputs,
        assignments: outputs.iter().map(|output| assignment(printer, output)).collect(),
    };
    small.render().expect("the template renders")
}

fn assignment(printer: &Printer<'_>, output: &OutputView) -> String {
    let program = format!("programs[{}]", output.place);
    let value = format!("{}_run(frame, {program})", printer.prefix);
    format!("action->{} = {};", output.field, leaves::limited(printer, output, &value))
}
