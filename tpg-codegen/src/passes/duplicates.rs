//! Edges of a team that bid the same value: only the last can win, because it breaks the tie. The others are removed,
//! whatever their destinations. (So a compiled policy has no second choice if an action is rejected afterwards: actions must
//! be masked in the graph.)

use crate::ir::{Edge, Module};
use std::collections::BTreeSet;

/// Removes them.
pub(super) fn run(module: &mut Module<'_>) {
    let Module { teams, bidders, .. } = module;
    for team in teams {
        let mut seen = BTreeSet::new();
        let mut kept: Vec<Edge> = Vec::with_capacity(team.edges.len());
        for edge in team.edges.iter().rev() {
            if seen.insert(bidders[edge.bidder].value) {
                kept.push(*edge);
            }
        }
        kept.reverse();
        team.edges = kept;
    }
}

#[cfg(test)]
mod tests {
    use super::run;
    use crate::ir::{Bidder, Edge, Module, Node, NodeId, Successor, Team};
    use tpg_graph::sample::{self, Shape};
    use tpg_graph::{ActionId, Input};

    #[test]
    fn the_last_of_equal_bids_stays_in_its_place() {
        let bidder = |label, value| Bidder { label, value: NodeId(value) };
        let edge = |bidder, action| Edge { bidder, to: Successor::Action(ActionId(action)) };
        let edges = vec![edge(0, 0), edge(1, 1), edge(2, 2), edge(0, 3), edge(3, 4)];
        let graph = sample::graph(&Shape::default(), 0);
        let mut module = Module {
            nodes: vec![Node::Input(Input(0)), Node::Input(Input(1))],
            bidders: vec![bidder(10, 0), bidder(11, 1), bidder(12, 0), bidder(13, 1)],
            teams: vec![Team { label: 1, edges }],
            ..Module::empty(&graph)
        };
        run(&mut module);
        assert_eq!(module.teams[0].edges, [edge(0, 3), edge(3, 4)]);
    }
}
