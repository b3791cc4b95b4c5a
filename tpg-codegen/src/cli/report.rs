//! `tpg-codegen report`: the resources that a graph's code needs.

use super::limits::LimitArgs;
use super::numbers::{Chosen, NumbersArgs};
use crate::options::{Options, Prefix, Profile};
use crate::report;
use crate::size::Target;
use clap::Args;
use tpg_graph::command::{self, CommandError, Verdict};

/// Report the flash, RAM, stack and operations of a graph's code.
#[derive(Clone, Debug, Args)]
pub(super) struct ReportArgs {
    #[command(flatten)]
    numbers: NumbersArgs,
    /// Comma-separated targets [default: m4f,host]
    #[arg(long, value_enum, value_delimiter = ',')]
    target: Vec<Target>,
    #[command(flatten)]
    limits: LimitArgs,
    /// The profile that the limits apply to; with --fixed, its integer version
    #[arg(long, value_enum, default_value_t = Profile::Fast)]
    profile: Profile,
    /// Print one JSON object
    #[arg(long)]
    json: bool,
}

impl ReportArgs {
    pub(super) fn run(&self) -> Result<Verdict, CommandError> {
        let Chosen { graph, conversion, whole } = self.numbers.load()?;
        let options = Options { conversion, ..Options::new(Prefix::of_file(&self.numbers.graph.graph)) };
        let targets = if self.target.is_empty() { &Target::DEFAULT[..] } else { &self.target };
        let report = report::report(&self.numbers.graph.name(), &graph, &options, targets, whole.as_ref())?;
        let text = if self.json {
            serde_json::to_string(&report).map_err(CommandError::other)? + "\n"
        } else {
            report.to_string()
        };
        command::print(text)?;
        let limited = if self.target.is_empty() { &[Target::M4f][..] } else { &self.target };
        let profile = match self.profile {
            Profile::Small if whole.is_some() || graph.has_counts() => "integers, small",
            _ if whole.is_some() || graph.has_counts() => "integers",
            profile => profile.name(),
        };
        let mut rows = report.sizes.iter().filter(|size| limited.contains(&size.target) && size.profile == profile);
        rows.try_for_each(|size| self.limits.check(size))?;
        Ok(Verdict::Good)
    }
}
