//! Bids that provably never win: those whose highest value is below what another bid of their team is certain to reach.
//! A bid that can only equal it stays, for it may come later.

use super::interval::Interval;
use crate::ir::Module;

/// Removes them.
pub(super) fn run(module: &mut Module<'_>, intervals: &[Interval]) {
    let Module { teams, bidders, .. } = module;
    for team in teams {
        let interval = |bidder: usize| intervals[bidders[bidder].value.index()];
        let certain =
            team.edges.iter().map(|edge| interval(edge.bidder).certain_bid()).fold(f64::NEG_INFINITY, f64::max);
        // The edge that is certain stays itself: its highest value is at least its lowest.
        team.edges.retain(|edge| interval(edge.bidder).high >= certain);
    }
}

#[cfg(test)]
mod tests {
    use super::run;
    use crate::ir::{Bidder, Edge, Module, Node, NodeId, Successor, Team};
    use crate::passes::interval::Interval;
    use tpg_graph::sample::{self, Shape};
    use tpg_graph::{ActionId, Input};

    #[test]
    fn only_bids_that_are_always_lower_go() {
        let interval = |low, high, nan| Interval { low, high, nan };
        let intervals = [
            interval(0.0, 10.0, false), // certain to reach 0
            interval(-5.0, 0.0, false), // can equal that
            interval(-5.0, -0.1, true), // cannot
            interval(50.0, 60.0, true), // may be NaN: certain of nothing
        ];
        let bidders = (0..4).map(|n| Bidder { label: n, value: NodeId(n) }).collect();
        let edge = |bidder| Edge { bidder, to: Successor::Action(ActionId(0)) };
        let team = Team { label: 1, edges: (0..4).map(edge).collect() };
        let nodes = (0..4).map(|n| Node::Input(Input(n))).collect();
        let graph = sample::graph(&Shape::default(), 0);
        let mut module = Module { nodes, bidders, teams: vec![team], ..Module::empty(&graph) };
        run(&mut module, &intervals);
        assert_eq!(module.teams[0].edges, [edge(0), edge(1), edge(3)]);
    }
}
