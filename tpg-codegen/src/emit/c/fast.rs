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

use super::expression::Printer;
use crate::emit::layout;
use crate::graph::ScalarType;
use crate::ir::{Module, Node, NodeId, Target, needed, topological};
use crate::passes::schedule::{Bid, Infinite, LazyBid, Plan, Schedule, Sparing};
use askama::Template;
use std::collections::BTreeSet;

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

/// The bids of a team that may lead without having been computed.
struct LateTeamView {
    label: u32,
    bids: Vec<LateView>,
    reads_state: bool,
}

/// Some teams, one after another.
struct FunctionView {
    /// How to come to a team from another function; none where there is only one.
    entries: Vec<EntryView>,
    teams: Vec<TeamView>,
    /// The number after its last team's.
    end: usize,
    reads_state: bool,
}

struct EntryView {
    number: String,
    label: u32,
}

struct TeamView {
    label: u32,
    /// Whether control comes to it from elsewhere: not to the root.
    is_entered: bool,
    /// The variable that holds the winner: the way it goes, or its place.
    winner: &'static str,
    nobody: String,
    /// What is asked first: the condition under which a bid is infinite, and its rank.
    infinite: Option<InfiniteView>,
    eager: Vec<EagerView>,
    eager_before: Vec<EagerView>,
    lazy: Vec<LazyView>,
    /// Where the edges lead; the last is where nobody's win leads.
    ways: Vec<WayView>,
}

struct WayView {
    condition: String,
    /// What is decided, where control leaves the function.
    vertex: Option<String>,
    label: String,
}

struct InfiniteView {
    statements: Vec<String>,
    condition: String,
    rank: String,
}

struct EagerView {
    statements: Vec<String>,
    value: String,
    rank: String,
    in_turn: bool,
    /// Whether no bid follows: then, what is best does not matter any more.
    last: bool,
}

/// A bid that may lead without having been computed.
struct LateView {
    rank: String,
    statements: Vec<String>,
    value: String,
}

struct LazyView {
    before: Vec<String>,
    /// Whether to look at it at all.
    considered: Option<String>,
    bound_statements: Vec<String>,
    /// The ends of what it can be, where it need not be computed to win.
    ends: Option<(String, String)>,
    /// Certain to win.
    sure: String,
    /// What is the highest that the leader can bid.
    top: &'static str,
    /// Whether the leader may not have been computed yet.
    pending: bool,
    /// Whether this is the first that can win without being computed.
    first: bool,
    /// None where it must be looked at whatever the others bid.
    guard: Option<String>,
    statements: Vec<String>,
    value: String,
    rank: String,
    wins: String,
    last: bool,
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

struct TeamPrinter<'a> {
    printer: &'a Printer<'a>,
    module: &'a Module,
    plan: &'a Plan,
    span: &'a Span<'a>,
    /// Where edges lead, each once; the last is where the last edge does.
    targets: Vec<Target>,
    /// Whether every bid is looked at in turn: then, the way that the winner goes is enough to know.
    in_turn: bool,
    computed: BTreeSet<NodeId>,
    reads_state: bool,
    /// Whether the leader may be a bid that was not computed.
    pending: bool,
}

impl<'a> TeamPrinter<'a> {
    fn new(printer: &'a Printer<'a>, module: &'a Module, plan: &'a Plan, span: &'a Span<'a>) -> Self {
        let in_turn = plan.infinite.is_none() && plan.bids().all(|bid| bid.in_turn);
        let in_turn = in_turn && plan.lazy.iter().all(|lazy| lazy.certain.is_none());
        let targets = plan.destinations();
        let (computed, reads_state, pending) = (BTreeSet::new(), false, false);
        Self { printer, module, plan, span, targets, in_turn, computed, reads_state, pending }
    }

