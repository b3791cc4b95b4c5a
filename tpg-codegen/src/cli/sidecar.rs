//! `tpg-codegen sidecar`: an example of a sidecar.

use clap::Args;
use tpg_graph::command::{CommandError, Verdict, print};
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
        print(Sidecar::EXAMPLE).map_err(CommandError::other)?;
        Ok(Verdict::Good)
    }
}
