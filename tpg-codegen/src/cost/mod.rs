//! The cost of a decision, counted on the program: teams, bids, operations, and the sines, cosines, logarithms and
//! exponentials among these. At most ([`Costs::worst`]), and on average over given states ([`Costs::mean`]).

mod mean;

use crate::ir::{Module, Node, NodeId, heaviest_walk, needed};
use crate::options::Language;
use crate::passes::cases::{Case, Cases, Function, Kind};
use crate::passes::functions;
use crate::passes::schedule::{Bid, LazyBid, Sparing, TeamSchedule};
use crate::program::Program;
use crate::shape::Shape::*;
use serde::Serialize;
use std::collections::BTreeSet;

/// The cost of one decision.
#[derive(Clone, Copy, Debug, Default, PartialEq, Serialize)]
pub struct Cost<N> {
    /// Teams that decide.
    pub teams: N,
    /// Bids that are considered.
    pub bids: N,
    /// Operations on numbers: arithmetic, functions, bounds. Not comparisons of bids, not the way through tables.
    pub operations: N,
    /// Sines, cosines, logarithms and exponentials among the operations: with the system's maths, calls of libm.
    pub maths_calls: N,
}

/// Operations, and the expensive ones among them.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
struct Work {
    operations: u64,
    maths_calls: u64,
}

impl Work {
    fn plus(self, other: Self) -> Self {
        Self { operations: self.operations + other.operations, maths_calls: self.maths_calls + other.maths_calls }
    }

    fn most(self, other: Self) -> Self {
        Self { operations: self.operations.max(other.operations), maths_calls: self.maths_calls.max(other.maths_calls) }
    }
}

/// The condition for computing a bid.
#[derive(Clone, Copy, Debug, PartialEq)]
enum Guard {
    /// Always.
    None,
    /// Unless this bound is below the best bid so far; where it is as low, the place decides.
    Bound(NodeId),
    /// Unless this bound is below the best bid so far.
    Above(NodeId),
    /// Unless this number is below the best bid so far.
    Over(f64),
    /// Unless the best bid so far is infinite and has a higher place.
    Place,
}

/// The evaluation of a bid.
#[derive(Clone, Copy, Debug, PartialEq)]
struct Step {
    bid: Bid,
    /// Skips even the bound.
    sparing: Option<Sparing>,
    guard: Guard,
    /// Executed always.
    first: Work,
    /// Executed regardless of the guard.
    before: Work,
    /// Executed if the guard passes.
    inside: Work,
}

impl Step {
    /// All of its work, at most.
    fn all(&self) -> Work {
        self.first.plus(self.before).plus(self.inside)
    }

    /// A bid that is always computed.
    fn always(bid: Bid, inside: Work) -> Self {
        let nothing = Work::default();
        Self { bid, sparing: None, guard: Guard::None, first: nothing, before: nothing, inside }
    }
}

/// The work of a program, decision by decision.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct Costs<'a> {
    module: &'a Module<'a>,
    /// The nodes that steps name: the module's, and bounds after them.
    nodes: &'a [Node],
    /// Executed once, before the walk.
    once: Work,
    /// The steps of each team, in order of evaluation.
    teams: Vec<Vec<Step>>,
    /// Every team decides, on the walk or not.
    all_teams: bool,
    /// Executed at each leaf.
    leaves: Vec<Work>,
}

impl<'a> Costs<'a> {
    /// Counts a program.
    pub(crate) fn of(program: &'a Program<'a>) -> Self {
        let module = &program.module;
        let costs = Self {
            module,
            nodes: &module.nodes,
            once: Work::default(),
            teams: Vec::new(),
            all_teams: false,
            leaves: module.leaves.iter().map(|leaf| needed_work(&module.nodes, &leaf.values)).collect(),
        };
        match &program.shape {
            // Every bid of a team is computed by itself.
            Small(_) | Gegelati | Integers(_) => {
                let step = |bid: Bid| Step::always(bid, work(&module.nodes, &module.operations_of(bid.value)));
                Self { teams: in_order(module, step), ..costs }
            }
            // Everything is computed, whatever the state.
            ConstantTime(functions) => {
                let deciding = functions.iter().map(|function| work(&module.nodes, &function.operations));
                let deciding = deciding.fold(Work::default(), Work::plus);
                let once = deciding.plus(work(&module.nodes, &functions::leaf_operations(module, functions)));
                let teams = in_order(module, |bid| Step::always(bid, Work::default()));
                Self { once, teams, all_teams: true, leaves: Vec::new(), ..costs }
            }
            Balanced(cases) => {
                let teams = (0..module.teams.len()).map(|team| tabulated(cases, team)).collect();
                let leaves = cases.leaves.iter().map(|leaf| needed_work(&cases.nodes, &leaf.values)).collect();
                Self { nodes: &cases.nodes, teams, leaves, ..costs }
            }
            // The root has one way to go, and its bids are not computed.
            Formula(_) => Self { teams: vec![Vec::new()], ..costs },
            Fast { schedule, .. } => {
                let plans = schedule.plans.iter();
                let teams = plans.map(|plan| planned(&schedule.nodes, plan, program.language)).collect();
                let leaves = schedule.leaves.iter().map(|leaf| needed_work(&schedule.nodes, &leaf.values)).collect();
                Self { nodes: &schedule.nodes, teams, leaves, ..costs }
            }
        }
    }

