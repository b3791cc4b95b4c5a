//! The interpreter: the reference for all generated code.
//!
//! It follows the semantics literally, without optimisation: every line of a program runs in order, including introns,
//! on registers that start at zero.

use crate::in_arithmetic_of;
use crate::model::{Destination, Graph, Operand, Program, Reg, TeamId};
use serde::{Serialize, Serializer};
use std::fmt;
use std::marker::PhantomData;
use tpg_runtime::ops::{self, Instruction, Maths};
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

    /// Returns the result of a program: its bid, or an output before it is limited. NaN is returned unchanged.
    ///
    /// # Panics
    /// If `state` is shorter than [`Graph::state_length`].
    pub fn run(&self, program: &Program, state: &[S]) -> S {
        let mut registers = vec![S::ZERO; usize::from(self.graph.registers())];
        for line in &program.lines {
            let [a, b] = line.operands.map(|operand| match operand {
                Operand::Register(register) => registers[register.index()],
                Operand::Input(input) => state[input.index()],
                Operand::Constant(value) => S::from_f64(value),
            });
            let to = registers[line.to.index()];
            let apply = |instruction: Instruction, [a, b]: [S; 2]| instruction.apply::<S, M>(a, b);
            registers[line.to.index()] = line.instruction.compose(to, [a, b], apply);
        }
        registers[Reg::RESULT.index()]
    }

    /// Lets one team decide: the highest bid wins, and among equal bids the last.
    ///
    /// # Panics
    /// As [`run`](Self::run).
    pub fn decide_team(&self, team: TeamId, state: &[S]) -> Decision<S> {
        let mut best: Option<Decision<S>> = None;
        for (index, edge) in self.graph.team(team).edges.iter().enumerate() {
            let bid = ops::bid(self.run(self.graph.program(edge.program), state));
            if best.is_none_or(|best| bid >= best.bid) {
                best = Some(Decision { team, edge: index, bid, to: edge.to });
            }
        }
        best.expect("a validated team has an edge")
    }

    /// Walks from the root to an action or a leaf, and returns one decision per team.
    ///
    /// # Panics
    /// As [`run`](Self::run).
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

impl<S: Scalar, M: Maths<S>> Interpreter<'_, S, M> {
    /// Returns the value of each output: that of the leaf's program, limited to the output's range.
    ///
    /// # Panics
    /// As [`run`](Self::run), and if the graph has no leaf of that number.
    pub fn outputs(&self, leaf: ActionId, state: &[S]) -> Vec<S> {
        let programs = &self.graph.leaves()[usize::from(leaf.0)].programs;
        (self.graph.outputs().iter().zip(programs))
            .map(|(output, &program)| {
                let [low, high, nan] = [output.range.min, output.range.max, output.nan].map(S::from_f64);
                ops::clamp(self.run(self.graph.program(program), state), low, high, nan)
            })
            .collect()
    }

    /// Walks from the root and returns the answer.
    ///
    /// # Panics
    /// As [`run`](Self::run).
    pub fn answer(&self, state: &[S]) -> Answer {
        let (_, end) = self.walk(state);
        if self.graph.leaves().is_empty() {
            Answer::Action(end)
        } else {
            Answer::Values(self.outputs(end, state).into_iter().map(S::to_f64).collect())
        }
    }
}

/// The answer of a policy to a state.
#[derive(Clone, Debug, PartialEq)]
pub enum Answer {
    /// An action.
    Action(ActionId),
    /// The value of each output, none of them NaN.
    Values(Vec<f64>),
}

impl Answer {
    /// Tests for the same action, or the same bits of each value: 0 is not −0.
    pub fn same_bits(&self, other: &Self) -> bool {
        match (self, other) {
            (Self::Action(a), Self::Action(b)) => a == b,
            (Self::Values(a), Self::Values(b)) => {
                a.len() == b.len() && a.iter().zip(b).all(|(a, b)| a.to_bits() == b.to_bits())
            }
            _ => false,
        }
    }
}

/// As an action's number, or as a list of values.
impl Serialize for Answer {
    fn serialize<R: Serializer>(&self, serializer: R) -> Result<R::Ok, R::Error> {
        match self {
            Self::Action(ActionId(action)) => action.serialize(serializer),
            Self::Values(values) => values.serialize(serializer),
        }
    }
}

impl fmt::Display for Answer {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Action(ActionId(action)) => write!(f, "action {action}"),
            Self::Values(values) => {
                let values: Vec<String> = values.iter().map(|value| format!("{value:?}")).collect();
                write!(f, "({})", values.join(", "))
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

/// Returns the ends of a graph's walks on flat states, actions or leaves, in the graph's own scalar type and maths.
///
/// # Panics
/// If the length of `states` is not a multiple of [`Graph::state_length`].
pub fn actions(graph: &Graph, states: &[f64]) -> Vec<ActionId> {
    assert_eq!(states.len() % graph.state_length(), 0, "whole states");
    in_arithmetic_of!(graph, actions_in(graph, states))
}

fn actions_in<S: Scalar, M: Maths<S>>(graph: &Graph, states: &[f64]) -> Vec<ActionId> {
    on_each::<S, M, _>(graph, states, Interpreter::decide)
}

/// Returns the answers of a graph to flat states, in the graph's own scalar type and maths.
///
/// # Panics
/// If the length of `states` is not a multiple of [`Graph::state_length`].
pub fn answers(graph: &Graph, states: &[f64]) -> Vec<Answer> {
    assert_eq!(states.len() % graph.state_length(), 0, "whole states");
    in_arithmetic_of!(graph, answers_in(graph, states))
}

fn answers_in<S: Scalar, M: Maths<S>>(graph: &Graph, states: &[f64]) -> Vec<Answer> {
    on_each::<S, M, _>(graph, states, Interpreter::answer)
}

fn on_each<'g, S: Scalar, M: Maths<S>, T>(
    graph: &'g Graph,
    states: &[f64],
    ask: impl Fn(&Interpreter<'g, S, M>, &[S]) -> T,
) -> Vec<T> {
    let interpreter = Interpreter::<S, M>::new(graph);
    let mut state = vec![S::ZERO; graph.state_length()];
    (states.chunks_exact(graph.state_length()))
        .map(|values| {
            for (slot, &value) in state.iter_mut().zip(values) {
                *slot = S::from_f64(value);
            }
            ask(&interpreter, &state)
        })
        .collect()
}
