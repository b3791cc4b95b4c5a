//! A graph in Python.

use crate::error;
use crate::network::Network;
use crate::space::Space;
use numpy::{PyArray1, PyArray2, PyArrayMethods, PyReadonlyArray2, PyUntypedArrayMethods};
use pyo3::prelude::*;
use std::path::PathBuf;
use tpg_codegen::emit::Code;
use tpg_codegen::emit::{Language, Options, Prefix, Profile, Style};
use tpg_codegen::policy::to_asking_c;
use tpg_codegen::quantise::{Request, quantise};
use tpg_codegen::report;
use tpg_codegen::verify::Proof;
use tpg_engine::{PolicyGraph, Units};
use tpg_graph::error::{InputError, counted};
use tpg_graph::files::{read_graph, write_atomically};
use tpg_graph::interpret::{self, Answer};
use tpg_graph::output::write_folder;
use tpg_graph::states::StateSet;
use tpg_graph::{Input, Output, Range};
use tpg_picture as picture;
use tpg_train::{InIntegers, Visit};

/// States that a report's means are taken over, and their seed.
const STATES: usize = 20_000;
const SEED: u64 = 1;

/// A tangled program graph.
#[pyclass(frozen, module = "tpg_train._tpg")]
#[derive(Debug)]
pub(crate) struct Graph(pub(crate) tpg_graph::Graph);

#[pymethods]
impl Graph {
    /// Reads a `graph.json`.
    #[staticmethod]
    fn load(path: PathBuf) -> PyResult<Self> {
        read_graph(&path).map(Self).map_err(error::input)
    }

    /// Reads the text of a `graph.json`; messages name it `name`.
    #[staticmethod]
    #[pyo3(signature = (text, name = "<text>"))]
    fn from_json(text: &str, name: &str) -> PyResult<Self> {
        tpg_graph::Graph::from_json(name, text).map(Self).map_err(error::input)
    }

    /// Returns the text of the `graph.json`: the same bytes for the same graph.
    fn to_json(&self) -> String {
        self.0.to_json()
    }

    fn __reduce__(&self, py: Python<'_>) -> PyResult<(Py<PyAny>, (String,))> {
        Ok((py.get_type::<Self>().getattr("from_json")?.unbind(), (self.0.to_json(),)))
    }

    /// Writes the `graph.json`, whole or not at all.
    fn save(&self, path: PathBuf) -> PyResult<()> {
        write_atomically(&path, self.0.to_json().as_bytes()).map_err(error::input)
    }

    /// The SHA-256 of the `graph.json`.
    #[getter]
    fn sha256(&self) -> String {
        self.0.sha256()
    }

    /// The names of the inputs, in the order of the flat state.
    #[getter]
    fn inputs(&self) -> Vec<String> {
        self.0.inputs().map(|input| self.0.input_name(input)).collect()
    }

    /// Returns the place in the states of a space of each input.
    fn columns(&self, space: &Space) -> PyResult<Vec<u16>> {
        tpg_engine::places("graph", self.0.sources(), &space.seen_by(&self.0)).map_err(error::input)
    }

    /// The range of each input, as a value.
    #[getter]
    fn ranges(&self) -> Vec<(f64, f64)> {
        let value = |(input, range): (Input, Range)| match self.0.counts_of(input) {
            Some(counts) => (counts.value(range.min), counts.value(range.max)),
            None => (range.min, range.max),
        };
        self.0.inputs().zip(self.0.state_ranges()).map(value).collect()
    }

    /// True for a graph in integers, whose ranges are those of its counts.
    #[getter]
    fn counts(&self) -> bool {
        self.0.has_counts()
    }

    /// The names of the actions; empty for a policy with outputs.
    #[getter]
    fn actions(&self) -> Vec<String> {
        self.0.actions().iter().map(|action| action.name.clone()).collect()
    }

    /// The outputs: name, lowest and highest value; empty for a policy that chooses among actions.
    #[getter]
    fn outputs(&self) -> Vec<(String, f64, f64)> {
        let value = |output: &Output, end| output.counts.map_or(end, |counts| counts.value(end));
        let bounds = |output: &Output| (value(output, output.range.min), value(output, output.range.max));
        self.0.outputs().iter().map(|output| (output.name.clone(), bounds(output).0, bounds(output).1)).collect()
    }

    /// The number of the outputs, the last ones, that are remembered until the next decision, which reads them as its last inputs.
    #[getter]
    fn memory(&self) -> usize {
        self.0.memory()
    }

