//! Roots prepared for evaluation: their distinct nodes, and for each distinct team the nodes to compute and the edges to
//! evaluate.

use crate::nodes::{Arena, Node, NodeId, NodeSet};
use crate::options::EngineOptions;
use crate::policy::{Destination, Line, PolicyGraph};
use crate::source_set::SourceSet;
use std::collections::HashMap;
use std::sync::Arc;
use tpg_graph::SourceDocument;
use tpg_graph::hash_cons::HashCons;
use tpg_runtime::ops::{Instruction, Maths};
use tpg_runtime::policy::ActionId;
use tpg_runtime::scalar::Scalar;

/// A bidder and its destination.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
struct PlannedEdge {
    bid: NodeId,
    to: PlannedTarget,
}

/// The destination of an edge, numbered among the distinct ones of all roots, in the order in which they were found.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
enum PlannedTarget {
    Team(u32),
    Action(u32),
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
    pub(super) needs: Vec<NodeId>,
}

/// A team: its edges, and the operations that its eager bids depend on.
#[derive(Clone, Debug)]
pub(super) struct PlannedTeam<S> {
    pub(super) first: Code,
    /// Eager edges, in the order of the team's edges.
    pub(super) eager: Vec<EagerEdge>,
    pub(super) needs: Vec<NodeId>,
    pub(super) lazy: Vec<LazyEdge<S>>,
    /// The places that edges lead to, numbered as in [`Code::to`].
    pub(super) next: Vec<u32>,
}

/// A leaf: its values before they are limited, and the operations that they depend on.
#[derive(Clone, Debug)]
pub(super) struct PlannedLeaf {
    pub(super) values: Vec<NodeId>,
    pub(super) needs: Vec<NodeId>,
}

/// One root or several, ready for evaluation.
///
/// Roots of a population have most of their programs and teams in common. In a plan of several each exists once, so that
/// their episodes can be decided side by side: see [`Lanes::run_roots`](crate::Lanes::run_roots).
#[derive(Clone, Debug)]
pub struct Plan<S> {
    pub(super) nodes: Vec<Node<S>>,
    /// The distinct teams; edges lead to later ones.
    pub(super) teams: Vec<PlannedTeam<S>>,
    /// The place of each root among the teams.
    pub(super) roots: Vec<u32>,
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
        Self::of_roots::<M>(&[policy], sources, options)
    }

    /// Plans several policies over the same state.
    ///
    /// # Panics
    /// If they do not have the same outputs, or there are none.
    pub fn of_roots<M: Maths<S>>(
        policies: &[&PolicyGraph],
        sources: &[SourceDocument],
        options: EngineOptions,
    ) -> Self {
        Self::in_arena(Arena::<S, M>::default(), policies, sources, options)
    }

    /// As [`new`](Self::new), but the whole state is observed, also what no program reads.
    pub(super) fn observing_all<M: Maths<S>>(
        policy: &PolicyGraph,
        sources: &[SourceDocument],
        options: EngineOptions,
    ) -> Self {
        let mut arena = Arena::<S, M>::default();
        let length: u32 = sources.iter().map(|source| source.length).sum();
        (0..length).for_each(|input| arena.input(input as u16));
        Self::in_arena(arena, &[policy], sources, options)
    }

    fn in_arena<M: Maths<S>>(
        mut arena: Arena<S, M>,
        policies: &[&PolicyGraph],
        sources: &[SourceDocument],
        options: EngineOptions,
    ) -> Self {
        let outputs = &policies[0].outputs;
        assert!(policies.iter().all(|policy| policy.outputs == *outputs), "roots with the same outputs");
        let mut known = Known::default();
        let roots: Vec<u32> = policies.iter().map(|policy| known.add(&mut arena, policy)).collect();
        let Known { teams, actions, .. } = known;
        let facts = facts(arena.nodes(), options.lazy);
        let count = teams.nodes().len() as u32;
        // Edges lead to teams that were known before.
        let team_place = |team: u32| count - 1 - team;
        let place = |target: PlannedTarget| match target {
            PlannedTarget::Team(team) => team_place(team),
            PlannedTarget::Action(action) => count + action,
        };
        let teams = teams.nodes().iter().rev().map(|edges| planned_team(arena.nodes(), &facts, edges, place)).collect();
        let leaf = |(_, values): &(ActionId, Vec<NodeId>)| PlannedLeaf {
            needs: needs(arena.nodes(), values.iter().copied()).nodes(),
            values: values.clone(),
        };
        let leaves = if outputs.is_empty() { Vec::new() } else { actions.nodes().iter().map(leaf).collect() };
        let limits = outputs.iter().map(|it| [it.min, it.max, it.nan].map(S::from_f64)).collect();
        let mut places = vec![u32::MAX; sources.iter().map(|source| source.length as usize).sum()];
        for (place, node) in (0u32..).zip(arena.nodes()) {
            if let Node::Input(input) = node {
                places[usize::from(*input)] = place;
            }
        }
        let read = (0u16..).zip(&places).filter(|(_, place)| **place != u32::MAX).map(|(input, _)| input);
        let wanted = SourceSet::of_inputs(sources, read);
        let actions = actions.nodes().iter().map(|(action, _)| *action).collect();
        let roots = roots.into_iter().map(team_place).collect();
        Self { nodes: arena.into_nodes(), teams, roots, actions, leaves, limits, places, wanted }
    }

    /// Returns the sources that a policy reads.
    pub fn wanted(&self) -> SourceSet {
        self.wanted
    }

    /// Returns the number of values in the flat state.
    pub fn state_length(&self) -> usize {
        self.places.len()
    }
}

