//! `no_std` Rust without unsafe code and without a way to panic, in the shape of a profile.

mod constant_time;
mod expression;
mod fast;
mod helpers;
mod small;

use super::{File, Language, Options, Profile, banner, layout, moves::moves};
use crate::cost::{Cost, Costs};
use crate::ir::{Module, Target};
use crate::passes::{self, schedule};
use askama::Template;
use expression::Printer;
use tpg_graph::Graph;

#[derive(Template)]
#[template(path = "rust/policy.rs", escape = "none")]
struct Policy<'a> {
    banner: &'a [String],
    name: String,
    title: &'a str,
    scalar: &'a str,
    /// What is used of the runtime's instructions.
    imports: Vec<String>,
    state_length: usize,
    sources: Vec<SourceView>,
    actions: Vec<String>,
    arm: Option<ArmView>,
    depth: usize,
    worst: Cost<u64>,
    body: String,
    items: String,
}

struct SourceView {
    name: String,
    unit: String,
    places: String,
    range: String,
}

/// The sources and moves of a policy that drives the arm.
struct ArmView {
    sources: Vec<String>,
    joints: usize,
    moves: Vec<String>,
}

/// A profile's part of the file.
struct Parts {
    /// The statements that decide.
    body: String,
    /// What they call.
    items: String,
}

/// Emits the file.
pub(super) fn emit(graph: &Graph, options: &Options) -> Vec<File> {
    let module = &passes::optimise(graph, options.assumption).0;
    let name = options.prefix.camel();
    let printer = Printer { graph, nodes: &module.nodes, short_cuts: false, branch_free: false };
    let (title, parts, costs) = match options.profile_in(Language::Rust) {
        Profile::Fast => {
            let schedule = schedule::schedule(graph, module, options.recorded());
            let printer = Printer { graph, nodes: &schedule.nodes, short_cuts: true, ..printer };
            let costs = Costs::scheduled(module.clone(), &schedule, Language::Rust);
            ("expensive bids are computed only where they can win", fast::render(&printer, module, &schedule), costs)
        }
        Profile::Small => {
            ("tables and one small evaluator", small::render(&printer, module), Costs::bid_by_bid(module.clone()))
        }
        Profile::ConstantTime => {
            let printer = Printer { branch_free: true, ..printer };
            let costs = Costs::everything(module.clone());
            ("branch-free, the same time for every state", constant_time::render(&printer, module), costs)
        }
    };
    let policy = Policy {
        banner: &banner::lines(graph, module, options, Language::Rust),
        name,
        title,
        scalar: graph.scalar().name(),
        imports: imports(&printer, &parts),
        state_length: graph.state_length(),
        sources: source_views(graph),
        actions: graph.actions().iter().map(|action| one_line(&action.name)).collect(),
        arm: arm_view(graph),
        depth: module.depth,
        worst: costs.worst(),
        body: parts.body.trim_matches('\n').to_owned(),
        items: parts.items,
    };
    let text = layout::tidy(&policy.render().expect("the template renders"));
    vec![File { name: format!("{}.rs", options.prefix), text }]
}

/// What the parts name of `tpg_runtime::ops`.
fn imports(printer: &Printer<'_>, parts: &Parts) -> Vec<String> {
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

/// Teams are numbered from 0, the actions after them.
fn vertex(module: &Module, target: Target) -> usize {
    match target {
        Target::Team(team) => team,
        Target::Action(action) => module.teams.len() + usize::from(action.0),
    }
}

/// The least type that numbers them.
fn vertex_type(graph: &Graph, module: &Module) -> &'static str {
    match module.teams.len() + graph.actions().len() {
        0..=0x100 => "u8",
        0x101..=0x1_0000 => "u16",
        _ => "u32",
    }
}

fn one_line(text: &str) -> String {
    text.chars().map(|c| if c.is_control() { ' ' } else { c }).collect()
}

fn source_views(graph: &Graph) -> Vec<SourceView> {
    let mut first = 0;
    (graph.sources().iter())
        .map(|source| {
            let end = first + source.ranges.len();
            let places = format!("{first}..{end}");
            first = end;
            SourceView {
                name: source.name.clone(),
                unit: one_line(&source.unit),
                places,
                range: source.envelope().to_string(),
            }
        })
        .collect()
}

fn arm_view(graph: &Graph) -> Option<ArmView> {
    let moves = moves(graph)?;
    Some(ArmView {
        sources: graph.sources().iter().map(|source| format!("{:?}", source.name)).collect(),
        joints: moves.first().map_or(0, Vec::len),
        moves: moves.iter().map(|moves| format!("{moves:?}")).collect(),
    })
}
