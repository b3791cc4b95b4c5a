//! Translation between a graph's sources and actions and those of the arm.

use tpg_arm::binding;
use tpg_arm::observation::{Observation, Source, TargetMemo};
use tpg_arm::{Move, WIDOWX};
use tpg_graph::error::{InputError, Place};
use tpg_graph::{Action, Graph, ScalarType};
use tpg_runtime::policy::ActionId;

/// Finds the arm's sources that make up a graph's state, and the move of each of its actions.
///
/// # Errors
/// If the arm has no such source, or an action does not state its move.
pub fn bind(file: &str, graph: &Graph) -> Result<(Vec<Source>, Vec<Move>), InputError> {
    let error = |path: String, found: String, accepted: &str| {
        InputError::new(file, Place::Path(path), found, accepted.to_owned())
    };
    let source = |(place, declared): (usize, &tpg_graph::Source)| {
        let length = declared.ranges.len();
        binding::source(&declared.name, length).ok_or_else(|| {
            let found = format!("a source {:?} of {length} values", declared.name);
            error(format!("$.sources[{place}]"), found, &known_sources())
        })
    };
    let moved = |(place, action): (usize, &Action)| {
        let effect = action.effect.as_ref();
        effect.and_then(|effect| binding::moved(&effect.name, &effect.values)).ok_or_else(|| {
            let found = format!("the action \"{action}\" without a move");
            error(format!("$.actions[{place}]"), found, "a move of the arm's four joints, in ticks")
        })
    };
    let sources = graph.sources().iter().enumerate().map(source).collect::<Result<_, _>>()?;
    Ok((sources, graph.actions().iter().enumerate().map(moved).collect::<Result<_, _>>()?))
}

/// Fills an engine's flat state and interprets its answer.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Binding {
    scalar: ScalarType,
    sources: Vec<Source>,
    moves: Vec<Move>,
}

impl Binding {
    /// Creates the binding of a policy with these sources, in this order, and these actions.
    pub fn new(scalar: ScalarType, sources: Vec<Source>, moves: Vec<Move>) -> Self {
        Self { scalar, sources, moves }
    }

    /// Creates the binding of a graph.
    ///
    /// # Errors
    /// If a source is not part of the observation, or an action has no move that the arm knows.
    pub fn of_graph(file: &str, graph: &Graph) -> Result<Self, InputError> {
        let (sources, moves) = bind(file, graph)?;
        Ok(Self::new(graph.scalar(), sources, moves))
    }

    /// Returns the parts of the observation that make up a state, in order.
    pub fn sources(&self) -> &[Source] {
        &self.sources
    }

    /// Returns the number of values in a state.
    pub fn state_length(&self) -> usize {
        self.sources.iter().map(|source| source.length()).sum()
    }

    /// Appends an observation to a batch of flat states, exact in the policy's scalar type.
    pub fn push_state(&self, observation: &Observation<f64>, states: &mut Vec<f64>) {
        let start = states.len();
        states.resize(start + self.state_length(), 0.0);
        let state = &mut states[start..];
        Source::fill(&self.sources, &WIDOWX, observation, &TargetMemo::new(), state);
        for value in state {
            *value = self.scalar.round(*value);
        }
    }

    /// Returns the move of an action; `None` for an action that the policy does not have.
    pub fn wanted(&self, action: ActionId) -> Option<Move> {
        self.moves.get(usize::from(action.0)).copied()
    }
}

fn known_sources() -> String {
    Source::ALL.map(|source| format!("{} ({} values)", source.name(), source.length())).join(", ")
}
