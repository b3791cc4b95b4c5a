//! Graphs as policies of the arm's observations.

use std::cell::RefCell;
use tpg_arm::observation::{Observation, Source, TargetMemo};
use tpg_arm::{Arm, Move};
use tpg_engine::{Plan, PolicyGraph, Single};
use tpg_graph::Graph;
use tpg_graph::error::InputError;
use tpg_graph::interpret::Answer;
use tpg_problems::Number;
use tpg_problems::arm::binding::Binding;
use tpg_runtime::ops::Maths;
use tpg_runtime::policy::Policy;

/// A graph that controls the arm.
#[derive(Debug)]
pub(crate) struct GraphPolicy<S: Copy, M> {
    arm: Arm<S>,
    single: Single<S, M>,
    binding: Binding,
    memo: TargetMemo<S>,
    state: RefCell<Vec<S>>,
}

impl<S: Number, M: Maths<S>> GraphPolicy<S, M> {
    /// Creates the policy of a graph on an arm; `file` is the name shown in errors.
    ///
    /// # Errors
    /// If the graph reads sources that the arm does not have, or has actions that do not state their move.
    pub(crate) fn new(file: &str, graph: &Graph, arm: &Arm<f64>) -> Result<Self, InputError> {
        let binding = Binding::of_graph(file, graph)?;
        let plan = Plan::new::<M>(&PolicyGraph::from(graph), graph.sources());
        let state = RefCell::new(vec![S::ZERO; binding.state_length()]);
        Ok(Self { arm: S::arm(arm), single: Single::new(plan), binding, memo: TargetMemo::new(), state })
    }
}

impl<S: Number, M: Maths<S>> Policy for GraphPolicy<S, M> {
    type State = Observation<S>;
    type Action = Move;

    fn decide(&self, seen: &Observation<S>) -> Move {
        let mut state = self.state.borrow_mut();
        Source::fill(self.binding.sources(), &self.arm, seen, &self.memo, &mut state);
        let Answer::Action(action) = self.single.answer(&state) else { unreachable!("actions are named") };
        self.binding.wanted(action).unwrap_or(Move::STOP)
    }
}