    /// The worst case of each number by itself: the walk with most operations need not be the one with most teams.
    pub(crate) fn worst(&self) -> Cost<u64> {
        let heaviest = |weight: fn(&Step) -> u64| {
            let team = |team: usize| self.teams[team].iter().map(weight).sum::<u64>();
            if self.all_teams { (0..self.teams.len()).map(team).sum() } else { heaviest_walk(&self.module.teams, team) }
        };
        let leaf = self.leaves.iter().copied().fold(Work::default(), Work::most);
        Cost {
            teams: self.module.depth as u64,
            bids: heaviest(|_| 1),
            operations: self.once.operations + heaviest(|step| step.all().operations) + leaf.operations,
            maths_calls: self.once.maths_calls + heaviest(|step| step.all().maths_calls) + leaf.maths_calls,
        }
    }
}

/// The steps of teams that evaluate their bids by place.
fn in_order(module: &Module<'_>, step: impl Fn(Bid) -> Step) -> Vec<Vec<Step>> {
    (module.teams.iter())
        .map(|team| {
            (team.edges.iter().enumerate())
                .map(|(place, edge)| step(Bid { place, value: module.bidders[edge.bidder].value, ascending: true }))
                .collect()
        })
        .collect()
}

/// The steps of a team of tables over native bids.
fn tabulated(cases: &Cases, team: usize) -> Vec<Step> {
    let step = |(place, case): (usize, Case)| {
        let [before, inside] = cases.operations(case).map(|ids| work(&cases.nodes, &ids));
        let step = Step::always(Bid { place, value: case.value, ascending: false }, inside);
        match case.kind {
            Kind::Plain => Step { first: before, ..step },
            Kind::Bounded(bound) => Step { guard: Guard::Above(bound), before, ..step },
            Kind::Function(Function { bound: Some(bound), .. }) => Step { guard: Guard::Over(bound), before, ..step },
            Kind::Function(Function { sparing, .. }) => Step { sparing, first: before, ..step },
        }
    };
    cases.team(team).map(step).collect()
}

/// The steps of a plan.
fn planned(nodes: &[Node], plan: &TeamSchedule, language: Language) -> Vec<Step> {
    // With one way to go, no bid matters.
    if plan.destinations().len() == 1 {
        return Vec::new();
    }
    let mut scope = Scope { nodes, computed: BTreeSet::new() };
    let mut steps: Vec<Step> = (plan.eager.iter())
        .map(|&bid| Step { first: scope.compute(bid.value), ..Step::always(bid, Work::default()) })
        .collect();
    steps.extend(plan.lazy.iter().map(|lazy| scope.lazy(lazy, language)));
    steps
}

/// The values in scope while a team is evaluated. Later bids reuse values that were computed outside a guard; in Rust, an
/// unguarded bid has no braces around it.
struct Scope<'a> {
    nodes: &'a [Node],
    computed: BTreeSet<NodeId>,
}

impl Scope<'_> {
    fn compute(&mut self, value: NodeId) -> Work {
        let missing = needed(self.nodes, value, |id| !self.computed.contains(&id));
        let work = work(self.nodes, &missing);
        self.computed.extend(missing);
        work
    }

    fn lazy(&mut self, lazy: &LazyBid, language: Language) -> Step {
        let LazyBid { bid, sparing, bound } = *lazy;
        let first = sparing.map(|sparing| self.compute(sparing.argument)).unwrap_or_default();
        let outside = self.computed.clone();
        let before = bound.map(|bound| self.compute(bound)).unwrap_or_default();
        let guard = match bound {
            Some(bound) => Guard::Bound(bound),
            None if bid.ascending => Guard::None,
            None => Guard::Place,
        };
        let behind_bounds = self.computed.clone();
        let inside = self.compute(bid.value);
        if sparing.is_some() {
            self.computed = outside;
        } else if !(guard == Guard::None && language == Language::Rust) {
            self.computed = behind_bounds;
        }
        Step { sparing, guard, first, before, ..Step::always(bid, inside) }
    }
}

/// The work of some values.
fn needed_work(nodes: &[Node], values: &[NodeId]) -> Work {
    work(nodes, &values.iter().flat_map(|&value| needed(nodes, value, |_| true)).collect::<BTreeSet<_>>())
}

fn work<'a>(nodes: &[Node], ids: impl IntoIterator<Item = &'a NodeId, IntoIter: Clone>) -> Work {
    let nodes = ids.into_iter().map(|id| nodes[id.index()]);
    Work {
        operations: nodes.clone().filter(Node::is_computed).count() as u64,
        maths_calls: nodes.filter(Node::is_transcendental).count() as u64,
    }
}
