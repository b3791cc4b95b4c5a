//! The profile `fast`: control goes from team to team, always forward, without a loop and without a table. Cheap bids are
//! computed; the others only where a bound says that they can still win. Where there are many teams, they are in several
//! functions.
//!
//! The best bid starts at the lowest finite number, and a NaN is never as high: so only bids above −∞ win, and where there
//! is none, nobody wins, which is how the team's last edge does. No bid needs a test for NaN.
//!
//! A bid of 0 is read from a volatile variable: clang takes `(v > 0) ? v : 0` of a `v = max(0, x)` for v, which it is not
//! where x is NaN. Where what is best is no constant, it does not.

use super::entry::Entry;
use super::expression::Printer;
use super::leaves;
use crate::emit::interface::OutputView;
use crate::emit::layout;
use crate::emit::leaves::{LeafView, views};
use crate::emit::syntax::Syntax;
use crate::emit::team::{self, TeamView};
use crate::ir::{Module, Target, needed};
use crate::passes::schedule::Schedule;
use askama::Template;
use std::collections::BTreeSet;
use tpg_graph::ScalarType;

/// The minimum number of edges whose comparisons are worth functions.
const EDGES: usize = 32;

/// Tests for a graph whose bids are compared in functions: on a processor without doubles a comparison is a call, and with its
/// arguments and what follows from it, it takes most of the code of a team.
pub(crate) fn compares_in_functions(module: &Module<'_>) -> bool {
    let edges = module.teams.iter().map(|team| team.edges.len()).sum::<usize>();
    module.graph.scalar() == ScalarType::F64 && module.leaves.is_empty() && edges >= EDGES
}

#[derive(Template)]
#[template(path = "c/fast.c", escape = "none")]
struct Fast<'a> {
    entry: Entry,
    prefix: &'a str,
    upper: &'a str,
    scalar: &'a str,
    lowest: &'a str,
    leads: bool,
    functions: Vec<FunctionView>,
    outputs: &'a [OutputView],
    /// The leaves, where the only function computes them: its walks jump there.
    leaves: Vec<LeafView>,
    assignments: Vec<String>,
    /// The entry point over several functions that decide on a leaf.
    over_functions: String,
}

/// Some teams, one after another.
struct FunctionView {
    /// The numbers and labels of the teams that other functions lead to; empty if there is only one function.
    entries: Vec<(usize, u32)>,
    teams: Vec<TeamView<Jump>>,
    /// The number after its last team's.
    end: usize,
    reads_state: bool,
}

/// The vertex to return, if control leaves the function, and the label of what comes next.
struct Jump {
    vertex: Option<usize>,
    label: String,
}

/// Renders the body.
pub(super) fn render(
    printer: &Printer<'_>,
    module: &Module<'_>,
    schedule: &Schedule,
    functions: &[Vec<usize>],
    outputs: &[OutputView],
    upper: &str,
) -> String {
    let is_whole = functions.len() == 1;
    let (mut places, mut function_of) = (vec![0; module.teams.len()], vec![0; module.teams.len()]);
    functions.iter().flatten().zip(0..).for_each(|(&team, place)| places[team] = place);
    for (number, teams) in functions.iter().enumerate() {
        teams.iter().for_each(|&team| function_of[team] = number);
    }
    // Teams that other functions lead to.
    let mut entries = BTreeSet::from([0]);
    for (team, plan) in schedule.plans.iter().enumerate().filter(|_| !is_whole) {
        entries.extend(plan.targets.iter().filter_map(|&to| match to {
            Target::Team(to) if function_of[to] != function_of[team] => Some(to),
            _ => None,
        }));
    }
    let jump = |to: Target, from: &[usize]| match to {
        Target::Team(team) if from.contains(&team) => {
            Jump { vertex: None, label: format!("team_{}", module.teams[team].label) }
        }
        Target::Action(leaf) if is_whole && !module.leaves.is_empty() => {
            Jump { vertex: None, label: format!("leaf_{}", module.leaves[usize::from(leaf.0)].label) }
        }
        Target::Team(team) => Jump { vertex: Some(places[team]), label: "decided".to_owned() },
        Target::Action(action) => {
            let before = if is_whole { 0 } else { places.len() };
            Jump { vertex: Some(before + usize::from(action.0)), label: "decided".to_owned() }
        }
    };
    let mut printed: Vec<FunctionView> = Vec::new();
    for teams in functions {
        let entered = teams.iter().filter(|team| !is_whole && entries.contains(team));
        let values = teams.iter().flat_map(|&team| schedule.plans[team].values());
        let read = values.flat_map(|value| [needed(printer.nodes, value, |_| true), vec![value]].concat());
        printed.push(FunctionView {
            entries: entered.map(|&team| (places[team], module.teams[team].label)).collect(),
            teams: (teams.iter())
                .map(|&team| team::view(printer, &schedule.plans[team], |to| jump(to, teams)))
                .collect(),
            end: printed.last().map_or(0, |before| before.end) + teams.len(),
            reads_state: printer.reads_state(&read.collect::<Vec<_>>()),
        });
    }
    let (mut leaves, mut over_functions) = (Vec::new(), String::new());
    match &mut printed[..] {
        _ if outputs.is_empty() => {}
        [whole] => {
            leaves = views(printer, &schedule.leaves);
            whole.reads_state |= leaves.iter().any(|leaf| leaf.reads_state);
        }
        _ => over_functions = leaves::render(printer, &schedule.leaves, outputs),
    }
    let fast = Fast {
        entry: Entry::new(printer),
        prefix: printer.prefix,
        upper,
        scalar: printer.scalar(),
        lowest: printer.lowest(),
        leads: printer.leads,
        functions: printed,
        outputs,
        leaves,
        assignments: leaves::assignments(printer, outputs),
        over_functions,
    };
    layout::indent(&fast.render().expect("the template renders"))
}
