//! The profile `fast`: a function for each team, which ends by calling the next: a jump, where a compiler optimises. Cheap
//! bids are computed; the others only where a bound says that they can still win.
//!
//! The best bid starts at the lowest finite number, and a NaN is never as high: so only bids above −∞ win, and where there
//! is none, nobody wins, which is how the team's last edge does. No bid needs a test for NaN.
//!
//! A bid of 0 goes through `black_box`: LLVM 22 takes `if v > 0 { v } else { 0 }` of a `v = max(0, x)` for v, which it is not
//! where x is NaN. Where what is best is no constant, it does not.

use super::expression::Printer;
use super::leaves::{self, LeafView};
use super::{Parts, helpers};
use crate::emit::interface::OutputView;
use crate::emit::reuse::Reuse;
use crate::emit::syntax::Syntax;
use crate::emit::{layout, questions};
use crate::ir::{Module, NodeId, Target};
use crate::passes::schedule::{Bid, Infinite, LazyBid, Schedule, TeamSchedule};
use askama::Template;
use std::collections::BTreeSet;

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
    teams: Vec<TeamView>,
    helpers: String,
}

struct TeamView {
    label: u32,
    /// The variable that holds the winner: the way it goes, or its place.
    winner: &'static str,
    nobody: usize,
    /// The first bid, where it is a number: it leads without a test.
    first: Option<BidView>,
    infinite: Option<InfiniteView>,
    eager: Vec<BidView>,
    eager_before: Vec<BidView>,
    lazy: Vec<BidView>,
    /// The edges' destinations, by way or place; the last is taken if no bid wins.
    ways: Vec<(usize, String)>,
}

/// The bid that is tested first, for infinity.
struct InfiniteView {
    statements: Vec<String>,
    condition: String,
    rank: usize,
}

#[derive(Default)]
struct BidView {
    before: Vec<String>,
    /// The condition for evaluating even the bound.
    considered: Option<String>,
    bound_statements: Vec<String>,
    guard: Option<String>,
    statements: Vec<String>,
    value: String,
    rank: usize,
    wins: String,
}

/// Renders the profile.
pub(super) fn render(printer: &Printer<'_>, module: &Module<'_>, schedule: &Schedule, outputs: &[OutputView]) -> Parts {
    let teams: Vec<TeamView> =
        schedule.plans.iter().map(|plan| TeamPrinter::new(printer, module, plan).view()).collect();
    let scalar = printer.graph.scalar().name();
    let root = format!("team_{}(s)", schedule.plans[0].label);
    let (body, answer) = if outputs.is_empty() {
        (format!("        ActionId({root})"), "u16".to_owned())
    } else {
        let limited = leaves::limited(printer, outputs, leaves::element);
        (format!("        let out = {root};\n        {limited}"), format!("[{scalar}; {}]", outputs.len()))
    };
    let fast = Fast {
        scalar,
        answer,
        leaves: leaves::views(printer, &schedule.leaves),
        state_length: printer.graph.state_length(),
        many: teams.len() > MANY,
        teams,
        helpers: helpers::render(printer),
    };
    Parts { body, items: layout::indent(&fast.render().expect("the template renders")) }
}

struct TeamPrinter<'a> {
    printer: &'a Printer<'a>,
    module: &'a Module<'a>,
    plan: &'a TeamSchedule,
    /// The distinct destinations of the edges; the last is the last edge's.
    targets: Vec<Target>,
    /// All bids are evaluated in ascending order: the winner's destination identifies it well enough.
    ascending: bool,
    computed: BTreeSet<NodeId>,
}

impl Reuse for TeamPrinter<'_> {
    fn computed(&mut self) -> &mut BTreeSet<NodeId> {
        &mut self.computed
    }
}

impl<'a> TeamPrinter<'a> {
    fn new(printer: &'a Printer<'a>, module: &'a Module<'a>, plan: &'a TeamSchedule) -> Self {
        let ascending = plan.infinite.is_none() && plan.bids().all(|bid| bid.ascending);
        Self { printer, module, plan, targets: plan.destinations(), ascending, computed: BTreeSet::new() }
    }

