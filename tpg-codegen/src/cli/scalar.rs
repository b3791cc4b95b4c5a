//! Options that several commands share: the scalar type, and the states to measure over.

use super::{CliError, GraphArgs};
use clap::Args;
use std::path::PathBuf;
use tpg_graph::conversion::{self, Conversion};
use tpg_graph::error::InputError;
use tpg_graph::states::StateSet;
use tpg_graph::{Graph, ScalarType};

/// States that are measured over where none are recorded.
const STATES: usize = 20_000;
/// The seed they are drawn with.
const SEED: u64 = 1;

/// The states that a policy is measured over.
#[derive(Clone, Debug, Args)]
pub(super) struct StatesArgs {
    /// Recorded states: CSV with a column for every value of the state, named as in target[0]. Agreement and means are
    /// measured over them, and the profile fast looks first at the bids that win most often along them [default: 20000
    /// states sampled in the declared ranges, and no such order]
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

    /// Only what was recorded.
    pub(super) fn recorded(&self, graph: &Graph) -> Result<Option<StateSet>, InputError> {
        self.trace.as_ref().map(|path| StateSet::recorded(graph, path)).transpose()
    }
}

/// The scalar type that code computes in.
#[derive(Clone, Debug, Args)]
pub(super) struct ScalarArgs {
    /// Compute in another type than the graph says; f32 comes with own maths. How often the actions agree is measured and
    /// written into what is generated
    #[arg(long, value_name = "TYPE")]
    scalar: Option<ScalarType>,
    /// Refuse, with exit status 1, where fewer actions than that agree, in per cent
    #[arg(long, value_name = "PERCENT", value_parser = percent)]
    require_agreement: Option<f64>,
}

/// A graph in the type that was asked for.
pub(super) struct Chosen {
    pub(super) graph: Graph,
    pub(super) conversion: Option<Conversion>,
}

impl ScalarArgs {
    /// Converts the graph where another type is asked for, and refuses where too few actions agree.
    pub(super) fn choose(&self, args: &GraphArgs, graph: Graph, states: &StatesArgs) -> Result<Chosen, CliError> {
        let Some(scalar) = self.scalar.filter(|&scalar| scalar != graph.scalar()) else {
            return Ok(Chosen { graph, conversion: None });
        };
        let file = args.graph.display().to_string();
        let (graph, conversion) = conversion::convert(&graph, scalar, &file, &states.load(&graph)?)?;
        let agreement = &conversion.agreement;
        if let Some(percent) = self.require_agreement.filter(|&percent| !agreement.reaches(percent)) {
            let refused = format!("refused: {file} in {}: {agreement}; --require-agreement {percent} %", scalar.name());
            return Err(CliError::Failed(refused));
        }
        Ok(Chosen { graph, conversion: Some(conversion) })
    }
}

fn percent(text: &str) -> Result<f64, String> {
    let number = text.parse().ok().filter(|percent| (0.0..=100.0).contains(percent));
    number.ok_or_else(|| "accepted: a number from 0 to 100".to_owned())
}
