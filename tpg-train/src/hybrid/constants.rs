//! `tpg-train constants`: a `hybrid.toml` as constants of a Rust crate.

use super::{arm, setting};
use crate::files::{read_text, write_atomically};
use std::path::PathBuf;
use tpg_graph::error::{InputError, Place};
use tpg_graph::settings;

/// Turn a hybrid.toml into Rust constants
#[derive(Clone, Debug, clap::Args)]
pub struct ConstantsArgs {
    /// The hybrid.toml
    pub hybrid: PathBuf,
    /// The Rust file to write
    #[arg(long, value_name = "FILE")]
    pub out: PathBuf,
}

/// Writes the constants. The arm's file has a guard, any other a problem.
///
/// # Errors
/// If the file is not a `hybrid.toml`, or the output cannot be written.
pub fn constants(args: &ConstantsArgs) -> Result<(), InputError> {
    let name = args.hybrid.display().to_string();
    let text = read_text(&args.hybrid, "a hybrid.toml")?;
    let table: toml::Table = settings::from_toml(&name, &text, "a hybrid.toml")?;
    let rust = if table.contains_key("problem") {
        setting::read_file(&args.hybrid)?.to_rust()
    } else {
        let rust = arm::setting::HybridFile::read(&args.hybrid)?.to_rust();
        rust.map_err(|finding| InputError::new(name, Place::Path(finding.key), finding.found, finding.accepted))?
    };
    write_atomically(&args.out, rust.as_bytes())
}
