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

struct LazyView {
    bound_statements: Vec<String>,
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
}

impl<'a> TeamPrinter<'a> {
    fn new(printer: &'a Printer<'a>, module: &'a Module, plan: &'a Plan) -> Self {
        let in_turn = plan.eager.iter().chain(plan.lazy.iter().map(|lazy| &lazy.bid)).all(|bid| bid.in_turn);
        Self { printer, module, plan, in_turn, computed: BTreeSet::new(), reads_state: false }
    }

    fn view(mut self) -> TeamView {
        let mut eager: Vec<EagerView> = self.plan.eager.iter().map(|bid| self.eager(bid)).collect();
        let mut lazy: Vec<LazyView> = self.plan.lazy.iter().map(|lazy| self.lazy(lazy)).collect();
        match (lazy.last_mut(), eager.last_mut()) {
            (Some(bid), _) => bid.last = true,
            (None, Some(bid)) => bid.last = true,
            (None, None) => {}
        }
        let targets: Vec<String> = self.plan.targets.iter().map(|&to| vertex(self.module, to)).collect();
        let last = targets[targets.len() - 1].clone();
        TeamView {
            label: self.plan.label,
            winner: if self.in_turn { "vertex" } else { "edge" },
            nobody: if self.in_turn { last.clone() } else { "0U".to_owned() },
            next: (!self.in_turn).then(|| std::iter::once(last).chain(targets).collect()),
            reads_state: self.reads_state,
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
        let LazyBid { bid, bound } = lazy;
        let rank = self.rank(bid);
        let bound_statements = bound.map(|bound| self.statements(bound, true)).unwrap_or_default();
        let infinity = self.printer.constant(f64::INFINITY);
        let guard = match bound {
            // Also where the bound is NaN and says nothing.
            Some(bound) => Some(format!("!(best > {})", self.printer.value(*bound))),
            // Nothing is higher than infinity; in turn, what is as high wins.
            None if bid.in_turn => None,
            None => Some(format!("(best < {infinity}) || (edge < {rank})")),
        };
        let statements = self.statements(bid.value, false);
        let value = self.printer.value(bid.value);
        let wins = if bid.in_turn {
            format!("{value} >= best")
        } else {
            format!("({value} > best) || (({value} >= best) && (edge < {rank}))")
        };
        LazyView { bound_statements, guard, statements, value, rank, wins, last: false }
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
