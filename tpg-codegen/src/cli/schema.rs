//! `tpg-codegen schema`: the JSON Schema of graph.json.

use super::{CliError, Verdict};
use clap::Args;
use std::io::{self, Write};

/// Print the JSON Schema of graph.json.
#[derive(Clone, Debug, Args)]
pub(super) struct SchemaArgs {}

impl SchemaArgs {
    pub(super) fn run(&self) -> Result<Verdict, CliError> {
        let mut out = io::stdout().lock();
        out.write_all(tpg_graph::schema().as_bytes()).and_then(|()| out.flush()).map_err(CliError::other)?;
        Ok(Verdict::Good)
    }
}
