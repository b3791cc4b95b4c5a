//! The banner of generated files: their origin, never the time or place of generation.

use crate::cost::Cost;
use crate::integers::Integers;
use crate::ir::Node;
use crate::options::{Language, Profile, Style};
use crate::program::Program;
use crate::shape::Shape;
use tpg_graph::conversion::Conversion;
use tpg_graph::error::counted;
use tpg_graph::{Graph, MathsProvider, Provenance, ScalarType};
use tpg_runtime::ops::Instruction;

/// The banner's lines, without comment marks.
pub(crate) fn lines(program: &Program<'_>) -> Vec<String> {
    let Program { module, language, options, .. } = program;
    let (graph, language) = (program.graph(), *language);
    let operations = module.nodes.iter().filter(|node| matches!(node, Node::Operation(..))).count();
    let (name, style) = match (language, options.style) {
        (Language::C, Style::Gegelati) => ("c", " --style gegelati".to_owned()),
        (Language::C, Style::Pure) => ("c", format!(" --profile {}", options.profile_in(language).name())),
        (Language::Rust, _) => ("rust", format!(" --profile {}", options.profile_in(language).name())),
    };
    let scalar =
        options.conversion.as_ref().map_or_else(String::new, |_| format!(" --scalar {}", graph.scalar().name()));
    let walk = if module.depth > 1 { format!(" ({} on the longest walk)", module.depth) } else { String::new() };
    let mut lines = vec![
        policy(graph),
        format!("Made by tpg-codegen {} from a tangled program graph; do not edit.", env!("CARGO_PKG_VERSION")),
        format!("Options: --lang {name} --prefix {}{style}{scalar}", options.prefix),
        format!("Graph SHA-256: {}", program.graph_sha256()),
        format!(
            "{}{walk}, {}, {}, {}.",
            counted(module.teams.len(), "team"),
            counted(module.edges(), "edge"),
            counted(module.bidders.len(), "program"),
            counted(operations, "distinct operation"),
        ),
        match &program.shape {
            Shape::Integers(integers) => computes_in(integers),
            _ => format!("Computes in {} with {} maths.", graph.scalar().name(), graph.maths().name()),
        },
    ];
    if matches!(program.shape, Shape::Integers(_)) {
        return lines;
    }
    lines.insert(lines.len() - 1, at_most(program));
    let has_profile = language == Language::Rust || options.style == Style::Pure;
    if has_profile && options.profile_in(language) == Profile::ConstantTime {
        lines.extend(same_time(graph).map(str::to_owned));
        let is_open = |node: &Node| {
            use Instruction::{Atan, Quotient, Sqrt, Tanh};
            matches!(node, Node::Operation(Sqrt | Atan | Tanh | Quotient, ..))
        };
        if language == Language::Rust && graph.maths() == MathsProvider::Own && module.nodes.iter().any(is_open) {
            lines.push(
                "It is not shown that sqrt, atan, tanh and quotient take the same time for every state.".to_owned(),
            );
        }
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

/// What the policy is for, its score, and where it comes from, as far as the graph says so.
fn policy(graph: &Graph) -> String {
    let Provenance { tool, version, seed, config, scores, note } = graph.provenance();
    let named = config.as_ref().and_then(|config| config.pointer("/problem/name")?.as_str());
    // A note of the trainer names the task; one by hand is a sentence of its own.
    let problem = named.or(note.as_deref().filter(|_| tool.is_some()));
    // A policy in integers was not tested when the one in floats was.
    let scores = Some(scores).filter(|_| !graph.has_counts()).cloned().unwrap_or_default();
    let score = ["validation_score", "score"].iter().find_map(|name| scores.get(*name));
    let success = scores.get("validation_success").filter(|_| score.is_none());
    let mut about = vec![match (problem, note) {
        (Some(problem), _) => format!("A policy for {problem}"),
        (None, Some(note)) => note.trim_end_matches('.').to_owned(),
        (None, None) => "A policy".to_owned(),
    }];
    about.extend(score.map(|score| format!("score {} in validation", (score * 100.0).round() / 100.0)));
    about.extend(success.map(|success| format!("{:.1} % success in validation", 100.0 * success)));
    about.extend(tool.as_ref().map(|tool| {
        let version = version.as_ref().map_or_else(String::new, |version| format!(" {version}"));
        let seed = seed.map_or_else(String::new, |seed| format!(" with seed {seed}"));
        format!("trained by {tool}{version}{seed}")
    }));
    let line: String = about.join(", ").chars().map(|c| if c.is_control() { ' ' } else { c }).collect();
    format!("{}.", line.replace("*/", "* /").replace("/*", "/ *"))
}

/// The most that a decision takes.
fn at_most(program: &Program<'_>) -> String {
    let Cost { bids, operations, maths_calls, .. } = Cost::worst(program);
    let bids = if bids > 0 { counted(bids as usize, "bid") + " and " } else { String::new() };
    let maths = match maths_calls {
        0 => String::new(),
        calls => format!(", {calls} of them sines, cosines, logarithms or exponentials"),
    };
    format!("A decision takes at most {bids}{}{maths}.", counted(operations as usize, "operation"))
}

/// The integers that are computed in, and that it is proven to be enough.
fn computes_in(integers: &Integers) -> String {
    let wide = match integers.wide() {
        0 => String::new(),
        1 => ", of a value in 64".to_owned(),
        count => format!(", of {count} values in 64"),
    };
    format!("Computes in integers of 32 bits{wide}: no state makes any of them overflow.")
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
