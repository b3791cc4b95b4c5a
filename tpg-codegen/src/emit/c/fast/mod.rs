//! The profile `fast`: control goes from team to team, always forward, without a loop and without a table. Cheap bids are
//! computed; the others only where a bound says that they can still win.
//!
//! Compilers share what a team computes with the teams behind it, for all are in one function. Where there are many, they
//! are in several: some passes of compilers take more than linear time in the size of a function.
//!
//! The best bid starts at the lowest finite number, and a NaN is never as high: so only bids above −∞ win, and where there
//! is none, nobody wins, which is how the team's last edge does. No bid needs a test for NaN.
//!
//! A bid of 0 is read from a volatile variable: clang takes `(v > 0) ? v : 0` of a `v = max(0, x)` for v, which it is not
//! where x is NaN. Where what is best is no constant, it does not.

mod team;
mod view;

use super::expression::Printer;
use crate::emit::layout;
use crate::graph::ScalarType;
use crate::ir::{Module, topological};
use crate::passes::schedule::Schedule;
use askama::Template;
use team::TeamPrinter;
use view::{EntryView, FunctionView, LateTeamView};

/// Teams of one function, where all are in it.
const TEAMS: usize = 64;
/// Teams of one function, where there are more.
const SOME_TEAMS: usize = 32;

#[derive(Template)]
#[template(path = "c/fast.c", escape = "none")]
struct Fast<'a> {
    prefix: &'a str,
    upper: &'a str,
    scalar: &'a str,
    lowest: &'a str,
    infinity: String,
    /// For teams with bids that may lead without having been computed.
    late: Vec<LateTeamView>,
    functions: Vec<FunctionView>,
}

/// Renders the body.
pub(super) fn render(printer: &Printer<'_>, module: &Module, schedule: &Schedule, upper: &str) -> String {
    let order = topological(&module.teams);
    let mut places = vec![0; order.len()];
    for (place, &team) in order.iter().enumerate() {
        places[team] = place;
    }
    let mut late = Vec::new();
    let several = if order.len() <= TEAMS { TEAMS } else { SOME_TEAMS };
    let functions = (order.chunks(several).zip((0..).step_by(several)))
        .map(|(teams, start)| {
            let whole = teams.len() == order.len();
            let span = Span { places: &places, start, end: start + teams.len(), whole };
            let mut reads_state = false;
            let entries = teams
                .iter()
                .filter(|_| !whole)
                .map(|&team| EntryView { number: format!("{}U", places[team]), label: module.teams[team].label });
            let entries = entries.collect();
            let teams = teams.iter().map(|&team| {
                let mut printed = TeamPrinter::new(printer, module, &schedule.plans[team], &span);
                let view = printed.view(!whole || team != 0);
                reads_state |= printed.reads_state;
                late.extend(printed.late_team());
                view
            });
            let teams = teams.collect();
            FunctionView { entries, teams, end: span.end, reads_state }
        })
        .collect();
    let fast = Fast {
        prefix: printer.prefix,
        upper,
        scalar: printer.scalar(),
        lowest: if printer.graph.scalar() == ScalarType::F32 { "FLT_MAX" } else { "DBL_MAX" },
        infinity: printer.constant(f64::INFINITY),
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
    /// Whether these are all teams there are.
    whole: bool,
}
