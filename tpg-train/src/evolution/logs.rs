//! The log of a run: one row per generation, from generation 0. It contains no times, so that equal runs have equal logs.

use super::record::Row;
use std::path::Path;
use tpg_graph::error::InputError;
use tpg_graph::files::write_atomically;

/// Writes `generations.jsonl`.
///
/// # Errors
/// If it cannot be written.
pub(crate) fn write(folder: &Path, rows: &[Row]) -> Result<(), InputError> {
    let json = |row: &Row| serde_json::to_string(row).expect("a row is plain data") + "\n";
    write_atomically(&folder.join("generations.jsonl"), rows.iter().map(json).collect::<String>().as_bytes())
}
