//! `tpg-codegen sidecar`: an example of a sidecar.

use clap::Args;
use std::io::{self, Write};
use tpg_graph::command::{CommandError, Verdict};
use tpg_graph::import::Sidecar;

/// Print an example of a sidecar, the description that a .dot file lacks, with a comment on each field.
#[derive(Clone, Debug, Args)]
pub(super) struct SidecarArgs {
    /// Print the example
    #[arg(long, required = true)]
    example: bool,
}

impl SidecarArgs {
    pub(super) fn run(&self) -> Result<Verdict, CommandError> {
        debug_assert!(self.example, "clap requires it");
        let mut out = io::stdout().lock();
        out.write_all(Sidecar::EXAMPLE.as_bytes()).and_then(|()| out.flush()).map_err(CommandError::other)?;
        Ok(Verdict::Good)
    }
}
