//! A root prepared for evaluation: its distinct nodes, and for each team the nodes to compute and the edges to
//! evaluate.

use crate::nodes::{Arena, Node, NodeId, NodeSet};
use crate::options::EngineOptions;
use crate::policy::{Destination, Edge, PolicyGraph};
use crate::source_set::SourceSet;
use std::collections::BTreeSet;
use tpg_graph::SourceDocument;
use tpg_runtime::ops::{Instruction, Maths};
use tpg_runtime::policy::ActionId;
use tpg_runtime::scalar::Scalar;

/// A bidder and its destination.
#[derive(Clone, Copy, Debug)]
struct PlannedEdge {
    bid: NodeId,
    to: Destination,
}

/// An edge of a team: its index in the upper half, its destination in the lower.
///
/// Of two edges of a team the later one has the greater code.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub(super) struct Code(pub(super) u32);

impl Code {
    fn new(edge: u32, to: u32) -> Self {
        assert!(
            edge < 1 << 16 && to < 1 << 16,
            "the engine takes graphs of fewer than 2¹⁶ teams, actions and edges of a team"
        );
        Self(edge << 16 | to)
    }

    /// Returns the destination: the index of a team, or the number of teams plus an index into the plan's actions.
    #[inline(always)]
    pub(super) fn to(self) -> u32 {
        self.0 & 0xffff
    }
}

/// An edge that is always evaluated.
#[derive(Clone, Copy, Debug)]
pub(super) struct EagerEdge {
    pub(super) code: Code,
    pub(super) bid: NodeId,
}

/// An edge that is evaluated only where its bid could win.
#[derive(Clone, Debug)]
pub(super) struct LazyEdge<S> {
    pub(super) code: Code,
    pub(super) bid: NodeId,
    /// Upper bound of its bid.
    pub(super) most: S,
    pub(super) needs: NodeSet,
}

/// A team: its edges, and the operations that its eager bids depend on.
#[derive(Clone, Debug)]
pub(super) struct PlannedTeam<S> {
    pub(super) first: Code,
    /// Eager edges, in the order of the team's edges.
    pub(super) eager: Vec<EagerEdge>,
    pub(super) needs: NodeSet,
    pub(super) lazy: Vec<LazyEdge<S>>,
    /// The successor teams.
    pub(super) next: Vec<u32>,
}

/// A leaf: its values before they are limited, and the operations that they depend on.
#[derive(Clone, Debug)]
pub(super) struct PlannedLeaf {
    pub(super) values: Vec<NodeId>,
    pub(super) needs: NodeSet,
}

/// A root, ready for evaluation.
#[derive(Clone, Debug)]
pub struct Plan<S> {
    pub(super) nodes: Vec<Node<S>>,
    pub(super) teams: Vec<PlannedTeam<S>>,
    /// The actions or leaves that edges lead to.
    pub(super) actions: Vec<ActionId>,
    /// The leaves among these, in the same order; empty for a policy without outputs.
    pub(super) leaves: Vec<PlannedLeaf>,
    /// The lowest value of each output, its highest, and that in place of NaN.
    pub(super) limits: Vec<[S; 3]>,
    /// The node of each value of the flat state; `u32::MAX` if nothing reads it.
    pub(super) places: Vec<u32>,
    pub(super) wanted: SourceSet,
}

impl<S: Scalar> Plan<S> {
    /// Plans a policy over the state made of the given sources.
    pub fn new<M: Maths<S>>(policy: &PolicyGraph, sources: &[SourceDocument], options: EngineOptions) -> Self {
        Self::in_arena(Arena::<S, M>::new(options.share), policy, sources, options)
    }

    /// As [`new`](Self::new), but the whole state is observed, also what no program reads.
    pub(super) fn observing_all<M: Maths<S>>(
        policy: &PolicyGraph,
        sources: &[SourceDocument],
        options: EngineOptions,
    ) -> Self {
        let mut arena = Arena::<S, M>::new(options.share);
        let length: u32 = sources.iter().map(|source| source.length).sum();
        (0..length).for_each(|input| arena.input(input as u16));
        Self::in_arena(arena, policy, sources, options)
    }

