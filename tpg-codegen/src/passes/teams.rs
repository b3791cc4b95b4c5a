//! Teams without a choice, and equivalent teams.
//!
//! A team whose edges all have one destination is bypassed: its bids do not matter. Teams with the same bids for the same
//! destinations are merged. Each rule can enable the other, so teams are visited in reverse topological order: successors
//! first.

use crate::ir::{Module, NodeId, Successor, breadth_first, ends_first, longest_walk};
use Successor::*;
use std::collections::BTreeMap;

/// Redirects edges past such teams, and renumbers the remaining ones breadth first. The root always stays.
pub(super) fn run(module: &mut Module<'_>) {
    let mut place: Vec<Successor> = (0..module.teams.len()).map(Team).collect();
    let mut known: BTreeMap<Vec<(NodeId, Successor)>, usize> = BTreeMap::new();
    for index in ends_first(&module.teams) {
        let team = &mut module.teams[index];
        for edge in &mut team.edges {
            if let Team(to) = edge.to {
                edge.to = place[to];
            }
        }
        if index == 0 {
            continue;
        }
        let only = team.edges.first().map(|edge| edge.to).filter(|&to| team.edges.iter().all(|edge| edge.to == to));
        if let Some(to) = only {
            place[index] = to;
            continue;
        }
        let decision = team.edges.iter().map(|edge| (module.bidders[edge.bidder].value, edge.to)).collect();
        let first = *known.entry(decision).or_insert(index);
        if first != index {
            place[index] = Team(first);
        }
    }
    let (teams, used) = breadth_first(&module.teams, 0);
    module.depth = longest_walk(&teams);
    module.teams = teams;
    module.bidders = used.into_iter().map(|bidder| module.bidders[bidder].clone()).collect();
}

#[cfg(test)]
mod tests {
    use super::run;
    use crate::ir::{Bidder, Edge, Module, Node, NodeId, Successor, Team};
    use tpg_graph::sample::{self, Shape};
    use tpg_graph::{ActionId, Input};

    #[test]
    fn teams_without_a_choice_and_twins_go() {
        let nodes = (0..3).map(|n| Node::Input(Input(n))).collect();
        let bidders = (0..3).map(|n| Bidder { label: n, value: NodeId(n) }).collect();
        let to_team = |bidder, team| Edge { bidder, to: Successor::Team(team) };
        let to_action = |bidder, action| Edge { bidder, to: Successor::Action(ActionId(action)) };
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
        run(&mut module);
        assert_eq!(module.teams.len(), 2);
        assert_eq!(module.depth, 2);
        assert_eq!(module.teams[0].edges, [to_action(0, 5), to_team(1, 1), to_team(2, 1)]);
        assert_eq!(module.teams[1].edges, [to_action(0, 1), to_action(2, 5)]);
    }
}
