//! One state at a time: for who must act between two decisions, as a hybrid does.

use super::nodes::{Node, NodeId};
use super::plan::Plan;
use super::policy::Destination;
use std::cell::RefCell;
use std::marker::PhantomData;
use tpg_runtime::ops::{self, Maths};
use tpg_runtime::policy::ActionId;
use tpg_runtime::scalar::Scalar;

/// A plan with the memory that one decision needs.
#[derive(Debug)]
pub struct Single<S, M> {
    plan: Plan<S>,
    scratch: RefCell<Scratch<S>>,
    maths: PhantomData<M>,
}

#[derive(Debug)]
struct Scratch<S> {
    values: Vec<S>,
    computed_at: Vec<u64>,
    now: u64,
}

impl<S: Scalar, M: Maths<S>> Single<S, M> {
    /// Of a plan.
    pub fn new(plan: Plan<S>) -> Self {
        let constant = |node: &Node<S>| if let Node::Constant(value) = node { *value } else { S::ZERO };
        let values: Vec<S> = plan.nodes.iter().map(constant).collect();
        let scratch = Scratch { computed_at: vec![0; values.len()], values, now: 0 };
        Self { plan, scratch: RefCell::new(scratch), maths: PhantomData }
    }

    /// The action for a flat state: the interpreter's.
    ///
    /// # Panics
    /// If the state is shorter than [`Plan::state_length`].
    pub fn decide(&self, state: &[S]) -> ActionId {
        let mut scratch = self.scratch.borrow_mut();
        scratch.now += 1;
        for &(input, node) in &self.plan.inputs {
            scratch.values[node.index()] = state[usize::from(input)];
        }
        let mut team = 0;
        loop {
            let planned = &self.plan.teams[team];
            for &node in &planned.needs {
                scratch.compute::<M>(&self.plan.nodes, node);
            }
            let mut best: Option<(S, Destination)> = None;
            for edge in &planned.edges {
                let bid = ops::bid(scratch.values[edge.bid.index()]);
                if best.is_none_or(|(highest, _)| bid >= highest) {
                    best = Some((bid, edge.to));
                }
            }
            match best.expect("a planned team has an edge").1 {
                Destination::Team(next) => team = next as usize,
                Destination::Action(action) => return ActionId(action),
            }
        }
    }
}

impl<S: Scalar> Scratch<S> {
    fn compute<M: Maths<S>>(&mut self, nodes: &[Node<S>], node: NodeId) {
        let place = node.index();
        if let Node::Operation(instruction, a, b) = nodes[place]
            && std::mem::replace(&mut self.computed_at[place], self.now) != self.now
        {
            self.values[place] = instruction.apply::<S, M>(self.values[a.index()], self.values[b.index()]);
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::engine::Policy;
    use tpg_codegen::graph::Graph;
    use tpg_codegen::{interpret, states};
    use tpg_runtime::ops::Own;

    #[test]
    fn it_acts_like_the_interpreter() {
        for text in [
            include_str!("../../../generated/widowx-fs/graph.json"),
            include_str!("../../../generated/widowx-rs/graph.json"),
        ] {
            let graph = Graph::from_json("graph.json", text).expect("a committed graph");
            let sources: Vec<_> = graph.to_document().sources;
            let single = Single::<f32, Own>::new(Plan::new::<Own>(&Policy::from(&graph), &sources, true));
            let states = states::sample(&graph, 20_000, 5);
            let expected = interpret::actions(&graph, &states);
            for (state, expected) in states.chunks_exact(graph.state_length()).zip(expected) {
                let state: Vec<f32> = state.iter().map(|&value| value as f32).collect();
                assert_eq!(single.decide(&state), expected, "{state:?}");
            }
        }
    }
}
