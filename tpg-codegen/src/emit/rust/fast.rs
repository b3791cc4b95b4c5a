//! The profile `fast`: a function for each team, which ends by calling the next: a jump, where a compiler optimises. Cheap
//! bids are computed; the others only where a bound says that they can still win.
//!
//! The best bid starts at the lowest finite number, and a NaN is never as high: so only bids above −∞ win, and where there
//! is none, nobody wins, which is how the team's last edge does. No bid needs a test for NaN.
//!
//! A bid of 0 goes through `black_box`: LLVM 22 takes `if v > 0 { v } else { 0 }` of a `v = max(0, x)` for v, which it is not
//! where x is NaN. Where what is best is no constant, it does not.

use super::expression::Printer;
use super::leaves;
use super::{Parts, helpers};
use crate::emit::interface::OutputView;
use crate::emit::layout;
use crate::emit::leaves::{LeafView, views};
use crate::emit::syntax::Syntax;
use crate::emit::team::{self, TeamView};
use crate::ir::{Module, Target};
use crate::passes::schedule::Schedule;
use askama::Template;

/// Above this number of teams, none is inlined: LLVM would inline every team that has one caller, and its passes take
/// superlinear time on the result.
const MANY: usize = 64;

#[derive(Template)]
#[template(path = "rust/fast.rs", escape = "none")]
struct Fast<'a> {
    scalar: &'a str,
    state_length: usize,
    many: bool,
    /// The type of an answer.
    answer: String,
    leaves: Vec<LeafView>,
    teams: Vec<TeamView<String>>,
    helpers: String,
}

/// Renders the profile.
pub(super) fn render(printer: &Printer<'_>, module: &Module<'_>, schedule: &Schedule, outputs: &[OutputView]) -> Parts {
    // The decision at a target.
    let decided = |target: Target| match target {
        Target::Team(team) => format!("team_{}(s)", module.teams[team].label),
        Target::Action(leaf) if !module.leaves.is_empty() => {
            format!("leaf_{}(s)", module.leaves[usize::from(leaf.0)].label)
        }
        Target::Action(action) => action.0.to_string(),
    };
    let root = format!("team_{}(s)", schedule.plans[0].label);
    let (body, answer) = if outputs.is_empty() {
        (format!("        ActionId({root})"), "u16".to_owned())
    } else {
        let limited = leaves::limited(printer, outputs, leaves::element);
        (format!("        let out = {root};\n        {limited}"), format!("[{}; {}]", printer.scalar(), outputs.len()))
    };
    let fast = Fast {
        scalar: printer.scalar(),
        state_length: printer.graph.state_length(),
        many: schedule.plans.len() > MANY,
        answer,
        leaves: views(printer, &schedule.leaves),
        teams: schedule.plans.iter().map(|plan| team::view(printer, plan, decided)).collect(),
        helpers: helpers::render(printer),
    };
    Parts { body, items: layout::indent(&fast.render().expect("the template renders")) }
}
