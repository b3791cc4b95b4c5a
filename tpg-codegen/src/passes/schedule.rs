//! The order in which a team of a fast policy evaluates its bids, and the guards that skip some of them.
//!
//! Cheap bids come first; a bid with sines, logarithms or exponentials follows, and is computed only if its
//! [upper bound](super::bound) says that it can still win. The winner does not depend on the order: the highest place in
//! the team breaks ties, and a bid that is computed out of order compares places, too.

use super::arithmetic::Arithmetic;
use super::bound::Bounds;
use super::collect;
use super::interval;
use crate::ir::{Leaf, Module, Node, NodeId, Successor, Values};
use Instruction::*;
use tpg_graph::ScalarType;
use tpg_runtime::ops::Instruction;

/// A bid of a team.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) struct Bid {
    /// Its place in the team.
    pub place: usize,
    /// The value of the bid.
    pub value: NodeId,
    /// All bids evaluated before have lower places: an equal bid wins.
    pub ascending: bool,
}

/// A logarithm or an exponential is not above a number where its argument is not above another.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Sparing {
    /// The argument, which is cheap.
    pub argument: NodeId,
    /// If the argument is at most this …
    pub at_most: f64,
    /// … the bid is lower than this.
    pub below: f64,
}

impl Sparing {
    /// The rule for a logarithm or an exponential of an argument: numbers far enough apart for every provider.
    pub(crate) fn new(instruction: Instruction, argument: NodeId) -> Option<Self> {
        match instruction {
            Exp => Some(Self { argument, at_most: 2.0, below: 7.5 }),
            Ln => Some(Self { argument, at_most: 8000.0, below: 9.0 }),
            _ => None,
        }
    }
}

/// A bid that may be skipped.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct LazyBid {
    /// The bid.
    pub bid: Bid,
    /// Skips even the bound.
    pub sparing: Option<Sparing>,
    /// Upper bound: it cannot win if this is below the best bid so far.
    pub bound: Option<NodeId>,
}

/// The evaluation plan of a team.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct TeamSchedule {
    /// The team's id in the source file.
    pub label: u32,
    /// Bids that are always computed, by place.
    pub eager: Vec<Bid>,
    /// The others, in order of evaluation.
    pub lazy: Vec<LazyBid>,
    /// The edges' destinations, by place.
    pub targets: Vec<Successor>,
}

impl TeamSchedule {
    /// The distinct destinations of the edges; the last is the last edge's, which is taken if no bid wins.
    pub(crate) fn destinations(&self) -> Vec<Successor> {
        let mut destinations = Vec::new();
        for &target in self.targets.iter().rev() {
            if !destinations.contains(&target) {
                destinations.push(target);
            }
        }
        destinations.reverse();
        destinations
    }

    /// Tests whether the first bid is a finite number, which leads whatever the state is.
    pub(crate) fn leads_at_first(&self, nodes: &[Node]) -> bool {
        let number = |bid: &Bid| nodes[bid.value.index()].as_constant();
        self.eager.first().and_then(number).is_some_and(f64::is_finite)
    }

    /// Every value that the team's code mentions: none with one way to go, where no bid matters.
    pub(crate) fn values(&self) -> impl Iterator<Item = NodeId> {
        let lazy = self.lazy.iter().flat_map(|LazyBid { bid, sparing, bound }| {
            sparing.map(|sparing| sparing.argument).into_iter().chain(*bound).chain([bid.value])
        });
        let has_choice = self.destinations().len() > 1;
        self.eager.iter().map(|bid| bid.value).chain(lazy).filter(move |_| has_choice)
    }

    /// Tests for bids that are evaluated in the order that decides ties.
    pub(crate) fn is_ascending(&self) -> bool {
        self.bids().all(|bid| bid.ascending)
    }

    /// Every bid, in order of evaluation.
    pub(crate) fn bids(&self) -> impl Iterator<Item = Bid> {
        self.eager.iter().copied().chain(self.lazy.iter().map(|lazy| lazy.bid))
    }
}

/// The plans of a policy.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct Schedule {
    /// The module's nodes, and bounds after them.
    pub nodes: Vec<Node>,
    /// A plan for each team.
    pub plans: Vec<TeamSchedule>,
    /// The module's leaves.
    pub leaves: Vec<Leaf>,
}

impl Schedule {
    /// Tests for guarded bids.
    pub(crate) fn is_lazy(&self) -> bool {
        self.plans.iter().any(|plan| !plan.lazy.is_empty())
    }
}

