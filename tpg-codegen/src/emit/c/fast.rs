//! The profile `fast`: a function for each team. Cheap bids are computed without a branch; the others only where a bound
//! says that they can still win.
//!
//! The best bid starts at the lowest finite number, and a NaN is never as high: so only bids above −∞ win, and where there
//! is none, nobody wins, which is how the team's last edge does. No bid needs a test for NaN.
//!
//! A bid of 0 is read from a volatile variable: clang takes `(v > 0) ? v : 0` of a `v = max(0, x)` for v, which it is not
//! where x is NaN. Where what is best is no constant, it does not.

use super::expression::Printer;
use super::{vertex, walk};
use crate::emit::Style;
use crate::graph::ScalarType;
use crate::ir::{Module, Node, NodeId, needed};
use crate::passes::schedule::{Bid, LazyBid, Plan, Schedule};
use askama::Template;
use std::collections::BTreeSet;

#[derive(Template)]
#[template(path = "c/fast.c", escape = "none")]
struct Fast<'a> {
    prefix: &'a str,
    scalar: &'a str,
    lowest: &'a str,
    vertex: &'a str,
    teams: Vec<TeamView>,
    /// The entry point.
    walk: String,
}

struct TeamView {
    label: u32,
    /// The values of the bids that may lead without having been computed, by place.
    late: Vec<LateView>,
    /// Whether the team must be told the state to compute them.
    late_reads_state: bool,
    /// Where edges lead, after where nobody's win leads: only where winners are known by their place.
    next: Option<Vec<String>>,
    /// The variable that holds the winner: its place, or where it leads.
    winner: &'static str,
    nobody: String,
    reads_state: bool,
    eager: Vec<EagerView>,
    lazy: Vec<LazyView>,
}

struct EagerView {
    statements: Vec<String>,
    value: String,
    rank: String,
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
    let fast = Fast {
        prefix: printer.prefix,
        scalar: printer.scalar(),
        lowest: if printer.graph.scalar() == ScalarType::F32 { "FLT_MAX" } else { "DBL_MAX" },
        vertex: super::vertex_type(printer.graph, module),
        teams: schedule.plans.iter().map(|plan| TeamPrinter::new(printer, module, plan).view()).collect(),
        walk: walk::render(printer, module, upper, Style::Pure),
    };
    fast.render().expect("the template renders")
}

struct TeamPrinter<'a> {
    printer: &'a Printer<'a>,
    module: &'a Module,
    plan: &'a Plan,
    /// Whether every bid is looked at in turn: then, where the winner leads is enough to know.
    in_turn: bool,
    computed: BTreeSet<NodeId>,
    reads_state: bool,
    /// Whether the leader may be a bid that was not computed.
    pending: bool,
}

impl<'a> TeamPrinter<'a> {
    fn new(printer: &'a Printer<'a>, module: &'a Module, plan: &'a Plan) -> Self {
        let in_turn = plan.eager.iter().chain(plan.lazy.iter().map(|lazy| &lazy.bid)).all(|bid| bid.in_turn);
        let in_turn = in_turn && plan.lazy.iter().all(|lazy| lazy.certain.is_none());
        Self { printer, module, plan, in_turn, computed: BTreeSet::new(), reads_state: false, pending: false }
    }

    fn view(mut self) -> TeamView {
        let mut eager: Vec<EagerView> = self.plan.eager.iter().map(|bid| self.eager(bid)).collect();
        let mut lazy: Vec<LazyView> = self.plan.lazy.iter().map(|lazy| self.lazy(lazy)).collect();
        let late: Vec<LateView> =
            self.plan.lazy.iter().filter(|lazy| lazy.certain.is_some()).map(|lazy| self.late(lazy)).collect();
        match (lazy.last_mut(), eager.last_mut()) {
            (Some(bid), _) => bid.last = true,
            (None, Some(bid)) => bid.last = true,
            (None, None) => {}
        }
        let targets: Vec<String> = self.plan.targets.iter().map(|&to| vertex(self.module, to)).collect();
        let last = targets[targets.len() - 1].clone();
        TeamView {
            label: self.plan.label,
            late_reads_state: late.iter().any(|late| {
                late.value.contains("state->") || late.statements.iter().any(|statement| statement.contains("state->"))
            }),
            late,
            winner: if self.in_turn { "vertex" } else { "edge" },
            nobody: if self.in_turn { last.clone() } else { "0U".to_owned() },
            next: (!self.in_turn).then(|| std::iter::once(last).chain(targets).collect()),
            reads_state: self.reads_state || self.pending,
            eager,
            lazy,
        }
    }

    fn rank(&self, bid: &Bid) -> String {
        if self.in_turn { vertex(self.module, self.plan.targets[bid.place]) } else { format!("{}U", bid.place + 1) }
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
        EagerView { statements, value, rank: self.rank(bid), last: false }
    }

    fn lazy(&mut self, lazy: &LazyBid) -> LazyView {
        let LazyBid { bid, bound, certain } = lazy;
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
                    format!("!((best > {bound}) || ((best >= {bound}) && (edge > {rank})))")
                })
            }
            // Nothing is higher than infinity; in turn, what is as high wins.
            None if bid.in_turn => None,
            None => Some(format!("(best < {infinity}) || (edge < {rank})")),
        };
        let (statements, value) = if certain.is_some() {
            (Vec::new(), "bid".to_owned())
        } else {
            (self.statements(bid.value, false), self.printer.value(bid.value))
        };
        let wins = self.wins(bid, &rank, &value, if certain.is_some() && pending { "lead" } else { "best" });
        LazyView {
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
            format!("({value} > {best}) || (({value} >= {best}) && (edge < {rank}))")
        }
    }

    /// A bid's value on its own, with all that it needs.
    fn late(&self, lazy: &LazyBid) -> LateView {
        let value = lazy.bid.value;
        let needed = needed(self.printer.nodes, value, |_| true);
        LateView {
            rank: self.rank(&lazy.bid),
            statements: needed.iter().map(|&id| self.printer.statement(id)).collect(),
            value: self.printer.value(value),
        }
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
