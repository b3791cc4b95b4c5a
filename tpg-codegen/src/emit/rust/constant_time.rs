//! The profile `constant-time`: every distinct operation once, then every team's choice by masks, then a chase of fixed
//! length from the root to an action. Comparisons are made on integers, by masks that LLVM does not know for such
//! (`tpg_runtime::ops::constant_time`): it has no condition to make a branch or an IT block of. Where there are
//! many teams, they are in several functions, each of which returns what its teams decide.

use super::parts::Parts;
use super::{expression::Printer, leaves};
use crate::emit::block::Block;
use crate::emit::choice::{self, KeyView, TeamView};
use crate::emit::interface::OutputView;
use crate::emit::layout;
use crate::emit::syntax::Syntax;
use crate::ir::{Leaf, Module, NodeId};
use crate::passes::functions::Function;
use askama::Template;
use std::collections::BTreeMap;
use std::ops::Range;
use tpg_graph::ScalarType;
use tpg_runtime::ops::constant_time as ct;

/// All teams in one function.
#[derive(Template)]
#[template(path = "rust/constant_time.rs", escape = "none")]
struct RustConstantTime<'a> {
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
struct RustRows<'a> {
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
    functions: Vec<RustFunctionView>,
    row: usize,
    themselves: Vec<String>,
    scalar: &'a str,
    state_length: usize,
    vertex: &'a str,
}

struct RustFunctionView {
    decided: String,
    next: Vec<String>,
}

/// The choices of a function's teams.
#[derive(Template)]
#[template(path = "rust/constant_time_teams.rs", escape = "none")]
struct RustTeams<'a> {
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
    let names = choice::names(module);
    if let [function] = functions {
        let size = vertices.next_power_of_two();
        let (decided, mut block) = decided(printer, module, function, &names, vertex, &module.leaves);
        let answer = &*answer(printer, module, &mut block, functions, outputs);
        let (only, next) = (teams == 1, next(0..size, teams));
        let whole = RustConstantTime { decided: &decided, only, next, size, vertex, depth, answer };
        return Parts { body: whole.render().expect("the template renders"), items: String::new() };
    }
    let answer = &*answer(printer, module, &mut choice::block(printer, [], &module.leaves), functions, outputs);
    let row = functions[0].teams.len();
    let count = vertices.div_ceil(row).next_power_of_two();
    let calls = (0..functions.len()).map(|number| format!("teams_{number}(s)"));
    let rows = calls.chain((functions.len()..count).map(|number| format!("themselves({})", number * row))).collect();
    let rows = RustRows { rows, row, vertex, depth, answer };
    let function = |function: &Function| RustFunctionView {
        // A function is a level further out than a method.
        decided: decided(printer, module, function, &names, vertex, &[]).0.replace("        ", "    "),
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
fn answer(
    printer: &Printer<'_>,
    module: &Module<'_>,
    block: &mut Block<'_, Printer<'_>>,
    functions: &[Function],
    outputs: &[OutputView],
) -> String {
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
    let (statements, leaves) = choice::leaves(block, &module.leaves, outputs);
    lines.extend(statements);
    for (place, leaf) in leaves.iter().enumerate() {
        for (OutputView { variable, .. }, value) in outputs.iter().zip(&leaf.values) {
            lines.push(match place {
                0 => format!("let {variable} = {value};"),
                _ => format!("let {variable} = ct.if_equal(leaf, {}, {value}, {variable});", leaf.number),
            });
        }
    }
    lines.push(leaves::limited(printer, outputs, |output| output.variable.clone()));
    lines.join("\n        ")
}

/// The successors of vertices: a team's is its choice; any other vertex is its own.
fn next(vertices: Range<usize>, teams: usize) -> Vec<String> {
    vertices.map(|vertex| if vertex < teams { format!("t{vertex}") } else { vertex.to_string() }).collect()
}

fn decided<'a>(
    printer: &'a Printer<'a>,
    module: &Module<'_>,
    function: &Function,
    names: &BTreeMap<NodeId, String>,
    vertex: &str,
    leaves: &[Leaf],
) -> (String, Block<'a, Printer<'a>>) {
    let mut block = choice::block(printer, function.bids.iter().map(|&bid| (bid, None)), leaves);
    let (mut statements, mut keys) = (Vec::new(), Vec::new());
    for &bid in &function.bids {
        let (before, value) = block.argument(bid, || format!("{}_value", names[&bid]));
        statements.extend(before);
        keys.push(KeyView { name: names[&bid].clone(), value: key(printer, bid, &value) });
    }
    let teams = RustTeams {
        scalar: printer.graph.scalar().name(),
        only: module.teams.len() == 1,
        statements,
        keys,
        teams: function.teams.clone().map(|number| choice::team(module, number, |bid| names[&bid].clone())).collect(),
        vertex,
    };
    (teams.render().expect("the template renders").trim_matches('\n').to_owned(), block)
}

/// The key of a bid. A constant's is computed here: the compiler does not see through the masks and would compute it each
/// time.
fn key(printer: &Printer<'_>, bid: NodeId, value: &str) -> String {
    match (printer.nodes[bid.index()].as_constant(), printer.graph.scalar()) {
        (None, _) => format!("ct.order({value});"),
        (Some(bid), ScalarType::F32) => {
            format!("{}_i32; // {value}", ct::ConstantTime::<f32>::default().order(bid as f32))
        }
        (Some(bid), ScalarType::F64) => format!("{}_i64; // {value}", ct::ConstantTime::<f64>::default().order(bid)),
    }
}
