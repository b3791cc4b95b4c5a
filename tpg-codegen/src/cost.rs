//! The most that a decision takes, counted on the program: teams, bids, operations, and the sines, cosines, logarithms and
//! exponentials among these.

use crate::ir::{Leaf, Module, Node, NodeId, heaviest_walk, needed};
use crate::options::Language;
use crate::passes::schedule::{LazyBid, TeamSchedule};
use crate::program::Program;
use crate::shape::Shape::*;
use serde::Serialize;
use std::collections::BTreeSet;

/// The cost of a decision at most.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize)]
pub struct Cost {
    /// Teams that decide.
    pub teams: u64,
    /// Bids that are considered.
    pub bids: u64,
    /// Operations on numbers: arithmetic, functions, bounds. Not comparisons of bids, not the way through tables.
    pub operations: u64,
    /// Sines, cosines, logarithms and exponentials among the operations: with the system's maths, calls of libm.
    pub maths_calls: u64,
}

/// A part of a decision.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
struct Tally {
    operations: u64,
    maths_calls: u64,
}

impl Tally {
    fn plus(self, other: Self) -> Self {
        Self { operations: self.operations + other.operations, maths_calls: self.maths_calls + other.maths_calls }
    }

    fn most(self, other: Self) -> Self {
        Self { operations: self.operations.max(other.operations), maths_calls: self.maths_calls.max(other.maths_calls) }
    }
}

impl Cost {
    /// Returns the most that a decision of a program takes.
    pub(crate) fn worst(program: &Program<'_>) -> Self {
        let module = &program.module;
        let mut once = Tally::default();
        // The nodes and leaves that are computed, and the work of each team's bids.
        let (nodes, leaves, teams): (&[Node], &[Leaf], Vec<Vec<Tally>>) = match &program.shape {
            // Every bid of a team is computed by itself.
            Small(_) | Gegelati | Integers(_) => {
                let bids = in_order(module, |bid| work(&module.nodes, &module.operations_of(bid)));
                (&module.nodes, &module.leaves, bids)
            }
            // Everything is computed, whatever the state.
            ConstantTime => {
                let of_leaves = module.leaves.iter().flat_map(|leaf| leaf.values.iter().copied());
                once = needed_work(&module.nodes, module.deciding_bids().into_iter().chain(of_leaves));
                (&module.nodes, &[], in_order(module, |_| Tally::default()))
            }
            Balanced(cases) => {
                let bids = |team| cases.team(team).map(|case| work(&cases.nodes, &cases.operations(case))).collect();
                (&cases.nodes, &cases.leaves, (0..module.teams.len()).map(bids).collect())
            }
            // The root has one way to go, and its bids are not computed.
            Formula => (&module.nodes, &module.leaves, vec![Vec::new()]),
            Fast(schedule) => {
                let bids = |plan| planned(&schedule.nodes, plan, program.language);
                (&schedule.nodes, &schedule.leaves, schedule.plans.iter().map(bids).collect())
            }
        };
        let heaviest = |weight: fn(&Tally) -> u64| {
            let team = |team: usize| teams[team].iter().map(weight).sum::<u64>();
            let all = program.shape == ConstantTime;
            if all { (0..teams.len()).map(team).sum() } else { heaviest_walk(&module.teams, team) }
        };
        let leaf = leaves
            .iter()
            .map(|leaf| needed_work(nodes, leaf.values.iter().copied()))
            .fold(Tally::default(), Tally::most);
        Self {
            teams: module.depth as u64,
            bids: heaviest(|_| 1),
            operations: once.operations + heaviest(|work| work.operations) + leaf.operations,
            maths_calls: once.maths_calls + heaviest(|work| work.maths_calls) + leaf.maths_calls,
        }
    }
}

/// The work of each bid of every team, as the module has them.
fn in_order(module: &Module<'_>, bid: impl Fn(NodeId) -> Tally) -> Vec<Vec<Tally>> {
    let bids = |team: &crate::ir::Team| team.edges.iter().map(|edge| bid(module.bidders[edge.bidder].value)).collect();
    module.teams.iter().map(bids).collect()
}

/// The work of the bids of a team of the profile `fast`, where none can be spared.
fn planned(nodes: &[Node], plan: &TeamSchedule, language: Language) -> Vec<Tally> {
    // With one way to go, no bid matters.
    if plan.destinations().len() == 1 {
        return Vec::new();
    }
    let mut scope = Scope { nodes, computed: BTreeSet::new() };
    let mut bids: Vec<Tally> = plan.eager.iter().map(|bid| scope.compute(bid.value)).collect();
    bids.extend(plan.lazy.iter().map(|lazy| scope.lazy(lazy, language)));
    bids
}

/// The operations whose results are in scope.
struct Scope<'a> {
    nodes: &'a [Node],
    computed: BTreeSet<NodeId>,
}

impl Scope<'_> {
    /// Computes a value; returns what that took.
    fn compute(&mut self, value: NodeId) -> Tally {
        let missing = needed(self.nodes, value, |id| !self.computed.contains(&id));
        let work = work(self.nodes, &missing);
        self.computed.extend(missing);
        work
    }

    /// Computes a bid and its bounds. What stands under a condition is out of scope behind it.
    fn lazy(&mut self, lazy: &LazyBid, language: Language) -> Tally {
        let LazyBid { bid, sparing, bound } = *lazy;
        let first = sparing.map(|sparing| self.compute(sparing.argument)).unwrap_or_default();
        let outside = self.computed.clone();
        let before = bound.map(|bound| self.compute(bound)).unwrap_or_default();
        let behind_bounds = self.computed.clone();
        let inside = self.compute(bid.value);
        if sparing.is_some() {
            self.computed = outside;
        } else if bound.is_some() || !bid.ascending || language == Language::C {
            self.computed = behind_bounds;
        }
        first.plus(before).plus(inside)
    }
}

/// The work of some values, each operation once.
fn needed_work(nodes: &[Node], values: impl IntoIterator<Item = NodeId>) -> Tally {
    work(nodes, &values.into_iter().flat_map(|value| needed(nodes, value, |_| true)).collect::<BTreeSet<_>>())
}

fn work<'a>(nodes: &[Node], ids: impl IntoIterator<Item = &'a NodeId, IntoIter: Clone>) -> Tally {
    let nodes = ids.into_iter().map(|id| nodes[id.index()]);
    Tally {
        operations: nodes.clone().filter(Node::is_computed).count() as u64,
        maths_calls: nodes.filter(Node::is_transcendental).count() as u64,
    }
}

#[cfg(test)]
mod tests {
    use super::Cost;
    use crate::options::{Language, Options, Profile, Style};
    use crate::program::compile;
    use tpg_graph::Graph;

    fn worst(options: Options) -> Cost {
        let text = include_str!("../tests/fixtures/all_instructions.json");
        let graph = Graph::from_json("fixture", text).expect("a valid graph");
        Cost::worst(&compile(&graph, &options, Language::C))
    }

    #[test]
    fn bid_by_bid_every_operation_of_a_walk_counts() {
        let options = Options::new("arm".parse().expect("a prefix"));
        let found = worst(Options { style: Style::Gegelati, ..options });
        assert_eq!(found, Cost { teams: 3, bids: 13, operations: 6 + 5 + 11, maths_calls: 1 + 2 + 6 });
    }

    #[test]
    fn in_constant_time_a_cosine_of_two_programs_counts_once() {
        let options = Options::new("arm".parse().expect("a prefix"));
        assert_eq!(worst(Options { profile: Some(Profile::ConstantTime), ..options }).maths_calls, 8);
    }
}
