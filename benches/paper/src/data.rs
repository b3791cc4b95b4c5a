//! The recorded files: starts and targets, end states, step traces.
//!
//! Columns are found by name because some files lack some of them.

use super::episode::EndState;
use flate2::read::MultiGzDecoder;
use serde::Deserialize;
use serde::de::DeserializeOwned;
use std::collections::BTreeMap;
use std::fs;
use std::io::Read;
use std::path::Path;
use tpg_arm::Pose;
use tpg_graph::error::{InputError, Place};
pub use tpg_problems::arm::targets::Task;

/// A recorded end of an episode.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Deserialize)]
pub struct End {
    /// Row of the targets file.
    pub row: u32,
    /// End state.
    #[serde(flatten)]
    pub state: EndState,
    /// Number of actions chosen by the graph, if recorded.
    #[serde(rename = "nb_tpg_actions")]
    pub tpg_actions: Option<u32>,
}

/// Data of each row of the targets file, by row number.
pub type ByRow<T> = BTreeMap<u32, T>;

#[derive(Deserialize)]
struct TaskRow {
    row: u32,
    m0: i16,
    m1: i16,
    m2: i16,
    m3: i16,
    tx: f64,
    ty: f64,
    tz: f64,
}

/// Reads the starts and targets of the recorded episodes.
///
/// # Errors
/// As [`rows`].
pub fn tasks(path: &Path) -> Result<ByRow<Task>, InputError> {
    let task = |TaskRow { row, m0, m1, m2, m3, tx, ty, tz }| {
        (row, Task { start: Pose([m0, m1, m2, m3]), target: [tx, ty, tz] })
    };
    Ok(rows(path)?.into_iter().map(task).collect())
}

/// Reads the recorded end states.
///
/// # Errors
/// As [`rows`].
pub fn ends(path: &Path) -> Result<ByRow<End>, InputError> {
    Ok(rows(path)?.into_iter().map(|end: End| (end.row, end)).collect())
}

/// Reads the rows of a CSV file, gzip allowed.
///
/// # Errors
/// A file that cannot be read, is no CSV, or has a row that lacks a column.
pub fn rows<R: DeserializeOwned>(path: &Path) -> Result<Vec<R>, InputError> {
    let accepted = "a CSV file, gzip allowed";
    let mut bytes = fs::read(path).map_err(|error| InputError::io(path, &error, accepted))?;
    if bytes.starts_with(&[0x1f, 0x8b]) {
        let mut text = Vec::new();
        let read = MultiGzDecoder::new(bytes.as_slice()).read_to_end(&mut text);
        read.map_err(|error| InputError::io(path, &error, accepted))?;
        bytes = text;
    }
    let rows = csv::Reader::from_reader(bytes.as_slice()).into_deserialize().collect::<Result<_, _>>();
    rows.map_err(|error| InputError::new(path.display().to_string(), Place::Whole, error.to_string(), accepted))
}
