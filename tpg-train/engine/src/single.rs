//! Evaluation of one state at a time, for callers that act between two decisions, such as a hybrid.

use crate::action::Acts;
use crate::columns::Columns;
use crate::decide::Decider;
use crate::plan::Plan;
use crate::policy::PolicyGraph;
use std::cell::RefCell;
use std::io;
use tpg_graph::Graph;
use tpg_graph::engine::Engine;
use tpg_graph::in_arithmetic_of;
use tpg_graph::interpret::Answer;
use tpg_runtime::ops::Maths;
use tpg_runtime::scalar::Scalar;

/// A plan with the buffers that one decision needs: one lane.
#[derive(Debug)]
pub struct Single<S, M> {
    plan: Plan<S>,
    lane: RefCell<(Columns<S, M>, Decider<S>)>,
}

impl<S: Scalar, M: Maths<S>> Single<S, M> {
    /// Creates the evaluator of a plan's first root.
    pub fn new(plan: Plan<S>) -> Self {
        let (mut columns, mut decider) = (Columns::new(1), Decider::new(1));
        columns.prepare(&plan);
        decider.prepare(&plan);
        decider.begin(0, plan.roots[0]);
        Self { plan, lane: RefCell::new((columns, decider)) }
    }

    /// Returns the answer to a flat state, the same as the interpreter's.
    ///
    /// # Panics
    /// If the state is shorter than [`Plan::state_length`].
    pub fn answer(&self, state: &[S]) -> Answer {
        let (columns, decider) = &mut *self.lane.borrow_mut();
        let mut view = columns.view(&self.plan.places);
        for (input, &value) in state[..self.plan.state_length()].iter().enumerate() {
            if let Some([block, ..]) = view.column(input) {
                block[0] = value;
            }
        }
        decider.decide(&self.plan, columns, 1);
        match decider.acts(&self.plan, 1) {
            Acts::Choices(actions) => Answer::Action(actions[0]),
            Acts::Values { values, .. } => Answer::Values(values.iter().map(|value| value.to_f64()).collect()),
        }
    }
}

impl<S: Scalar, M: Maths<S>> Engine for Single<S, M> {
    fn name(&self) -> &str {
        "trainer"
    }

    fn answer(&mut self, states: &[f64], answers: &mut Vec<Answer>) -> io::Result<()> {
        for state in states.chunks_exact(self.plan.state_length()) {
            let state: Vec<S> = state.iter().map(|&value| S::from_f64(value)).collect();
            answers.push(Single::answer(self, &state));
        }
        Ok(())
    }
}

/// Wraps a graph, computed in its own arithmetic, as an [`Engine`].
pub fn single(graph: &Graph) -> Box<dyn Engine> {
    fn engine<S: Scalar, M: Maths<S> + 'static>(graph: &Graph) -> Box<dyn Engine> {
        let plan = Plan::new::<M>(&PolicyGraph::from(graph), &graph.state_sources());
        Box::new(Single::<S, M>::new(plan))
    }
    in_arithmetic_of!(graph, engine(graph))
}

#[cfg(test)]
mod tests {
    use super::single;
    use tpg_graph::sample::{self, Shape};
    use tpg_graph::{interpret, states};

    #[test]
    fn it_acts_like_the_interpreter() {
        for seed in 0..80 {
            let shape = if seed % 2 == 0 { Shape::random(seed) } else { Shape::random_with_outputs(seed) };
            let graph = sample::graph(&shape, seed);
            let states = states::sample(&graph, 1000, seed);
            let mut answers = Vec::new();
            single(&graph).answer(&states, &mut answers).expect("no process, no error");
            assert_eq!(answers, interpret::answers(&graph, &states), "graph {seed}");
        }
    }
}
