//! The banner of generated files: their origin, never the time or place of generation.

use crate::ir::Node;
use crate::options::{Language, Profile, Style};
use crate::program::Program;
use tpg_graph::conversion::Conversion;
use tpg_graph::{Graph, MathsProvider, ScalarType};

/// The banner's lines, without comment marks.
pub(super) fn lines(program: &Program<'_>) -> Vec<String> {
    let Program { module, language, options, .. } = program;
    let (graph, language) = (program.graph(), *language);
    let operations = module.nodes.iter().filter(|node| matches!(node, Node::Operation(..))).count();
    let edges: usize = module.teams.iter().map(|team| team.edges.len()).sum();
    let (name, style) = match (language, options.style) {
        (Language::C, Style::Gegelati) => ("c", " --style gegelati".to_owned()),
        (Language::C, Style::Pure) => ("c", format!(" --profile {}", options.profile_in(language).name())),
        (Language::Rust, _) => ("rust", format!(" --profile {}", options.profile_in(language).name())),
    };
    let scalar =
        options.conversion.as_ref().map_or_else(String::new, |_| format!(" --scalar {}", graph.scalar().name()));
    let mut lines = vec![
        format!("Made by tpg-codegen {} from a tangled program graph; do not edit.", env!("CARGO_PKG_VERSION")),
        format!("Options: --lang {name} --prefix {}{style}{scalar}", options.prefix),
        format!("Graph SHA-256: {}", program.graph_sha256()),
        format!(
            "{} teams ({} on the longest walk), {edges} edges, {} programs, {operations} distinct operations.",
            module.teams.len(),
            module.depth,
            module.bidders.len(),
        ),
        format!("Computes in {} with {} maths.", graph.scalar().name(), graph.maths().name()),
    ];
    let has_profile = language == Language::Rust || options.style == Style::Pure;
    if has_profile && options.profile_in(language) == Profile::ConstantTime {
        lines.extend(same_time(graph).map(str::to_owned));
    }
    if let Some(Conversion { from, maths, agreement, .. }) = &options.conversion {
        lines.push(format!(
            "The graph says {} with {} maths, so this is not the graph, only near it:",
            from.name(),
            maths.name()
        ));
        lines.push(format!("{agreement}."));
    }
    lines
}

/// The limit of constant time that lies outside the code.
fn same_time(graph: &Graph) -> Option<&'static str> {
    match (graph.scalar(), graph.maths()) {
        (ScalarType::F64, MathsProvider::Own) => Some(
            "Every decision takes the same time only where the FPU has doubles: in software they branch on what they compute.",
        ),
        (ScalarType::F64, MathsProvider::System) => Some(
            "Every decision takes the same time only where the FPU has doubles, and as far as the platform's maths does: in software \
             they branch on what they compute.",
        ),
        (ScalarType::F32, MathsProvider::System) => {
            Some("Every decision takes the same time as far as the platform's maths does.")
        }
        (ScalarType::F32, MathsProvider::Own) => None,
    }
}
