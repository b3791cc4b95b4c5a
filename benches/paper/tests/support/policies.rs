//! Graphs as policies of the arm's observations.

use std::cell::RefCell;
use tpg_arm::observation::{Observation, Source, TargetMemo};
use tpg_arm::{Arm, Move};
use tpg_engine::{Plan, PolicyGraph, Single};
use tpg_graph::Graph;
use tpg_graph::interpret::Answer;
use tpg_paper::binding::Binding;
use tpg_problems::Number;
use tpg_runtime::ops::Maths;
use tpg_runtime::policy::Policy;

/// A graph that controls the arm.
#[derive(Debug)]
pub(crate) struct GraphPolicy<S: Copy, M> {
    arm: Arm<S>,
    single: Single<S, M>,
    sources: Vec<Source>,
    moves: Vec<Move>,
    memo: TargetMemo<S>,
    state: RefCell<Vec<S>>,
}

impl<S: Number, M: Maths<S>> GraphPolicy<S, M> {
    /// Creates the policy of a graph on an arm; `None` if it is not a graph of the arm.
    pub(crate) fn new(graph: &Graph, arm: &Arm<f64>) -> Option<Self> {
        let Binding { sources, moves, .. } = Binding::new(graph)?;
        let plan = Plan::new::<M>(&PolicyGraph::from(graph), graph.sources());
        let state = RefCell::new(vec![S::ZERO; graph.state_length()]);
        Some(Self { arm: S::arm(arm), single: Single::new(plan), sources, moves, memo: TargetMemo::new(), state })
    }
}

impl<S: Number, M: Maths<S>> Policy for GraphPolicy<S, M> {
    type State = Observation<S>;
    type Action = Move;

    fn decide(&self, seen: &Observation<S>) -> Move {
        let mut state = self.state.borrow_mut();
        Source::fill(&self.sources, &self.arm, seen, &self.memo, &mut state);
        let Answer::Action(action) = self.single.answer(&state) else { unreachable!("actions are named") };
        self.moves.get(usize::from(action.0)).copied().unwrap_or(Move::STOP)
    }
}
