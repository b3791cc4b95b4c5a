//! The limits on flash and instructions that `report` takes.

use crate::emit::Code;
use crate::size::{self, Target};
use clap::Args;
use tpg_graph::command::CommandError;

/// Limits on what C takes on a target.
#[derive(Clone, Debug, Args)]
pub(super) struct LimitArgs {
    /// Exit with status 1 and write no code if the C takes more flash, with the library functions that it calls; without --target, on a
    /// Cortex-M4F
    #[arg(long, value_name = "BYTES")]
    max_flash: Option<u64>,
    /// Exit with status 1 and write no code if a decision can take more instructions than this, on an AVR cycles, or has no bound
    #[arg(long, value_name = "N")]
    max_instructions: Option<u64>,
}

impl LimitArgs {
    /// True if there is a limit.
    pub(super) fn any(&self) -> bool {
        self.max_flash.is_some() || self.max_instructions.is_some()
    }

    /// Refuses C that exceeds a limit, or whose need cannot be found.
    pub(super) fn check(&self, code: &Code<'_>, target: Target) -> Result<(), CommandError> {
        let limits = [("--max-flash", self.max_flash), ("--max-instructions", self.max_instructions)];
        for (option, limit) in limits.into_iter().filter_map(|(option, limit)| Some((option, limit?))) {
            let name = target.name();
            let found = if option == "--max-flash" { flash(code, target) } else { instructions(code, target) };
            let why = match found {
                Ok((found, _)) if found <= limit => continue,
                Ok((found, what)) => {
                    format!("{found} {what} on {name}, {} more than {option} {limit}", found - limit)
                }
                Err(why) => format!("{option} {limit} cannot be checked on {name}: {why}"),
            };
            return Err(CommandError::Failed(format!("refused: {why}")));
        }
        Ok(())
    }
}

/// Returns the bytes of flash, of linked code where it can be linked.
fn flash(code: &Code<'_>, target: Target) -> Result<(u64, String), String> {
    let built = size::build_c(code, target).map_err(|error| error.to_string())?;
    let size = match built.link(code).map_err(|error| error.to_string())? {
        Some(linked) => linked.size,
        None => size::measure(&built.object).map_err(|error| error.to_string())?,
    };
    Ok((size.flash(), "bytes of flash".to_owned()))
}

/// Returns the bound of a decision.
fn instructions(code: &Code<'_>, target: Target) -> Result<(u64, String), String> {
    let built = size::build_c(code, target).map_err(|error| error.to_string())?;
    let linked = built.link(code).map_err(|error| error.to_string())?;
    let accepted = "accepted are Cortex-M and RISC-V, whose machine code is analysed, and integers on an AVR";
    let bound = linked.and_then(|linked| linked.bound).ok_or(accepted)??;
    Ok((bound.instructions, format!("{} of a decision at most", target.unit())))
}