/// Bids that cost more than this are guarded.
const CHEAP: u32 = 8;

/// The maximum number of edges of a small graph.
const FEW_EDGES: usize = 64;

/// Plans every team.
pub(crate) fn schedule(module: &Module<'_>) -> Schedule {
    let arithmetic = Arithmetic::new(module.graph);
    let intervals = interval::analyse(module);
    let cheap = cheap_nodes(module);
    let mut values = Values::new(module.nodes.clone());
    // Estimates take more flash than all bids of a small graph, which they would seldom spare.
    let estimates = module.edges() > FEW_EDGES && module.graph.scalar() == ScalarType::F64;
    let mut bounds = Bounds::new(arithmetic, &intervals, &cheap, &mut values, estimates);
    let planner = Planner { module, cheap: &cheap };
    let mut plans: Vec<TeamSchedule> = (0..module.teams.len()).map(|team| planner.plan(team, &mut bounds)).collect();
    let mut nodes = values.into_nodes();
    // Parts of bounds that came to nothing.
    let mut roots = Vec::new();
    for TeamSchedule { eager, lazy, .. } in &mut plans {
        roots.extend(eager.iter_mut().map(|bid| &mut bid.value));
        for LazyBid { bid, sparing, bound } in lazy {
            roots.extend(sparing.iter_mut().map(|sparing| &mut sparing.argument));
            roots.extend(bound.iter_mut().chain([&mut bid.value]));
        }
    }
    let mut leaves = module.leaves.clone();
    roots.extend(leaves.iter_mut().flat_map(|leaf| &mut leaf.values));
    collect::keep(&mut nodes, roots);
    Schedule { nodes, plans, leaves }
}

/// The nodes that need no transcendental function.
fn cheap_nodes(module: &Module<'_>) -> Vec<bool> {
    let mut cheap: Vec<bool> = Vec::with_capacity(module.nodes.len());
    for node in &module.nodes {
        cheap.push(!node.is_transcendental() && node.operands().iter().all(|operand| cheap[operand.index()]));
    }
    cheap
}

/// The rough cost of a node, in additions.
pub(crate) fn cost(node: &Node) -> u32 {
    let Node::Operation(instruction, _) = node else { return 0 };
    match instruction {
        Sub | Add | Mul | Abs => 1,
        NegateIfLess | Min | Max | Gate => 2,
        Div => 4,
        Quotient => 6,
        Sqrt => 8,
        Fmod => 12,
        Exp => 20,
        Ln | Atan => 25,
        Cos | Sin | Tanh => 30,
        Tan => 60,
    }
}

struct Planner<'a> {
    module: &'a Module<'a>,
    cheap: &'a [bool],
}

impl Planner<'_> {
    fn plan(&self, number: usize, bounds: &mut Bounds<'_>) -> TeamSchedule {
        let team = &self.module.teams[number];
        let value = |place: usize| self.module.bidders[team.edges[place].bidder].value;
        let total = |place: usize| -> u32 {
            let operations = self.module.operations_of(value(place));
            operations.iter().map(|id| cost(&self.module.nodes[id.index()])).sum()
        };
        let (eager, mut lazy): (Vec<usize>, Vec<usize>) =
            (0..team.edges.len()).partition(|&place| self.cheap[value(place).index()] || total(place) <= CHEAP);
        // Bids without a bound come first: a higher best bid does not skip them, but skips others. Then the cheaper bids.
        lazy.sort_by_key(|&place| (bounds.upper(value(place)).is_some(), total(place), place));
        let mut highest = None;
        let mut turn = |place: usize| {
            let ascending = highest.is_none_or(|highest| highest < place);
            highest = highest.max(Some(place));
            Bid { place, value: value(place), ascending }
        };
        let eager = eager.into_iter().map(&mut turn).collect();
        let lazy = (lazy.into_iter())
            .map(|place| LazyBid {
                bid: turn(place),
                sparing: self.sparing(value(place)),
                bound: bounds.upper(value(place)),
            })
            .collect();
        TeamSchedule { label: team.label, eager, lazy, targets: team.edges.iter().map(|edge| edge.to).collect() }
    }

    /// The rule for a logarithm or an exponential of a cheap argument.
    fn sparing(&self, value: NodeId) -> Option<Sparing> {
        match self.module.node(value) {
            Node::Operation(instruction, [argument, _]) if self.cheap[argument.index()] => {
                Sparing::new(instruction, argument)
            }
            _ => None,
        }
    }
}
