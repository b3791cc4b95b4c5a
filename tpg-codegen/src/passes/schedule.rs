//! The order in which a team of a fast policy looks at its bids, and what spares it to look at some.
//!
//! Cheap bids come first; a bid with sines, logarithms or exponentials follows, and is computed only where its
//! [upper bound](super::bound) says that it can still win. Of a logarithm or an
//! exponential that is certain to win, the value is not computed either, unless another bid comes near it: what matters is
//! who wins. The winner does not depend on the order: of equal bids the one
//! with the highest place in the team wins, and a bid that is computed out of turn compares places, too.

use super::arithmetic::Arithmetic;
use super::bound::{Bounds, is_worth_sparing};
use super::collect;
use super::interval::{self, Assumption};
use crate::graph::Graph;
use crate::ir::{Module, Node, NodeId, Target, Team, Values};
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

/// A bid that may be spared.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct LazyBid {
    /// The bid.
    pub bid: Bid,
    /// It cannot win where this is below the best bid so far.
    pub bound: Option<NodeId>,
    /// It is certain to win where this is above the best bid so far, and need not be computed to know that.
    pub certain: Option<NodeId>,
}

/// What a team does.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Plan {
    /// The team's id in the source file.
    pub label: u32,
    /// Bids that are always computed, by place.
    pub eager: Vec<Bid>,
    /// The others, in the order they are looked at.
    pub lazy: Vec<LazyBid>,
    /// Where the edges lead, by place.
    pub targets: Vec<Target>,
}

/// What a policy does.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Schedule {
    /// The module's nodes, and bounds after them.
    pub nodes: Vec<Node>,
    /// A plan for each team.
    pub plans: Vec<Plan>,
}

/// Above this, a bid is worth a test that may spare it.
const CHEAP: u32 = 8;

/// Plans every team.
pub fn schedule(graph: &Graph, module: &Module) -> Schedule {
    let arithmetic = Arithmetic { scalar: graph.scalar(), maths: graph.maths() };
    let intervals = interval::analyse(graph, module, Assumption::Nothing);
    let cheap = cheap_nodes(module);
    let mut values = Values::of(module.nodes.clone());
    let mut bounds = Bounds::new(arithmetic, &intervals, &cheap, &mut values);
    let mut plans: Vec<Plan> = module.teams.iter().map(|team| plan(module, team, &cheap, &mut bounds)).collect();
    let mut nodes = values.into_nodes();
    // Parts of bounds that came to nothing.
    let mut roots = Vec::new();
    for Plan { eager, lazy, .. } in &mut plans {
        roots.extend(eager.iter_mut().map(|bid| &mut bid.value));
        roots.extend(
            lazy.iter_mut()
                .flat_map(|LazyBid { bid, bound, certain }| bound.iter_mut().chain(certain).chain([&mut bid.value])),
        );
    }
    collect::keep(&mut nodes, roots);
    Schedule { nodes, plans }
}

/// The nodes that need no sine, cosine, logarithm or exponential.
fn cheap_nodes(module: &Module) -> Vec<bool> {
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

fn plan(module: &Module, team: &Team, cheap: &[bool], bounds: &mut Bounds<'_>) -> Plan {
    let value = |place: usize| module.bidders[team.edges[place].bidder].value;
    let total = |place: usize| -> u32 {
        (module.operations_of(value(place)).iter())
            .map(|&id| if let Node::Operation(instruction, _) = module.node(id) { cost(instruction) } else { 0 })
            .sum()
    };
    let (eager, mut lazy): (Vec<usize>, Vec<usize>) =
        (0..team.edges.len()).partition(|&place| cheap[value(place).index()] || total(place) <= CHEAP);
    // What has no bound comes first: a higher best bid does not spare it, but spares the others. Then the cheaper ones.
    lazy.sort_by_key(|&place| (bounds.upper(value(place)).is_some(), total(place), place));

    let mut highest = None;
    let mut turn = |place: usize| {
        let in_turn = highest.is_none_or(|highest| highest < place);
        highest = highest.max(Some(place));
        Bid { place, value: value(place), in_turn }
    };
    let eager = eager.into_iter().map(&mut turn).collect();
    let lazy = (lazy.into_iter())
        .map(|place| LazyBid {
            bid: turn(place),
            bound: bounds.upper(value(place)),
            certain: bounds.certain(value(place)),
        })
        .collect();
    let targets = team.edges.iter().map(|edge| edge.to).collect();
    Plan { label: team.label, eager, lazy, targets }
}
