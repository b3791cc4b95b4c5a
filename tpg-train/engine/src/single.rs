//! Evaluation of one state at a time, for callers that act between two decisions, such as a hybrid.

use crate::action::Acts;
use crate::columns::Columns;
use crate::decide::Decider;
use crate::plan::Plan;
use std::cell::RefCell;
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

#[cfg(test)]
mod tests {
    use super::Single;
    use crate::plan::Plan;
    use crate::policy::PolicyGraph;
    use tpg_graph::interpret::Answer;
    use tpg_graph::sample::{self, Shape};
    use tpg_graph::{Graph, in_arithmetic_of, interpret, states};
    use tpg_runtime::ops::Maths;
    use tpg_runtime::scalar::Scalar;

    fn answers<S: Scalar, M: Maths<S>>(graph: &Graph, states: &[f64]) -> Vec<Answer> {
        let single = Single::<S, M>::new(Plan::new::<M>(&PolicyGraph::from(graph), graph.sources()));
        let rounded: Vec<S> = states.iter().map(|&value| S::from_f64(value)).collect();
        rounded.chunks_exact(graph.state_length()).map(|state| single.answer(state)).collect()
    }

    #[test]
    fn it_acts_like_the_interpreter() {
        for seed in 0..80 {
            let shape = if seed % 2 == 0 { Shape::random(seed) } else { Shape::random_with_outputs(seed) };
            let graph = sample::graph(&shape, seed);
            let states = states::sample(&graph, 1000, seed);
            let found = in_arithmetic_of!(graph, answers(&graph, &states));
            assert_eq!(found, interpret::answers(&graph, &states), "graph {seed}");
        }
    }
}
