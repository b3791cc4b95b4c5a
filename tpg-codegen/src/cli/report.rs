//! `tpg-codegen report`: the resources that a graph's code needs.

use super::GraphArgs;
use super::flash::check_flash;
use super::scalar::{Chosen, ScalarArgs, StatesArgs};
use crate::emit::Code;
use crate::options::{Language, Options, Prefix, Profile};
use crate::program::compile;
use crate::report;
use crate::size::Target;
use clap::Args;
use tpg_graph::command::{CommandError, Verdict};

/// Report the flash, RAM, stack and operations of a graph's code, and what was removed from it.
#[derive(Clone, Debug, Args)]
pub(super) struct ReportArgs {
    #[command(flatten)]
    graph: GraphArgs,
    /// The target [default: both]
    #[arg(long, value_enum)]
    target: Option<Target>,
    #[command(flatten)]
    scalar: ScalarArgs,
    #[command(flatten)]
    states: StatesArgs,
    /// Exit with status 1 if the C of --profile takes more flash on the target (without --target, a Cortex-M4F)
    #[arg(long, value_name = "BYTES")]
    max_flash: Option<u64>,
    /// The profile that --max-flash limits
    #[arg(long, value_enum, default_value_t = Profile::Fast, requires = "max_flash")]
    profile: Profile,
    /// Print one JSON object
    #[arg(long)]
    json: bool,
}

impl ReportArgs {
    pub(super) fn run(&self) -> Result<Verdict, CommandError> {
        let Chosen { graph, conversion } = self.scalar.choose(&self.graph, self.graph.load()?, &self.states)?;
        let trace = self.states.recorded(&graph)?;
        let options = Options { conversion, trace, ..Options::new(Prefix::of_file(&self.graph.graph)) };
        let targets = self.target.map_or(Target::ALL.to_vec(), |target| vec![target]);
        let report = report::report(&graph, &options, &targets, &self.states.load(&graph)?);
        if self.json {
            println!("{}", serde_json::to_string(&report).map_err(CommandError::other)?);
        } else {
            print!("{report}");
        }
        let options = Options { profile: Some(self.profile), ..options };
        if let Some(limit) = self.max_flash {
            let code = Code::of(compile(&graph, &options, Language::C));
            check_flash(&code, self.target.unwrap_or(Target::CortexM4), limit)?;
        }
        Ok(Verdict::Good)
    }
}
