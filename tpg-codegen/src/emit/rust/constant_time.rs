//! The profile `constant-time`: every distinct operation once, then every team's choice by masks, then a chase of fixed
//! length from the root to an action. Comparisons are made on integers, by masks that LLVM does not know for such
//! (`tpg_runtime::ops::constant_time`): it has no condition to make a branch or an IT block of.

use super::parts::Parts;
use super::{expression::RustPrinter, leaves};
use crate::emit::choice::{self, ChoiceView, KeyView};
use crate::emit::interface::OutputView;
use crate::emit::layout;
use crate::emit::syntax::Syntax;
use crate::ir::{Module, NodeId};
use askama::Template;
use tpg_graph::ScalarType;
use tpg_runtime::ops::constant_time as ct;

#[derive(Template)]
#[template(path = "rust/constant_time.rs", escape = "none")]
struct RustConstantTime<'a> {
    scalar: &'a str,
    /// There is one team: what it decides is the answer.
    only: bool,
    statements: Vec<String>,
    keys: Vec<KeyView>,
    teams: Vec<ChoiceView>,
    /// The names of the teams' choices, then the actions, padded to a power of two by numbers that all differ: many zeros
    /// would become a call of `memset`.
    next: Vec<String>,
    size: usize,
    vertex: &'a str,
    depth: usize,
    answer: String,
}

/// Renders the profile.
pub(super) fn render(printer: &RustPrinter<'_>, module: &Module<'_>, outputs: &[OutputView]) -> Parts {
    let teams = module.teams.len();
    let size = module.vertices().next_power_of_two();
    let (names, bids) = (choice::names(module), module.deciding_bids());
    let mut block = choice::block(printer, bids.iter().map(|&bid| (bid, None)), &module.leaves);
    let (mut statements, mut keys) = (Vec::new(), Vec::new());
    for bid in bids {
        let (before, value) = block.argument(bid, || format!("{}_value", names[&bid]));
        statements.extend(before);
        keys.push(KeyView { name: names[&bid].clone(), value: key(printer, bid, &value) });
    }
    let (of_leaves, leaves) = choice::leaves(&mut block, &module.leaves, outputs);
    let decided = if teams == 1 { "best.1".to_owned() } else { format!("(vertex as u32).wrapping_sub({teams})") };
    let answer = if outputs.is_empty() {
        match teams {
            1 => format!("ActionId({decided} as u16)"),
            _ => format!("ActionId(vertex.wrapping_sub({teams}) as u16)"),
        }
    } else {
        let mut lines = vec![format!("let leaf = {decided};")];
        lines.push("// Every leaf's values, and the choice among them.".to_owned());
        lines.extend(of_leaves);
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
    };
    // A team's successor is its choice; any other vertex is its own.
    let next = |vertex: usize| if vertex < teams { format!("t{vertex}") } else { vertex.to_string() };
    let whole = RustConstantTime {
        scalar: printer.graph.scalar().name(),
        only: teams == 1,
        statements,
        keys,
        teams: (0..teams).map(|number| choice::team(module, number, |bid| names[&bid].clone())).collect(),
        next: (0..size).map(next).collect(),
        size,
        vertex: &printer.vertex_type(module.vertices()),
        depth: module.depth,
        answer,
    };
    Parts { body: whole.render().expect("the template renders"), items: String::new() }
}

/// The key of a bid. A constant's is computed here: the compiler does not see through the masks and would compute it each
/// time.
fn key(printer: &RustPrinter<'_>, bid: NodeId, value: &str) -> String {
    match (printer.nodes[bid.index()].as_constant(), printer.graph.scalar()) {
        (None, _) => format!("ct.order({value});"),
        (Some(bid), ScalarType::F32) => {
            format!("{}_i32; // {value}", ct::ConstantTime::<f32>::default().order(bid as f32))
        }
        (Some(bid), ScalarType::F64) => format!("{}_i64; // {value}", ct::ConstantTime::<f64>::default().order(bid)),
    }
}
