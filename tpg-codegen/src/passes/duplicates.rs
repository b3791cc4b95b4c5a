//! Of edges of a team that bid the same value, only the last can win: it is as high as the others and comes after them.
//! The others go, wherever they lead. (So a compiled policy has no edge to fall back on when someone refuses an action
//! after the fact: whoever wants to refuse actions must do so in the graph.)

use crate::ir::{Edge, Module};
use std::collections::BTreeSet;

/// Removes them and says how many there were.
pub(super) fn run(module: &mut Module) -> usize {
    let Module { teams, bidders, .. } = module;
    let mut removed = 0;
    for team in teams {
        let mut seen = BTreeSet::new();
        let mut kept: Vec<Edge> =
            team.edges.iter().rev().filter(|edge| seen.insert(bidders[edge.bidder].value)).copied().collect();
        kept.reverse();
        removed += team.edges.len() - kept.len();
        team.edges = kept;
    }
    removed
}

#[cfg(test)]
mod tests {
    use super::run;
    use crate::graph::{ActionId, Input};
    use crate::ir::{Bidder, Edge, Module, Node, NodeId, Target, Team};

    #[test]
    fn the_last_of_equal_bids_stays_in_its_place() {
        let bidder = |label, value| Bidder { label, value: NodeId(value) };
        let edge = |bidder, action| Edge { bidder, to: Target::Action(ActionId(action)) };
        let edges = vec![edge(0, 0), edge(1, 1), edge(2, 2), edge(0, 3), edge(3, 4)];
        let mut module = Module {
            nodes: vec![Node::Input(Input(0)), Node::Input(Input(1))],
            bidders: vec![bidder(10, 0), bidder(11, 1), bidder(12, 0), bidder(13, 1)],
            teams: vec![Team { label: 1, edges }],
            depth: 1,
        };
        assert_eq!(run(&mut module), 3);
        assert_eq!(module.teams[0].edges, [edge(0, 3), edge(3, 4)]);
    }
}
