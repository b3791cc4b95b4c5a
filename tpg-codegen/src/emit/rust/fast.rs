//! The profile `fast`: a function for each team, which ends by calling the next: a jump, where a compiler optimises. Cheap
//! bids are computed; the others only where a bound says that they can still win.
//!
//! The best bid starts at the lowest finite number, and a NaN is never as high: so only bids above −∞ win, and where there
//! is none, the team's last edge is taken. No bid needs a test for NaN.
//!
//! A bid of 0 goes through `black_box` where another may be `max(0, x)`: see [`Syntax::hides_zeros`].

use super::expression::RustPrinter;
use super::helpers;
use super::leaves;
use super::parts::Parts;
use crate::emit::interface::OutputView;
use crate::emit::layout;
use crate::emit::leaves::{LeafView, views};
use crate::emit::names;
use crate::emit::syntax::Syntax;
use crate::emit::team::{self, Destinations, TeamDecision, TeamView};
use crate::ir::Module;
use crate::passes::schedule::Schedule;
use askama::Template;

/// Above this number of teams, none is inlined: LLVM would inline every team that has one caller, and its passes take
/// superlinear time on the result.
const MANY: usize = 64;

#[derive(Template)]
#[template(path = "rust/fast.rs", escape = "none")]
pub(super) struct RustFast<'a> {
    scalar: &'a str,
    state_length: usize,
    many: bool,
    leads: bool,
    /// The type of an answer.
    answer: String,
    leaves: Vec<LeafView>,
    teams: Vec<TeamView<String>>,
}

/// Renders the profile.
pub(super) fn render(
    printer: &RustPrinter<'_>,
    module: &Module<'_>,
    schedule: &Schedule,
    outputs: &[OutputView],
) -> Parts {
    let scalar = printer.scalar();
    let answer = match outputs.len() {
        0 => "u16".to_owned(),
        count => format!("[{scalar}; {count}]"),
    };
    let leaves = views(printer, &schedule.leaves, outputs, false);
    let view = |team: usize, to: &Destinations<'_, String>| team::view(printer, &schedule.plans[team], to);
    let (decision, items) = RustFast::text(printer, module, scalar, answer, leaves, view);
    let body = match outputs {
        [] => decision,
        _ => format!("let out = {decision};\n        {}", leaves::limited(printer, outputs, leaves::element)),
    };
    Parts {
        body: format!("        {body}"),
        items: layout::indent(&(helpers::render(printer, &items) + "\n" + &items)),
    }
}

impl<'a> RustFast<'a> {
    /// Renders the expression that decides and the functions that it calls, with a team as a function views it.
    pub(super) fn text(
        printer: &RustPrinter<'_>,
        module: &Module<'_>,
        scalar: &'a str,
        answer: String,
        leaves: Vec<LeafView>,
        view: impl Fn(usize, &Destinations<'_, String>) -> TeamView<String>,
    ) -> (String, String) {
        let actions = names::actions(printer.graph);
        let to = Destinations {
            module,
            answers: (0..actions.len()).map(|action| action.to_string()).collect(),
            names: actions.iter().map(|name| printer.local(name)).collect(),
            jump: &|_, to| to.map_or_else(|answer| answer, |label| format!("{label}(s)")),
        };
        let root = format!("team_{}(s)", module.teams[0].label);
        let decision = if leaves.is_empty() { format!("ActionId({root})") } else { root };
        let fast = RustFast {
            scalar,
            state_length: printer.graph.state_length(),
            many: module.teams.len() > MANY,
            leads: printer.leads,
            answer,
            leaves,
            teams: (0..module.teams.len()).map(|team| view(team, &to)).collect(),
        };
        (decision, fast.render().expect("the template renders"))
    }
}
