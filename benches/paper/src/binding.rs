//! Translation between a graph's sources and actions and those of the arm.

use tpg_arm::binding;
use tpg_arm::observation::{Observation, Source, TargetMemo};
use tpg_arm::{Move, WIDOWX};
use tpg_graph::{Action, Graph, ScalarType};

/// Fills an engine's flat state and interprets its answer.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Binding {
    /// The number type of the state.
    pub scalar: ScalarType,
    /// The parts of the observation that make up a state, in order.
    pub sources: Vec<Source>,
    /// The move of each action.
    pub moves: Vec<Move>,
}

impl Binding {
    /// Creates the binding of a graph; `None` if the arm has no such source, or an action does not state its move.
    pub fn new(graph: &Graph) -> Option<Self> {
        let source = |source: &tpg_graph::Source| binding::source(&source.name, source.ranges.len());
        let moved = |action: &Action| {
            let effect = action.effect.as_ref()?;
            binding::moved(&effect.name, &effect.values)
        };
        let sources = graph.sources().iter().map(source).collect::<Option<_>>()?;
        let moves = graph.actions().iter().map(moved).collect::<Option<_>>()?;
        Some(Self { scalar: graph.scalar(), sources, moves })
    }

    /// Appends the state that a policy decides from, rounded to its number type.
    pub fn push_state(&self, observation: &Observation<f64>, states: &mut Vec<f64>) {
        let start = states.len();
        let length: usize = self.sources.iter().map(|source| source.length()).sum();
        states.resize(start + length, 0.0);
        let state = &mut states[start..];
        Source::fill(&self.sources, &WIDOWX, observation, &TargetMemo::new(), state);
        state.iter_mut().for_each(|value| *value = self.scalar.round(*value));
    }
}
