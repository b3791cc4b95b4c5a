//! The logs of a run: one row per generation, from generation 0. They contain no times, so that equal runs have equal
//! logs; times go to a separate file.

use super::record::Row;
use crate::csv_text::{optional, table};
use std::fs;
use std::path::Path;
use tpg_engine::Summary;
use tpg_graph::error::InputError;
use tpg_graph::files::write_atomically;

/// Writes `generations.csv` and `generations.jsonl`.
///
/// # Errors
/// If they cannot be written.
pub(crate) fn write(folder: &Path, rows: &[Row]) -> Result<(), InputError> {
    const HEADER: [&str; 12] = [
        "generation",
        "steps",
        "best_score",
        "median_score",
        "best_success",
        "best_measure",
        "roots",
        "teams",
        "programs",
        "validation_score",
        "validation_success",
        "validation_measure",
    ];
    let fields = |row: &Row| {
        let validation = |value: fn(&Summary) -> f64| optional(row.validation.as_ref().map(value));
        [
            row.generation.to_string(),
            row.steps.to_string(),
            row.best_score.to_string(),
            row.median_score.to_string(),
            optional(row.best_success),
            row.best_measure.to_string(),
            row.roots.to_string(),
            row.teams.to_string(),
            row.programs.to_string(),
            validation(|result| result.score),
            optional(row.validation.and_then(|result| result.success)),
            validation(|result| result.measure),
        ]
    };
    let json = |row: &Row| serde_json::to_string(row).expect("a row is plain data") + "\n";
    write_atomically(&folder.join("generations.csv"), &table(HEADER, rows.iter().map(fields)))?;
    let json: String = rows.iter().map(json).collect();
    write_atomically(&folder.join("generations.jsonl"), json.as_bytes())
}

/// Returns the CPU time so far, in seconds, of this process and its finished children, if the system reports it
/// (Linux).
pub(crate) fn cpu_seconds() -> Option<f64> {
    let stat = fs::read_to_string("/proc/self/stat").ok()?;
    // Fields 14 to 17, in ticks of 1/100 s; the second field, in brackets, may contain spaces.
    let fields = stat.rsplit_once(')')?.1.split_whitespace().skip(11).take(4);
    let ticks: Option<Vec<u64>> = fields.map(|field| field.parse().ok()).collect();
    Some(ticks?.iter().sum::<u64>() as f64 / 100.0)
}