    fn in_arena<M: Maths<S>>(
        mut arena: Arena<S, M>,
        policy: &PolicyGraph,
        sources: &[SourceDocument],
        options: EngineOptions,
    ) -> Self {
        let bids: Vec<NodeId> =
            policy.programs.iter().map(|program| arena.program(policy.registers, program)).collect();
        let facts = facts(arena.nodes(), options.lazy);
        let actions = actions(policy);
        let teams = (policy.teams.iter())
            .map(|team| {
                let mut edges: Vec<PlannedEdge> =
                    (team.iter()).map(|edge| PlannedEdge { bid: bids[edge.program as usize], to: edge.to }).collect();
                if options.share {
                    drop_hopeless(&mut edges);
                }
                planned_team(arena.nodes(), &facts, &edges, |to| place(policy, &actions, to))
            })
            .collect();
        let leaf = |&ActionId(leaf): &ActionId| {
            let programs = policy.leaves[usize::from(leaf)].iter();
            let values: Vec<NodeId> = programs.map(|&program| bids[program as usize]).collect();
            PlannedLeaf { needs: needs(arena.nodes(), values.iter().copied()), values }
        };
        let leaves = if policy.outputs.is_empty() { Vec::new() } else { actions.iter().map(leaf).collect() };
        let limits = policy.outputs.iter().map(|it| [it.min, it.max, it.nan].map(S::from_f64)).collect();
        let mut places = vec![u32::MAX; sources.iter().map(|source| source.length as usize).sum()];
        for (place, node) in (0u32..).zip(arena.nodes()) {
            if let Node::Input(input) = node {
                places[usize::from(*input)] = place;
            }
        }
        let read = (0u16..).zip(&places).filter(|(_, place)| **place != u32::MAX).map(|(input, _)| input);
        let wanted = SourceSet::of_inputs(sources, read);
        Self { nodes: arena.nodes().to_vec(), teams, actions, leaves, limits, places, wanted }
    }

    /// Returns the number of values in the flat state.
    pub fn state_length(&self) -> usize {
        self.places.len()
    }

    /// Returns the number of outputs; 0 for a policy that chooses among actions.
    pub fn outputs(&self) -> usize {
        self.limits.len()
    }

    /// Returns the number of distinct operations of the whole root.
    pub fn operations(&self) -> usize {
        self.nodes.iter().filter(|node| matches!(node, Node::Operation(..))).count()
    }
}

/// Drops edges that can never win: among edges of a team with the same bid, the last one wins.
fn drop_hopeless(edges: &mut Vec<PlannedEdge>) {
    let mut later = Vec::new();
    for edge in std::mem::take(edges).into_iter().rev() {
        if !later.iter().any(|kept: &PlannedEdge| kept.bid == edge.bid) {
            later.push(edge);
        }
    }
    later.reverse();
    *edges = later;
}

/// Maximum number of nodes of a lazy edge: in one lane they are computed without caching.
const FEW: usize = 8;

fn planned_team<S: Scalar>(
    nodes: &[Node<S>],
    facts: &[Fact<S>],
    edges: &[PlannedEdge],
    place: impl Fn(Destination) -> u32,
) -> PlannedTeam<S> {
    if let [PlannedEdge { to, .. }] = *edges {
        // Nothing to decide.
        let next = if matches!(to, Destination::Team(_)) { vec![place(to)] } else { Vec::new() };
        let first = Code::new(0, place(to));
        return PlannedTeam { first, eager: Vec::new(), needs: needs(nodes, []), lazy: Vec::new(), next };
    }
    let bounded = |bid: NodeId| facts[bid.index()].most.filter(|_| facts[bid.index()].expensive);
    let (mut eager, mut lazy) = (Vec::new(), Vec::new());
    let always = needs(nodes, edges.iter().map(|edge| edge.bid).filter(|&bid| bounded(bid).is_none()));
    let codes: Vec<Code> = (0u32..).zip(edges).map(|(edge, planned)| Code::new(edge, place(planned.to))).collect();
    for (&code, &PlannedEdge { bid, .. }) in codes.iter().zip(edges) {
        let needs = needs(nodes, [bid]);
        let more = needs.without(&always).len();
        match bounded(bid) {
            // Nodes that the eager edges compute anyway add no cost.
            Some(most) if more > 0 && more <= FEW => lazy.push(LazyEdge { code, bid, most, needs }),
            _ => eager.push(EagerEdge { code, bid }),
        }
    }
    let needs = needs(nodes, eager.iter().map(|edge| edge.bid));
    let next = edges.iter().filter(|edge| matches!(edge.to, Destination::Team(_))).map(|edge| place(edge.to)).collect();
    PlannedTeam { first: codes.first().copied().unwrap_or(Code(0)), eager, needs, lazy, next }
}

