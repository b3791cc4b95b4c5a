//! Options that several commands share: a graph, and the numbers that its code computes in.

use super::graph::GraphArgs;
use crate::quantise::{Request, quantise};
use clap::Args;
use std::path::PathBuf;
use tpg_graph::command::note;
use tpg_graph::conversion::{self, Conversion};
use tpg_graph::error::{InputError, Place};
use tpg_graph::states::StateSet;
use tpg_graph::{Graph, ScalarType};

/// Number of states for measurements if none are recorded.
const STATES: usize = 20_000;
/// Their seed.
const SEED: u64 = 1;

/// A graph, and the numbers that its code computes in.
#[derive(Clone, Debug, Args)]
pub(super) struct NumbersArgs {
    #[command(flatten)]
    pub(super) graph: GraphArgs,
    /// First convert the graph to integers, with inputs and weights of BITS bits: see `tpg-codegen quantise`
    #[arg(long, value_name = "BITS", value_parser = clap::value_parser!(u32).range(2..=16), conflicts_with = "scalar")]
    fixed: Option<u32>,
    /// Compute in another scalar type than the graph's; f32 implies own maths. The agreement of actions is measured and
    /// written into the generated files
    #[arg(long, value_name = "TYPE")]
    scalar: Option<ScalarType>,
    /// Recorded states: CSV with a column for every value of the state, named as in target[0]. Agreement is
    /// measured over them [default: 20000 states sampled in the declared ranges]
    #[arg(long, value_name = "FILE")]
    trace: Option<PathBuf>,
}

/// A graph in the requested scalar type.
pub(super) struct Chosen {
    pub(super) graph: Graph,
    pub(super) conversion: Option<Conversion>,
    /// The graph in integers, if it is asked for.
    pub(super) whole: Option<Graph>,
}

impl NumbersArgs {
    /// Reads the graph and converts it as requested; a note says how good integers are.
    pub(super) fn load(&self) -> Result<Chosen, InputError> {
        if self.trace.is_some() && self.scalar.is_none() && self.fixed.is_none() {
            return Err(InputError::new("--trace", Place::Whole, "no conversion", "it with --scalar or --fixed"));
        }
        let (file, graph) = (self.graph.name(), self.graph.load()?);
        let states = || match &self.trace {
            Some(path) => StateSet::recorded(&graph, path),
            None => Ok(StateSet::sampled(&graph, STATES, SEED)),
        };
        if let Some(bits) = self.fixed {
            let (whole, report) = quantise(&file, &graph, &Request::of_bits(bits, &states()?))?;
            note(report.to_string().trim_end());
            return Ok(Chosen { graph, conversion: None, whole: Some(whole) });
        }
        match self.scalar.filter(|&scalar| scalar != graph.scalar()) {
            Some(scalar) => {
                let (graph, conversion) = conversion::convert(&graph, scalar, &file, &states()?)?;
                Ok(Chosen { graph, conversion: Some(conversion), whole: None })
            }
            None => Ok(Chosen { graph, conversion: None, whole: None }),
        }
    }
}
