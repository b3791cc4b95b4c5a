//! What every generated file says of itself: where it comes from, never when or where it was made.

use super::{Options, Style};
use crate::graph::Graph;
use crate::ir::{Module, Node};

/// The banner's lines, without comment marks.
pub(super) fn lines(graph: &Graph, module: &Module, options: &Options, language: &str) -> Vec<String> {
    let operations = module.nodes.iter().filter(|node| matches!(node, Node::Operation(..))).count();
    let edges: usize = module.teams.iter().map(|team| team.edges.len()).sum();
    let style = match options.style {
        Style::Gegelati if language == "c" => " --style gegelati",
        Style::Gegelati | Style::Pure => "",
    };
    vec![
        format!("Made by tpg-codegen {} from a tangled program graph; do not edit.", env!("CARGO_PKG_VERSION")),
        format!("Options: --lang {language} --prefix {}{style}", options.prefix),
        format!("Graph SHA-256: {}", graph.sha256()),
        format!(
            "{} teams ({} on the longest walk), {edges} edges, {} programs, {operations} distinct operations.",
            module.teams.len(),
            module.depth,
            module.bidders.len(),
        ),
        format!("Computes in {} with {} maths.", graph.scalar().name(), graph.maths().name()),
    ]
}
