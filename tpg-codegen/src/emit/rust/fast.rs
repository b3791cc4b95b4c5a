//! The profile `fast`: a function for each team. Cheap bids are computed without a condition; the others only where a
//! bound says that they can still win.
//!
//! The best bid starts at the lowest finite number, and a NaN is never as high: so only bids above −∞ win, and where there
//! is none, nobody wins, which is how the team's last edge does. No bid needs a test for NaN.
//!
//! A bid of 0 goes through `black_box`: LLVM 22 takes `if v > 0 { v } else { 0 }` of a `v = max(0, x)` for v, which it is not
//! where x is NaN. Where what is best is no constant, it does not.

use super::expression::{Printer, literal};
use super::{Parts, helpers, vertex, vertex_type};
use crate::ir::{Module, NodeId, needed};
use crate::passes::schedule::{Bid, LazyBid, Plan, Schedule};
use askama::Template;
use std::collections::BTreeSet;

#[derive(Template)]
#[template(path = "rust/fast.rs", escape = "none")]
struct Fast<'a> {
    scalar: &'a str,
    state_length: usize,
    vertex: &'a str,
    teams: Vec<TeamView>,
    helpers: String,
}

#[derive(Template)]
#[template(path = "rust/fast_body.rs", escape = "none")]
struct Body<'a> {
    teams: &'a [TeamView],
}

struct TeamView {
    label: u32,
    /// Where the edges lead, and where the last of them does: only where winners are known by their place.
    next: Option<(Vec<(usize, usize)>, usize)>,
    /// The variable that holds the winner: its place, or where it leads.
    winner: &'static str,
    nobody: usize,
    eager: Vec<BidView>,
    lazy: Vec<BidView>,
}

struct BidView {
    bound_statements: Vec<String>,
    guard: Option<String>,
    statements: Vec<String>,
    value: String,
    rank: usize,
    wins: String,
}

/// Renders the profile.
pub(super) fn render(printer: &Printer<'_>, module: &Module, schedule: &Schedule) -> Parts {
    let teams: Vec<TeamView> =
        schedule.plans.iter().map(|plan| TeamPrinter::new(printer, module, plan).view()).collect();
    let body = Body { teams: &teams }.render().expect("the template renders");
    let fast = Fast {
        scalar: printer.graph.scalar().name(),
        state_length: printer.graph.state_length(),
        vertex: vertex_type(printer.graph, module),
        teams,
        helpers: helpers::render(printer),
    };
    Parts { body, items: fast.render().expect("the template renders") }
}

struct TeamPrinter<'a> {
    printer: &'a Printer<'a>,
    module: &'a Module,
    plan: &'a Plan,
    /// Whether every bid is looked at in turn: then, where the winner leads is enough to know.
    in_turn: bool,
    computed: BTreeSet<NodeId>,
}

impl<'a> TeamPrinter<'a> {
    fn new(printer: &'a Printer<'a>, module: &'a Module, plan: &'a Plan) -> Self {
        let in_turn = plan.eager.iter().chain(plan.lazy.iter().map(|lazy| &lazy.bid)).all(|bid| bid.in_turn);
        Self { printer, module, plan, in_turn, computed: BTreeSet::new() }
    }

    fn view(mut self) -> TeamView {
        let eager = self.plan.eager.iter().map(|bid| self.eager(bid)).collect();
        let lazy = self.plan.lazy.iter().map(|lazy| self.lazy(lazy)).collect();
        let targets: Vec<usize> = self.plan.targets.iter().map(|&to| vertex(self.module, to)).collect();
        let last = targets[targets.len() - 1];
        TeamView {
            label: self.plan.label,
            winner: if self.in_turn { "vertex" } else { "edge" },
            nobody: if self.in_turn { last } else { 0 },
            next: (!self.in_turn).then(|| ((1..targets.len()).zip(targets.iter().copied()).collect(), last)),
            eager,
            lazy,
        }
    }

    fn rank(&self, bid: &Bid) -> usize {
        if self.in_turn { vertex(self.module, self.plan.targets[bid.place]) } else { bid.place + 1 }
    }

    fn eager(&mut self, bid: &Bid) -> BidView {
        let mut statements = self.statements(bid.value, true);
        let mut value = self.printer.value(bid.value);
        if self.printer.nodes[bid.value.index()].as_constant() == Some(0.0) {
            statements.push(format!("let zero = core::hint::black_box({value});"));
            value = "zero".to_owned();
        }
        BidView {
            bound_statements: Vec::new(),
            guard: None,
            statements,
            wins: format!("{value} >= best"),
            value,
            rank: self.rank(bid),
        }
    }

    fn lazy(&mut self, lazy: &LazyBid) -> BidView {
        let LazyBid { bid, bound, .. } = lazy;
        let rank = self.rank(bid);
        let bound_statements = bound.map(|bound| self.statements(bound, true)).unwrap_or_default();
        let infinity = literal(self.printer.graph.scalar(), f64::INFINITY);
        let guard = match bound {
            // Also where the bound is NaN and says nothing.
            Some(bound) => {
                let bound = self.printer.value(*bound);
                Some(if bid.in_turn {
                    format!("!(best > {bound})")
                } else {
                    format!("!(best > {bound} || (best >= {bound} && edge > {rank}))")
                })
            }
            // Nothing is higher than infinity; in turn, what is as high wins.
            None if bid.in_turn => None,
            None => Some(format!("best < {infinity} || edge < {rank}")),
        };
        // Where nothing guards it, it is computed for whatever follows.
        let statements = self.statements(bid.value, guard.is_none());
        let value = self.printer.value(bid.value);
        let wins = if bid.in_turn {
            format!("{value} >= best")
        } else {
            format!("{value} > best || ({value} >= best && edge < {rank})")
        };
        BidView { bound_statements, guard, statements, value, rank, wins }
    }

    /// What must still be computed for a value; later bids can use it where it `stays`.
    fn statements(&mut self, value: NodeId, stays: bool) -> Vec<String> {
        let missing = needed(self.printer.nodes, value, |id| !self.computed.contains(&id));
        let statements = missing.iter().map(|&id| self.printer.statement(id)).collect();
        if stays {
            self.computed.extend(missing);
        }
        statements
    }
}