/// The distinct teams and actions of some roots.
#[derive(Default)]
struct Known {
    teams: HashCons<Vec<PlannedEdge>>,
    /// An action, or a leaf with its values.
    actions: HashCons<(ActionId, Vec<NodeId>)>,
    /// The bids of programs, by the place of their lines in memory: policies share programs. The number of a policy's registers
    /// changes no bid.
    bids: HashMap<*const Line, NodeId>,
}

impl Known {
    /// Adds a root and returns its number among the teams.
    fn add<S: Scalar, M: Maths<S>>(&mut self, arena: &mut Arena<S, M>, policy: &PolicyGraph) -> u32 {
        let bid = |program: &Arc<[Line]>| {
            *self.bids.entry(program.as_ptr()).or_insert_with(|| arena.program(policy.registers, program))
        };
        let bids: Vec<NodeId> = policy.programs.iter().map(bid).collect();
        let mut numbers = vec![0; policy.teams.len()];
        // From the last team to the root: edges lead to later teams.
        for (team, edges) in policy.teams.iter().enumerate().rev() {
            let edges = edges.iter().map(|edge| PlannedEdge {
                bid: bids[edge.program as usize],
                to: match edge.to {
                    Destination::Team(team) => PlannedTarget::Team(numbers[team as usize]),
                    Destination::Action(action) => PlannedTarget::Action(self.action(policy, action, &bids)),
                },
            });
            let mut edges: Vec<PlannedEdge> = edges.collect();
            drop_hopeless(&mut edges);
            numbers[team] = self.teams.intern(edges);
        }
        numbers[0]
    }

    /// Returns the number of an action, or of a leaf of a policy with outputs.
    fn action(&mut self, policy: &PolicyGraph, action: u16, bids: &[NodeId]) -> u32 {
        let values = policy.leaves.get(usize::from(action)).filter(|_| !policy.outputs.is_empty());
        let values = values.into_iter().flatten().map(|&program| bids[program as usize]).collect();
        self.actions.intern((ActionId(action), values))
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
    place: impl Fn(PlannedTarget) -> u32,
) -> PlannedTeam<S> {
    let codes: Vec<Code> = (0u32..).zip(edges).map(|(edge, planned)| Code::new(edge, place(planned.to))).collect();
    let (mut eager, mut lazy) = (Vec::new(), Vec::new());
    let bounded = |bid: NodeId| facts[bid.index()].most.filter(|_| facts[bid.index()].expensive);
    // A single edge leaves nothing to decide.
    let asked = if edges.len() == 1 { &[] } else { edges };
    let always = needs(nodes, asked.iter().map(|edge| edge.bid).filter(|&bid| bounded(bid).is_none()));
    for (&code, &PlannedEdge { bid, .. }) in codes.iter().zip(asked) {
        let lazily = bounded(bid).and_then(|most| {
            let needs = needs(nodes, [bid]).nodes();
            let more = needs.iter().filter(|&&node| !always.contains(node)).count();
            // Nodes that the eager edges compute anyway add no cost.
            (more > 0 && more <= FEW).then_some(LazyEdge { code, bid, most, needs })
        });
        match lazily {
            Some(edge) => lazy.push(edge),
            None => eager.push(EagerEdge { code, bid }),
        }
    }
    let needs = needs(nodes, eager.iter().map(|edge| edge.bid)).nodes();
    let first = codes.first().copied().unwrap_or(Code(0));
    let mut next: Vec<u32> = codes.iter().map(|code| code.to()).collect();
    next.sort_unstable();
    next.dedup();
    PlannedTeam { first, eager, needs, lazy, next }
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
                let expensive = lazy && (instruction.is_transcendental() || a.expensive || b.expensive);
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
        Instruction::Cos | Instruction::Sin | Instruction::Tanh => Some(S::ONE),
        Instruction::Atan => Some(S::from_f64(1.6)),
        Instruction::Abs | Instruction::NegateIfLess | Instruction::Fmod | Instruction::Gate => a,
        Instruction::Add | Instruction::Sub => Some(a? + b?),
        Instruction::Min | Instruction::Max => Some(if a? > b? { a? } else { b? }),
        Instruction::Mul | Instruction::Div | Instruction::Quotient | Instruction::Sqrt => None,
        Instruction::Tan | Instruction::Ln | Instruction::Exp => None,
    }
}

/// Returns the operations that the given bids depend on.
fn needs<S>(nodes: &[Node<S>], bids: impl IntoIterator<Item = NodeId>) -> NodeSet {
    let mut needed = NodeSet::empty(nodes.len());
    let mut open: Vec<NodeId> = bids.into_iter().collect();
    while let Some(id) = open.pop() {
        if let Node::Operation(_, a, b) = &nodes[id.index()]
            && needed.insert(id)
        {
            open.extend([*a, *b]);
        }
    }
    needed
}
