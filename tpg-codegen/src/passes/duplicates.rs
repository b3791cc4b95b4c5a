//! Edges of a team that bid the same value: only the last can win, because it breaks the tie. The others are removed,
//! whatever their destinations. (So a compiled policy has no second choice if an action is rejected afterwards: actions must
//! be masked in the graph.)

use super::log::DuplicateBid;
use crate::ir::{Edge, Module};
use std::collections::BTreeMap;

/// Removes them and returns them.
pub(super) fn run(module: &mut Module<'_>) -> Vec<DuplicateBid> {
    let Module { teams, bidders, .. } = module;
    let mut removed = Vec::new();
    for team in teams {
        let mut last = BTreeMap::new();
        let mut kept: Vec<Edge> = Vec::with_capacity(team.edges.len());
        for edge in team.edges.iter().rev() {
            let bidder = &bidders[edge.bidder];
            let same_as = *last.entry(bidder.value).or_insert(bidder.label);
            if last.len() > kept.len() {
                kept.push(*edge);
            } else {
                removed.push(DuplicateBid { team: team.label, program: bidder.label, same_as });
            }
        }
        kept.reverse();
        team.edges = kept;
    }
    removed
}

#[cfg(test)]
mod tests {
    use super::run;
    use crate::ir::{Bidder, Edge, Module, Node, NodeId, Target, Team};
    use crate::passes::log::DuplicateBid;
    use tpg_graph::sample::{self, Shape};
    use tpg_graph::{ActionId, Input};

    #[test]
    fn the_last_of_equal_bids_stays_in_its_place() {
        let bidder = |label, value| Bidder { label, value: NodeId(value) };
        let edge = |bidder, action| Edge { bidder, to: Target::Action(ActionId(action)) };
        let edges = vec![edge(0, 0), edge(1, 1), edge(2, 2), edge(0, 3), edge(3, 4)];
        let graph = sample::graph(&Shape::default(), 0);
        let mut module = Module {
            nodes: vec![Node::Input(Input(0)), Node::Input(Input(1))],
            bidders: vec![bidder(10, 0), bidder(11, 1), bidder(12, 0), bidder(13, 1)],
            teams: vec![Team { label: 1, edges }],
            ..Module::empty(&graph)
        };
        let removed = |program, same_as| DuplicateBid { team: 1, program, same_as };
        assert_eq!(run(&mut module), [removed(12, 10), removed(11, 13), removed(10, 10)]);
        assert_eq!(module.teams[0].edges, [edge(0, 3), edge(3, 4)]);
    }
}
