//! `tpg-codegen convert`: a graph of GEGELATI as graph.json.

use super::graph::GraphArgs;
use clap::Args;
use std::path::PathBuf;
use tpg_graph::command::{CommandError, Verdict};
use tpg_graph::output;

/// Convert a graph to graph.json.
#[derive(Clone, Debug, Args)]
pub(super) struct ConvertArgs {
    #[command(flatten)]
    graph: GraphArgs,
    /// The graph.json to write; - for standard output
    #[arg(value_name = "OUT")]
    out: PathBuf,
}

impl ConvertArgs {
    pub(super) fn run(&self) -> Result<Verdict, CommandError> {
        output::write_or_print(&self.out, &self.graph.load()?.to_json())?;
        Ok(Verdict::Good)
    }
}
