//! The profile `fast`: control goes from team to team, always forward, without a loop and without a table. Cheap bids are
//! computed; the others only where a bound says that they can still win. Where there are many teams, they are in several
//! functions.
//!
//! The best bid starts at the lowest finite number, and a NaN is never as high: so only bids above −∞ win, and where there
//! is none, the team's last edge is taken. No bid needs a test for NaN.
//!
//! A bid of 0 is read from a volatile variable where another may be `max(0, x)`: see [`Syntax::hides_zeros`].

use super::entry::Entry;
use super::expression::Printer;
use super::leaves;
use crate::emit::interface::OutputView;
use crate::emit::layout;
use crate::emit::leaves::{LeafView, views};
use crate::emit::names;
use crate::emit::syntax::Syntax;
use crate::emit::team::{self, Decision, Destinations, TeamView};
use crate::ir::{Module, Target};
use crate::passes::schedule::Schedule;
use Decision::*;
use Jump::*;
use Target::*;
use askama::Template;
use std::collections::BTreeSet;

#[derive(Template)]
#[template(path = "c/fast.c", escape = "none")]
struct CFast<'a> {
    entry: Entry,
    prefix: &'a str,
    upper: &'a str,
    scalar: &'a str,
    lowest: String,
    rule: &'a str,
    leads: bool,
    /// There is more than one team.
    has_order: bool,
    functions: Vec<CFunctionView>,
    outputs: &'a [OutputView],
    /// The leaves, where the only function computes them after its teams: its walks jump there.
    leaves: Vec<LeafView>,
    /// The only team computes the outputs itself.
    answers_in_place: bool,
    assignments: Vec<String>,
    /// The entry point over several functions that decide on a leaf.
    over_functions: String,
}

/// The rule of a choice, for readers.
const RULE: &str = "The highest bid wins, of equal bids the last; NaN and minus infinity never win.";

/// Some teams, one after another.
struct CFunctionView {
    head: String,
    /// The numbers and labels of the teams that other functions lead to; empty if there is only one function.
    entries: Vec<(usize, u32)>,
    teams: Vec<CTeamLines>,
    /// The labels that something goes to.
    gone_to: BTreeSet<String>,
    /// The number after its last team's.
    end: usize,
    reads_state: bool,
}

impl CFunctionView {
    fn is_entered(&self, team: &u32) -> bool {
        self.gone_to.contains(&format!("team_{team}")) || self.entries.iter().any(|(_, label)| label == team)
    }

    fn is_entered_leaf(&self, leaf: &u32) -> bool {
        self.gone_to.contains(&format!("leaf_{leaf}"))
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
enum Jump {
    /// At a label of the function.
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

/// The destinations of a function's teams.
struct Places<'a> {
    module: &'a Module<'a>,
    /// The names of the actions, and of the constants for them.
    names: &'a [String],
    constants: &'a [String],
    /// The teams of the function.
    teams: &'a [usize],
    /// The places of all teams in the order of functions.
    places: &'a [usize],
    is_whole: bool,
    /// The leaves that the only team computes itself.
    in_place: &'a [LeafView],
    outputs: &'a [OutputView],
}

impl Destinations for Places<'_> {
    type Jump = Jump;

    fn jump(&self, to: Target) -> Jump {
        match (self.answer(to), to) {
            (Some(answer), _) => Return(answer),
            (None, Team(team)) => Goto(format!("team_{}", self.module.teams[team].label)),
            (None, Action(leaf)) => match self.in_place.iter().find(|view| view.number == usize::from(leaf.0)) {
                Some(leaf) => Answer(answer(leaf, self.outputs)),
                None => Goto(format!("leaf_{}", self.module.leaves[usize::from(leaf.0)].label)),
            },
        }
    }

    fn answer(&self, to: Target) -> Option<String> {
        match to {
            Team(team) if self.teams.contains(&team) => None,
            Team(team) => Some(format!("{}U", self.places[team])),
            Action(_) if self.is_whole && !self.module.leaves.is_empty() => None,
            Action(action) if self.is_whole => Some(self.constants[usize::from(action.0)].clone()),
            Action(action) => Some(format!("{}U", self.places.len() + usize::from(action.0))),
        }
    }

    fn winner(&self) -> &'static str {
        if self.is_whole { "action" } else { "vertex" }
    }

    fn bid(&self, to: Target) -> String {
        match to {
            Team(team) => format!("to_team_{}", self.module.teams[team].label),
            Action(leaf) if !self.module.leaves.is_empty() => {
                format!("to_leaf_{}", self.module.leaves[usize::from(leaf.0)].label)
            }
            Action(action) => self.names[usize::from(action.0)].clone(),
        }
    }
}

