//! Counts of each bid's wins along recorded states. The likeliest winner is evaluated first, so that its bid skips the
//! others.
//!
//! Testing the likeliest destination first was measured as well, and gains nothing.

use super::evaluate::evaluate;
use crate::ir::{Module, Target};
use tpg_graph::in_arithmetic_of;
use tpg_runtime::ops::{self, Maths};
use tpg_runtime::scalar::Scalar;

/// Wins by team and place; 0 without recorded states.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Wins(Vec<Vec<u64>>);

impl Wins {
    /// Counts wins along flat states.
    ///
    /// # Panics
    /// If the states' length is no multiple of [`Graph::state_length`](tpg_graph::Graph::state_length).
    pub fn count(module: &Module<'_>, states: &[f64]) -> Self {
        assert_eq!(states.len() % module.graph.state_length(), 0, "whole states");
        in_arithmetic_of!(module.graph, count_in(module, states))
    }

    /// The wins of a place in a team.
    pub fn of(&self, team: usize, place: usize) -> u64 {
        self.0[team][place]
    }
}

fn count_in<S: Scalar, M: Maths<S>>(module: &Module<'_>, states: &[f64]) -> Wins {
    let graph = module.graph;
    let mut wins: Vec<Vec<u64>> = module.teams.iter().map(|team| vec![0; team.edges.len()]).collect();
    let mut values = vec![S::ZERO; module.nodes.len()];
    for state in states.chunks_exact(graph.state_length()) {
        evaluate::<S, M>(graph.scalar(), &module.nodes, state, &mut values);
        let mut team = 0;
        loop {
            let edges = &module.teams[team].edges;
            let bids = edges.iter().map(|edge| ops::bid(values[module.bidders[edge.bidder].value.index()]));
            let first = (S::NEG_INFINITY, 0);
            let (_, place) = bids.zip(0..).fold(first, ops::challenge);
            wins[team][place] += 1;
            match edges[place].to {
                Target::Team(next) => team = next,
                Target::Action(_) => break,
            }
        }
    }
    Wins(wins)
}

#[cfg(test)]
mod tests {
    use super::Wins;
    use crate::ir::{Module, Target};
    use std::collections::BTreeMap;
    use tpg_graph::sample::{self, Shape};
    use tpg_graph::{interpret, states};

    /// Every walk ends with a win that leads to its action.
    #[test]
    fn wins_are_the_interpreters() {
        for seed in 0..30 {
            let graph = sample::graph(&Shape::random(seed), seed);
            let module = Module::lower(&graph);
            let recorded = states::sample(&graph, 200, seed);
            let wins = Wins::count(&module, &recorded);
            let mut found: BTreeMap<u16, u64> = BTreeMap::new();
            for (number, team) in module.teams.iter().enumerate() {
                for (place, edge) in team.edges.iter().enumerate() {
                    if let Target::Action(action) = edge.to {
                        *found.entry(action.0).or_default() += wins.of(number, place);
                    }
                }
            }
            let mut expected: BTreeMap<u16, u64> = found.keys().map(|&action| (action, 0)).collect();
            for action in interpret::actions(&graph, &recorded) {
                *expected.entry(action.0).or_default() += 1;
            }
            assert_eq!(found, expected, "graph {seed}");
        }
    }
}
