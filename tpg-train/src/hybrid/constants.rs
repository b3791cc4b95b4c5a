//! `tpg-train constants`: a `hybrid.toml` as constants of a Rust crate.

use super::setting::read_file;
use std::path::PathBuf;
use tpg_graph::error::{InputError, Place};
use tpg_graph::files::write_atomically;

/// Turn a hybrid.toml into Rust constants
#[derive(Clone, Debug, clap::Args)]
pub(crate) struct ConstantsArgs {
    /// The hybrid.toml
    pub hybrid: PathBuf,
    /// The Rust file to write
    #[arg(long, value_name = "FILE")]
    pub out: PathBuf,
}

/// Writes the constants.
///
/// # Errors
/// If the file is not a `hybrid.toml`, or the output cannot be written.
pub(crate) fn constants(args: &ConstantsArgs) -> Result<(), InputError> {
    let rust = read_file(&args.hybrid)?.to_rust().map_err(|finding| {
        let file = args.hybrid.display().to_string();
        InputError::new(file, Place::Path(finding.key), finding.found, finding.accepted)
    })?;
    write_atomically(&args.out, rust.as_bytes())
}
