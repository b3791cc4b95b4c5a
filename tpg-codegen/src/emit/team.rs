//! Teams of the profile `fast` in syntax that C and Rust share: the tests of bids, in order, and the ways to go.

use super::syntax::Syntax;
use crate::ir::{NodeId, Target, needed};
use crate::passes::schedule::{Bid, LazyBid, Sparing, TeamSchedule};
use std::collections::BTreeSet;

/// A team; `J` is a language's jump to a destination.
pub(super) struct TeamView<J> {
    pub(super) label: u32,
    /// The variable that holds the winner: the way it goes, or its place.
    pub(super) winner: &'static str,
    /// Its value before a bid wins.
    pub(super) nobody: String,
    /// The first bid, where it is a number: it leads without a test.
    pub(super) first: Option<BidView>,
    pub(super) eager: Vec<BidView>,
    pub(super) lazy: Vec<BidView>,
    /// The winners of each destination; the last is taken if no bid wins.
    pub(super) ways: Vec<(Vec<String>, J)>,
}

/// A bid and the conditions for computing it.
#[derive(Default)]
pub(super) struct BidView {
    /// Computed before the conditions.
    pub(super) before: Vec<String>,
    /// The condition for evaluating even the bound.
    pub(super) considered: Option<String>,
    pub(super) bound: Vec<String>,
    /// The condition for computing the bid.
    pub(super) guard: Option<String>,
    pub(super) statements: Vec<String>,
    pub(super) value: String,
    pub(super) rank: String,
    /// The condition under which it becomes the leader.
    pub(super) wins: String,
    /// An equal bid wins.
    pub(super) ascending: bool,
    /// The last bid of its team: the best bid is not read after it.
    pub(super) last: bool,
}

/// Views a team.
pub(super) fn view<J>(syntax: &impl Syntax, plan: &TeamSchedule, jump: impl Fn(Target) -> J) -> TeamView<J> {
    let targets = plan.destinations();
    let ascending = plan.is_ascending();
    let mut team = Team { syntax, plan, targets: &targets, ascending, computed: BTreeSet::new() };
    let (mut eager, mut lazy, mut first) = (Vec::new(), Vec::new(), None);
    // With one way to go, no bid matters.
    if targets.len() > 1 {
        eager.extend(plan.eager.iter().map(|bid| team.eager(bid)));
        first = plan.leads_at_first(syntax.nodes()).then(|| eager.remove(0));
        lazy.extend(plan.lazy.iter().map(|lazy| team.lazy(lazy)));
    }
    if let Some(bid) = lazy.last_mut().or(eager.last_mut()) {
        bid.last = true;
    }
    let ranks = |target: Target| match ascending {
        true => vec![team.way(target)],
        false => {
            let leads = plan.targets.iter().enumerate().filter(|&(_, &to)| to == target);
            leads.map(|(place, _)| syntax.index(place + 1)).collect()
        }
    };
    TeamView {
        label: plan.label,
        winner: match syntax.lead_prefix() {
            Some(_) => "lead.winner",
            None if ascending => "way",
            None => "edge",
        },
        nobody: syntax.index(if ascending { targets.len() } else { 0 }),
        first,
        eager,
        lazy,
        ways: targets.iter().map(|&target| (ranks(target), jump(target))).collect(),
    }
}

struct Team<'a, S> {
    syntax: &'a S,
    plan: &'a TeamSchedule,
    /// The distinct destinations of the edges; the last is the last edge's.
    targets: &'a [Target],
    /// All bids are evaluated in ascending order: the winner's destination identifies it well enough.
    ascending: bool,
    /// Values in scope, which later bids reuse.
    computed: BTreeSet<NodeId>,
}

impl<S: Syntax> Team<'_, S> {
    /// The number of a way, counted from 1.
    fn way(&self, target: Target) -> String {
        let place = self.targets.iter().position(|&other| other == target).unwrap_or_default();
        self.syntax.index(place + 1)
    }

    fn rank(&self, bid: &Bid) -> String {
        if self.ascending { self.way(self.plan.targets[bid.place]) } else { self.syntax.index(bid.place + 1) }
    }

    /// Statements for the operations that a value still needs; later bids reuse them if it `stays` in scope.
    fn statements(&mut self, value: NodeId, stays: bool) -> Vec<String> {
        let missing = needed(self.syntax.nodes(), value, |id| !self.computed.contains(&id));
        if stays {
            self.computed.extend(&missing);
        }
        missing.into_iter().map(|id| self.syntax.statement(id)).collect()
    }

    fn eager(&mut self, bid: &Bid) -> BidView {
        let mut statements = self.statements(bid.value, true);
        let mut value = self.syntax.value(bid.value);
        if self.syntax.nodes()[bid.value.index()].as_constant() == Some(0.0) {
            statements.extend(self.syntax.hidden_zero(&value));
            value = "zero".to_owned();
        }
        let wins = format!("{value} >= best");
        BidView { statements, value, rank: self.rank(bid), wins, ascending: true, ..BidView::default() }
    }

    fn lazy(&mut self, LazyBid { bid, sparing, bound }: &LazyBid) -> BidView {
        let rank = self.rank(bid);
        let before = sparing.map_or_else(Vec::new, |sparing| self.statements(sparing.argument, true));
        let considered =
            sparing.map(|sparing| format!("!({})", low(self.syntax, sparing, &self.syntax.value(sparing.argument))));
        let outside = considered.is_some().then(|| self.computed.clone());
        let bound_statements = bound.map_or_else(Vec::new, |bound| self.statements(bound, true));
        // Also true where the bound is NaN and says nothing.
        let can_win = |bound: String| match (self.syntax.lead_prefix(), bid.ascending) {
            (Some(prefix), true) => format!("{prefix}_can(&lead, {bound}) != 0U"),
            (Some(prefix), false) => format!("{prefix}_can_at(&lead, {bound}, {rank}) != 0U"),
            (None, true) => format!("!(best > {bound})"),
            (None, false) => format!("!((best > {bound}) || ((best >= {bound}) && (edge >= {rank})))"),
        };
        let guard = match bound {
            Some(bound) => Some(can_win(self.syntax.value(*bound))),
            // Nothing is higher than infinity; in ascending order, an equal bid wins.
            None if bid.ascending => None,
            None if self.syntax.lead_prefix().is_some() => Some(can_win(self.syntax.number(f64::INFINITY))),
            None => Some(format!("(best < {}) || (edge < {rank})", self.syntax.number(f64::INFINITY))),
        };
        let stays = guard.is_none() && !S::BRACES;
        let statements = self.statements(bid.value, stays);
        self.computed = outside.unwrap_or(std::mem::take(&mut self.computed));
        let value = self.syntax.value(bid.value);
        let wins = match bid.ascending {
            true => format!("{value} >= best"),
            false => format!("({value} >= best) && (({value} > best) || (edge < {rank}))"),
        };
        BidView {
            before,
            considered,
            bound: bound_statements,
            guard,
            statements,
            value,
            rank,
            wins,
            ascending: bid.ascending,
            last: false,
        }
    }
}

/// The condition under which an argument is low and the best bid is not.
pub(super) fn low(syntax: &impl Syntax, Sparing { at_most, below, .. }: Sparing, argument: &str) -> String {
    let [at_most, below] = [at_most, below].map(|number| syntax.number(number));
    let best = if syntax.lead_prefix().is_some() { "lead.best" } else { "best" };
    format!("({argument} <= {at_most}) && ({best} >= {below})")
}
