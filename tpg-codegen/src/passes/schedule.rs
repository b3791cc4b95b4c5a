//! The order in which a team of a fast policy looks at its bids, and what spares it to look at some.
//!
//! Cheap bids come first; a bid with sines, logarithms or exponentials follows, and is computed only where its
//! [upper bound](super::bound) says that it can still win. Of a logarithm or an
//! exponential that is certain to win, the value is not computed either, unless another bid comes near it: what matters is
//! who wins. The winner does not depend on the order: of equal bids the one
//! with the highest place in the team wins, and a bid that is computed out of turn compares places, too.

use super::arithmetic::Arithmetic;
use super::bound::{Bounds, beyond_exponentials, is_worth_sparing};
use super::collect;
use super::interval::{self, Assumption, Interval};
use super::wins::Wins;
use crate::ir::{Module, Node, NodeId, Target, Values};
use std::cmp::Reverse;
use tpg_graph::ScalarType;
use tpg_runtime::ops::Instruction;

/// A bid of a team.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Bid {
    /// Its place in the team.
    pub place: usize,
    /// What is bid.
    pub value: NodeId,
    /// Whether every bid that was looked at before has a lower place: then, as high a bid wins.
    pub in_turn: bool,
}

/// A logarithm or an exponential is not above a number where its argument is not above another.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Sparing {
    /// The argument, which is cheap.
    pub argument: NodeId,
    /// Where the argument is at most this …
    pub at_most: f64,
    /// … the bid is lower than this.
    pub below: f64,
}

/// A bid that may be spared.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct LazyBid {
    /// The bid.
    pub bid: Bid,
    /// Spares even the bound.
    pub sparing: Option<Sparing>,
    /// Whether it is lower in place than [`Plan::infinite`]: then it cannot win over an infinite bid from there.
    pub before_infinite: bool,
    /// It cannot win where this is below the best bid so far.
    pub bound: Option<NodeId>,
    /// It is certain to win where this is above the best bid so far, and need not be computed to know that.
    pub certain: Option<NodeId>,
}

/// An exponential that is likely infinite.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Infinite {
    /// Its place in the team.
    pub place: usize,
    /// What it is the exponential of, which is cheap.
    pub argument: NodeId,
    /// Above this, every provider's exponential is infinite.
    pub above: f64,
}

/// What a team does.
#[derive(Clone, Debug, PartialEq)]
pub struct Plan {
    /// The team's id in the source file.
    pub label: u32,
    /// What is asked first: an infinite bid spares all that have a lower place. It stands among the lazy bids, too.
    pub infinite: Option<Infinite>,
    /// Bids that are always computed, by place.
    pub eager: Vec<Bid>,
    /// Bids that are computed unless an infinite one leads, by place: those before [`Plan::infinite`].
    pub eager_before: Vec<Bid>,
    /// The others, in the order they are looked at.
    pub lazy: Vec<LazyBid>,
    /// Where the edges lead, by place.
    pub targets: Vec<Target>,
}

impl Plan {
    /// Where edges lead, each place once; the last is where the last edge does, which is where nobody's win leads.
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

    /// Every bid, in the order they are looked at.
    pub fn bids(&self) -> impl Iterator<Item = Bid> {
        self.eager.iter().chain(&self.eager_before).copied().chain(self.lazy.iter().map(|lazy| lazy.bid))
    }
}

/// What a policy does.
#[derive(Clone, Debug, PartialEq)]
pub struct Schedule {
    /// The module's nodes, and bounds after them.
    pub nodes: Vec<Node>,
    /// A plan for each team.
    pub plans: Vec<Plan>,
}

/// Above this, a bid is worth a test that may spare it.
const CHEAP: u32 = 8;

/// Plans every team; where flat states are recorded, by how often bids win along them.
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
    let mut plans: Vec<Plan> = (0..module.teams.len()).map(|team| planner.plan(team, &mut bounds)).collect();
    let mut nodes = values.into_nodes();
    // Parts of bounds that came to nothing.
    let mut roots = Vec::new();
    for Plan { infinite, eager, eager_before, lazy, .. } in &mut plans {
        roots.extend(infinite.iter_mut().map(|infinite| &mut infinite.argument));
        roots.extend(eager.iter_mut().chain(eager_before).map(|bid| &mut bid.value));
        for LazyBid { bid, sparing, bound, certain, .. } in lazy {
            roots.extend(sparing.iter_mut().map(|sparing| &mut sparing.argument));
            roots.extend(bound.iter_mut().chain(certain).chain([&mut bid.value]));
        }
    }
    collect::keep(&mut nodes, roots);
    Schedule { nodes, plans }
}

/// The nodes that need no sine, cosine, logarithm or exponential.
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
        Instruction::NegateIfLess | Instruction::Min | Instruction::Max => 2,
        Instruction::Div => 4,
        Instruction::Exp => 20,
        Instruction::Ln => 25,
        Instruction::Cos | Instruction::Sin => 30,
    }
}

struct Planner<'a> {
    module: &'a Module<'a>,
    scalar: ScalarType,
    wins: &'a Wins,
    cheap: &'a [bool],
    /// What values are where inputs lie in their declared ranges. Only for what is likely: nothing relies on it.
    expected: &'a [Interval],
}

impl Planner<'_> {
    fn plan(&self, number: usize, bounds: &mut Bounds<'_>) -> Plan {
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
        // What has no bound comes first: a higher best bid does not spare it, but spares the others. Then the likelier
        // winners, then the cheaper bids.
        let wins = |place: usize| Reverse(self.wins.of(number, place));
        lazy.sort_by_key(|&place| (bounds.upper(value(place)).is_some(), wins(place), total(place), place));
        let likely = lazy.iter().filter_map(|&place| self.infinite(place, value(place)));
        let infinite = likely.max_by_key(|infinite| infinite.place).filter(|infinite| infinite.place > 0);
        let is_before = |place: usize| infinite.is_some_and(|infinite| place < infinite.place);

        let mut highest = infinite.map(|infinite| infinite.place);
        let mut turn = |place: usize| {
            let in_turn = highest.is_none_or(|highest| highest < place);
            highest = highest.max(Some(place));
            Bid { place, value: value(place), in_turn }
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
        Plan { label: team.label, infinite, eager, eager_before, lazy, targets }
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

    /// Numbers far enough apart for every provider.
    fn sparing(&self, value: NodeId) -> Option<Sparing> {
        let exponential =
            self.argument(value, Instruction::Exp).map(|argument| Sparing { argument, at_most: 2.0, below: 7.5 });
        let logarithm =
            || self.argument(value, Instruction::Ln).map(|argument| Sparing { argument, at_most: 8000.0, below: 9.0 });
        exponential.or_else(logarithm)
    }
}
