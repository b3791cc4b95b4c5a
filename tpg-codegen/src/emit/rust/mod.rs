//! `no_std` Rust without unsafe code and without a way to panic, in the shape of a profile.

mod balanced;
mod constant_time;
mod expression;
mod fast;
mod helpers;
mod integers;
mod leaves;
mod parts;
mod small;

use super::file::{File, one_line};
use super::integers::{answer_bits, state_bits};
use super::interface::{OutputView, SourceView, asks, outputs, sources};
use super::look::{self, LookView};
use super::{banner, layout, moves::moves, names, team::compares_in_functions};
use crate::program::Program;
use crate::shape::Shape;
use askama::Template;
use expression::RustPrinter;
use parts::Parts;
use tpg_graph::Graph;

#[derive(Template)]
#[template(path = "rust/policy.rs", escape = "none")]
struct RustPolicy<'a> {
    banner: &'a [String],
    name: String,
    title: &'a str,
    /// Numbers are whole.
    integers: bool,
    /// The type of a value of the state and the memory, and that of an output.
    kind: &'a str,
    answer: &'a str,
    /// Imports from `tpg_runtime`.
    imports: Vec<String>,
    state_length: usize,
    sources: Vec<SourceView>,
    actions: Vec<String>,
    /// The constants of the actions.
    constants: Vec<String>,
    /// Name and number of each action that asks.
    asks: Vec<(String, usize)>,
    /// The outputs, then the next values of the memory.
    outputs: &'a [OutputView],
    memory: &'a [OutputView],
    /// The memory's first values.
    initial: Vec<String>,
    /// The names of a state's values and the memory's, of the outputs that are the next memory, and of the others.
    seen: Vec<String>,
    remembered: Vec<String>,
    answered: Vec<String>,
    arm: Option<RustArmView>,
    depth: usize,
    body: String,
    items: String,
    look: String,
}

/// The sources and moves of a policy that drives the arm.
struct RustArmView {
    sources: Vec<String>,
    joints: usize,
    moves: Vec<String>,
}

/// The file.
pub(super) fn files(program: &Program<'_>) -> Vec<File> {
    let (graph, module, prefix) = (program.graph(), &program.module, &program.options.prefix);
    let printer = RustPrinter {
        graph,
        nodes: &module.nodes,
        short_cuts: false,
        branch_free: program.is_branch_free(),
        leads: false,
    };
    let integers = matches!(program.shape, Shape::Integers(_));
    let kind = |bits: u32| if integers { format!("i{bits}") } else { graph.scalar().name().to_owned() };
    let (kind, answer) = (kind(state_bits(graph)), kind(answer_bits(graph)));
    let sources = sources(graph, one_line, |_| kind.clone());
    let outputs = outputs(&printer, one_line, |_| answer.clone());
    let (title, parts) = match &program.shape {
        Shape::Fast(schedule) => {
            let leads = compares_in_functions(module);
            let printer = RustPrinter { nodes: &schedule.nodes, short_cuts: true, leads, ..printer };
            ("expensive bids are computed only where they can win", fast::render(&printer, module, schedule, &outputs))
        }
        Shape::Balanced(cases) => {
            let printer = RustPrinter { nodes: &cases.nodes, ..printer };
            ("tables of teams over native bids", balanced::render(&printer, module, cases, &outputs))
        }
        Shape::Small(code) => ("tables and one small evaluator", small::render(&printer, module, code, &outputs)),
        Shape::ConstantTime => {
            let parts = constant_time::render(&printer, module, &outputs);
            ("branch-free, the same time for every state", parts)
        }
        Shape::Formula => {
            let body = leaves::formula(&printer, module, &outputs);
            ("a formula", Parts { body, items: String::new() })
        }
        Shape::Integers(whole) => ("in integers", integers::render(&printer, program, whole, &outputs)),
        Shape::Gegelati => unreachable!("in C alone"),
    };
    let (observed, first) = (graph.state_length() - graph.memory(), outputs.len() - graph.memory());
    let memory = &outputs[first..];
    let policy = RustPolicy {
        banner: &banner::lines(program),
        name: prefix.camel(),
        title,
        integers,
        kind: &kind,
        answer: &answer,
        imports: imports(&printer, &parts),
        state_length: graph.state_length(),
        look: LookView::new(graph, &sources)
            .map_or_else(String::new, |view| look::rust(&view, &prefix.camel(), &kind, observed)),
        sources,
        actions: graph.actions().iter().map(|action| one_line(&action.to_string())).collect(),
        constants: names::actions(graph).into_iter().map(|name| name.to_ascii_uppercase()).collect(),
        asks: asks(graph),
        outputs: &outputs,
        memory,
        initial: (memory.iter())
            .map(|value| if integers { value.nan.to_string() } else { value.initial.clone() })
            .collect(),
        seen: [names("state", observed), names("memory", memory.len())].concat(),
        remembered: memory.iter().map(leaves::element).collect(),
        answered: outputs[..first].iter().map(leaves::element).collect(),
        arm: arm_view(graph),
        depth: module.depth,
        body: parts.body.trim_matches('\n').to_owned(),
        items: parts.items,
    };
    let text = layout::wrap(&layout::tidy(&policy.render().expect("the template renders")), true);
    vec![File { name: format!("{prefix}.rs"), text }]
}

/// The imports from `tpg_runtime::ops` that the parts need.
fn imports(printer: &RustPrinter<'_>, parts: &Parts) -> Vec<String> {
    let names = |name: &str| parts.body.contains(name) || parts.items.contains(name);
    let provider = printer.provider();
    let masks = names("ConstantTime::").then(|| "ops::constant_time::ConstantTime".to_owned());
    let others = match (names("ops::"), names(&format!("{provider}::"))) {
        (true, true) => Some(format!("ops::{{self, Maths, {provider}}}")),
        (true, false) => Some("ops".to_owned()),
        (false, true) => Some(format!("ops::{{Maths, {provider}}}")),
        (false, false) => None,
    };
    masks.into_iter().chain(others).collect()
}

/// The names of an array's elements.
fn names(array: &str, count: usize) -> Vec<String> {
    (0..count).map(|place| format!("{array}[{place}]")).collect()
}

fn arm_view(graph: &Graph) -> Option<RustArmView> {
    let moves = moves(graph)?;
    Some(RustArmView {
        sources: graph.sources().iter().map(|source| format!("{:?}", source.name)).collect(),
        joints: moves.first().map_or(0, Vec::len),
        moves: moves.iter().map(|moves| format!("{moves:?}")).collect(),
    })
}
