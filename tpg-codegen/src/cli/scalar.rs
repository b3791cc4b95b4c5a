//! Options that several commands share: the scalar type, and the states for measurements.

use super::graph::GraphArgs;
use crate::quantise::{Request, quantise};
use clap::Args;
use std::path::PathBuf;
use tpg_graph::command::{CommandError, note};
use tpg_graph::conversion::{self, Conversion};
use tpg_graph::error::InputError;
use tpg_graph::states::StateSet;
use tpg_graph::{Graph, ScalarType};

/// Number of states for measurements if none are recorded.
const STATES: usize = 20_000;
/// Their seed.
const SEED: u64 = 1;

/// The states for measurements.
#[derive(Clone, Debug, Args)]
pub(super) struct StatesArgs {
    /// Recorded states: CSV with a column for every value of the state, named as in target[0]. Agreement is
    /// measured over them [default: 20000 states sampled in the declared ranges]
    #[arg(long, value_name = "FILE")]
    trace: Option<PathBuf>,
}

impl StatesArgs {
    pub(super) fn load(&self, graph: &Graph) -> Result<StateSet, InputError> {
        match &self.trace {
            Some(path) => StateSet::recorded(graph, path),
            None => Ok(StateSet::sampled(graph, STATES, SEED)),
        }
    }
}

/// Integers for the graph.
#[derive(Clone, Debug, Args)]
pub(super) struct FixedArgs {
    /// First convert the graph to integers, with inputs and weights of BITS bits: see `tpg-codegen quantise`
    #[arg(long = "fixed", id = "fixed", value_name = "BITS", value_parser = clap::value_parser!(u32).range(2..=16), conflicts_with = "scalar")]
    bits: Option<u32>,
}

impl FixedArgs {
    /// Returns the graph in integers, if it is asked for; a note says how good it is.
    pub(super) fn integers(
        &self,
        args: &GraphArgs,
        graph: &Graph,
        states: &StatesArgs,
    ) -> Result<Option<Graph>, InputError> {
        let Some(bits) = self.bits else { return Ok(None) };
        let compared = states.load(graph)?;
        let request = Request::of_bits(bits, &compared, states.trace.is_some());
        let (whole, report) = quantise(&args.name(), graph, &request)?;
        note(report.to_string().trim_end());
        Ok(Some(whole))
    }
}

/// The scalar type that code computes in.
#[derive(Clone, Debug, Args)]
pub(super) struct ScalarArgs {
    /// Compute in another scalar type than the graph's; f32 implies own maths. The agreement of actions is measured and
    /// written into the generated files
    #[arg(long, value_name = "TYPE")]
    scalar: Option<ScalarType>,
    /// Exit with status 1 if fewer actions agree, in per cent
    #[arg(long, value_name = "PERCENT", value_parser = percent)]
    require_agreement: Option<f64>,
}

/// A graph in the requested scalar type.
pub(super) struct Chosen {
    pub(super) graph: Graph,
    pub(super) conversion: Option<Conversion>,
}

impl ScalarArgs {
    /// Converts the graph if another type is requested; fails if too few actions agree.
    pub(super) fn choose(&self, args: &GraphArgs, graph: Graph, states: &StatesArgs) -> Result<Chosen, CommandError> {
        let Some(scalar) = self.scalar.filter(|&scalar| scalar != graph.scalar()) else {
            return Ok(Chosen { graph, conversion: None });
        };
        let file = args.graph.display().to_string();
        let (graph, conversion) = conversion::convert(&graph, scalar, &file, &states.load(&graph)?)?;
        let agreement = &conversion.agreement;
        if let Some(percent) = self.require_agreement.filter(|&percent| !agreement.reaches(percent)) {
            let refused = format!("refused: {file} in {}: {agreement}; --require-agreement {percent} %", scalar.name());
            return Err(CommandError::Failed(refused));
        }
        Ok(Chosen { graph, conversion: Some(conversion) })
    }
}

fn percent(text: &str) -> Result<f64, String> {
    let number = text.parse().ok().filter(|percent| (0.0..=100.0).contains(percent));
    number.ok_or_else(|| "accepted: a number from 0 to 100".to_owned())
}
