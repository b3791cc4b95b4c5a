//! The profile `constant-time`: every distinct operation once, then every team's choice by masks, then a chase of fixed
//! length from the root to an action. Comparisons are made on integers, by masks that LLVM does not know for such
//! (`tpg_runtime::ops::constant_time`): it has no condition to make a branch or an IT block of. Where there are
//! many teams, they are in several functions, each of which returns what its teams decide.

use super::Parts;
use super::{expression::Printer, leaves};
use crate::emit::choice::{self, KeyView, TeamView};
use crate::emit::interface::OutputView;
use crate::emit::layout;
use crate::emit::syntax::Syntax;
use crate::ir::{Module, NodeId, reached};
use crate::passes::functions::{self, Function};
use askama::Template;
use std::ops::Range;
use tpg_graph::ScalarType;
use tpg_runtime::ops::constant_time as ct;

/// All teams in one function.
#[derive(Template)]
#[template(path = "rust/constant_time.rs", escape = "none")]
struct Whole<'a> {
    decided: &'a str,
    /// There is one team: what it decides is the answer.
    only: bool,
    /// The names of the teams' choices, then the actions, padded to a power of two by numbers that all differ: many zeros
    /// would become a call of `memset`.
    next: Vec<String>,
    size: usize,
    vertex: &'a str,
    depth: usize,
    answer: &'a str,
}

/// The functions' results, a row each.
#[derive(Template)]
#[template(path = "rust/constant_time_rows.rs", escape = "none")]
struct Rows<'a> {
    rows: Vec<String>,
    row: usize,
    vertex: &'a str,
    depth: usize,
    answer: &'a str,
}

/// The functions.
#[derive(Template)]
#[template(path = "rust/constant_time_items.rs", escape = "none")]
struct Items<'a> {
    functions: Vec<FunctionView>,
    row: usize,
    themselves: Vec<String>,
    scalar: &'a str,
    state_length: usize,
    vertex: &'a str,
}

struct FunctionView {
    decided: String,
    next: Vec<String>,
}

/// The choices of a function's teams.
#[derive(Template)]
#[template(path = "rust/constant_time_teams.rs", escape = "none")]
struct Teams<'a> {
    scalar: &'a str,
    only: bool,
    statements: Vec<String>,
    keys: Vec<KeyView>,
    teams: Vec<TeamView>,
    vertex: &'a str,
}

/// Renders the profile.
pub(super) fn render(
    printer: &Printer<'_>,
    module: &Module<'_>,
    functions: &[Function],
    outputs: &[OutputView],
) -> Parts {
    let (teams, vertices) = (module.teams.len(), module.vertices());
    let (vertex, depth) = (&*printer.vertex_type(vertices), module.depth);
    let answer = &*answer(printer, module, functions, outputs);
    if let [function] = functions {
        let size = vertices.next_power_of_two();
        let decided = decided(printer, module, function, vertex);
        let (only, next) = (teams == 1, next(0..size, teams));
        let whole = Whole { decided: &decided, only, next, size, vertex, depth, answer };
        return Parts { body: whole.render().expect("the template renders"), items: String::new() };
    }
    let row = functions[0].teams.len();
    let count = vertices.div_ceil(row).next_power_of_two();
    let calls = (0..functions.len()).map(|number| format!("teams_{number}(s)"));
    let rows = calls.chain((functions.len()..count).map(|number| format!("themselves({})", number * row))).collect();
    let rows = Rows { rows, row, vertex, depth, answer };
    let function = |function: &Function| FunctionView {
        // A function is a level further out than a method.
        decided: decided(printer, module, function, vertex).replace("        ", "    "),
        next: next(function.teams.start..function.teams.start + row, teams),
    };
    let items = Items {
        functions: functions.iter().map(function).collect(),
        row,
        themselves: (0..row).map(|place| format!("first | {place}")).collect(),
        scalar: printer.graph.scalar().name(),
        state_length: printer.graph.state_length(),
        vertex,
    };
    let [body, items] = [rows.render(), items.render()].map(|text| text.expect("the template renders"));
    Parts { body, items }
}

/// The statements that turn the vertex of the walk's end into the answer.
fn answer(printer: &Printer<'_>, module: &Module<'_>, functions: &[Function], outputs: &[OutputView]) -> String {
    let teams = module.teams.len();
    let decided = if teams == 1 { "best.1".to_owned() } else { format!("(vertex as u32).wrapping_sub({teams})") };
    if outputs.is_empty() {
        return if teams == 1 {
            format!("ActionId({decided} as u16)")
        } else {
            format!("ActionId(vertex.wrapping_sub({teams}) as u16)")
        };
    }
    let mut lines = Vec::new();
    if functions.len() > 1 {
        lines.push(leaves::masks(printer));
    }
    lines.push(format!("let leaf = {decided};"));
    lines.push("// Every leaf's values, and the choice among them.".to_owned());
    lines.extend(functions::leaf_operations(module, functions).into_iter().map(|id| printer.statement(id)));
    for (place, (number, leaf)) in reached(&module.leaves).enumerate() {
        for (output, &value) in outputs.iter().zip(&leaf.values) {
            let (variable, value) = (output.variable(), printer.value(value));
            lines.push(match place {
                0 => format!("let {variable} = {value};"),
                _ => format!("let {variable} = ct.if_equal(leaf, {number}, {value}, {variable});"),
            });
        }
    }
    lines.push(leaves::limited(printer, outputs, OutputView::variable));
    lines.join("\n        ")
}

/// The successors of vertices: a team's is its choice; any other vertex is its own.
fn next(vertices: Range<usize>, teams: usize) -> Vec<String> {
    vertices.map(|vertex| if vertex < teams { format!("t{vertex}") } else { vertex.to_string() }).collect()
}

fn decided(printer: &Printer<'_>, module: &Module<'_>, function: &Function, vertex: &str) -> String {
    let teams = Teams {
        scalar: printer.graph.scalar().name(),
        only: module.teams.len() == 1,
        statements: function.operations.iter().map(|&id| printer.statement(id)).collect(),
        keys: function
            .bids
            .iter()
            .map(|&id| KeyView { name: choice::key(id), value: key_value(printer, id) })
            .collect(),
        teams: function.teams.clone().map(|number| choice::team(module, number, choice::key)).collect(),
        vertex,
    };
    teams.render().expect("the template renders").trim_matches('\n').to_owned()
}

/// The key of a bid. A constant's is computed here: the compiler does not see through the masks and would compute it each
/// time.
fn key_value(printer: &Printer<'_>, bid: NodeId) -> String {
    let value = printer.value(bid);
    match (printer.nodes[bid.index()].as_constant(), printer.graph.scalar()) {
        (None, _) => format!("ct.order({value});"),
        (Some(bid), ScalarType::F32) => {
            format!("{}_i32; // {value}", ct::ConstantTime::<f32>::default().order(bid as f32))
        }
        (Some(bid), ScalarType::F64) => format!("{}_i64; // {value}", ct::ConstantTime::<f64>::default().order(bid)),
    }
}