    /// "f32" or "f64": what the graph computes in.
    #[getter]
    fn scalar(&self) -> &'static str {
        self.0.scalar().name()
    }

    /// The lines that matter and the edges of the teams.
    #[getter]
    fn size(&self) -> usize {
        PolicyGraph::from(&self.0).size()
    }

    /// Returns the interpreter's answer to each row of `states`, in values: numbers of actions, or rows of values.
    fn answers<'py>(&self, py: Python<'py>, states: PyReadonlyArray2<'py, f64>) -> PyResult<Bound<'py, PyAny>> {
        let (columns, inputs) = (states.shape()[1], self.0.state_length());
        if columns != inputs {
            return Err(error::input(format!("states of {columns} values; accepted: {inputs}")));
        }
        let mut flat: Vec<f64> = states.as_array().iter().copied().collect();
        let (graph, units) = (&self.0, Units::of(&self.0));
        flat.chunks_exact_mut(inputs).for_each(|state| units.count(state));
        let answers = py.detach(|| interpret::answers(graph, &flat));
        if graph.outputs().is_empty() {
            let action = |answer| if let Answer::Action(action) = answer { i64::from(action.0) } else { 0 };
            return Ok(PyArray1::from_iter(py, answers.into_iter().map(action)).into_any());
        }
        let values = answers.into_iter().flat_map(|answer| match answer {
            Answer::Values(mut values) => {
                units.value(&mut values);
                values
            }
            Answer::Action(_) => Vec::new(),
        });
        let values: Vec<f64> = values.collect();
        let rows = PyArray1::from_vec(py, values).reshape([flat.len() / inputs, graph.outputs().len()])?;
        let rows: Bound<'py, PyArray2<f64>> = rows;
        Ok(rows.into_any())
    }

    /// Returns what the policy computes, as formulas.
    fn formula(&self, py: Python<'_>) -> String {
        py.detach(|| report::explain(&self.0, &plain_options()))
    }

    /// Returns what the code costs on `targets`, named as by `tpg-codegen report`, as text and as JSON.
    fn report(&self, py: Python<'_>, targets: Vec<String>) -> PyResult<(String, String)> {
        let targets = targets.iter().map(|name| name.parse().map_err(error::input)).collect::<PyResult<Vec<_>>>()?;
        let report = py.detach(|| report::report("graph", &self.0, &plain_options(), &targets, None));
        let report = report.map_err(error::input)?;
        Ok((report.to_string(), serde_json::to_string(&report).map_err(error::input)?))
    }

    /// Returns the graph in integers, with inputs and weights of so many bits, which the ranges of `states` fill, or the declared
    /// ones; and a report.
    fn quantise(
        &self,
        py: Python<'_>,
        bits: u32,
        states: Option<PyReadonlyArray2<'_, f64>>,
    ) -> PyResult<(Self, String)> {
        let states = self.given(states)?.unwrap_or_else(|| StateSet::sampled(&self.0, STATES, SEED));
        let quantised = py.detach(|| quantise("graph", &self.0, &Request::of_bits(bits, &states)));
        quantised.map(|(graph, report)| (Self(graph), report.to_string())).map_err(error::input)
    }

    /// Returns the graph in integers that keep its return, and a report: see [`InIntegers::keeping_return`]. `play` gives the
    /// returns of a graph, and the states that it visits without its memory.
    fn quantise_keeping(
        &self,
        bits: Option<u32>,
        states: Option<PyReadonlyArray2<'_, f64>>,
        play: &Bound<'_, PyAny>,
    ) -> PyResult<(Self, String)> {
        let visit = |graph: &tpg_graph::Graph| -> PyResult<Visit> {
            let played = play.call1((Self(graph.clone()),))?;
            let (returns, states): (_, PyReadonlyArray2<'_, f64>) = played.extract()?;
            Ok(Visit { returns, states: states.as_array().iter().copied().collect() })
        };
        let given = self.given(states)?;
        let whole = InIntegers::keeping_return("graph", &self.0, bits, given, |graph| visit(graph).map_err(Raised));
        whole.map(in_python).map_err(|Raised(error)| error)
    }

    /// Returns the generated files, names and texts, in integers where the graph is. `language` is "c" or "rust"; `profile` is "fast", "balanced", "small" or
    /// "constant-time".
    fn code(&self, py: Python<'_>, language: &str, prefix: &str, profile: &str) -> PyResult<Vec<(String, String)>> {
        let (language, options) = (language_of(language)?, options(prefix, profile)?);
        let code = py.detach(|| Code::of_graph("graph", &self.0, &options, language)).map_err(error::input)?;
        Ok(code.files.into_iter().map(|file| (file.name, file.text)).collect())
    }

    /// Writes the generated files into a folder, which appears with all of them or not at all; returns their paths.
    fn export(
        &self,
        py: Python<'_>,
        folder: PathBuf,
        language: &str,
        prefix: &str,
        profile: &str,
    ) -> PyResult<Vec<PathBuf>> {
        export(&folder, self.code(py, language, prefix, profile)?)
    }

    /// Writes C as `export` does, with the network that the graph asks.
    fn export_with(&self, folder: PathBuf, prefix: &str, profile: &str, network: &Network) -> PyResult<Vec<PathBuf>> {
        let files = to_asking_c(&self.0, &options(prefix, profile)?, &network.0).map_err(error::input)?;
        export(&folder, files.into_iter().map(|file| (file.name, file.text)).collect())
    }

    /// Returns this graph with one more action, its last, which asks a network where the two highest bids of a team for different
    /// destinations are less than `margin` apart.
    fn asking(&self, margin: f64) -> PyResult<Self> {
        self.0.clone().asking("network", margin).map(Self).map_err(error::input)
    }

    /// Compiles generated code in each language and profile, and compares its answers with the interpreter's on `states`
    /// states drawn with `seed`. Returns the proof as JSON, and true if it holds.
    fn verify(
        &self,
        py: Python<'_>,
        languages: Vec<String>,
        profiles: Vec<String>,
        states: usize,
        seed: u64,
    ) -> PyResult<(String, bool)> {
        let mut shapes = Vec::new();
        for language in &languages {
            for profile in &profiles {
                shapes.push((language_of(language)?, options("policy", profile)?));
            }
        }
        let proof = py.detach(|| {
            let code = |(language, options): &(Language, Options)| Code::of_graph("graph", &self.0, options, *language);
            let codes = shapes.iter().map(code).collect::<Result<Vec<_>, _>>().map_err(error::input)?;
            Proof::of(&codes, states, seed).map_err(error::training)
        })?;
        Ok((serde_json::to_string(&proof).map_err(error::input)?, proof.holds()))
    }

    /// Returns the graph as a picture.
    fn svg(&self) -> String {
        picture::graph::standalone(&self.0)
    }

    fn __repr__(&self) -> String {
        let ends = match (self.0.outputs().is_empty(), self.0.ends()) {
            (true, ends) => counted(ends, "action"),
            (false, 1) => "1 leaf".to_owned(),
            (false, ends) => format!("{ends} leaves"),
        };
        let (teams, programs) = (self.0.teams().len(), self.0.programs().len());
        format!("<Graph of {}, {}, {ends}>", counted(teams, "team"), counted(programs, "program"))
    }
}

