//! `tpg-codegen schema`: the JSON Schema of graph.json.

use clap::Args;
use tpg_graph::command::{CommandError, Verdict, print};

/// Print the JSON Schema of graph.json.
#[derive(Clone, Debug, Args)]
pub(super) struct SchemaArgs {}

impl SchemaArgs {
    pub(super) fn run(&self) -> Result<Verdict, CommandError> {
        print(tpg_graph::schema()).map_err(CommandError::other)?;
        Ok(Verdict::Good)
    }
}
