//! `tpg-codegen schema`: the JSON Schema of graph.json.

use clap::Args;
use std::io::{self, Write};
use tpg_graph::command::{CommandError, Verdict};

/// Print the JSON Schema of graph.json.
#[derive(Clone, Debug, Args)]
pub(super) struct SchemaArgs {}

impl SchemaArgs {
    pub(super) fn run(&self) -> Result<Verdict, CommandError> {
        let mut out = io::stdout().lock();
        out.write_all(tpg_graph::schema().as_bytes()).and_then(|()| out.flush()).map_err(CommandError::other)?;
        Ok(Verdict::Good)
    }
}