/// Returns the actions that edges lead to, in ascending order.
fn actions(policy: &PolicyGraph) -> Vec<ActionId> {
    let action = |edge: &Edge| match edge.to {
        Destination::Team(_) => None,
        Destination::Action(action) => Some(action),
    };
    let actions: BTreeSet<u16> = policy.teams.iter().flatten().filter_map(action).collect();
    actions.into_iter().map(ActionId).collect()
}

/// Returns the place of a destination, numbered as in [`Code::to`].
fn place(policy: &PolicyGraph, actions: &[ActionId], to: Destination) -> u32 {
    match to {
        Destination::Team(team) => team,
        Destination::Action(action) => {
            let place = actions.iter().position(|&known| known == ActionId(action)).expect("the policy's own action");
            (policy.teams.len() + place) as u32
        }
    }
}

/// Static knowledge about a node's value, valid for all inputs.
#[derive(Clone, Copy, Debug)]
struct Fact<S> {
    /// Upper bound of the magnitude. NaN is ignored: it bids −∞.
    most: Option<S>,
    /// True if the value is expensive to compute.
    expensive: bool,
}

/// Returns the facts of every node; with `lazy` false, none is marked as expensive.
fn facts<S: Scalar>(nodes: &[Node<S>], lazy: bool) -> Vec<Fact<S>> {
    let mut facts: Vec<Fact<S>> = Vec::with_capacity(nodes.len());
    for node in nodes {
        facts.push(match *node {
            Node::Input(_) => Fact { most: None, expensive: false },
            Node::Constant(value) => Fact { most: (!value.is_nan()).then(|| value.abs()), expensive: false },
            Node::Operation(instruction, a, b) => {
                let (a, b) = (facts[a.index()], facts[b.index()]);
                let transcendental = matches!(
                    instruction,
                    Instruction::Cos | Instruction::Sin | Instruction::Tan | Instruction::Ln | Instruction::Exp
                );
                let expensive = lazy && (transcendental || a.expensive || b.expensive);
                Fact { most: most(instruction, a.most, b.most), expensive }
            }
        });
    }
    facts
}

/// Derives the bound of a result from those of its operands. Rounding is monotone: the rounded sum of bounds bounds
/// every rounded sum.
fn most<S: Scalar>(instruction: Instruction, a: Option<S>, b: Option<S>) -> Option<S> {
    match instruction {
        Instruction::Cos | Instruction::Sin => Some(S::ONE),
        Instruction::Abs | Instruction::NegateIfLess | Instruction::Fmod | Instruction::Gate => a,
        Instruction::Add | Instruction::Sub => Some(a? + b?),
        Instruction::Min | Instruction::Max => Some(if a? > b? { a? } else { b? }),
        Instruction::Mul | Instruction::Div | Instruction::Tan | Instruction::Ln | Instruction::Exp => None,
    }
}

/// Returns the operations that the given bids depend on.
fn needs<S>(nodes: &[Node<S>], bids: impl IntoIterator<Item = NodeId>) -> NodeSet {
    let mut needed = NodeSet::empty(nodes.len());
    let mut open: Vec<NodeId> = bids.into_iter().collect();
    while let Some(id) = open.pop() {
        if let Node::Operation(_, a, b) = &nodes[id.index()]
            && !needed.contains(id)
        {
            needed.insert(id);
            open.extend([*a, *b]);
        }
    }
    needed
}
