//! The interpreter: the reference that everything generated is compared with.
//!
//! It does what the semantics say and nothing clever: every line of a program runs, introns too, in order, on registers
//! that start at zero.

use crate::in_arithmetic_of;
use crate::model::{Destination, Graph, Operand, Program, Reg, TeamId};
use std::marker::PhantomData;
use tpg_runtime::ops::{self, Maths};
use tpg_runtime::policy::{ActionId, Policy};
use tpg_runtime::scalar::Scalar;

/// Runs a graph in scalar `S` with the maths of `M`.
#[derive(Clone, Copy, Debug)]
pub struct Interpreter<'g, S, M> {
    graph: &'g Graph,
    number: PhantomData<(S, M)>,
}

/// One decision of a team.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Decision<S> {
    /// The team that decided.
    pub team: TeamId,
    /// The place of the winning edge in the team.
    pub edge: usize,
    /// The winning bid; −∞ where it was a NaN.
    pub bid: S,
    /// Where the walk goes.
    pub to: Destination,
}

impl<'g, S: Scalar, M: Maths<S>> Interpreter<'g, S, M> {
    /// An interpreter of `graph`. Scalar and maths are the caller's choice; the graph's own are
    /// [`Graph::scalar`] and [`Graph::maths`].
    pub fn new(graph: &'g Graph) -> Self {
        Self { graph, number: PhantomData }
    }

    /// The value that a program bids; NaN as it is.
    ///
    /// # Panics
    /// If `state` is shorter than [`Graph::state_length`].
    pub fn bid(&self, program: &Program, state: &[S]) -> S {
        let mut registers = vec![S::ZERO; usize::from(self.graph.registers())];
        for line in &program.lines {
            let [a, b] = line.operands.map(|operand| match operand {
                Operand::Register(register) => registers[register.index()],
                Operand::Input(input) => state[input.index()],
                Operand::Constant(value) => S::from_f64(value),
            });
            registers[line.to.index()] = line.instruction.apply::<S, M>(a, b);
        }
        registers[Reg::BID.index()]
    }

    /// Lets one team decide: the highest bid wins, of equal bids the last.
    ///
    /// # Panics
    /// As [`bid`](Self::bid).
    pub fn decide_team(&self, team: TeamId, state: &[S]) -> Decision<S> {
        let mut best: Option<Decision<S>> = None;
        for (index, edge) in self.graph.team(team).edges.iter().enumerate() {
            let bid = ops::bid(self.bid(self.graph.program(edge.program), state));
            if best.is_none_or(|best| bid >= best.bid) {
                best = Some(Decision { team, edge: index, bid, to: edge.to });
            }
        }
        best.expect("a validated team has an edge")
    }

    /// The walk from the root to an action, one decision a team.
    ///
    /// # Panics
    /// As [`bid`](Self::bid).
    pub fn walk(&self, state: &[S]) -> (Vec<Decision<S>>, ActionId) {
        let mut walk = Vec::new();
        let mut team = self.graph.root();
        loop {
            let decision = self.decide_team(team, state);
            walk.push(decision);
            match decision.to {
                Destination::Team(next) => team = next,
                Destination::Action(action) => return (walk, action),
            }
        }
    }
}

impl<S: Scalar, M: Maths<S>> Policy for Interpreter<'_, S, M> {
    type State = [S];
    type Action = ActionId;

    fn decide(&self, state: &[S]) -> ActionId {
        self.walk(state).1
    }
}

/// The actions of a graph on flat states, in the graph's own scalar type and maths.
///
/// # Panics
/// If the states' length is no multiple of [`Graph::state_length`].
pub fn actions(graph: &Graph, states: &[f64]) -> Vec<ActionId> {
    assert_eq!(states.len() % graph.state_length(), 0, "whole states");
    in_arithmetic_of!(graph, actions_in(graph, states))
}

fn actions_in<S: Scalar, M: Maths<S>>(graph: &Graph, states: &[f64]) -> Vec<ActionId> {
    let interpreter = Interpreter::<S, M>::new(graph);
    let mut state = vec![S::ZERO; graph.state_length()];
    (states.chunks_exact(graph.state_length()))
        .map(|values| {
            for (slot, &value) in state.iter_mut().zip(values) {
                *slot = S::from_f64(value);
            }
            interpreter.decide(&state)
        })
        .collect()
}
