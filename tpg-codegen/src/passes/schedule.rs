//! The order in which a team of a fast policy evaluates its bids, and the guards that skip some of them.
//!
//! Cheap bids come first; a bid with sines, logarithms or exponentials follows, and is computed only if its
//! [upper bound](super::bound) says that it can still win. A logarithm or an exponential that is certain to win is not
//! computed either, unless another bid comes near it: only the winner matters. The winner does not depend on the order: the
//! highest place in the team breaks ties, and a bid that is computed out of order compares places, too.

use super::arithmetic::Arithmetic;
use super::bound::{Bounds, beyond_exponentials, is_worth_sparing};
use super::collect;
use super::interval::{self, Assumption, Interval};
use super::wins::Wins;
use crate::ir::{Leaf, Module, Node, NodeId, Target, Values};
use std::cmp::Reverse;
use tpg_graph::ScalarType;
use tpg_runtime::ops::Instruction;

/// A bid of a team.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Bid {
    /// Its place in the team.
    pub place: usize,
    /// The value of the bid.
    pub value: NodeId,
    /// All bids evaluated before have lower places: an equal bid wins.
    pub ascending: bool,
}

/// A logarithm or an exponential is not above a number where its argument is not above another.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Sparing {
    /// The argument, which is cheap.
    pub argument: NodeId,
    /// If the argument is at most this …
    pub at_most: f64,
    /// … the bid is lower than this.
    pub below: f64,
}

impl Sparing {
    /// The rule for a logarithm or an exponential of an argument: numbers far enough apart for every provider.
    pub fn of(instruction: Instruction, argument: NodeId) -> Option<Self> {
        Self::ends(instruction).map(|(at_most, below)| Self { argument, at_most, below })
    }

    /// The two numbers of a logarithm or an exponential.
    pub(crate) fn ends(instruction: Instruction) -> Option<(f64, f64)> {
        match instruction {
            Instruction::Exp => Some((2.0, 7.5)),
            Instruction::Ln => Some((8000.0, 9.0)),
            _ => None,
        }
    }
}

/// A bid that may be skipped.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct LazyBid {
    /// The bid.
    pub bid: Bid,
    /// Skips even the bound.
    pub sparing: Option<Sparing>,
    /// The place is lower than that of [`TeamSchedule::infinite`]: it loses to an infinite bid there.
    pub before_infinite: bool,
    /// Upper bound: it cannot win if this is below the best bid so far.
    pub bound: Option<NodeId>,
    /// Lower bound: it leads without being computed if this is above the best bid so far.
    pub certain: Option<NodeId>,
}

/// An exponential that is likely infinite.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Infinite {
    /// Its place in the team.
    pub place: usize,
    /// The argument of the exponential, which is cheap.
    pub argument: NodeId,
    /// Above this, every provider's exponential is infinite.
    pub above: f64,
}

/// The evaluation plan of a team.
#[derive(Clone, Debug, PartialEq)]
pub struct TeamSchedule {
    /// The team's id in the source file.
    pub label: u32,
    /// Evaluated first: an infinite bid makes every lower-ranked bid unnecessary. It is one of the lazy bids, too.
    pub infinite: Option<Infinite>,
    /// Bids that are always computed, by place.
    pub eager: Vec<Bid>,
    /// Bids that are computed unless an infinite one leads, by place: those before [`TeamSchedule::infinite`].
    pub eager_before: Vec<Bid>,
    /// The others, in order of evaluation.
    pub lazy: Vec<LazyBid>,
    /// The edges' destinations, by place.
    pub targets: Vec<Target>,
}