    fn view(mut self) -> TeamView {
        let (mut eager, mut eager_before, mut lazy) = (Vec::new(), Vec::new(), Vec::new());
        let (mut infinite, mut first) = (None, None);
        // With one way to go, no bid matters.
        if self.targets.len() > 1 {
            infinite = self.plan.infinite.as_ref().map(|infinite| self.infinite(infinite));
            eager.extend(self.plan.eager.iter().map(|bid| self.eager(bid)));
            first = self.plan.leads_at_first(self.printer.nodes).then(|| eager.remove(0));
            eager_before = self.in_braces(|team| team.plan.eager_before.iter().map(|bid| team.eager(bid)).collect());
            lazy.extend(self.plan.lazy.iter().map(|lazy| self.lazy(lazy)));
        }
        let last = self.way(self.targets[self.targets.len() - 1]);
        let ways = if self.ascending || self.targets.len() == 1 {
            (1..).zip(self.targets.iter().map(|&target| self.way(target))).collect()
        } else {
            let places = self.plan.targets.iter().map(|&target| self.way(target)).chain([last.clone()]);
            (1..).zip(places).filter(|&(place, ref way)| place > self.plan.targets.len() || *way != last).collect()
        };
        TeamView {
            label: self.plan.label,
            winner: if self.ascending { "way" } else { "edge" },
            nobody: if self.ascending { self.targets.len() } else { 0 },
            first,
            infinite,
            eager,
            eager_before,
            lazy,
            ways,
        }
    }

    /// The decision at a target.
    fn way(&self, target: Target) -> String {
        match target {
            Target::Team(team) => format!("team_{}(s)", self.module.teams[team].label),
            Target::Action(leaf) if !self.module.leaves.is_empty() => {
                format!("leaf_{}(s)", self.module.leaves[usize::from(leaf.0)].label)
            }
            Target::Action(action) => action.0.to_string(),
        }
    }

    fn rank(&self, bid: &Bid) -> usize {
        let target = self.plan.targets[bid.place];
        match self.targets.iter().position(|&other| self.ascending && other == target) {
            Some(way) => way + 1,
            None => bid.place + 1,
        }
    }

    fn infinite(&mut self, infinite: &Infinite) -> InfiniteView {
        let statements = self.statements(infinite.argument, true);
        let argument = self.printer.value(infinite.argument);
        let condition = format!("{argument} > {}", self.printer.literal(infinite.above));
        InfiniteView { statements, condition, rank: infinite.place + 1 }
    }

    fn eager(&mut self, bid: &Bid) -> BidView {
        let mut statements = self.statements(bid.value, true);
        let mut value = self.printer.value(bid.value);
        if self.printer.nodes[bid.value.index()].as_constant() == Some(0.0) {
            statements.push(format!("let zero = core::hint::black_box({value});"));
            value = "zero".to_owned();
        }
        let rank = self.rank(bid);
        BidView {
            statements,
            wins: questions::wins(bid, &rank.to_string(), &value, "best"),
            value,
            rank,
            ..BidView::default()
        }
    }

    fn lazy(&mut self, lazy: &LazyBid) -> BidView {
        let before = lazy.sparing.map(|sparing| self.statements(sparing.argument, true)).unwrap_or_default();
        let considered = questions::considered(self.printer, lazy, &self.rank(&lazy.bid).to_string());
        let view = match considered {
            Some(_) => self.in_braces(|team| team.guarded(lazy, false)),
            None => self.guarded(lazy, true),
        };
        BidView { before, considered, ..view }
    }

    fn guarded(&mut self, lazy: &LazyBid, stays: bool) -> BidView {
        let LazyBid { bid, bound, .. } = lazy;
        let rank = self.rank(bid);
        let bound_statements = bound.map(|bound| self.statements(bound, true)).unwrap_or_default();
        let guard = questions::guard(self.printer, lazy, &rank.to_string());
        // Where nothing guards it, it is computed for whatever follows.
        let statements = self.statements(bid.value, guard.is_none() && stays);
        let value = self.printer.value(bid.value);
        BidView {
            bound_statements,
            guard,
            statements,
            wins: questions::wins(bid, &rank.to_string(), &value, "best"),
            value,
            rank,
            ..BidView::default()
        }
    }

    /// Statements for the operations that a value still needs; later bids reuse them if it `stays` in scope.
    fn statements(&mut self, value: NodeId, stays: bool) -> Vec<String> {
        let printer = self.printer;
        self.missing(printer.nodes, value, stays).into_iter().map(|id| printer.statement(id)).collect()
    }
}
