//! The limit on flash that several commands take.

use crate::emit::Code;
use crate::size::{self, Target};
use tpg_graph::command::CommandError;

/// Refuses C that takes more flash than the limit, or whose size cannot be measured.
pub(super) fn check_flash(code: &Code<'_>, target: Target, limit: u64) -> Result<(), CommandError> {
    let name = target.name();
    match size::build_c(code, target).and_then(|built| size::measure(&built.object)) {
        Ok(size) if size.flash() <= limit => Ok(()),
        Ok(size) => {
            let flash = size.flash();
            let excess = flash - limit;
            Err(CommandError::Failed(format!(
                "refused: {flash} bytes of flash on {name}, {excess} more than --max-flash {limit}"
            )))
        }
        Err(error) => {
            Err(CommandError::Failed(format!("refused: --max-flash {limit} cannot be checked on {name}: {error}")))
        }
    }
}
