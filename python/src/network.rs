//! Networks in integers, made of the weights of another library.

use crate::error;
use crate::graph::export;
use numpy::{PyArray1, PyArrayMethods, PyReadonlyArray1, PyReadonlyArray2, PyUntypedArrayMethods};
use pyo3::prelude::*;
use std::path::PathBuf;
use tpg_codegen::emit::Prefix;
use tpg_codegen::policy::{
    FloatLayer, FloatNetwork, FloatOutput, FloatValue, Input, Output, QuantisedPolicy, differences, to_plain_c, to_rust,
};
use tpg_graph::files::{read_text, write_atomically};
use tpg_runtime::net::{Kind, Squash};

/// A multilayer perceptron in integers.
#[pyclass(frozen, module = "tpg_train._tpg")]
#[derive(Debug)]
pub(crate) struct Network(pub(crate) QuantisedPolicy);

#[pymethods]
impl Network {
    /// Puts a network into integers. `inputs` are names with offset and scale; `layers` are weights, a row for each unit, and
    /// bias, with a ReLU behind all but the last; `values` are names with lowest and highest value and "tanh" or "clamp";
    /// without them the greatest of `actions` is the answer. `states`, a row each, calibrate it.
    #[staticmethod]
    #[pyo3(signature = (inputs, layers, values, actions, states, kind, sha256))]
    fn quantise(
        inputs: Vec<(String, f32, f32)>,
        layers: Vec<(PyReadonlyArray2<'_, f32>, PyReadonlyArray1<'_, f32>)>,
        values: Vec<(String, f32, f32, String)>,
        actions: Vec<String>,
        states: PyReadonlyArray2<'_, f32>,
        kind: &str,
        sha256: String,
    ) -> PyResult<Self> {
        let input = |(name, offset, scale)| Input { name, offset, scale };
        let layer = |(weights, bias): &(PyReadonlyArray2<'_, f32>, PyReadonlyArray1<'_, f32>)| FloatLayer {
            inputs: weights.shape()[1],
            weights: weights.as_array().iter().copied().collect(),
            bias: bias.as_array().iter().copied().collect(),
        };
        let value = |(name, min, max, squash): (String, f32, f32, String)| {
            let squash = match squash.as_str() {
                "tanh" => Squash::Tanh,
                "clamp" => Squash::Clamp,
                other => return Err(error::input(format!("the squash {other:?}; accepted: tanh, clamp"))),
            };
            Ok(FloatValue { name, min, max, squash })
        };
        let output = match actions.is_empty() {
            true => FloatOutput::Values(values.into_iter().map(value).collect::<PyResult<_>>()?),
            false => FloatOutput::Argmax(actions),
        };
        let kind = kind_of(kind)?;
        let network = FloatNetwork {
            inputs: inputs.into_iter().map(input).collect(),
            layers: layers.iter().map(layer).collect(),
            output,
        };
        network.quantise(&rows(&states), kind, sha256).map(Self).map_err(error::input)
    }

    /// Reads a `policy.q.json`.
    #[staticmethod]
    fn load(path: PathBuf) -> PyResult<Self> {
        let text = read_text(&path, "a policy.q.json").map_err(error::input)?;
        Self::from_json(&text, &path.display().to_string())
    }

    /// Reads the text of a `policy.q.json`; messages name it `name`.
    #[staticmethod]
    #[pyo3(signature = (text, name = "<text>"))]
    fn from_json(text: &str, name: &str) -> PyResult<Self> {
        QuantisedPolicy::from_json(name, text).map(Self).map_err(error::input)
    }

    fn __reduce__(&self, py: Python<'_>) -> PyResult<(Py<PyAny>, (String,))> {
        Ok((py.get_type::<Self>().getattr("from_json")?.unbind(), (self.0.to_json(),)))
    }

    /// Writes the `policy.q.json`, whole or not at all.
    fn save(&self, path: PathBuf) -> PyResult<()> {
        write_atomically(&path, self.0.to_json().as_bytes()).map_err(error::input)
    }

    /// The names of the inputs.
    #[getter]
    fn inputs(&self) -> Vec<String> {
        self.0.inputs.iter().map(|input| input.name.clone()).collect()
    }

    /// The names of the actions; empty for a network that answers with values.
    #[getter]
    fn actions(&self) -> Vec<String> {
        if let Output::Argmax(names) = &self.0.output { names.clone() } else { Vec::new() }
    }

    /// Bytes of constants on a target.
    #[getter]
    fn bytes(&self) -> usize {
        self.0.bytes()
    }

    /// Multiplications of a weight that a decision costs.
    #[getter]
    fn multiplications(&self) -> usize {
        self.0.multiplications()
    }

    /// Returns the answer to each row of `states`: numbers of actions, or rows of values.
    fn answers<'py>(&self, py: Python<'py>, states: PyReadonlyArray2<'py, f32>) -> PyResult<Bound<'py, PyAny>> {
        let (columns, inputs) = (states.shape()[1], self.0.inputs.len());
        if columns != inputs {
            return Err(error::input(format!("states of {columns} values; accepted: {inputs}")));
        }
        let states = rows(&states);
        if let Output::Values(values) = &self.0.output {
            let answers: Vec<f32> = py.detach(|| states.iter().flat_map(|state| self.0.values(state)).collect());
            return Ok(PyArray1::from_vec(py, answers).reshape([states.len(), values.len()])?.into_any());
        }
        let answers: Vec<i64> = py.detach(|| states.iter().map(|state| self.0.choose(state) as i64).collect());
        Ok(PyArray1::from_vec(py, answers).into_any())
    }

    /// Writes C that needs no library into a folder, and returns the paths.
    fn export_c(&self, folder: PathBuf, prefix: &str) -> PyResult<Vec<PathBuf>> {
        let prefix: Prefix = prefix.parse().map_err(error::input)?;
        let files = to_plain_c(&self.0, &prefix).map_err(error::input)?;
        export(&folder, files.into_iter().map(|file| (file.name, file.text)).collect())
    }

    /// Writes a Rust module of constants for the crate `tpg-runtime` into a folder, and returns its path.
    fn export_rust(&self, folder: PathBuf, prefix: &str) -> PyResult<Vec<PathBuf>> {
        let prefix: Prefix = prefix.parse().map_err(error::input)?;
        export(&folder, vec![(format!("{prefix}.rs"), to_rust(&self.0).map_err(error::input)?)])
    }

    /// Compiles the C and counts the rows of `states` to which it does not answer as the network, bit for bit.
    fn differences(&self, py: Python<'_>, states: PyReadonlyArray2<'_, f32>) -> PyResult<usize> {
        let states = rows(&states);
        py.detach(|| differences(&self.0, &states)).map_err(error::training)
    }
}

/// Finds the widths of weights and activations by name.
pub(crate) fn kind_of(kind: &str) -> PyResult<Kind> {
    Kind::from_name(kind)
        .ok_or_else(|| error::input(format!("the kind {kind:?}; accepted: {}", Kind::ALL.map(Kind::name).join(", "))))
}

fn rows(states: &PyReadonlyArray2<'_, f32>) -> Vec<Vec<f32>> {
    states.as_array().rows().into_iter().map(|row| row.to_vec()).collect()
}
