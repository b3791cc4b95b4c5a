//! The graph that a command reads.

use clap::Args;
use std::path::PathBuf;
use tpg_graph::error::InputError;
use tpg_graph::{Graph, import};

/// The graph to read, and the description that a `.dot` file lacks.
#[derive(Clone, Debug, Args)]
pub(crate) struct GraphArgs {
    /// A graph.json or a GEGELATI .dot file; - for standard input
    pub graph: PathBuf,
    /// A built-in description of the data that a .dot file lacks
    #[arg(long, value_name = "NAME", conflicts_with = "sidecar")]
    pub profile_of: Option<import::Profile>,
    /// A TOML file with the data that a .dot file lacks
    #[arg(long, value_name = "FILE")]
    pub sidecar: Option<PathBuf>,
}

impl GraphArgs {
    /// Returns the graph's name in messages.
    pub(crate) fn name(&self) -> String {
        self.graph.display().to_string()
    }

    /// Reads and validates the graph.
    ///
    /// # Errors
    /// The first defect of the input.
    pub(crate) fn load(&self) -> Result<Graph, InputError> {
        import::load(&self.graph, self.profile_of, self.sidecar.as_deref())
    }
}
