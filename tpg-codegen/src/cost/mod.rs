//! What a decision costs, counted on the generated code: teams, bids, operations, and sines, cosines, logarithms and
//! exponentials among them. At most ([`Costs::worst`]), and on average over given states ([`Costs::mean`]).

mod mean;

use crate::emit::{Language, Options, Profile, Style};
use crate::graph::Graph;
use crate::ir::{Module, Node, NodeId, heaviest_walk, needed};
use crate::passes::arithmetic::is_transcendental;
use crate::passes::schedule::{Bid, LazyBid, Plan, Schedule, schedule};
use crate::passes::{self, Removed};
use serde::Serialize;
use std::collections::BTreeSet;

/// What one decision costs.
#[derive(Clone, Copy, Debug, Default, PartialEq, Serialize)]
pub struct Cost<N> {
    /// Teams that decide.
    pub teams: N,
    /// Bids that are looked at.
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

/// When a bid is computed.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Guard {
    /// Always.
    None,
    /// Unless this bound is below the best bid so far.
    Bound(NodeId),
    /// Unless the best bid so far is infinite and has a higher place.
    Place,
}

/// A team looks at a bid.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
struct Step {
    bid: Bid,
    guard: Guard,
    /// Where this is above the best bid so far, the bid wins without being computed.
    certain: Option<NodeId>,
    /// Done whatever the guard says.
    before: Work,
    /// Done where it lets pass.
    inside: Work,
    /// Done besides, at most: a leader that was not computed may have to be.
    again: Work,
}

impl Step {
    /// A bid that is computed always, whatever the others bid.
    fn always(bid: Bid, inside: Work) -> Self {
        let nothing = Work::default();
        Self { bid, guard: Guard::None, certain: None, before: nothing, inside, again: nothing }
    }
}

/// What code of one shape does, decision by decision.
#[derive(Clone, Debug, PartialEq)]
pub struct Costs {
    module: Module,
    /// The nodes that steps name: the module's, and bounds after them.
    nodes: Vec<Node>,
    /// Done before the walk, once.
    once: Work,
    /// By team, in the order they are looked at.
    teams: Vec<Vec<Step>>,
    /// Whether every team decides, on the walk or not.
    all_teams: bool,
}

impl Costs {
    /// Of the code that `options` ask for in a language, and what the passes removed.
    pub fn of(graph: &Graph, language: Language, options: &Options) -> (Self, Removed) {
        if options.style == Style::Gegelati && language == Language::C {
            return (Self::bid_by_bid(Module::lower(graph)), Removed::default());
        }
        let (module, removed) = passes::optimise(graph, options.assumption);
        let costs = match options.shape(language, &module) {
            Profile::Fast => {
                let schedule = schedule(graph, &module);
                Self::scheduled(module, &schedule, language)
            }
            Profile::Small => Self::bid_by_bid(module),
            Profile::ConstantTime => Self::everything(module),
        };
        (costs, removed)
    }

    /// Every bid of a team is computed by itself: tables, and GEGELATI's style.
    pub fn bid_by_bid(module: Module) -> Self {
        let step = |bid: Bid| {
            let operations = module.operations_of(bid.value);
            Step::always(bid, work(&module.nodes, &operations))
        };
        let teams = in_order(&module, step);
        Self { nodes: module.nodes.clone(), once: Work::default(), teams, all_teams: false, module }
    }

    /// Everything is computed once, whatever the state: constant time.
    pub fn everything(module: Module) -> Self {
        let teams = in_order(&module, |bid| Step::always(bid, Work::default()));
        let all: Vec<NodeId> = (0..).map(NodeId).take(module.nodes.len()).collect();
        Self { nodes: module.nodes.clone(), once: work(&module.nodes, &all), teams, all_teams: true, module }
    }

    /// What a schedule says, as a language's emitter writes it.
    pub fn scheduled(module: Module, schedule: &Schedule, language: Language) -> Self {
        let teams = schedule.plans.iter().map(|plan| planned(&schedule.nodes, plan, language)).collect();
        Self { nodes: schedule.nodes.clone(), once: Work::default(), teams, all_teams: false, module }
    }

    /// No decision costs more, each number by itself: the walk with most operations need not be the one with most teams.
    pub fn worst(&self) -> Cost<u64> {
        let heaviest = |weight: fn(&Step) -> u64| {
            let team = |team: usize| self.teams[team].iter().map(weight).sum::<u64>();
            if self.all_teams { (0..self.teams.len()).map(team).sum() } else { heaviest_walk(&self.module.teams, team) }
        };
        Cost {
            teams: self.module.depth as u64,
            bids: heaviest(|_| 1),
            operations: self.once.operations
                + heaviest(|step| step.before.operations + step.inside.operations + step.again.operations),
            maths_calls: self.once.maths_calls
                + heaviest(|step| step.before.maths_calls + step.inside.maths_calls + step.again.maths_calls),
        }
    }

    /// Operations as the code writes them down, all teams together.
    pub(crate) fn written(&self) -> u64 {
        let steps = self.teams.iter().flatten();
        self.once.operations + steps.map(|step| step.before.operations + step.inside.operations).sum::<u64>()
    }

    /// The optimised module that the code is made of.
    pub fn module(&self) -> &Module {
        &self.module
    }
}

/// The steps of teams that look at their bids by place.
fn in_order(module: &Module, step: impl Fn(Bid) -> Step) -> Vec<Vec<Step>> {
    (module.teams.iter())
        .map(|team| {
            (team.edges.iter().enumerate())
                .map(|(place, edge)| step(Bid { place, value: module.bidders[edge.bidder].value, in_turn: true }))
                .collect()
        })
        .collect()
}

/// The steps of a plan. What was computed outside of a guard is there for later bids; in Rust, an unguarded bid has no
/// braces around it.
fn planned(nodes: &[Node], plan: &Plan, language: Language) -> Vec<Step> {
    let mut computed = BTreeSet::new();
    let mut missing = |value: NodeId, stays: bool| {
        let missing = needed(nodes, value, |id| !computed.contains(&id));
        let work = work(nodes, &missing);
        if stays {
            computed.extend(missing);
        }
        work
    };
    let mut steps: Vec<Step> = (plan.eager.iter())
        .map(|&bid| Step { before: missing(bid.value, true), ..Step::always(bid, Work::default()) })
        .collect();
    let mut again = Work::default();
    steps.extend(plan.lazy.iter().map(|&LazyBid { bid, bound, certain }| {
        // Only C leaves it at what is certain.
        let certain = certain.filter(|_| language == Language::C);
        let before =
            bound.into_iter().chain(certain).map(|bound| missing(bound, true)).fold(Work::default(), Work::plus);
        let guard = match bound {
            Some(bound) => Guard::Bound(bound),
            None if bid.in_turn => Guard::None,
            None => Guard::Place,
        };
        let inside = match certain {
            // In a function of its own, which computes all that it needs.
            Some(_) => work(nodes, &needed(nodes, bid.value, |_| true)),
            None => missing(bid.value, guard == Guard::None && language == Language::Rust),
        };
        let step = Step { bid, guard, certain, before, inside, again };
        if certain.is_some() {
            again = again.most(inside);
        }
        step
    }));
    steps
}

fn work(nodes: &[Node], ids: &[NodeId]) -> Work {
    let nodes = || ids.iter().map(|id| nodes[id.index()]);
    Work {
        operations: nodes().filter(Node::is_computed).count() as u64,
        maths_calls: nodes()
            .filter(|node| matches!(*node, Node::Operation(instruction, _) if is_transcendental(instruction)))
            .count() as u64,
    }
}