impl Graph {
    /// Returns states that are given.
    pub(crate) fn given(&self, states: Option<PyReadonlyArray2<'_, f64>>) -> PyResult<Option<StateSet>> {
        let Some(states) = states else { return Ok(None) };
        let (found, wanted) = (states.shape(), self.0.state_length());
        if found[1] != wanted || found[0] == 0 {
            return Err(error::input(format!("states of {} values; accepted: rows of {wanted}", found[1])));
        }
        Ok(Some(StateSet::given(&self.0, states.as_array().iter().copied().collect())))
    }
}

/// Returns a graph in integers, and its report.
pub(crate) fn in_python(whole: InIntegers) -> (Graph, String) {
    let said = whole.to_string();
    (Graph(whole.graph), said)
}

/// An exception, also of an input.
struct Raised(PyErr);

impl From<InputError> for Raised {
    fn from(error: InputError) -> Self {
        Self(error::input(error))
    }
}

/// Writes files into a folder, which appears with all of them or not at all; returns their paths.
pub(crate) fn export(folder: &std::path::Path, files: Vec<(String, String)>) -> PyResult<Vec<PathBuf>> {
    let files: Vec<(PathBuf, String)> = files.into_iter().map(|(name, text)| (folder.join(name), text)).collect();
    write_folder(folder, &files).map_err(error::input)?;
    Ok(files.into_iter().map(|(path, _)| path).collect())
}

/// The options of code that is measured and explained, and not written.
fn plain_options() -> Options {
    Options::new(Prefix::of_file("policy".as_ref()))
}

fn options(prefix: &str, profile: &str) -> PyResult<Options> {
    let prefix = prefix.parse().map_err(error::input)?;
    let found = Profile::ALL.into_iter().find(|known| known.name() == profile).ok_or_else(|| {
        error::input(format!("the profile {profile:?}; accepted: {}", Profile::ALL.map(Profile::name).join(", ")))
    })?;
    Ok(Options { profile: Some(found), style: Style::Pure, ..Options::new(prefix) })
}

fn language_of(name: &str) -> PyResult<Language> {
    match name {
        "c" => Ok(Language::C),
        "rust" => Ok(Language::Rust),
        _ => Err(error::input(format!("the language {name:?}; accepted: c, rust"))),
    }
}
