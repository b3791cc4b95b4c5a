//! `tpg-codegen verify`: interpreter = C = Rust, state by state.

use super::{CliError, GraphArgs, Verdict};
use crate::emit::{Options, Prefix, Profile, Style};
use crate::verify::{self, Comparison, Workshop};
use clap::Args;
use tpg_graph::Graph;
use tpg_graph::engine::Engine;

/// Compile the generated code and compare it with the interpreter.
#[derive(Clone, Debug, Args)]
pub(super) struct VerifyArgs {
    #[command(flatten)]
    graph: GraphArgs,
    /// How many states to compare: in the declared ranges, on their ends, and beyond, with NaN, infinities and denormals
    #[arg(long, default_value_t = 100_000, value_name = "N")]
    states: usize,
    /// The seed the states are drawn with
    #[arg(long, default_value_t = 1, value_name = "S")]
    seed: u64,
    /// Print one JSON object
    #[arg(long)]
    json: bool,
}

impl VerifyArgs {
    pub(super) fn run(&self) -> Result<Verdict, CliError> {
        let graph = self.graph.load()?;
        let prefix = Prefix::of_file(&self.graph.graph);
        let comparisons = compare(&graph, &prefix, self.states, self.seed)?;
        if self.json {
            let report = serde_json::json!({ "graph_sha256": graph.sha256(), "comparisons": comparisons });
            println!("{report}");
        } else {
            comparisons.iter().for_each(|comparison| println!("{}", sentence(comparison)));
        }
        let equal = comparisons.iter().all(|comparison| comparison.differences == 0);
        Ok(if equal { Verdict::Good } else { Verdict::Failed })
    }
}

/// Everything that can be generated from a graph, against the interpreter.
pub(super) fn compare(graph: &Graph, prefix: &Prefix, states: usize, seed: u64) -> Result<Vec<Comparison>, CliError> {
    let workshop = Workshop::new().map_err(CliError::other)?;
    let options = Options::new(prefix.clone());
    let gegelati = Options { style: Style::Gegelati, ..options.clone() };
    let mut programs = vec![workshop.c(graph, &gegelati).map_err(CliError::other)?];
    for profile in Profile::ALL {
        let options = Options { profile: Some(profile), ..options.clone() };
        programs.push(workshop.c(graph, &options).map_err(CliError::other)?);
        programs.push(workshop.rust(graph, &options).map_err(CliError::other)?);
    }
    let mut engines: Vec<&mut dyn Engine> = programs.iter_mut().map(|program| program as &mut dyn Engine).collect();
    verify::compare(graph, &mut engines, states, seed).map_err(CliError::other)
}

/// What a comparison found, for people.
pub(super) fn sentence(comparison: &Comparison) -> String {
    let Comparison { engine, states, differences, first } = comparison;
    match first {
        None => format!("{engine} = interpreter on {states} states"),
        Some(first) => format!(
            "{engine} differs from the interpreter on {differences} of {states} states; the first, number {}: action {} \
             instead of {} for [{}]",
            first.index,
            first.found,
            first.expected,
            first.state.join(", ")
        ),
    }
}
