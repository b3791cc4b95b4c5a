//! `tpg-codegen convert`: a graph from one format to another.

use super::graph::GraphArgs;
use clap::Args;
use std::path::{Path, PathBuf};
use tpg_graph::Graph;
use tpg_graph::command::{CommandError, Verdict, print};
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
        let format = Format::detect(&self.out)?;
        let graph = self.graph.load()?;
        match format {
            Format::Stdout => {
                print(graph.to_json()).map_err(CommandError::other)?;
            }
            Format::Json => output::write_atomically(&self.out, graph.to_json().as_bytes())?,
            Format::Dot => self.write_dot(&graph)?,
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

/// The output format.
#[derive(Clone, Copy)]
enum Format {
    Stdout,
    Json,
    Dot,
}

impl Format {
    fn detect(out: &Path) -> Result<Self, InputError> {
        if out == Path::new("-") {
            return Ok(Self::Stdout);
        }
        match out.extension().and_then(|extension| extension.to_str()) {
            Some("json") => Ok(Self::Json),
            Some("dot") => Ok(Self::Dot),
            _ => {
                let found = "an output whose name does not say its format";
                Err(InputError::new(out.display().to_string(), Place::Whole, found, "NAME.json, NAME.dot, or -"))
            }
        }
    }
}
