//! A policy under evaluation: what a worker is sent.

use crate::error;
use crate::graph::Graph;
use pyo3::prelude::*;
use pyo3::types::PyBytes;
use std::sync::Mutex;
use tpg_engine::{EngineOptions, Plan, Single};
use tpg_graph::interpret::Answer;
use tpg_graph::{MathsProvider, ScalarType, SourceDocument};
use tpg_runtime::ops::Own;

/// A policy that is evaluated in an episode.
#[pyclass(frozen, module = "tpg_train._tpg")]
#[derive(Debug)]
pub(crate) struct Policy {
    policy: tpg_engine::PolicyGraph,
    inputs: usize,
    /// Its own plan, made when it first acts.
    single: Mutex<Option<Single<f32, Own>>>,
}

impl Policy {
    /// Wraps a policy over a state of `inputs` values.
    pub(crate) fn new(policy: tpg_engine::PolicyGraph, inputs: usize) -> Self {
        Self { policy, inputs, single: Mutex::new(None) }
    }

    /// Creates an evaluator of one state at a time.
    pub(crate) fn single(&self) -> Single<f32, Own> {
        let source = SourceDocument {
            name: "state".to_owned(),
            length: self.inputs as u32,
            unit: String::new(),
            ranges: vec![[-1.0, 1.0]; self.inputs],
        };
        Single::new(Plan::new::<Own>(&self.policy, &[source], EngineOptions { lanes: 1, ..EngineOptions::default() }))
    }
}

#[pymethods]
impl Policy {
    /// Returns the policy of a graph.
    #[staticmethod]
    fn of(graph: &Graph) -> PyResult<Self> {
        let graph = in_f32(&graph.0)?;
        Ok(Self::new(tpg_engine::PolicyGraph::from(graph), graph.state_length()))
    }

    /// Reads what `to_bytes` wrote.
    #[staticmethod]
    fn from_bytes(bytes: &[u8]) -> PyResult<Self> {
        let (inputs, policy) = serde_json::from_slice(bytes).map_err(error::input)?;
        Ok(Self::new(policy, inputs))
    }

    /// Returns the policy as bytes, one to three kilobytes.
    fn to_bytes<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyBytes>> {
        let bytes = serde_json::to_vec(&(self.inputs, &self.policy)).map_err(error::input)?;
        Ok(PyBytes::new(py, &bytes))
    }

    /// Returns the number of the action for a flat state; the values of the outputs for a policy that has some.
    fn answer(&self, state: Vec<f32>) -> PyResult<(Option<u16>, Vec<f64>)> {
        if state.len() != self.inputs {
            return Err(error::input(format!("a state of {} values; accepted: {}", state.len(), self.inputs)));
        }
        let mut single = self.single.lock().map_err(error::training)?;
        Ok(match single.get_or_insert_with(|| self.single()).answer(&state) {
            Answer::Action(action) => (Some(action.0), Vec::new()),
            Answer::Values(values) => (None, values),
        })
    }
}

/// Returns a graph that computes in f32 with own maths, as evolution does.
fn in_f32(graph: &tpg_graph::Graph) -> PyResult<&tpg_graph::Graph> {
    if (graph.scalar(), graph.maths()) == (ScalarType::F32, MathsProvider::Own) {
        return Ok(graph);
    }
    let found = format!("a graph in {} with {} maths", graph.scalar().name(), graph.maths().name());
    Err(error::input(format!("{found}; accepted: f32 with own maths")))
}