    fn view(&mut self, is_entered: bool) -> TeamView {
        let (mut eager, mut eager_before, mut lazy) = (Vec::new(), Vec::new(), Vec::new());
        let mut infinite = None;
        // With one way to go, no bid matters.
        if self.targets.len() > 1 {
            infinite = self.plan.infinite.as_ref().map(|infinite| self.infinite(infinite));
            eager.extend(self.plan.eager.iter().map(|bid| self.eager(bid)));
            eager_before.extend(
                self.in_braces(|team| team.plan.eager_before.iter().map(|bid| team.eager(bid)).collect::<Vec<_>>()),
            );
            lazy.extend(self.plan.lazy.iter().map(|lazy| self.lazy(lazy)));
            self.reads_state |= self.pending;
        }
        match (lazy.last_mut(), eager.last_mut()) {
            (Some(LazyView { last, .. }), _) | (None, Some(EagerView { last, .. })) => *last = true,
            (None, None) => {}
        }
        TeamView {
            label: self.plan.label,
            is_entered,
            winner: if self.in_turn { "way" } else { "edge" },
            nobody: if self.in_turn { format!("{}U", self.targets.len()) } else { "0U".to_owned() },
            infinite,
            eager,
            eager_before,
            lazy,
            ways: self.targets.iter().map(|&target| self.way(target)).collect(),
        }
    }

    /// When to go to a target, and how.
    fn way(&self, target: Target) -> WayView {
        let condition = if self.in_turn {
            format!("way == {}", self.number(target))
        } else {
            let leads_there = |&(_, &to): &(usize, &Target)| to == target;
            let places: Vec<String> = (self.plan.targets.iter().enumerate().filter(leads_there))
                .map(|(place, _)| format!("edge == {}U", place + 1))
                .collect();
            if let [place] = &places[..] { place.clone() } else { format!("({})", places.join(") || (")) }
        };
        let Span { places, start, end, whole } = *self.span;
        let (vertex, label) = match target {
            Target::Team(team) if (start..end).contains(&places[team]) => {
                (None, format!("team_{}", self.module.teams[team].label))
            }
            Target::Team(team) => (Some(places[team]), "decided".to_owned()),
            Target::Action(action) => {
                let before = if whole { 0 } else { places.len() };
                (Some(before + usize::from(action.0)), "decided".to_owned())
            }
        };
        WayView { condition, vertex: vertex.map(|vertex| format!("{vertex}U")), label }
    }

    /// The number of a way: counted from 1.
    fn number(&self, target: Target) -> String {
        let place = self.targets.iter().position(|&other| other == target).unwrap_or_default();
        format!("{}U", place + 1)
    }

    fn rank(&self, bid: &Bid) -> String {
        if self.in_turn { self.number(self.plan.targets[bid.place]) } else { format!("{}U", bid.place + 1) }
    }

    /// What is computed meanwhile is not there afterwards.
    fn in_braces<T>(&mut self, print: impl FnOnce(&mut Self) -> T) -> T {
        let outside = self.computed.clone();
        let printed = print(self);
        self.computed = outside;
        printed
    }

    fn infinite(&mut self, infinite: &Infinite) -> InfiniteView {
        let statements = self.statements(infinite.argument, true);
        let argument = self.printer.value(infinite.argument);
        let condition = format!("{argument} > {}", self.printer.constant(infinite.above));
        InfiniteView { statements, condition, rank: format!("{}U", infinite.place + 1) }
    }

    fn eager(&mut self, bid: &Bid) -> EagerView {
        let mut statements = self.statements(bid.value, true);
        let mut value = self.printer.value(bid.value);
        if self.printer.nodes[bid.value.index()].as_constant() == Some(0.0) {
            let scalar = self.printer.scalar();
            statements.push(format!("const volatile {scalar} constant = {value};"));
            statements.push(format!("const {scalar} zero = constant;"));
            value = "zero".to_owned();
        }
        EagerView { statements, value, rank: self.rank(bid), in_turn: bid.in_turn, last: false }
    }

    fn lazy(&mut self, lazy: &LazyBid) -> LazyView {
        let before = lazy.sparing.map(|sparing| self.statements(sparing.argument, true)).unwrap_or_default();
        let considered = self.considered(lazy);
        let mut view = match considered {
            Some(_) => self.in_braces(|team| team.looked_at(lazy, considered)),
            None => self.looked_at(lazy, None),
        };
        view.before = before;
        view
    }

