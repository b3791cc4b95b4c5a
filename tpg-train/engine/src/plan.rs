//! Roots prepared for evaluation: their distinct nodes, and for each distinct team the nodes to compute and the edges to
//! evaluate.

use crate::nodes::{Arena, Node, NodeId};
use crate::policy::{Destination, Line, PolicyGraph};
use crate::source_set::{SourceSet, state_length};
use std::collections::{BTreeSet, HashMap};
use std::sync::Arc;
use tpg_graph::SourceDocument;
use tpg_graph::hash_cons::HashCons;
use tpg_runtime::ops::Maths;
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

/// A bid for an edge.
#[derive(Clone, Copy, Debug)]
pub(super) struct PlannedBid {
    pub(super) code: Code,
    pub(super) bid: NodeId,
}

/// A team: its edges, and the operations that their bids depend on.
#[derive(Clone, Debug)]
pub(super) struct PlannedTeam {
    pub(super) first: Code,
    /// The edges; none where there is a single one, and so nothing to decide.
    pub(super) edges: Vec<PlannedBid>,
    pub(super) needs: Vec<NodeId>,
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
    pub(super) teams: Vec<PlannedTeam>,
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
    pub fn new<M: Maths<S>>(policy: &PolicyGraph, sources: &[SourceDocument]) -> Self {
        Self::of_roots::<M>(&[policy], sources)
    }

    /// Plans several policies over the same state.
    ///
    /// # Panics
    /// If they do not have the same outputs, or there are none.
    pub fn of_roots<M: Maths<S>>(policies: &[&PolicyGraph], sources: &[SourceDocument]) -> Self {
        Self::in_arena(Arena::<S, M>::default(), policies, sources)
    }

    /// As [`new`](Self::new), but the whole state is observed, also what no program reads.
    pub(super) fn observing_all<M: Maths<S>>(policy: &PolicyGraph, sources: &[SourceDocument]) -> Self {
        let mut arena = Arena::<S, M>::default();
        (0..state_length(sources)).for_each(|input| arena.input(input as u16));
        Self::in_arena(arena, &[policy], sources)
    }

    fn in_arena<M: Maths<S>>(mut arena: Arena<S, M>, policies: &[&PolicyGraph], sources: &[SourceDocument]) -> Self {
        let outputs = &policies[0].outputs;
        assert!(policies.iter().all(|policy| policy.outputs == *outputs), "roots with the same outputs");
        let mut known = Known::default();
        let roots: Vec<u32> = policies.iter().map(|policy| known.add(&mut arena, policy)).collect();
        let Known { teams, actions, .. } = known;
        let count = teams.nodes().len() as u32;
        // Edges lead to teams that were known before.
        let team_place = |team: u32| count - 1 - team;
        let place = |target: PlannedTarget| match target {
            PlannedTarget::Team(team) => team_place(team),
            PlannedTarget::Action(action) => count + action,
        };
        let teams = teams.nodes().iter().rev().map(|edges| planned_team(arena.nodes(), edges, place)).collect();
        let leaf = |(_, values): &(ActionId, Vec<NodeId>)| PlannedLeaf {
            needs: needs(arena.nodes(), values.iter().copied()),
            values: values.clone(),
        };
        let leaves = if outputs.is_empty() { Vec::new() } else { actions.nodes().iter().map(leaf).collect() };
        let limits = outputs.iter().map(|it| [it.min, it.max, it.nan].map(S::from_f64)).collect();
        let mut places = vec![u32::MAX; state_length(sources)];
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

fn planned_team<S>(nodes: &[Node<S>], edges: &[PlannedEdge], place: impl Fn(PlannedTarget) -> u32) -> PlannedTeam {
    let codes: Vec<Code> = (0u32..).zip(edges).map(|(edge, planned)| Code::new(edge, place(planned.to))).collect();
    let asked = if edges.len() == 1 { &[] } else { edges };
    let bids = codes.iter().zip(asked).map(|(&code, edge)| PlannedBid { code, bid: edge.bid });
    let mut next: Vec<u32> = codes.iter().map(|code| code.to()).collect();
    next.sort_unstable();
    next.dedup();
    PlannedTeam {
        first: codes.first().copied().unwrap_or(Code(0)),
        edges: bids.collect(),
        needs: needs(nodes, asked.iter().map(|edge| edge.bid)),
        next,
    }
}

/// Returns the operations that the given bids depend on, operands first.
fn needs<S>(nodes: &[Node<S>], bids: impl IntoIterator<Item = NodeId>) -> Vec<NodeId> {
    let mut needed = BTreeSet::new();
    let mut open: Vec<NodeId> = bids.into_iter().collect();
    while let Some(id) = open.pop() {
        if let Node::Operation(_, a, b) = &nodes[id.index()]
            && needed.insert(id)
        {
            open.extend([*a, *b]);
        }
    }
    needed.into_iter().collect()
}
