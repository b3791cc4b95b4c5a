//! A graph in terms of the arm: which parts of the observation its state is made of, and what its actions move.

use crate::environments::arm::binding::bind;
use tpg_arm::observation::{Observation, Source, TargetMemo};
use tpg_arm::{Move, WIDOWX};
use tpg_graph::error::InputError;
use tpg_graph::{Graph, ScalarType};
use tpg_runtime::policy::ActionId;

/// How an engine's flat state is filled and its answer understood.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Binding {
    scalar: ScalarType,
    sources: Vec<Source>,
    moves: Vec<Move>,
}

impl Binding {
    /// Of a policy with these sources, in this order, and these actions.
    pub fn new(scalar: ScalarType, sources: Vec<Source>, moves: Vec<Move>) -> Self {
        Self { scalar, sources, moves }
    }

    /// Of a graph.
    ///
    /// # Errors
    /// When a source is no part of the observation, or an action moves nothing that the arm knows.
    pub fn of(file: &str, graph: &Graph) -> Result<Self, InputError> {
        let (sources, moves) = bind(file, graph)?;
        Ok(Self::new(graph.scalar(), sources, moves))
    }

    /// The parts of the observation that a state is made of, in order.
    pub fn sources(&self) -> &[Source] {
        &self.sources
    }

    /// How many values a state has.
    pub fn state_length(&self) -> usize {
        self.sources.iter().map(|source| source.length()).sum()
    }

    /// Appends what is seen to a batch of flat states, exact in the policy's scalar type.
    pub fn push_state(&self, observation: &Observation<f64>, states: &mut Vec<f64>) {
        let start = states.len();
        states.resize(start + self.state_length(), 0.0);
        let state = &mut states[start..];
        Source::fill(&self.sources, &WIDOWX, observation, &TargetMemo::new(), state);
        for value in state {
            *value = self.scalar.round(*value);
        }
    }

    /// What an action moves; `None` for an action that the policy does not have.
    pub fn wanted(&self, action: ActionId) -> Option<Move> {
        self.moves.get(usize::from(action.0)).copied()
    }
}
