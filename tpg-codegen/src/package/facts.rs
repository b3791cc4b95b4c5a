//! Facts about a policy for the templates of packages.

use super::details::Details;
use crate::cost::Cost;
use crate::emit::Code;
use crate::emit::c::field::field;
use crate::emit::integers::worth_from;
use crate::emit::interface::written;
use crate::options::{Language, Options};
use crate::report::{ShapeSize, size_of};
use crate::size::Target;
use tpg_graph::error::counted;
use tpg_graph::{Counts, Graph, MathsProvider, ScalarType};

/// The facts.
pub(super) struct Facts<'a> {
    pub(super) details: &'a Details,
    /// The prefix: the package's name.
    pub(super) name: &'a str,
    /// The Rust type.
    pub(super) camel: String,
    pub(super) upper: String,
    pub(super) title: String,
    pub(super) inputs: Vec<Row>,
    pub(super) actions: Vec<String>,
    pub(super) outputs: Vec<Row>,
    /// Values of the memory.
    pub(super) memory: usize,
    /// The middle of every range: in C by source, in Rust flat.
    pub(super) state_c: String,
    pub(super) state_rust: String,
    /// Needs of the C on the package's chip.
    pub(super) size: ShapeSize,
    pub(super) worst: Cost,
    pub(super) sha256: String,
    /// The version of the runtime that Rust stands on: this tool's.
    pub(super) runtime: &'static str,
    pub(super) rust: bool,
    /// The platform's libm is called.
    pub(super) libm: bool,
    /// The policy sees counts and computes in integers.
    pub(super) whole: bool,
}

/// An input or output: name, values, unit, range.
pub(super) struct Row {
    pub(super) name: String,
    /// The field of C's struct.
    pub(super) field: String,
    pub(super) length: usize,
    pub(super) unit: String,
    pub(super) range: String,
}

/// A text in a cell of a Markdown table, on one line.
fn cell(text: &str) -> String {
    text.replace(['\n', '\r'], " ").replace('|', "\\|")
}

impl<'a> Facts<'a> {
    pub(super) fn new(
        code: &Code<'_>,
        c: &Code<'_>,
        graph: &Graph,
        options: &'a Options,
        details: &'a Details,
        target: Target,
    ) -> Self {
        let (seen, (answered, _)) = (graph.observed(), graph.split_outputs());
        let whole = graph.has_counts();
        let suffix = if graph.scalar() == ScalarType::F32 && !whole { "F" } else { "" };
        let middle = |[low, high]: [f64; 2]| match low / 2.0 + high / 2.0 {
            count if whole => format!("{}", count.round() as i64),
            value => format!("{:?}", graph.scalar().round(value)),
        };
        let unit = |counts: Option<&Counts>, unit: &str| match counts {
            Some(counts) => cell(&worth_from(counts, unit)),
            None => cell(unit),
        };
        let group = |source: &tpg_graph::SourceDocument| {
            let values: Vec<String> = source.ranges.iter().map(|&range| middle(range) + suffix).collect();
            if let [value] = &values[..] { value.clone() } else { format!("{{ {} }}", values.join(", ")) }
        };
        let answers = match answered.len() {
            0 => counted(graph.actions().len(), "action"),
            count => counted(count, "output"),
        };
        Self {
            details,
            name: options.prefix.lower(),
            camel: options.prefix.camel(),
            upper: options.prefix.upper(),
            title: format!(
                "A learned policy with {} and {answers}: a tangled program graph, compiled",
                counted(seen.iter().map(|source| source.ranges.len()).sum(), "input")
            ),
            inputs: seen
                .iter()
                .map(|source| Row {
                    name: source.name.clone(),
                    field: field(graph, &source.name),
                    length: source.ranges.len(),
                    unit: unit(source.counts.first(), &source.unit),
                    range: source.ranges.iter().map(written).collect::<Vec<_>>().join("; "),
                })
                .collect(),
            actions: graph.actions().iter().map(|action| cell(&action.to_string())).collect(),
            outputs: answered
                .iter()
                .map(|output| Row {
                    name: output.name.clone(),
                    field: field(graph, &output.name),
                    length: 1,
                    unit: unit(output.counts.as_ref(), &output.unit),
                    range: written(&[output.range.min, output.range.max]),
                })
                .collect(),
            memory: graph.memory(),
            state_c: seen.iter().map(group).collect::<Vec<_>>().join(", "),
            state_rust: seen
                .iter()
                .flat_map(|source| &source.ranges)
                .map(|&range| middle(range))
                .collect::<Vec<_>>()
                .join(", "),
            size: size_of(c, target, ""),
            worst: Cost::worst(&code.program),
            sha256: code.program.graph_sha256(),
            runtime: env!("CARGO_PKG_VERSION"),
            rust: code.program.language == Language::Rust,
            libm: graph.maths() == MathsProvider::System && !whole,
            whole,
        }
    }
}