/// The statements that compute a leaf's outputs.
fn answer(leaf: &LeafView, outputs: &[OutputView]) -> Vec<String> {
    let assignments = outputs.iter().zip(&leaf.values).map(|(output, value)| format!("{} = {value};", output.variable));
    leaf.statements.iter().cloned().chain(assignments).collect()
}

/// The statements after a team's bids; `follows` is the label of what stands next.
fn decision(decision: &Decision<Jump>, winner: &str, follows: Option<&str>) -> Vec<String> {
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
    printer: &Printer<'_>,
    module: &Module<'_>,
    schedule: &Schedule,
    functions: &[Vec<usize>],
    outputs: &[OutputView],
    upper: &str,
) -> String {
    let is_whole = functions.len() == 1;
    let answers_in_place = is_whole && module.teams.len() == 1 && !outputs.is_empty();
    let entry = Entry::new(printer);
    let names: Vec<String> = names::actions(printer.graph).iter().map(|name| printer.local(name)).collect();
    let constants = printer.constants();
    let (mut places, mut function_of) = (vec![0; module.teams.len()], vec![0; module.teams.len()]);
    functions.iter().flatten().zip(0..).for_each(|(&team, place)| places[team] = place);
    for (number, teams) in functions.iter().enumerate() {
        teams.iter().for_each(|&team| function_of[team] = number);
    }
    // Teams that other functions lead to.
    let mut entries = BTreeSet::from([0]);
    for (team, plan) in schedule.plans.iter().enumerate().filter(|_| !is_whole) {
        entries.extend(plan.targets.iter().filter_map(|&to| match to {
            Team(to) if function_of[to] != function_of[team] => Some(to),
            _ => None,
        }));
    }
    let mut leaves = if is_whole { views(printer, &schedule.leaves, outputs, true) } else { Vec::new() };
    let in_place = if answers_in_place { std::mem::take(&mut leaves) } else { Vec::new() };
    let mut printed: Vec<CFunctionView> = Vec::new();
    for (number, teams) in functions.iter().enumerate() {
        let to = Places {
            module,
            names: &names,
            constants: &constants,
            teams,
            places: &places,
            is_whole,
            in_place: &in_place,
            outputs,
        };
        let labels = teams.iter().map(|&team| format!("team_{}", module.teams[team].label));
        let labels: Vec<String> = labels.chain(leaves.first().map(|leaf| format!("leaf_{}", leaf.label))).collect();
        let line = |(place, &team): (usize, &usize)| {
            let view = team::view(printer, &schedule.plans[team], &to);
            let decision = decision(&view.decision, view.winner, labels.get(place + 1).map(String::as_str));
            let is_action = is_whole && matches!(view.decision, Winner);
            CTeamLines {
                keeps_winner: matches!(view.decision, Winner | Ways(_)),
                winner_type: if is_action { entry.action.clone() } else { "uint32_t".to_owned() },
                view,
                decision,
            }
        };
        let lines: Vec<CTeamLines> = teams.iter().enumerate().map(line).collect();
        let gotos = lines.iter().flat_map(|team| &team.decision).filter_map(|line| line.strip_prefix("goto "));
        let entered = teams.iter().filter(|team| !is_whole && entries.contains(team));
        let answers = leaves.iter().chain(&in_place).any(|leaf| leaf.reads_state);
        let values: Vec<_> = teams.iter().flat_map(|&team| schedule.plans[team].values()).collect();
        printed.push(CFunctionView {
            head: match is_whole {
                true => entry.head.clone(),
                false => format!(
                    "static uint32_t {}_walk_{number}(const {} *state, uint32_t start)",
                    printer.prefix, entry.state
                ),
            },
            gone_to: gotos.map(|label| label.trim_end_matches(';').to_owned()).collect(),
            entries: entered.map(|&team| (places[team], module.teams[team].label)).collect(),
            end: printed.last().map_or(0, |before| before.end) + teams.len(),
            reads_state: answers || printer.reads_state(&values),
            teams: lines,
        });
    }
    let over_functions = match is_whole || outputs.is_empty() {
        true => String::new(),
        false => leaves::render(printer, &schedule.leaves, outputs),
    };
    let fast = CFast {
        entry,
        prefix: printer.prefix,
        upper,
        scalar: printer.scalar(),
        lowest: printer.lowest(),
        rule: RULE,
        leads: printer.leads,
        has_order: module.teams.len() > 1,
        functions: printed,
        outputs,
        leaves,
        answers_in_place,
        assignments: leaves::assignments(printer, outputs),
        over_functions,
    };
    layout::indent(&fast.render().expect("the template renders"))
}
