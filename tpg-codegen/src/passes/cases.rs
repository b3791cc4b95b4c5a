//! A module as tables of teams over native bids, for the profile `balanced`.
//!
//! Every distinct bid is a case of one `switch`. Of a sine, cosine, logarithm or exponential, the case computes the argument,
//! and the function stands once behind the switch: it is not called where the result is certain to be lower than the best bid so
//! far. A team's cheap bids come first. As bids are taken out of order, a tie needs their places.

use super::collect;
use super::schedule::{LazyBid, Schedule, Sparing};
use crate::ir::{Leaf, Module, Node, NodeId, needed};
use CaseKind::*;
use std::collections::BTreeMap;
use tpg_runtime::ops::Instruction;

/// A distinct bid.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Case {
    /// The value of the bid.
    pub value: NodeId,
    /// The way it is computed.
    pub kind: CaseKind,
}

/// The way a bid is computed.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) enum CaseKind {
    /// At once.
    Plain,
    /// Unless the best bid is above this upper bound.
    Bounded(NodeId),
    /// A function of an argument, unless its result is low.
    Function(CaseFunction),
}

/// A function of an argument.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct CaseFunction {
    /// The function.
    pub instruction: Instruction,
    /// Its argument.
    pub argument: NodeId,
    /// If the best bid is above this, the function is not; the same for all arguments.
    pub bound: Option<f64>,
    /// No bound: a high argument may still give more than the best bid.
    pub sparing: Option<Sparing>,
}

/// The tables, and the bids and leaves that they name.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct Cases {
    /// The distinct bids; functions come last, each kind together.
    pub bids: Vec<Case>,
    /// The bid of each edge, by the order of evaluation in its team.
    pub bidders: Vec<u64>,
    /// The place of each edge in its team, counted from 1; empty if every team's edges are evaluated by place.
    pub places: Vec<u64>,
    /// The destination of each edge: teams from 0, then actions or leaves.
    pub targets: Vec<u64>,
    /// The start of each team's edges, and the end of the last team's.
    pub teams: Vec<u64>,
    /// The destination of each team where no bid wins, which is its last edge's by place.
    pub otherwise: Vec<u64>,
    /// The module's nodes, and bounds after them.
    pub nodes: Vec<Node>,
    /// The module's leaves.
    pub leaves: Vec<Leaf>,
}

impl Cases {
    /// The operations of a bid and of its bound.
    pub(crate) fn operations(&self, case: Case) -> Vec<NodeId> {
        let mut operations = needed(&self.nodes, case.value, |_| true);
        if let Bounded(bound) = case.kind {
            operations.extend(needed(&self.nodes, bound, |id| !operations.contains(&id)));
        }
        operations
    }

    /// The cases that a team's edges name, in order of evaluation.
    pub(crate) fn team(&self, team: usize) -> impl Iterator<Item = Case> {
        let edges = self.teams[team] as usize..self.teams[team + 1] as usize;
        self.bidders[edges].iter().map(|&bidder| self.bids[bidder as usize])
    }

    /// The functions behind the switch: each with the number of its first bid, the highest first.
    pub(crate) fn functions(&self) -> Vec<(usize, CaseFunction)> {
        let mut functions: Vec<(usize, CaseFunction)> = Vec::new();
        for (number, case) in self.bids.iter().enumerate() {
            if let CaseKind::Function(function) = case.kind
                && functions.last().is_none_or(|(_, last)| last.instruction != function.instruction)
            {
                functions.push((number, function));
            }
        }
        functions.reverse();
        functions
    }
}

/// Builds the tables over a schedule's plans.
pub(crate) fn tabulate(module: &Module<'_>, schedule: Schedule) -> Cases {
    let Schedule { nodes, plans, leaves } = schedule;
    let mut bids: BTreeMap<NodeId, CaseKind> = BTreeMap::new();
    let mut edges = Vec::new();
    let (mut places, mut targets, mut teams, mut otherwise) = (Vec::new(), Vec::new(), vec![0], Vec::new());
    for plan in &plans {
        let mut order: Vec<_> = plan.eager.iter().map(|bid| (*bid, Plain)).collect();
        order.extend(plan.lazy.iter().map(|lazy| (lazy.bid, kind(&nodes, lazy))));
        for (bid, kind) in order {
            bids.entry(bid.value).or_insert(kind);
            edges.push(bid.value);
            places.push(bid.place as u64 + 1);
            targets.push(module.vertex(plan.targets[bid.place]) as u64);
        }
        otherwise.extend(plan.targets.last().map(|&target| module.vertex(target) as u64));
        teams.push(edges.len() as u64);
    }
    let mut bids: Vec<Case> = bids.into_iter().map(|(value, kind)| Case { value, kind }).collect();
    bids.sort_by_key(|case| match case.kind {
        Plain | Bounded(_) => None,
        CaseKind::Function(CaseFunction { instruction, .. }) => Some(instruction as u32),
    });
    // Numbered before the nodes are: estimates that no case asks for go.
    let numbers: BTreeMap<NodeId, u64> = (0..).zip(&bids).map(|(number, case)| (case.value, number)).collect();
    let bidders = edges.iter().map(|value| numbers[value]).collect();
    let (mut nodes, mut leaves) = (nodes, leaves);
    let mut roots: Vec<&mut NodeId> = leaves.iter_mut().flat_map(|leaf| &mut leaf.values).collect();
    for Case { value, kind } in &mut bids {
        roots.push(value);
        match kind {
            Plain => {}
            Bounded(bound) => roots.push(bound),
            CaseKind::Function(CaseFunction { argument, sparing, .. }) => {
                roots.push(argument);
                roots.extend(sparing.iter_mut().map(|sparing| &mut sparing.argument));
            }
        }
    }
    collect::keep(&mut nodes, roots);
    let mut cases = Cases { bids, bidders, places, targets, teams, otherwise, nodes, leaves };
    let mut of_teams = cases.teams.windows(2).map(|ends| ends[0] as usize..ends[1] as usize);
    if of_teams.all(|edges| cases.places[edges].is_sorted()) {
        cases.places.clear();
    }
    cases
}

/// The kind of a bid that the schedule may skip. An estimate of a logarithm or an exponential would cost more flash than it saves
/// time: what is known of its argument is enough.
fn kind(nodes: &[Node], lazy: &LazyBid) -> CaseKind {
    let is_estimate = |id: &NodeId| matches!(nodes[id.index()], Node::Upper(..));
    let is_cheap =
        |id: NodeId| !needed(nodes, id, |_| true).iter().any(|id: &NodeId| nodes[id.index()].is_transcendental());
    match nodes[lazy.bid.value.index()] {
        Node::Operation(instruction @ (Instruction::Sin | Instruction::Cos), [argument, _]) if is_cheap(argument) => {
            CaseKind::Function(CaseFunction { instruction, argument, bound: Some(1.0), sparing: None })
        }
        Node::Operation(instruction @ (Instruction::Exp | Instruction::Ln), [argument, _]) => {
            CaseKind::Function(CaseFunction {
                instruction,
                argument,
                bound: None,
                sparing: Sparing::new(instruction, argument),
            })
        }
        _ => match lazy.bound {
            Some(bound) if !needed(nodes, bound, |_| true).iter().any(is_estimate) => Bounded(bound),
            _ => Plain,
        },
    }
}
