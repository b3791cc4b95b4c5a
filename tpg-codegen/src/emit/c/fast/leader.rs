//! Teams in doubles, compact: who leads is a variable that small functions change.
//!
//! On a processor without doubles a comparison is a call. With its arguments and what follows from it, it takes most of the code of a
//! team, and GCC copies the paths behind it. So the comparisons stand in functions: where code is compiled for size, these are
//! called, else they are inlined.

use super::team::TeamPrinter;
use super::view::StepView;
use crate::emit::c::expression::Printer;
use crate::emit::reuse::Reuse;
use crate::emit::syntax::Syntax;
use crate::ir::{Module, Node};
use crate::passes::estimate;
use crate::passes::schedule::{Bid, LazyBid, Sparing};
use askama::Template;
use tpg_graph::ScalarType;
use tpg_runtime::ops::Instruction;

/// The least number of edges whose comparisons are worth functions.
const EDGES: usize = 32;

/// Tests for code that is compact.
pub(crate) fn is_compact(module: &Module<'_>) -> bool {
    let edges = module.teams.iter().map(|team| team.edges.len()).sum::<usize>();
    module.graph.scalar() == ScalarType::F64 && module.graph.outputs().is_empty() && edges >= EDGES
}

/// The functions that the teams call.
#[derive(Template)]
#[template(path = "c/fast_leader.c", escape = "none")]
struct Functions<'a> {
    prefix: &'a str,
    upper: &'a str,
    scalar: &'a str,
    takes: bool,
    takes_at: bool,
    can: bool,
    can_at: bool,
    near: bool,
    estimates: Vec<Estimate>,
}

/// A logarithm or an exponential that may lead without having been computed.
struct Estimate {
    name: &'static str,
    at_most: String,
    below: String,
    /// The lower end, made of the higher.
    low: String,
}

/// Puts bids behind each other that the same number bounds: once one of them has been computed, none is above it.
pub(super) fn join(steps: &mut [StepView], prefix: &str) {
    let bounded = |step: &StepView| {
        let is_alone = step.before.is_empty() && step.considered.is_none() && step.bound.is_empty();
        step.guard.clone().filter(|guard| is_alone && step.is_bounded && guard.starts_with(&format!("{prefix}_can(")))
    };
    for place in 1..steps.len() {
        if let (Some(one), Some(other)) = (bounded(&steps[place - 1]), bounded(&steps[place]))
            && one == other
        {
            steps[place - 1].goes_on = true;
            steps[place].continues = true;
            steps[place].is_late = false;
        }
    }
}

/// Tests for bids that may lead without having been computed.
pub(super) fn has_near(steps: &[&StepView]) -> bool {
    steps.iter().any(|step| step.guard.iter().any(|guard| guard.contains("_near(")))
}

/// Renders the functions that some teams call.
pub(super) fn functions(printer: &Printer<'_>, upper: &str, steps: &[&StepView]) -> String {
    let called = |name: &str| {
        let call = format!("{}_{name}(", printer.prefix);
        steps.iter().any(|step| step.take == name || step.guard.iter().any(|guard| guard.contains(&call)))
    };
    let estimate = |instruction: Instruction| {
        let near = format!("{}_near", instruction.name());
        if !called(&near) {
            return None;
        }
        let number = |value: f64| printer.number(value);
        let low = match instruction {
            Instruction::Ln => format!("high - {}", number(estimate::LN_LESS)),
            _ => {
                let below = number(estimate::of(printer.graph.scalar()).exp_below);
                format!("(high - {below}) * {}", number(estimate::EXP_LEAST))
            }
        };
        let (at_most, below) = Sparing::ends(instruction)?;
        let name = instruction.name();
        Some(Estimate { name, at_most: number(at_most), below: number(below), low })
    };
    let estimates: Vec<Estimate> = [Instruction::Ln, Instruction::Exp].into_iter().filter_map(estimate).collect();
    let near = has_near(steps);
    let functions = Functions {
        prefix: printer.prefix,
        upper,
        scalar: printer.scalar(),
        takes: called("take"),
        takes_at: called("take_at"),
        can: called("can"),
        can_at: near || called("can_at"),
        near,
        estimates,
    };
    functions.render().expect("the template renders")
}

