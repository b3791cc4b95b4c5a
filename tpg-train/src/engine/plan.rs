//! A root, made ready to be evaluated: its distinct nodes, and for each team what to compute and whom to ask.

use super::environment::SourceSet;
use super::nodes::{Arena, Node, NodeId};
use super::policy::{Destination, Policy};
use tpg_codegen::graph::SourceDocument;
use tpg_runtime::ops::Maths;
use tpg_runtime::scalar::Scalar;

/// A bidder and what it bids for.
#[derive(Clone, Copy, Debug)]
pub(super) struct PlannedEdge {
    pub(super) bid: NodeId,
    pub(super) to: Destination,
}

/// A team: what its bids need, in an order in which it can be computed, and its edges.
#[derive(Clone, Debug)]
pub(super) struct PlannedTeam {
    pub(super) needs: Vec<NodeId>,
    pub(super) edges: Vec<PlannedEdge>,
}

/// A root, ready to be evaluated.
#[derive(Clone, Debug)]
pub struct Plan<S> {
    pub(super) nodes: Vec<Node<S>>,
    pub(super) teams: Vec<PlannedTeam>,
    /// The inputs read anywhere, with the node each one is.
    pub(super) inputs: Vec<(u16, NodeId)>,
    pub(super) wanted: SourceSet,
    pub(super) state_length: usize,
}

impl<S: Scalar> Plan<S> {
    /// Plans a policy over the state of those sources. `share` as in [`Arena::new`].
    pub fn new<M: Maths<S>>(policy: &Policy, sources: &[SourceDocument], share: bool) -> Self {
        let mut arena = Arena::<S, M>::new(share);
        let bids: Vec<NodeId> =
            policy.programs.iter().map(|program| arena.program(policy.registers, program)).collect();
        let teams = (policy.teams.iter())
            .map(|team| {
                let mut edges: Vec<PlannedEdge> =
                    (team.iter()).map(|edge| PlannedEdge { bid: bids[edge.program as usize], to: edge.to }).collect();
                if share {
                    drop_hopeless(&mut edges);
                }
                PlannedTeam { needs: needs(arena.nodes(), &edges), edges }
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

/// The operations that the bids of `edges` are made of.
fn needs<S>(nodes: &[Node<S>], edges: &[PlannedEdge]) -> Vec<NodeId> {
    let mut needed = vec![false; nodes.len()];
    let mut open: Vec<NodeId> = edges.iter().map(|edge| edge.bid).collect();
    while let Some(id) = open.pop() {
        if let Node::Operation(_, a, b) = &nodes[id.index()]
            && !std::mem::replace(&mut needed[id.index()], true)
        {
            open.extend([*a, *b]);
        }
    }
    (0u32..).zip(needed).filter(|(_, needed)| *needed).map(|(place, _)| NodeId(place)).collect()
}
