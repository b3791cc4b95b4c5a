//! The profile `fast`: control goes from team to team, always forward, without a loop and without a table. Cheap bids are
//! computed; the others only where a bound says that they can still win.
//!
//! The best bid starts at the lowest finite number, and a NaN is never as high: so only bids above −∞ win, and where there
//! is none, the team's last edge is taken. No bid needs a test for NaN.
//!
//! A bid of 0 is read from a volatile variable where another may be `max(0, x)`: see [`Syntax::hides_zeros`].

use super::expression::CPrinter;
use super::leaves;
use crate::emit::interface::OutputView;
use crate::emit::layout;
use crate::emit::leaves::{LeafView, views};
use crate::emit::names;
use crate::emit::syntax::Syntax;
use crate::emit::team::{self, Destinations, TeamDecision, TeamView};
use crate::ir::{Module, NodeId, Successor, topological};
use crate::passes::schedule::{Schedule, TeamSchedule};
use Jump::*;
use Successor::*;
use TeamDecision::*;
use askama::Template;

#[derive(Template)]
#[template(path = "c/fast.c", escape = "none")]
struct CFast<'a> {
    printer: &'a CPrinter<'a>,
    rule: &'a str,
    leads: bool,
    teams: Vec<CTeamLines>,
    reads_state: bool,
    outputs: &'a [OutputView],
    /// The leaves, which are computed after the teams: walks jump there.
    leaves: Vec<LeafView>,
    /// The only team computes the outputs itself.
    answers_in_place: bool,
    assignments: Vec<String>,
}

/// The rule of a choice, for readers.
const RULE: &str = "The highest bid wins; of equal bids, the last. NaN and minus infinity never win.";

impl CFast<'_> {
    /// Tests for a label that something goes to.
    fn is_entered(&self, kind: &str, label: &u32) -> bool {
        let jump = format!("goto {kind}_{label};");
        self.teams.iter().flat_map(|team| &team.decision).any(|line| *line == jump)
    }
}

/// A team, and the statements that go on from it.
struct CTeamLines {
    view: TeamView<Jump>,
    /// The winner has a variable.
    keeps_winner: bool,
    winner_type: String,
    decision: Vec<String>,
}

/// The way to go on.
pub(super) enum Jump {
    /// At a label.
    Goto(String),
    /// Out of the function, with its result.
    Return(String),
    /// By the statements that compute the outputs.
    Answer(Vec<String>),
}

impl Jump {
    /// Tests for what comes next in any case.
    fn is(&self, label: Option<&str>) -> bool {
        matches!(self, Self::Goto(to) if Some(&**to) == label)
    }

    fn lines(&self) -> Vec<String> {
        match self {
            Self::Goto(label) => vec![format!("goto {label};")],
            Self::Return(value) => vec![format!("return {value};")],
            Self::Answer(lines) => lines.clone(),
        }
    }
}

/// The statements that compute a leaf's outputs.
fn answer(leaf: &LeafView, outputs: &[OutputView]) -> Vec<String> {
    let assignments = outputs.iter().zip(&leaf.values).map(|(output, value)| format!("{} = {value};", output.variable));
    leaf.statements.iter().cloned().chain(assignments).collect()
}

/// The statements after a team's bids; `follows` is the label of what stands next.
fn decision(decision: &TeamDecision<Jump>, winner: &str, follows: Option<&str>) -> Vec<String> {
    /// The longest choice on a line of its own.
    const LONGEST: usize = 96;
    let on = |condition: &str, lines: Vec<String>| {
        [vec![format!("if ({condition}) {{")], lines, vec!["}".to_owned()]].concat()
    };
    let last = |jump: &Jump| if jump.is(follows) { Vec::new() } else { jump.lines() };
    match decision {
        Always(jump) => last(jump),
        Winner => vec![format!("return {winner};")],
        Either(condition, Return(first), Return(second))
            if condition.len() + first.len() + second.len() < LONGEST - 16 =>
        {
            vec![format!("return ({condition}) ? {first} : {second};")]
        }
        Either(condition, first @ Answer(_), second) => {
            let mut lines = on(condition, first.lines());
            lines.pop();
            [lines, vec!["} else {".to_owned()], second.lines(), vec!["}".to_owned()]].concat()
        }
        Either(condition, first, second) if first.is(follows) => on(&format!("!({condition})"), second.lines()),
        Either(condition, first, second) => [on(condition, first.lines()), last(second)].concat(),
        Ways(ways) => {
            let condition = |ranks: &[String]| match ranks {
                [rank] => format!("{winner} == {rank}"),
                _ => ranks.iter().map(|rank| format!("({winner} == {rank})")).collect::<Vec<_>>().join(" || "),
            };
            // What stands next is gone to where nothing else is.
            let at = ways.iter().position(|(_, jump)| jump.is(follows)).unwrap_or(ways.len() - 1);
            let others = ways.iter().enumerate().filter(|(place, _)| *place != at).map(|(_, way)| way);
            if matches!(ways[at].1, Answer(_)) {
                let mut lines = Vec::new();
                for (ranks, jump) in others {
                    let opening = if lines.is_empty() { "" } else { "} else " };
                    lines.push(format!("{opening}if ({}) {{", condition(ranks)));
                    lines.extend(jump.lines());
                }
                return [lines, vec!["} else {".to_owned()], ways[at].1.lines(), vec!["}".to_owned()]].concat();
            }
            let tested = others.flat_map(|(ranks, jump)| on(&condition(ranks), jump.lines()));
            tested.chain(last(&ways[at].1)).collect()
        }
    }
}

