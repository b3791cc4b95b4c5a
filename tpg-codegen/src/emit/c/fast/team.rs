//! One team: the tests of its bids, in order, and the jump to the winner's destination.

use super::Span;
use super::leader;
use super::view::{EagerView, InfiniteView, LateTeamView, LateView, LazyView, TeamView, WayView};
use crate::emit::c::expression::Printer;
use crate::emit::questions;
use crate::emit::reuse::Reuse;
use crate::emit::syntax::Syntax;
use crate::ir::{Module, NodeId, Target, needed};
use crate::passes::schedule::{Bid, Infinite, LazyBid, TeamSchedule};
use std::collections::BTreeSet;

pub(super) struct TeamPrinter<'a> {
    pub(super) printer: &'a Printer<'a>,
    module: &'a Module<'a>,
    pub(super) plan: &'a TeamSchedule,
    span: &'a Span<'a>,
    /// The distinct destinations of the edges; the last is the last edge's.
    targets: Vec<Target>,
    /// All bids are evaluated in ascending order: the winner's destination identifies it well enough.
    ascending: bool,
    /// Values computed so far; at first those available on entry.
    computed: BTreeSet<NodeId>,
    pub(super) reads_state: bool,
    /// The leader may be a bid that was not computed.
    pub(super) pending: bool,
    is_compact: bool,
}

impl Reuse for TeamPrinter<'_> {
    fn computed(&mut self) -> &mut BTreeSet<NodeId> {
        &mut self.computed
    }
}

impl<'a> TeamPrinter<'a> {
    pub(super) fn new(
        printer: &'a Printer<'a>,
        module: &'a Module<'a>,
        plan: &'a TeamSchedule,
        span: &'a Span<'a>,
        computed: BTreeSet<NodeId>,
        is_compact: bool,
    ) -> Self {
        let ascending = plan.infinite.is_none() && plan.bids().all(|bid| bid.ascending);
        let ascending = ascending && plan.lazy.iter().all(|lazy| lazy.certain.is_none());
        let targets = plan.destinations();
        let (reads_state, pending) = (false, false);
        Self { printer, module, plan, span, targets, ascending, computed, reads_state, pending, is_compact }
    }

    pub(super) fn view(&mut self, is_entered: bool) -> TeamView {
        let (mut eager, mut eager_before, mut lazy) = (Vec::new(), Vec::new(), Vec::new());
        let (mut infinite, mut first) = (None, None);
        let (mut steps, mut steps_before, mut steps_lazy) = (Vec::new(), Vec::new(), Vec::new());
        // With one way to go, no bid matters.
        if self.targets.len() > 1 && self.is_compact {
            infinite = self.plan.infinite.as_ref().map(|infinite| self.infinite(infinite));
            let mut always = self.plan.eager.iter();
            if self.plan.leads_at_first(self.printer.nodes) {
                first = always.next().map(|bid| self.eager(bid));
            }
            steps.extend(always.map(|bid| self.eager_step(bid)));
            steps_before.extend(
                self.in_braces(|team| {
                    team.plan.eager_before.iter().map(|bid| team.eager_step(bid)).collect::<Vec<_>>()
                }),
            );
            steps_lazy.extend(self.plan.lazy.iter().map(|lazy| self.lazy_step(lazy)));
            leader::join(&mut steps_lazy, self.printer.prefix);
            self.reads_state |= self.pending;
        } else if self.targets.len() > 1 {
            infinite = self.plan.infinite.as_ref().map(|infinite| self.infinite(infinite));
            eager.extend(self.plan.eager.iter().map(|bid| self.eager(bid)));
            first = self.plan.leads_at_first(self.printer.nodes).then(|| eager.remove(0));
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
            winner: self.winner(),
            nobody: if self.ascending { format!("{}U", self.targets.len()) } else { "0U".to_owned() },
            first,
            is_compact: self.is_compact,
            infinite,
            steps,
            steps_before,
            steps_lazy,
            eager,
            eager_before,
            lazy,
            ways: self.targets.iter().map(|&target| self.way(target)).collect(),
        }
    }

