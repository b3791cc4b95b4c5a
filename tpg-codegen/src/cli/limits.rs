//! The limits on flash and instructions that `report` takes.

use crate::report::ShapeSize;
use clap::Args;
use tpg_graph::command::CommandError;

/// Limits on what C takes on a target.
#[derive(Clone, Debug, Args)]
pub(super) struct LimitArgs {
    /// Exit with status 1 if the C takes more flash, with the library functions that it calls; without --target, on a Cortex-M4F
    #[arg(long, value_name = "BYTES")]
    max_flash: Option<u64>,
    /// Exit with status 1 if a decision can take more instructions than this, on an AVR cycles, or has no bound
    #[arg(long, value_name = "N")]
    max_instructions: Option<u64>,
}

impl LimitArgs {
    /// Refuses C that exceeds a limit, or whose need was not found.
    pub(super) fn check(&self, size: &ShapeSize) -> Result<(), CommandError> {
        let ShapeSize { target, flash, linked_flash, instructions, unavailable, .. } = size;
        let name = target.name();
        // What is not meant to be linked has its own flash.
        let flash = linked_flash.or(flash.filter(|_| unavailable.is_none()));
        let limits = [
            ("--max-flash", self.max_flash, flash, "bytes of flash".to_owned()),
            (
                "--max-instructions",
                self.max_instructions,
                *instructions,
                format!("{} of a decision at most", target.unit()),
            ),
        ];
        for (option, limit, found, what) in limits {
            let Some(limit) = limit else { continue };
            let why = match found {
                Some(found) if found <= limit => continue,
                Some(found) => format!("{found} {what} on {name}, {} more than {option} {limit}", found - limit),
                None => {
                    let accepted =
                        "accepted are Cortex-M and RISC-V, whose machine code is analysed, and integers on an AVR";
                    let why = unavailable.as_deref().unwrap_or(accepted);
                    format!("{option} {limit} cannot be checked on {name}: {why}")
                }
            };
            return Err(CommandError::Failed(format!("refused: {why}")));
        }
        Ok(())
    }
}
