//! The interpreter: the reference for all generated code.
//!
//! It follows the semantics literally, without optimisation: every line of a program runs in order, including introns,
//! on registers that start at zero.

use crate::in_arithmetic_of;
use crate::model::{Destination, Graph, Operand, Program, Reg, TeamId};
use std::marker::PhantomData;
use tpg_runtime::ops::{self, Maths};
use tpg_runtime::policy::{ActionId, Policy};
use tpg_runtime::scalar::Scalar;

/// Runs a graph in scalar type `S` with the maths of `M`.
///
/// ```
/// use tpg_graph::Graph;
/// use tpg_graph::interpret::Interpreter;
/// use tpg_runtime::ops::Own;
/// use tpg_runtime::policy::{ActionId, Policy};
///
/// # let text = r#"{
/// #     "format": "tpg-graph", "version": 1, "scalar": "f32", "maths": "own", "registers": 1,
/// #     "sources": [{ "name": "x", "length": 1, "unit": "mm", "ranges": [[-1, 1]] }],
/// #     "instructions": ["add"],
/// #     "actions": [{ "id": 0, "name": "left" }, { "id": 1, "name": "right" }],
/// #     "root": 0,
/// #     "teams": [{ "id": 0, "edges": [{ "program": 0, "action": 0 }, { "program": 1, "action": 1 }] }],
/// #     "programs": [
/// #         { "id": 0, "lines": [] },
/// #         { "id": 1, "lines": [{ "to": 0, "op": "add", "args": ["r0", "x[0]"] }] }
/// #     ]
/// # }"#;
/// // One team: `left` is bid 0, and `right` is bid x.
/// let graph = Graph::from_json("small.json", text)?;
/// let interpreter = Interpreter::<f32, Own>::new(&graph);
/// assert_eq!(interpreter.decide(&[-0.5]), ActionId(0));
/// assert_eq!(interpreter.decide(&[0.5]), ActionId(1));
///
/// let (walk, _) = interpreter.walk(&[0.5]);
/// assert_eq!((walk.len(), walk[0].edge, walk[0].bid), (1, 1, 0.5));
/// # Ok::<(), tpg_graph::error::InputError>(())
/// ```
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
    /// Index of the winning edge in the team.
    pub edge: usize,
    /// The winning bid; −∞ if it was NaN.
    pub bid: S,
    /// The next step of the walk.
    pub to: Destination,
}

impl<'g, S: Scalar, M: Maths<S>> Interpreter<'g, S, M> {
    /// Creates an interpreter of `graph`. Scalar type and maths are the caller's choice; the graph's own are
    /// [`Graph::scalar`] and [`Graph::maths`].
    pub fn new(graph: &'g Graph) -> Self {
        Self { graph, number: PhantomData }
    }

    /// Returns the bid of a program; NaN is returned unchanged.
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

    /// Lets one team decide: the highest bid wins, and among equal bids the last.
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

    /// Walks from the root to an action and returns one decision per team.
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

/// Returns the actions of a graph on flat states, in the graph's own scalar type and maths.
///
/// # Panics
/// If the length of `states` is not a multiple of [`Graph::state_length`].
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
