//! A root, made ready to be evaluated: its distinct nodes, and for each team what to compute and whom to ask.

use super::environment::SourceSet;
use super::lanes::Options;
use super::nodes::{Arena, Node, NodeId};
use super::policy::{Destination, Policy};
use tpg_codegen::graph::SourceDocument;
use tpg_runtime::ops::{Instruction, Maths};
use tpg_runtime::scalar::Scalar;

/// A bidder and what it bids for.
#[derive(Clone, Copy, Debug)]
pub(super) struct PlannedEdge {
    pub(super) bid: NodeId,
    pub(super) to: Destination,
}

/// An edge that is asked only where its bid could win.
#[derive(Clone, Debug)]
pub(super) struct LazyEdge<S> {
    /// Its place among the team's edges.
    pub(super) edge: u32,
    /// It never bids more.
    pub(super) most: S,
    /// What it needs beside the eager edges' needs.
    pub(super) needs: Vec<NodeId>,
}

/// A team: its edges, and what its eager bids need, in an order in which it can be computed.
#[derive(Clone, Debug)]
pub(super) struct PlannedTeam<S> {
    pub(super) edges: Vec<PlannedEdge>,
    /// Places of the edges that are always asked, ascending.
    pub(super) eager: Vec<u32>,
    pub(super) needs: Vec<NodeId>,
    pub(super) lazy: Vec<LazyEdge<S>>,
}

/// A root, ready to be evaluated.
#[derive(Clone, Debug)]
pub struct Plan<S> {
    pub(super) nodes: Vec<Node<S>>,
    pub(super) teams: Vec<PlannedTeam<S>>,
    /// The inputs read anywhere, with the node each one is.
    pub(super) inputs: Vec<(u16, NodeId)>,
    pub(super) wanted: SourceSet,
    pub(super) state_length: usize,
}

impl<S: Scalar> Plan<S> {
    /// Plans a policy over the state of those sources.
    pub fn new<M: Maths<S>>(policy: &Policy, sources: &[SourceDocument], options: Options) -> Self {
        let mut arena = Arena::<S, M>::new(options.share);
        let bids: Vec<NodeId> =
            policy.programs.iter().map(|program| arena.program(policy.registers, program)).collect();
        let facts = facts(arena.nodes(), options.lazy);
        let teams = (policy.teams.iter())
            .map(|team| {
                let mut edges: Vec<PlannedEdge> =
                    (team.iter()).map(|edge| PlannedEdge { bid: bids[edge.program as usize], to: edge.to }).collect();
                if options.share {
                    drop_hopeless(&mut edges);
                }
                planned_team(arena.nodes(), &facts, edges)
            })
            .collect();
        let inputs: Vec<(u16, NodeId)> = (0u32..)
            .zip(arena.nodes())
            .filter_map(|(place, node)| match node {
                Node::Input(input) => Some((*input, NodeId(place))),
                _ => None,
            })
            .collect();
        let wanted = SourceSet::of_inputs(sources, inputs.iter().map(|&(input, _)| input));
        let state_length = sources.iter().map(|source| source.length as usize).sum();
        Self { nodes: arena.nodes().to_vec(), teams, inputs, wanted, state_length }
    }

    /// Values of the flat state.
    pub fn state_length(&self) -> usize {
        self.state_length
    }

    /// Distinct operations of the whole root.
    pub fn operations(&self) -> usize {
        self.nodes.iter().filter(|node| matches!(node, Node::Operation(..))).count()
    }
}

/// Of two edges of a team with the same bid the later wins, so the earlier never does.
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

/// A lazy edge needs no more nodes than these: in one lane they are computed without memory of what was computed.
const FEW: usize = 8;

fn planned_team<S: Scalar>(nodes: &[Node<S>], facts: &[Fact<S>], edges: Vec<PlannedEdge>) -> PlannedTeam<S> {
    let all = || (0u32..).zip(&edges).map(|(place, edge)| (place, edge.bid));
    let bounded = |bid: NodeId| facts[bid.index()].most.filter(|_| facts[bid.index()].expensive);
    let (mut eager, mut lazy) = (Vec::new(), Vec::new());
    let always = needs(nodes, all().map(|(_, bid)| bid).filter(|&bid| bounded(bid).is_none()).collect());
    for (edge, bid) in all() {
        let mut needs = needs(nodes, vec![bid]);
        needs.retain(|node| !always.contains(node));
        match bounded(bid) {
            // What the eager edges compute anyway costs nothing more.
            Some(most) if !needs.is_empty() && needs.len() <= FEW => lazy.push(LazyEdge { edge, most, needs }),
            _ => eager.push(edge),
        }
    }
    let needs = needs(nodes, eager.iter().map(|&edge| edges[edge as usize].bid).collect());
    PlannedTeam { edges, eager, needs, lazy }
}

/// What is known of a node's value, whatever the inputs.
#[derive(Clone, Copy, Debug)]
struct Fact<S> {
    /// What its magnitude never exceeds. A NaN is no value: it bids −∞.
    most: Option<S>,
    /// Whether it takes long to compute.
    expensive: bool,
}

/// Facts of every node; none is expensive where nothing shall be lazy.
fn facts<S: Scalar>(nodes: &[Node<S>], lazy: bool) -> Vec<Fact<S>> {
    let mut facts: Vec<Fact<S>> = Vec::with_capacity(nodes.len());
    for node in nodes {
        facts.push(match *node {
            Node::Input(_) => Fact { most: None, expensive: false },
            Node::Constant(value) => Fact { most: (!value.is_nan()).then(|| value.abs()), expensive: false },
            Node::Operation(instruction, a, b) => {
                let (a, b) = (facts[a.index()], facts[b.index()]);
                let transcendental =
                    matches!(instruction, Instruction::Cos | Instruction::Sin | Instruction::Ln | Instruction::Exp);
                let expensive = lazy && (transcendental || a.expensive || b.expensive);
                Fact { most: most(instruction, a.most, b.most), expensive }
            }
        });
    }
    facts
}

/// The bound of a result by those of its operands. Rounding is monotone: a sum of bounds, rounded, bounds every rounded sum.
fn most<S: Scalar>(instruction: Instruction, a: Option<S>, b: Option<S>) -> Option<S> {
    match instruction {
        Instruction::Cos | Instruction::Sin => Some(S::ONE),
        Instruction::Abs | Instruction::NegateIfLess => a,
        Instruction::Add | Instruction::Sub => Some(a? + b?),
        Instruction::Min | Instruction::Max => Some(if a? > b? { a? } else { b? }),
        Instruction::Mul | Instruction::Div | Instruction::Ln | Instruction::Exp => None,
    }
}

/// The operations that some bids are made of.
fn needs<S>(nodes: &[Node<S>], mut open: Vec<NodeId>) -> Vec<NodeId> {
    let mut needed = vec![false; nodes.len()];
    while let Some(id) = open.pop() {
        if let Node::Operation(_, a, b) = &nodes[id.index()]
            && !std::mem::replace(&mut needed[id.index()], true)
        {
            open.extend([*a, *b]);
        }
    }
    (0u32..).zip(needed).filter(|(_, needed)| *needed).map(|(place, _)| NodeId(place)).collect()
}
