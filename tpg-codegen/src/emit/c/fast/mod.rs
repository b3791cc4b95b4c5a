//! The profile `fast`: control goes from team to team, always forward, without a loop and without a table. Cheap bids are
//! computed; the others only where a bound says that they can still win.
//!
//! Values that a team computes unconditionally are [reused](crate::passes::available) by its successors: they are variables
//! of the function. Where there are many teams, they are in several functions.
//!
//! The best bid starts at the lowest finite number, and a NaN is never as high: so only bids above −∞ win, and where there
//! is none, nobody wins, which is how the team's last edge does. No bid needs a test for NaN.
//!
//! A bid of 0 is read from a volatile variable: clang takes `(v > 0) ? v : 0` of a `v = max(0, x)` for v, which it is not
//! where x is NaN. Where what is best is no constant, it does not.

mod leader;
mod team;
mod view;

use super::entry::Entry;
use super::expression::Printer;
use super::leaves::{self, LeafView};
use crate::emit::interface::OutputView;
use crate::emit::layout;
use crate::emit::syntax::Syntax;
use crate::ir::{Module, NodeId};
use crate::passes::available::Available;
use crate::passes::schedule::Schedule;
use askama::Template;
pub(crate) use leader::is_compact;
use std::collections::BTreeSet;
use team::TeamPrinter;
use tpg_graph::ScalarType;
use view::{EntryView, FunctionView, LateTeamView};

#[derive(Template)]
#[template(path = "c/fast.c", escape = "none")]
struct Fast<'a> {
    entry: Entry,
    prefix: &'a str,
    upper: &'a str,
    scalar: &'a str,
    lowest: &'a str,
    infinity: String,
    /// The functions that change who leads; empty unless the code is compact.
    leading: String,
    /// Who leads may not have been computed.
    near: bool,
    /// For teams with bids that may lead without having been computed.
    late: Vec<LateTeamView>,
    functions: Vec<FunctionView>,
    outputs: &'a [OutputView],
    /// The leaves, where the only function computes them: its walks jump there.
    leaves: Vec<LeafView>,
    assignments: Vec<String>,
    /// The over_functions point over several functions that decide on a leaf.
    over_functions: String,
}

/// Renders the body.
pub(super) fn render(
    printer: &Printer<'_>,
    module: &Module<'_>,
    schedule: &Schedule,
    available: &Available,
    outputs: &[OutputView],
    upper: &str,
) -> String {
    let order = available.order();
    let mut places = vec![0; order.len()];
    for (place, &team) in order.iter().enumerate() {
        places[team] = place;
    }
    let is_compact = is_compact(module);
    let mut late = Vec::new();
    let functions = available.functions().map(|teams| {
        let (start, whole) = (places[teams[0]], teams.len() == order.len());
        let shared = teams.iter().flat_map(|&team| available.read(team)).copied().collect();
        let span = Span { places: &places, start, end: start + teams.len(), whole, shared };
        let mut reads_state = false;
        let entries = (teams.iter().filter(|&&team| available.is_entry(team)).filter(|_| !whole))
            .map(|&team| EntryView { number: format!("{}U", places[team]), label: module.teams[team].label })
            .collect();
        let teams = teams.iter().map(|&team| {
            let computed = available.on_entry(team).clone();
            let mut printed = TeamPrinter::new(printer, module, &schedule.plans[team], &span, computed, is_compact);
            let view = printed.view(!whole || team != 0);
            reads_state |= printed.reads_state;
            late.extend(printed.late_team());
            view
        });
        let teams = teams.collect();
        let shared = span.shared.iter().map(|&id| printer.value(id)).collect();
        FunctionView { shared, entries, teams, end: span.end, reads_state }
    });
    let mut functions: Vec<FunctionView> = functions.collect();
    let (near, leading) = {
        let teams = functions.iter().flat_map(|function| &function.teams);
        let steps: Vec<_> =
            teams.flat_map(|team| team.steps.iter().chain(&team.steps_before).chain(&team.steps_lazy)).collect();
        let leading = if steps.is_empty() { String::new() } else { leader::functions(printer, upper, &steps) };
        (leader::has_near(&steps), leading)
    };
    let (mut leaves, mut over_functions) = (Vec::new(), String::new());
    match &mut functions[..] {
        [whole] if !outputs.is_empty() => {
            let shared = order.iter().flat_map(|&team| available.read(team)).copied().collect();
            leaves = leaves::views(printer, &schedule.leaves, outputs, &shared);
            whole.reads_state |= leaves.iter().any(|leaf| leaf.reads_state);
        }
        _ if !outputs.is_empty() => over_functions = leaves::render(printer, &schedule.leaves, outputs),
        _ => {}
    }
    let fast = Fast {
        outputs,
        leaves,
        assignments: leaves::assignments(printer, outputs),
        over_functions,
        entry: Entry::of(printer),
        prefix: printer.prefix,
        upper,
        scalar: printer.scalar(),
        lowest: if printer.graph.scalar() == ScalarType::F32 { "FLT_MAX" } else { "DBL_MAX" },
        infinity: printer.number(f64::INFINITY),
        near,
        leading,
        late,
        functions,
    };
    layout::indent(&fast.render().expect("the template renders"))
}

/// The teams of a function.
struct Span<'a> {
    /// Every team's place in the order.
    places: &'a [usize],
    start: usize,
    end: usize,
    /// The function holds all teams of the graph.
    whole: bool,
    /// Values that teams reuse from their predecessors.
    shared: BTreeSet<NodeId>,
}