    /// The variable that holds the winner.
    fn winner(&self) -> &'static str {
        match (self.is_compact, self.ascending) {
            (true, _) => "lead.winner",
            (false, true) => "way",
            (false, false) => "edge",
        }
    }

    /// The condition for a target, and the jump to it.
    fn way(&self, target: Target) -> WayView {
        let condition = if self.ascending {
            format!("{} == {}", self.winner(), self.number(target))
        } else {
            let leads_there = |&(_, &to): &(usize, &Target)| to == target;
            let places: Vec<String> = (self.plan.targets.iter().enumerate().filter(leads_there))
                .map(|(place, _)| format!("{} == {}U", self.winner(), place + 1))
                .collect();
            if let [place] = &places[..] { place.clone() } else { format!("({})", places.join(") || (")) }
        };
        let Span { places, start, end, whole, .. } = *self.span;
        let (vertex, label) = match target {
            Target::Team(team) if (start..end).contains(&places[team]) => {
                (None, format!("team_{}", self.module.teams[team].label))
            }
            Target::Team(team) => (Some(places[team]), "decided".to_owned()),
            Target::Action(leaf) if whole && !self.module.leaves.is_empty() => {
                (None, format!("leaf_{}", self.module.leaves[usize::from(leaf.0)].label))
            }
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

    pub(super) fn rank(&self, bid: &Bid) -> String {
        if self.ascending { self.number(self.plan.targets[bid.place]) } else { format!("{}U", bid.place + 1) }
    }

    fn infinite(&mut self, infinite: &Infinite) -> InfiniteView {
        let statements = self.statements(infinite.argument, true);
        let argument = self.printer.value(infinite.argument);
        let condition = format!("{argument} > {}", self.printer.number(infinite.above));
        InfiniteView { statements, condition, rank: format!("{}U", infinite.place + 1) }
    }

    pub(super) fn eager(&mut self, bid: &Bid) -> EagerView {
        let mut statements = self.statements(bid.value, true);
        let mut value = self.printer.value(bid.value);
        if self.printer.nodes[bid.value.index()].as_constant() == Some(0.0) {
            let scalar = self.printer.scalar();
            statements.push(format!("const volatile {scalar} constant = {value};"));
            statements.push(format!("const {scalar} zero = constant;"));
            value = "zero".to_owned();
        }
        EagerView { statements, value, rank: self.rank(bid), ascending: bid.ascending, last: false }
    }

    fn lazy(&mut self, lazy: &LazyBid) -> LazyView {
        let before = lazy.sparing.map(|sparing| self.statements(sparing.argument, true)).unwrap_or_default();
        let considered = questions::considered(self.printer, lazy, &self.rank(&lazy.bid));
        let mut view = match considered {
            Some(_) => self.in_braces(|team| team.guarded(lazy, considered)),
            None => self.guarded(lazy, None),
        };
        view.before = before;
        view
    }

    fn guarded(&mut self, lazy: &LazyBid, considered: Option<String>) -> LazyView {
        let LazyBid { bid, bound, certain, .. } = lazy;
        let rank = self.rank(bid);
        let mut bound_statements = bound.map(|bound| self.statements(bound, true)).unwrap_or_default();
        bound_statements.extend(certain.iter().flat_map(|&certain| self.statements(certain, true)));
        let pending = self.pending;
        let top = if pending { "top" } else { "best" };
        let sure = certain.map(|certain| questions::wins(bid, &rank, &self.printer.value(certain), top));
        let ends = certain.zip(*bound).map(|(low, high)| (self.printer.value(low), self.printer.value(high)));
        self.pending |= certain.is_some();
        let guard = questions::guard(self.printer, lazy, &rank);
        let (statements, value) = if certain.is_some() {
            (Vec::new(), "bid".to_owned())
        } else {
            (self.statements(bid.value, false), self.printer.value(bid.value))
        };
        let wins = questions::wins(bid, &rank, &value, if certain.is_some() && pending { "lead" } else { "best" });
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

    /// The bids that may lead without having been computed, each with the operations it needs.
    pub(super) fn late_team(&self) -> Option<LateTeamView> {
        let mut reads_state = false;
        let bids: Vec<LateView> = (self.plan.lazy.iter().filter(|lazy| lazy.certain.is_some()))
            .map(|lazy| {
                let value = lazy.bid.value;
                let needed = needed(self.printer.nodes, value, |_| true);
                reads_state |= self.printer.reads_state(needed.iter().chain([&value]));
                LateView {
                    rank: self.rank(&lazy.bid),
                    statements: needed.iter().map(|&id| self.printer.statement(id)).collect(),
                    value: self.printer.value(value),
                }
            })
            .collect();
        (self.targets.len() > 1 && !bids.is_empty()).then_some(LateTeamView {
            label: self.plan.label,
            bids,
            reads_state,
        })
    }

    /// Statements for the operations that a value still needs; later bids reuse them if it `stays` in scope.
    pub(super) fn statements(&mut self, value: NodeId, stays: bool) -> Vec<String> {
        let missing = self.missing(self.printer.nodes, value, stays);
        self.reads_state |= self.printer.reads_state(missing.iter().chain([&value]));
        let statement = |&id: &NodeId| {
            if self.span.shared.contains(&id) { self.printer.assignment(id) } else { self.printer.statement(id) }
        };
        missing.iter().map(statement).collect()
    }
}
