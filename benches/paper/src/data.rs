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
use tpg_graph::error::{Finding, InputError, Place};
pub use tpg_problems::arm::targets::Task;

/// A recorded end of an episode.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct End {
    /// End state.
    pub state: EndState,
    /// Number of actions chosen by the graph, if recorded.
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

/// A row of a file of end states.
#[derive(Clone, Copy, Debug, Deserialize)]
pub struct EndRow {
    /// Row of the targets file.
    pub row: u32,
    score_x1000: i64,
    distance_um: i64,
    success: u8,
    collision: u8,
    nb_actions: u32,
    nb_tpg_actions: Option<u32>,
}

#[derive(Deserialize)]
struct TraceRow {
    row: u32,
    step: usize,
    m0: i16,
    m1: i16,
    m2: i16,
    m3: i16,
}

/// Reads the starts and targets of the recorded episodes.
///
/// # Errors
/// A file that cannot be read, is no CSV, lacks a column, or has a value that cannot be.
pub fn tasks(path: &Path) -> Result<ByRow<Task>, InputError> {
    let mut tasks = ByRow::new();
    each_row(path, |TaskRow { row, m0, m1, m2, m3, tx, ty, tz }| {
        for (key, length) in [("tx", tx), ("ty", ty), ("tz", tz)] {
            Finding::range(key, length, -1e6, 1e6)?;
        }
        insert(&mut tasks, row, Task { start: pose([m0, m1, m2, m3])?, target: [tx, ty, tz] })
    })?;
    Ok(tasks)
}

impl EndRow {
    /// Returns the end.
    ///
    /// # Errors
    /// A row without a task, or a value that cannot be.
    pub fn end(&self, tasks: &ByRow<Task>) -> Result<End, Finding> {
        let &Self { row, score_x1000, distance_um, success, collision, nb_actions: actions, nb_tpg_actions } = self;
        known(row, tasks)?;
        Finding::range("success", success, 0, 1)?;
        Finding::range("collision", collision, 0, 1)?;
        Finding::range("nb_actions", actions, 1, 1_000_000)?;
        let (success, collision) = (success == 1, collision == 1);
        let state = EndState { score_x1000, distance_um, success, collision, actions };
        Ok(End { state, tpg_actions: nb_tpg_actions })
    }
}

/// Reads the recorded end states of these tasks.
///
/// # Errors
/// As [`tasks`]; a row without a task, or twice.
pub fn ends(path: &Path, tasks: &ByRow<Task>) -> Result<ByRow<End>, InputError> {
    let mut ends = ByRow::new();
    each_row(path, |row: EndRow| insert(&mut ends, row.row, row.end(tasks)?))?;
    Ok(ends)
}

/// Reads the pose after each step of the episodes of these tasks.
///
/// # Errors
/// As [`tasks`]; a row without a task, or steps that are not in order.
pub fn traces(path: &Path, tasks: &ByRow<Task>) -> Result<ByRow<Vec<Pose>>, InputError> {
    let mut traces: ByRow<Vec<Pose>> = ByRow::new();
    each_row(path, |TraceRow { row, step, m0, m1, m2, m3 }| {
        known(row, tasks)?;
        let trace = traces.entry(row).or_default();
        if step != trace.len() + 1 {
            return Err(Finding::new("step", step, format!("{}: all steps in order", trace.len() + 1)));
        }
        trace.push(pose([m0, m1, m2, m3])?);
        Ok(())
    })?;
    Ok(traces)
}

/// Passes each row of a CSV file, gzip allowed, to `take`, which says what is wrong with it.
///
/// # Errors
/// A file that cannot be read, is no CSV, or has a row that lacks a column or cannot be; a file without rows.
pub fn each_row<R: DeserializeOwned>(
    path: &Path,
    mut take: impl FnMut(R) -> Result<(), Finding>,
) -> Result<(), InputError> {
    let refuse =
        |place, found: String, accepted: String| InputError::new(path.display().to_string(), place, found, accepted);
    let mut bytes = fs::read(path).map_err(|error| InputError::io(path, &error, "a CSV file, gzip allowed"))?;
    if bytes.starts_with(&[0x1f, 0x8b]) {
        let mut text = Vec::new();
        let read = MultiGzDecoder::new(bytes.as_slice()).read_to_end(&mut text);
        read.map_err(|error| InputError::io(path, &error, "a whole gzip file"))?;
        bytes = text;
    }
    let mut reader = csv::Reader::from_reader(bytes.as_slice());
    let mut has_rows = false;
    let bad = |error: csv::Error| {
        let place = error.position().map_or(Place::Whole, |position| Place::Line(position.line() as usize));
        refuse(place, error.to_string(), "rows of numbers below a header, in UTF-8".to_owned())
    };
    let headers = reader.headers().map_err(bad)?.clone();
    for record in reader.records() {
        let record = record.map_err(bad)?;
        let place = Place::Line(record.position().map_or(0, |position| position.line() as usize));
        let row = record.deserialize(Some(&headers)).map_err(bad)?;
        take(row).map_err(|Finding { key, found, accepted }| refuse(place, format!("{key} = {found}"), accepted))?;
        has_rows = true;
    }
    if has_rows {
        return Ok(());
    }
    Err(refuse(Place::Whole, "no rows".to_owned(), "a header line and at least one row".to_owned()))
}

fn insert<T>(all: &mut ByRow<T>, row: u32, value: T) -> Result<(), Finding> {
    match all.insert(row, value) {
        None => Ok(()),
        Some(_) => Err(Finding::new("row", format!("{row} again"), "each row once")),
    }
}

fn known(row: u32, tasks: &ByRow<Task>) -> Result<(), Finding> {
    if tasks.contains_key(&row) {
        return Ok(());
    }
    Err(Finding::new("row", row, "a row of the targets file"))
}

fn pose(ticks: [i16; 4]) -> Result<Pose, Finding> {
    ticks.iter().zip(["m0", "m1", "m2", "m3"]).try_for_each(|(&ticks, key)| Finding::range(key, ticks, 0, 4095))?;
    Ok(Pose(ticks))
}