/// Renders the body.
pub(super) fn render(
    printer: &CPrinter<'_>,
    module: &Module<'_>,
    schedule: &Schedule,
    outputs: &[OutputView],
) -> String {
    let mut leaves = views(printer, &schedule.leaves, outputs, true);
    // The only team computes its leaves itself.
    let in_place = if module.teams.len() == 1 { std::mem::take(&mut leaves) } else { Vec::new() };
    let values = schedule.plans.iter().flat_map(TeamSchedule::values).collect();
    let walk = Walk { printer, module, rule: RULE, place: "uint32_t", values, outputs, leaves, in_place };
    walk.text(|team, to| team::view(printer, &schedule.plans[team], to))
}

/// Teams, and the leaves behind them.
pub(super) struct Walk<'a> {
    pub(super) printer: &'a CPrinter<'a>,
    pub(super) module: &'a Module<'a>,
    pub(super) rule: &'a str,
    /// The type of the place of a winner.
    pub(super) place: &'a str,
    /// The values that teams compute.
    pub(super) values: Vec<NodeId>,
    /// The outputs that leaves leave in variables.
    pub(super) outputs: &'a [OutputView],
    /// The leaves that walks jump to, and those that the only team computes.
    pub(super) leaves: Vec<LeafView>,
    pub(super) in_place: Vec<LeafView>,
}

impl Walk<'_> {
    /// Renders the body, with a team as a function views it.
    pub(super) fn text(self, view: impl Fn(usize, &Destinations<'_, Jump>) -> TeamView<Jump>) -> String {
        let Self { printer, module, rule, place: winner_place, values, outputs, leaves, in_place } = self;
        let names = names::actions(printer.graph).iter().map(|name| printer.local(name)).collect();
        let jump = |to, way| match (way, to) {
            (Err(answer), _) => Return(answer),
            (Ok(label), Team(_)) => Goto(label),
            (Ok(label), Action(leaf)) => match in_place.iter().find(|view| view.number == usize::from(leaf.0)) {
                Some(leaf) => Answer(answer(leaf, outputs)),
                None => Goto(label),
            },
        };
        let to = Destinations { module, names, answers: printer.constants(), jump: &jump };
        // What a team leads to comes after it.
        let order = topological(&module.teams);
        let labels = order.iter().map(|&team| format!("team_{}", module.teams[team].label));
        let labels: Vec<String> = labels.chain(leaves.first().map(|leaf| format!("leaf_{}", leaf.label))).collect();
        let action = printer.entry().action;
        let line = |(place, &team): (usize, &usize)| {
            let view = view(team, &to);
            let decision = decision(&view.decision, view.winner, labels.get(place + 1).map(String::as_str));
            let is_action = matches!(view.decision, Winner);
            CTeamLines {
                keeps_winner: matches!(view.decision, Winner | Ways(_)),
                winner_type: if is_action { action.clone() } else { winner_place.to_owned() },
                view,
                decision,
            }
        };
        let teams = order.iter().enumerate().map(line).collect();
        let fast = CFast {
            printer,
            rule,
            leads: printer.leads,
            teams,
            reads_state: leaves.iter().chain(&in_place).any(|leaf| leaf.reads_state) || printer.reads_state(&values),
            outputs,
            answers_in_place: !in_place.is_empty(),
            leaves,
            assignments: leaves::assignments(printer, outputs),
        };
        layout::indent(&fast.render().expect("the template renders"))
    }
}