impl TeamSchedule {
    /// The distinct destinations of the edges; the last is the last edge's, which is taken if no bid wins.
    pub fn destinations(&self) -> Vec<Target> {
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
    pub fn leads_at_first(&self, nodes: &[Node]) -> bool {
        let number = |bid: &Bid| nodes[bid.value.index()].as_constant();
        self.infinite.is_none() && self.eager.first().and_then(number).is_some_and(f64::is_finite)
    }

    /// Every bid, in order of evaluation.
    pub fn bids(&self) -> impl Iterator<Item = Bid> {
        self.eager.iter().chain(&self.eager_before).copied().chain(self.lazy.iter().map(|lazy| lazy.bid))
    }
}

/// The plans of a policy.
#[derive(Clone, Debug, PartialEq)]
pub struct Schedule {
    /// The module's nodes, and bounds after them.
    pub nodes: Vec<Node>,
    /// A plan for each team.
    pub plans: Vec<TeamSchedule>,
    /// The module's leaves.
    pub leaves: Vec<Leaf>,
}

/// Bids that cost more than this are guarded.
const CHEAP: u32 = 8;

/// Plans every team; recorded states, flat, order the bids by how often they win.
///
/// # Panics
/// If the states' length is no multiple of [`Graph::state_length`](tpg_graph::Graph::state_length).
pub fn schedule(module: &Module<'_>, recorded: &[f64]) -> Schedule {
    let wins = &Wins::count(module, recorded);
    let arithmetic = Arithmetic::of(module.graph);
    let intervals = interval::analyse(module, Assumption::Nothing);
    let cheap = cheap_nodes(module);
    let mut values = Values::of(module.nodes.clone());
    let mut bounds = Bounds::new(arithmetic, &intervals, &cheap, &mut values);
    let expected = interval::analyse(module, Assumption::DeclaredRanges);
    let planner = Planner { module, scalar: module.graph.scalar(), wins, cheap: &cheap, expected: &expected };
    let mut plans: Vec<TeamSchedule> = (0..module.teams.len()).map(|team| planner.plan(team, &mut bounds)).collect();
    let mut nodes = values.into_nodes();
    // Parts of bounds that came to nothing.
    let mut roots = Vec::new();
    for TeamSchedule { infinite, eager, eager_before, lazy, .. } in &mut plans {
        roots.extend(infinite.iter_mut().map(|infinite| &mut infinite.argument));
        roots.extend(eager.iter_mut().chain(eager_before).map(|bid| &mut bid.value));
        for LazyBid { bid, sparing, bound, certain, .. } in lazy {
            roots.extend(sparing.iter_mut().map(|sparing| &mut sparing.argument));
            roots.extend(bound.iter_mut().chain(certain).chain([&mut bid.value]));
        }
    }
    let mut leaves = module.leaves.clone();
    roots.extend(leaves.iter_mut().flat_map(|leaf| &mut leaf.values));
    collect::keep(&mut nodes, roots);
    Schedule { nodes, plans, leaves }
}

/// The nodes that need no sine, cosine, tangent, logarithm or exponential.
fn cheap_nodes(module: &Module<'_>) -> Vec<bool> {
    let mut cheap: Vec<bool> = Vec::with_capacity(module.nodes.len());
    for node in &module.nodes {
        let itself = !matches!(*node, Node::Operation(instruction, _) if is_worth_sparing(instruction));
        cheap.push(itself && node.operands().iter().all(|operand| cheap[operand.index()]));
    }
    cheap
}

/// Rough costs, in additions.
pub fn cost(instruction: Instruction) -> u32 {
    match instruction {
        Instruction::Sub | Instruction::Add | Instruction::Mul | Instruction::Abs => 1,
        Instruction::NegateIfLess | Instruction::Min | Instruction::Max | Instruction::Gate => 2,
        Instruction::Div => 4,
        Instruction::Fmod => 12,
        Instruction::Exp => 20,
        Instruction::Ln => 25,
        Instruction::Cos | Instruction::Sin => 30,
        Instruction::Tan => 60,
    }
}

struct Planner<'a> {
    module: &'a Module<'a>,
    scalar: ScalarType,
    wins: &'a Wins,
    cheap: &'a [bool],
    /// Intervals for inputs in their declared ranges: a heuristic, which correctness does not depend on.
    expected: &'a [Interval],
}

impl Planner<'_> {
    fn plan(&self, number: usize, bounds: &mut Bounds<'_>) -> TeamSchedule {
        let team = &self.module.teams[number];
        let value = |place: usize| self.module.bidders[team.edges[place].bidder].value;
        let total = |place: usize| -> u32 {
            (self.module.operations_of(value(place)).iter())
                .map(
                    |&id| {
                        if let Node::Operation(instruction, _) = self.module.node(id) { cost(instruction) } else { 0 }
                    },
                )
                .sum()
        };
        let (eager, mut lazy): (Vec<usize>, Vec<usize>) =
            (0..team.edges.len()).partition(|&place| self.cheap[value(place).index()] || total(place) <= CHEAP);
        // Bids without a bound come first: a higher best bid does not skip them, but skips others. Then the likelier winners,
        // then the cheaper bids.
        let wins = |place: usize| Reverse(self.wins.of(number, place));
        lazy.sort_by_key(|&place| (bounds.upper(value(place)).is_some(), wins(place), total(place), place));
        let likely = lazy.iter().filter_map(|&place| self.infinite(place, value(place)));
        let infinite = likely.max_by_key(|infinite| infinite.place).filter(|infinite| infinite.place > 0);
        let is_before = |place: usize| infinite.is_some_and(|infinite| place < infinite.place);

        let mut highest = infinite.map(|infinite| infinite.place);
        let mut turn = |place: usize| {
            let ascending = highest.is_none_or(|highest| highest < place);
            highest = highest.max(Some(place));
            Bid { place, value: value(place), ascending }
        };
        let (before, after): (Vec<usize>, Vec<usize>) = eager.into_iter().partition(|&place| is_before(place));
        let eager = after.into_iter().map(&mut turn).collect();
        let eager_before = before.into_iter().map(&mut turn).collect();
        let lazy = (lazy.into_iter())
            .map(|place| LazyBid {
                bid: turn(place),
                sparing: self.sparing(value(place)),
                before_infinite: is_before(place),
                bound: bounds.upper(value(place)),
                certain: bounds.certain(value(place)),
            })
            .collect();
        let targets = team.edges.iter().map(|edge| edge.to).collect();
        TeamSchedule { label: team.label, infinite, eager, eager_before, lazy, targets }
    }

    /// The cheap argument of a logarithm or an exponential.
    fn argument(&self, value: NodeId, wanted: Instruction) -> Option<NodeId> {
        match self.module.node(value) {
            Node::Operation(found, [argument, _]) if found == wanted => {
                Some(argument).filter(|argument| self.cheap[argument.index()])
            }
            _ => None,
        }
    }

    /// A bid that is infinite more often than not.
    fn infinite(&self, place: usize, value: NodeId) -> Option<Infinite> {
        let argument = self.argument(value, Instruction::Exp)?;
        let (above, _) = beyond_exponentials(self.scalar);
        let Interval { low, high, .. } = self.expected[argument.index()];
        let likely = high.is_finite() && low.is_finite() && high - above >= above - low;
        likely.then_some(Infinite { place, argument, above })
    }

    fn sparing(&self, value: NodeId) -> Option<Sparing> {
        let of =
            |instruction| self.argument(value, instruction).and_then(|argument| Sparing::of(instruction, argument));
        of(Instruction::Exp).or_else(|| of(Instruction::Ln))
    }
}
