//! A policy under evaluation: what a worker is sent.

use crate::error;
use crate::graph::Graph;
use crate::space::Space;
use pyo3::prelude::*;
use pyo3::types::PyBytes;
use std::sync::Mutex;
use tpg_engine::{Moments, Plan, Single, Units};
use tpg_graph::interpret::Answer;
use tpg_graph::{MathsProvider, ScalarType, SourceDocument};
use tpg_runtime::ops::{Maths, Own};
use tpg_runtime::scalar::Scalar;

/// A policy that is evaluated in an episode.
#[pyclass(frozen, module = "tpg_train._tpg")]
pub(crate) struct Policy {
    policy: tpg_engine::PolicyGraph,
    inputs: usize,
    scalar: ScalarType,
    units: Units,
    /// Its own evaluator, made when it first acts.
    acting: Mutex<Option<Acting>>,
}

/// An evaluator of one state at a time, in what the policy computes in.
pub(crate) type Acting = Box<dyn FnMut(&[f64]) -> Answer + Send>;

impl Policy {
    /// Wraps a policy over a state of `inputs` values, computed in `scalar`.
    pub(crate) fn new(policy: tpg_engine::PolicyGraph, inputs: usize, scalar: ScalarType) -> Self {
        Self { policy, inputs, scalar, units: Units::default(), acting: Mutex::new(None) }
    }

    /// Returns what it computes in.
    pub(crate) fn scalar(&self) -> ScalarType {
        self.scalar
    }

    /// Creates an evaluator.
    pub(crate) fn acting(&self) -> Acting {
        match self.scalar {
            ScalarType::F32 => self.acting_in::<f32>(),
            ScalarType::F64 => self.acting_in::<f64>(),
        }
    }

    fn acting_in<S: Scalar>(&self) -> Acting
    where
        Own: Maths<S>,
    {
        let source = SourceDocument::new("state", "", vec![[-1.0, 1.0]; self.inputs]);
        let single = Single::<S, Own>::new(Plan::new::<Own>(&self.policy, &[source]));
        let (mut counts, mut rounded) = (Vec::with_capacity(self.inputs), Vec::with_capacity(self.inputs));
        let units = self.units.clone();
        Box::new(move |state| {
            counts.clear();
            counts.extend_from_slice(state);
            units.count(&mut counts);
            rounded.clear();
            rounded.extend(counts.iter().map(|&value| S::from_f64(value)));
            let mut answer = single.answer(&rounded);
            if let Answer::Values(values) = &mut answer {
                units.value(values);
            }
            answer
        })
    }
}

#[pymethods]
impl Policy {
    /// Returns the policy of a graph; with a space, one that reads the states of that.
    #[staticmethod]
    #[pyo3(signature = (graph, space = None))]
    fn of(graph: &Graph, space: Option<&Space>) -> PyResult<Self> {
        let graph = &graph.0;
        if graph.maths() != MathsProvider::Own {
            let found = format!("a graph with {} maths", graph.maths().name());
            return Err(error::input(format!("{found}; accepted: own maths, or a built-in problem")));
        }
        let Some(space) = space else {
            let policy = Self::new(tpg_engine::PolicyGraph::from(graph), graph.state_length(), graph.scalar());
            return Ok(Self { units: Units::of(graph), ..policy });
        };
        let policy = tpg_engine::reading("graph", graph, &space.seen_by(graph)).map_err(error::input)?;
        Ok(Self::new(policy, space.length() + graph.memory(), graph.scalar()))
    }

    /// Reads what `to_bytes` wrote.
    #[staticmethod]
    fn from_bytes(bytes: &[u8]) -> PyResult<Self> {
        let (inputs, scalar, policy, units) = serde_json::from_slice(bytes).map_err(error::input)?;
        Ok(Self { units, ..Self::new(policy, inputs, scalar) })
    }

    /// Returns the policy as bytes, one to three kilobytes.
    fn to_bytes<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyBytes>> {
        let bytes = serde_json::to_vec(&(self.inputs, self.scalar, &self.policy, &self.units)).map_err(error::input)?;
        Ok(PyBytes::new(py, &bytes))
    }

    /// The number of values that it reads: observations, and what it remembers.
    #[getter]
    pub(crate) fn inputs(&self) -> usize {
        self.inputs
    }

    /// Returns the moments of flat states, as the policy reads these, as JSON.
    fn moments(&self, states: Vec<Vec<f64>>) -> PyResult<String> {
        let mut seen = Moments::new(self.inputs);
        for mut state in states {
            state.iter_mut().for_each(|value| *value = self.scalar.round(*value));
            seen.push(&state);
        }
        serde_json::to_string(&seen).map_err(error::training)
    }

    /// Returns the number of the action for a flat state; the values of the outputs for a policy that has some.
    fn answer(&self, state: Vec<f64>) -> PyResult<(Option<u16>, Vec<f64>)> {
        if state.len() != self.inputs {
            return Err(error::input(format!("a state of {} values; accepted: {}", state.len(), self.inputs)));
        }
        let mut acting = self.acting.lock().map_err(error::training)?;
        let acting = acting.get_or_insert_with(|| self.acting());
        Ok(match acting(&state) {
            Answer::Action(action) => (Some(action.0), Vec::new()),
            Answer::Values(values) => (None, values),
        })
    }
}