    /// What must hold for a bid to be worth its bound.
    fn considered(&mut self, lazy: &LazyBid) -> Option<String> {
        let before = lazy.before_infinite.then(|| {
            let infinity = self.printer.constant(f64::INFINITY);
            format!("(best < {infinity}) || (edge < {})", self.rank(&lazy.bid))
        });
        let spared = lazy.sparing.map(|Sparing { argument, at_most, below }| {
            let [at_most, below] = [at_most, below].map(|number| self.printer.constant(number));
            format!("!(({} <= {at_most}) && (best >= {below}))", self.printer.value(argument))
        });
        match (before, spared) {
            (Some(before), Some(spared)) => Some(format!("({before}) && {spared}")),
            (before, spared) => before.or(spared),
        }
    }

    fn looked_at(&mut self, lazy: &LazyBid, considered: Option<String>) -> LazyView {
        let LazyBid { bid, bound, certain, .. } = lazy;
        let rank = self.rank(bid);
        let mut bound_statements = bound.map(|bound| self.statements(bound, true)).unwrap_or_default();
        bound_statements.extend(certain.iter().flat_map(|&certain| self.statements(certain, true)));
        let pending = self.pending;
        let top = if pending { "top" } else { "best" };
        let sure = certain.map(|certain| self.wins(bid, &rank, &self.printer.value(certain), top));
        let ends = certain.zip(*bound).map(|(low, high)| (self.printer.value(low), self.printer.value(high)));
        self.pending |= certain.is_some();
        let infinity = self.printer.constant(f64::INFINITY);
        let guard = match bound {
            // Also where the bound is NaN and says nothing.
            Some(bound) => {
                let bound = self.printer.value(*bound);
                Some(if bid.in_turn {
                    format!("!(best > {bound})")
                } else {
                    format!("!((best > {bound}) || ((best >= {bound}) && (edge >= {rank})))")
                })
            }
            // Nothing is higher than infinity; in turn, what is as high wins; and it may have been asked already.
            None if bid.in_turn || lazy.before_infinite => None,
            None => Some(format!("(best < {infinity}) || (edge < {rank})")),
        };
        let (statements, value) = if certain.is_some() {
            (Vec::new(), "bid".to_owned())
        } else {
            (self.statements(bid.value, false), self.printer.value(bid.value))
        };
        let wins = self.wins(bid, &rank, &value, if certain.is_some() && pending { "lead" } else { "best" });
        LazyView {
            before: Vec::new(),
            considered,
            bound_statements,
            ends,
            sure: sure.unwrap_or_default(),
            top,
            pending,
            first: certain.is_some() && !pending,
            guard,
            statements,
            value,
            rank,
            wins,
            last: false,
        }
    }

    /// Whether a value of a bid makes it the leader.
    fn wins(&self, bid: &Bid, rank: &str, value: &str, best: &str) -> String {
        if bid.in_turn {
            format!("{value} >= {best}")
        } else {
            format!("({value} >= {best}) && (({value} > {best}) || (edge < {rank}))")
        }
    }

    /// The bids that may lead without having been computed, each with all that it needs.
    fn late_team(&self) -> Option<LateTeamView> {
        let bids: Vec<LateView> = (self.plan.lazy.iter().filter(|lazy| lazy.certain.is_some()))
            .map(|lazy| {
                let value = lazy.bid.value;
                let needed = needed(self.printer.nodes, value, |_| true);
                LateView {
                    rank: self.rank(&lazy.bid),
                    statements: needed.iter().map(|&id| self.printer.statement(id)).collect(),
                    value: self.printer.value(value),
                }
            })
            .collect();
        let reads = |text: &String| text.contains("state->");
        let reads_state = bids.iter().any(|bid| reads(&bid.value) || bid.statements.iter().any(reads));
        (self.targets.len() > 1 && !bids.is_empty()).then_some(LateTeamView {
            label: self.plan.label,
            bids,
            reads_state,
        })
    }

    /// What must still be computed for a value; later bids can use it where it `stays`.
    fn statements(&mut self, value: NodeId, stays: bool) -> Vec<String> {
        let missing = needed(self.printer.nodes, value, |id| !self.computed.contains(&id));
        let nodes = self.printer.nodes;
        let is_input = |id: NodeId| matches!(nodes[id.index()], Node::Input(_));
        self.reads_state |=
            is_input(value) || missing.iter().any(|id| nodes[id.index()].operands().iter().any(|&id| is_input(id)));
        let statements = missing.iter().map(|&id| self.printer.statement(id)).collect();
        if stays {
            self.computed.extend(missing);
        }
        statements
    }
}