impl TeamPrinter<'_> {
    /// A bid that is always computed.
    pub(super) fn eager_step(&mut self, bid: &Bid) -> StepView {
        let eager = self.eager(bid);
        StepView {
            before: Vec::new(),
            considered: None,
            bound: Vec::new(),
            guard: None,
            continues: false,
            goes_on: false,
            is_bounded: false,
            outside: eager.statements,
            statements: Vec::new(),
            is_late: false,
            value: eager.value,
            take: if bid.ascending { "take" } else { "take_at" },
            rank: eager.rank,
        }
    }

    /// A bid that may be skipped.
    pub(super) fn lazy_step(&mut self, lazy: &LazyBid) -> StepView {
        let before = lazy.sparing.map(|sparing| self.statements(sparing.argument, true)).unwrap_or_default();
        let rank = self.rank(&lazy.bid);
        let infinite =
            lazy.before_infinite.then(|| format!("(lead.best < {}) || (lead.winner < {rank})", self.infinity()));
        let spared = lazy.sparing.filter(|_| lazy.certain.is_none()).map(|sparing| {
            let argument = self.printer.value(sparing.argument);
            let [at_most, below] = [sparing.at_most, sparing.below].map(|number| self.printer.number(number));
            format!("!(({argument} <= {at_most}) && (lead.best >= {below}))")
        });
        let considered = match (infinite, spared) {
            (Some(infinite), Some(spared)) => Some(format!("({infinite}) && {spared}")),
            (infinite, spared) => infinite.or(spared),
        };
        let mut view = match considered {
            Some(_) => self.in_braces(|team| team.guarded_step(lazy, rank)),
            None => self.guarded_step(lazy, rank),
        };
        view.before = before;
        view.considered = considered;
        view
    }

    fn infinity(&self) -> String {
        self.printer.number(f64::INFINITY)
    }

    fn guarded_step(&mut self, lazy: &LazyBid, rank: String) -> StepView {
        let LazyBid { bid, bound, certain, before_infinite, .. } = *lazy;
        let prefix = self.printer.prefix;
        let is_late = self.pending;
        let take = if bid.ascending { "take" } else { "take_at" };
        let step = StepView {
            before: Vec::new(),
            considered: None,
            bound: Vec::new(),
            guard: None,
            continues: false,
            goes_on: false,
            is_bounded: false,
            outside: Vec::new(),
            statements: Vec::new(),
            is_late,
            value: String::new(),
            take,
            rank: rank.clone(),
        };
        if let (Some(_), Some(sparing), Node::Operation(instruction, _)) =
            (certain, lazy.sparing, self.printer.nodes[bid.value.index()])
        {
            self.pending = true;
            let argument = self.printer.value(sparing.argument);
            let guard = format!("{prefix}_{}_near(&lead, {argument}, {rank}) != 0U", instruction.name());
            let value = format!("{prefix}_bid_{}(state, {rank}, lead.best)", self.plan.label);
            return StepView { guard: Some(guard), value, ..step };
        }
        let bound_statements = bound.map(|bound| self.statements(bound, true)).unwrap_or_default();
        let guard = match bound.map(|bound| self.printer.value(bound)) {
            Some(bound) if bid.ascending => Some(format!("{prefix}_can(&lead, {bound}) != 0U")),
            Some(bound) => Some(format!("{prefix}_can_at(&lead, {bound}, {rank}) != 0U")),
            None if bid.ascending || before_infinite => None,
            None => Some(format!("(lead.best < {}) || (lead.winner < {rank})", self.infinity())),
        };
        let (statements, value) = (self.statements(bid.value, false), self.printer.value(bid.value));
        let is_bounded = bound.is_some_and(|bound| self.printer.nodes[bound.index()].as_constant().is_some());
        StepView { bound: bound_statements, guard, is_bounded, statements, value, ..step }
    }
}
