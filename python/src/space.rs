//! An environment's observations and actions, as evolution sees them.

use crate::error;
use crate::eye::Eye;
use pyo3::prelude::*;
use tpg_engine::random::Stream;
use tpg_engine::{Act, ActionSpace, Environment, Output, SourceSet, Step, state_length};
use tpg_graph::{Graph, SourceDocument};
use tpg_runtime::scalar::Scalar;

/// Names, units and ranges of an environment's observations and actions. It never steps: episodes run in Python.
#[pyclass(frozen, from_py_object, module = "tpg_train._tpg")]
#[derive(Clone, Debug)]
pub(crate) struct Space {
    pub(crate) sources: Vec<SourceDocument>,
    pub(crate) actions: ActionSpace,
    pub(crate) limit: u32,
}

#[pymethods]
impl Space {
    /// Creates a space. `sources` are names with the range of each value; either `actions`, by name, or `outputs`, by name
    /// with lowest and highest value; `limit` is the greatest number of actions of an episode. Where `asks`, the last of the
    /// actions asks the network. An `eye` gives the sources that it has instead of these.
    #[new]
    #[pyo3(signature = (sources, actions, outputs, limit, asks = false, eye = None))]
    fn new(
        sources: Vec<(String, Vec<[f64; 2]>)>,
        actions: Vec<String>,
        outputs: Vec<(String, f64, f64)>,
        limit: u32,
        asks: bool,
        eye: Option<&Eye>,
    ) -> PyResult<Self> {
        let source = |(name, ranges): (String, Vec<[f64; 2]>)| SourceDocument::new(name, "", ranges);
        let output = |(name, min, max)| Output { name, unit: String::new(), min, max };
        let actions = if outputs.is_empty() {
            let own = &actions[..actions.len() - usize::from(asks && !actions.is_empty())];
            let space = ActionSpace::discrete(own.iter().map(String::as_str));
            if asks { space.with_ask() } else { space }
        } else {
            ActionSpace::Box(outputs.into_iter().map(output).collect())
        };
        let sources = match eye {
            Some(eye) => eye.sources.clone(),
            None => sources.into_iter().map(source).collect(),
        };
        if limit == 0 || sources.is_empty() {
            return Err(error::input("an environment without observations or steps; accepted: at least one of each"));
        }
        Ok(Self { sources, actions, limit })
    }
}

impl Space {
    /// Returns the sources of an observation, then those of a graph's memory.
    pub(crate) fn seen_by(&self, graph: &Graph) -> Vec<SourceDocument> {
        let own = graph.sources();
        self.sources.iter().chain(&own[own.len() - graph.memory()..]).cloned().collect()
    }

    /// Returns the number of values of an observation.
    pub(crate) fn length(&self) -> usize {
        state_length(&self.sources)
    }
}

/// Draws the seed of an episode: 31 bits, which every environment takes.
pub(crate) fn seed_of(stream: &mut Stream) -> u64 {
    stream.bits() >> 33
}

impl<S: Scalar> Environment<S> for Space {
    /// The seed of `reset`.
    type Task = u64;
    type Episode = ();

    fn sources(&self) -> Vec<SourceDocument> {
        self.sources.clone()
    }
    fn actions(&self) -> ActionSpace {
        self.actions.clone()
    }
    fn time_limit(&self) -> u32 {
        self.limit
    }
    fn draw(&self, stream: &mut Stream) -> u64 {
        seed_of(stream)
    }
    fn start(&self, _seed: &u64) {}
    fn observe(&self, (): &mut (), _wanted: SourceSet, _state: &mut [S]) {
        unreachable!("the mailbox evaluates, and observes nothing itself")
    }
    fn step(&self, (): &mut (), _act: Act<'_, S>) -> Step {
        unreachable!("the mailbox evaluates, and steps nothing itself")
    }
}
