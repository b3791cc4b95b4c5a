//! Teams without a choice, and equivalent teams.
//!
//! A team whose edges all have one destination is bypassed: its bids do not matter. Teams with the same bids for the same
//! destinations are merged. Each rule can enable the other, so teams are visited in reverse topological order: successors
//! first.

use super::log::TwinTeam;
use crate::ir::{Module, NodeId, Target, ends_first, longest_walk};
use std::collections::{BTreeMap, BTreeSet};

/// The removed teams.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub(super) struct Removed {
    /// Teams without a choice.
    pub(super) bypassed: Vec<u32>,
    /// Teams that are equivalent to another.
    pub(super) merged: Vec<TwinTeam>,
    /// Teams that have become unreachable.
    pub(super) unreachable: Vec<u32>,
}

impl Removed {
    /// Tests for no removals.
    pub(super) fn is_empty(&self) -> bool {
        self.bypassed.is_empty() && self.merged.is_empty() && self.unreachable.is_empty()
    }
}

/// Redirects edges past such teams, and renumbers the remaining ones breadth first. The root always stays.
pub(super) fn run(module: &mut Module<'_>) -> Removed {
    let before: Vec<u32> = module.teams.iter().map(|team| team.label).collect();
    let mut removed = Removed::default();
    let mut place: Vec<Target> = (0..before.len()).map(Target::Team).collect();
    let mut known: BTreeMap<Vec<(NodeId, Target)>, usize> = BTreeMap::new();
    for index in ends_first(&module.teams) {
        let team = &mut module.teams[index];
        for edge in &mut team.edges {
            if let Target::Team(to) = edge.to {
                edge.to = place[to];
            }
        }
        if index == 0 {
            continue;
        }
        let only = team.edges.first().map(|edge| edge.to).filter(|&to| team.edges.iter().all(|edge| edge.to == to));
        if let Some(to) = only {
            place[index] = to;
            removed.bypassed.push(team.label);
            continue;
        }
        let decision = team.edges.iter().map(|edge| (module.bidders[edge.bidder].value, edge.to)).collect();
        let first = *known.entry(decision).or_insert(index);
        if first != index {
            place[index] = Target::Team(first);
            removed.merged.push(TwinTeam { team: before[index], same_as: before[first] });
        }
    }
    renumber(module);
    let mut gone: BTreeSet<u32> = before.iter().copied().collect();
    let known = removed.bypassed.iter().copied().chain(removed.merged.iter().map(|twin| twin.team));
    for label in known.chain(module.teams.iter().map(|team| team.label)) {
        gone.remove(&label);
    }
    removed.unreachable = before.into_iter().filter(|label| gone.contains(label)).collect();
    removed
}

/// Keeps the reachable teams, breadth first from the root, and the bidders that they use.
fn renumber(module: &mut Module<'_>) {
    let mut place = vec![None; module.teams.len()];
    place[0] = Some(0);
    let mut order = vec![0];
    let mut next = 0;
    while let Some(&index) = order.get(next) {
        next += 1;
        for edge in &module.teams[index].edges {
            if let Target::Team(to) = edge.to
                && place[to].is_none()
            {
                place[to] = Some(order.len());
                order.push(to);
            }
        }
    }
    let mut bidder_place = BTreeMap::new();
    let mut bidders = Vec::new();
    let mut teams = Vec::with_capacity(order.len());
    for index in order {
        let mut team = module.teams[index].clone();
        for edge in &mut team.edges {
            if let Target::Team(to) = edge.to {
                edge.to = Target::Team(place[to].unwrap_or_default());
            }
            edge.bidder = *bidder_place.entry(edge.bidder).or_insert_with(|| {
                bidders.push(module.bidders[edge.bidder].clone());
                bidders.len() - 1
            });
        }
        teams.push(team);
    }
    module.depth = longest_walk(&teams);
    module.teams = teams;
    module.bidders = bidders;
}

#[cfg(test)]
mod tests {
    use super::{Removed, run};
    use crate::ir::{Bidder, Edge, Module, Node, NodeId, Target, Team};
    use crate::passes::log::TwinTeam;
    use tpg_graph::sample::{self, Shape};
    use tpg_graph::{ActionId, Input};

    #[test]
    fn teams_without_a_choice_and_twins_go() {
        let nodes = (0..3).map(|n| Node::Input(Input(n))).collect();
        let bidders = (0..3).map(|n| Bidder { label: n, value: NodeId(n) }).collect();
        let to_team = |bidder, team| Edge { bidder, to: Target::Team(team) };
        let to_action = |bidder, action| Edge { bidder, to: Target::Action(ActionId(action)) };
        let team = |label, edges| Team { label, edges };
        let graph = sample::graph(&Shape::default(), 0);
        let mut module = Module {
            nodes,
            bidders,
            teams: vec![
                team(100, vec![to_team(0, 1), to_team(1, 2), to_team(2, 3)]),
                team(101, vec![to_action(1, 5), to_action(2, 5)]), // no choice
                team(102, vec![to_action(0, 1), to_team(2, 1)]),   // 1 or, past 101, 5
                team(103, vec![to_action(0, 1), to_action(2, 5)]), // the same
            ],
            ..Module::empty(&graph)
        };
        // Successors come first, otherwise edges in their order: the twin that is reached first stays.
        let removed = run(&mut module);
        let twin = TwinTeam { team: 103, same_as: 102 };
        assert_eq!(removed, Removed { bypassed: vec![101], merged: vec![twin], unreachable: Vec::new() });
        assert_eq!(module.teams.len(), 2);
        assert_eq!(module.depth, 2);
        assert_eq!(module.teams[0].edges, [to_action(0, 5), to_team(1, 1), to_team(2, 1)]);
        assert_eq!(module.teams[1].edges, [to_action(0, 1), to_action(2, 5)]);
    }
}
