//! `tpg-codegen report`: the resources that a graph's code needs.

use super::flash::check_flash;
use super::graph::GraphArgs;
use super::scalar::{Chosen, ScalarArgs, StatesArgs};
use crate::emit::Code;
use crate::options::{Language, Options, Prefix, Profile};
use crate::program::compile;
use crate::report;
use crate::size::Target;
use clap::Args;
use std::path::{Path, PathBuf};
use tpg_graph::command::{self, CommandError, Verdict};
use tpg_graph::output;

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
    /// Write a page with the policy as formulas and as a graph, and which inputs matter; - for standard output
    #[arg(long, value_name = "FILE", conflicts_with = "json")]
    html: Option<PathBuf>,
}

impl ReportArgs {
    pub(super) fn run(&self) -> Result<Verdict, CommandError> {
        let Chosen { graph, conversion } = self.scalar.choose(&self.graph, self.graph.load()?, &self.states)?;
        let options = Options { conversion, ..Options::new(Prefix::of_file(&self.graph.graph)) };
        let targets = self.target.map_or(Target::ALL.to_vec(), |target| vec![target]);
        let states = self.states.load(&graph)?;
        let report = report::report(&graph, &options, &targets, &states);
        if let Some(path) = &self.html {
            let name =
                self.graph.graph.file_name().map_or_else(String::new, |name| name.to_string_lossy().into_owned());
            let page = report::html::page(&name, &report, &graph, &options, &states).html();
            if path == Path::new("-") {
                command::print(page).map_err(CommandError::other)?;
            } else {
                output::write_atomically(path, page.as_bytes())?;
                command::note(format_args!("wrote {}", path.display()));
            }
        } else {
            let text = if self.json {
                serde_json::to_string(&report).map_err(CommandError::other)? + "\n"
            } else {
                report.to_string()
            };
            command::print(text).map_err(CommandError::other)?;
        }
        let options = Options { profile: Some(self.profile), ..options };
        if let Some(limit) = self.max_flash {
            let code = Code::of(compile(&graph, &options, Language::C));
            check_flash(&code, self.target.unwrap_or(Target::CortexM4), limit)?;
        }
        Ok(Verdict::Good)
    }
}
