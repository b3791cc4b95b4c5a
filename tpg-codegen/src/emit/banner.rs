//! The banner of generated files: their origin, never the time or place of generation.

use crate::cost::Cost;
use crate::ir::Node;
use crate::options::{Language, Profile, Style};
use crate::program::Program;
use crate::shape::Shape;
use askama::Template;
use tpg_graph::error::counted;
use tpg_graph::{Graph, MathsProvider, ScalarType};
use tpg_runtime::ops::Instruction::{Atan, Quotient, Sqrt, Tanh};

#[derive(Template)]
#[template(path = "banner.txt", escape = "none")]
struct Banner<'a> {
    version: &'a str,
    program: &'a Program<'a>,
    graph: &'a Graph,
    /// The task, and how well the policy does it, as far as the graph says so.
    problem: Option<&'a str>,
    score: Option<f64>,
    success: Option<f64>,
    operations: usize,
    cost: Cost,
    /// Some operation may take another time for another state.
    is_open: bool,
}

/// The banner's lines, without comment marks.
pub(crate) fn lines(program: &Program<'_>) -> Vec<String> {
    let (graph, nodes) = (program.graph(), &program.module.nodes);
    let provenance = graph.provenance();
    let named = provenance.config.as_ref().and_then(|config| config.pointer("/problem/name")?.as_str());
    // A policy in integers was not tested when the one in floats was.
    let score = |name: &str| provenance.scores.get(name).filter(|_| !graph.has_counts());
    let found = ["validation_score", "score"].into_iter().find_map(score);
    let banner = Banner {
        version: env!("CARGO_PKG_VERSION"),
        program,
        graph,
        // A note of the trainer names the task; one by hand is a sentence of its own.
        problem: named.or(provenance.note.as_deref().filter(|_| provenance.tool.is_some())),
        score: found.map(|score| (score * 100.0).round() / 100.0),
        success: score("validation_success").filter(|_| found.is_none()).map(|share| 100.0 * share),
        operations: nodes.iter().filter(|node| matches!(node, Node::Operation(..))).count(),
        cost: Cost::worst(program),
        is_open: nodes.iter().any(|node| matches!(node, Node::Operation(Sqrt | Atan | Tanh | Quotient, ..))),
    };
    banner.render().expect("the template renders").lines().map(str::to_owned).collect()
}

/// Text of the graph that may stand in a comment.
fn safe(text: &str) -> String {
    let line: String = text.chars().map(|c| if c.is_control() { ' ' } else { c }).collect();
    line.replace("*/", "* /").replace("/*", "/ *")
}
