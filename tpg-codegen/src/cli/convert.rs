//! `tpg-codegen convert`: a graph from one format to another.

use super::graph::GraphArgs;
use clap::Args;
use std::path::{Path, PathBuf};
use tpg_graph::Graph;
use tpg_graph::command::{CommandError, Verdict};
use tpg_graph::error::{InputError, Place};
use tpg_graph::{export, output};

/// Convert a graph to graph.json, or to a GEGELATI .dot file and its sidecar.
#[derive(Clone, Debug, Args)]
pub(super) struct ConvertArgs {
    #[command(flatten)]
    graph: GraphArgs,
    /// The file to write: NAME.json, or NAME.dot and with it NAME.toml, the sidecar that says what a .dot file does not;
    /// - for graph.json on standard output
    #[arg(value_name = "OUT")]
    out: PathBuf,
}

impl ConvertArgs {
    pub(super) fn run(&self) -> Result<Verdict, CommandError> {
        let extension = self.out.extension().and_then(|extension| extension.to_str());
        match extension {
            Some("dot") => self.write_dot(&self.graph.load()?)?,
            _ if extension == Some("json") || self.out == Path::new("-") => {
                output::write_or_print(&self.out, &self.graph.load()?.to_json())?;
            }
            _ => {
                let found = "an output whose name does not say its format";
                let accepted = "NAME.json, NAME.dot, or -";
                return Err(InputError::new(self.out.display().to_string(), Place::Whole, found, accepted).into());
            }
        }
        Ok(Verdict::Good)
    }

    fn write_dot(&self, graph: &Graph) -> Result<(), InputError> {
        let text = export::dot::text(graph).map_err(|found| {
            InputError::new(self.out.display().to_string(), Place::Whole, found.to_string(), "NAME.json, or -")
        })?;
        let sidecar = self.out.with_extension("toml");
        output::write_all(&[(&self.out, text), (&sidecar, export::sidecar::text(graph))])?;
        eprintln!("{} needs --sidecar {} to be read", self.out.display(), sidecar.display());
        Ok(())
    }
}
