//! The recorded files: starts and targets, end states, step traces, reference poses.
//!
//! Columns are read by name, since not every file has all of them.

mod table;

use super::episode::EndState;
use std::collections::{BTreeMap, BTreeSet};
use std::path::Path;
use table::{Column, Row, Table};
use tpg_codegen::error::InputError;
use tpg_runtime::arm::{Collision, Pose};
use tpg_runtime::kinematics::Vector;

/// What an episode was asked to do.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Task {
    /// Where the arm starts.
    pub start: Pose,
    /// Where its hand shall go, mm.
    pub target: Vector<f64>,
}

/// How an episode ended.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct End {
    /// The recorded books.
    pub state: EndState,
    /// The actions that the TPG chose; absent where the artifact has no such column.
    pub tpg_actions: Option<u32>,
}

/// A recorded hand and collision answer.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct ReferencePose {
    /// The pose.
    pub pose: Pose,
    /// Its hand, mm.
    pub hand: Vector<f64>,
    /// What the arm hits there.
    pub collision: Option<Collision>,
}

/// Something for each row, by its number.
pub type ByRow<T> = BTreeMap<u32, T>;

const POSITIONS: [&str; 4] = ["m0", "m1", "m2", "m3"];
const ANY_POSITION: std::ops::RangeInclusive<i16> = 0..=4095;
/// Far more than anything recorded, and a bound that an error message can name.
const ANY_LENGTH: std::ops::RangeInclusive<f64> = -1e6..=1e6;
const ANY_COUNT: std::ops::RangeInclusive<i64> = -1_000_000_000..=1_000_000_000;
const ANY_ROW: std::ops::RangeInclusive<u32> = 0..=u32::MAX;
const ANY_ACTIONS: std::ops::RangeInclusive<u32> = 1..=1_000_000;

/// Reads starts and targets.
///
/// # Errors
/// What is wrong with the file, by line.
pub fn tasks(path: &Path) -> Result<ByRow<Task>, InputError> {
    let table = Table::read(path)?;
    let row = table.column("row")?;
    let positions = columns(&table, POSITIONS)?;
    let target = columns(&table, ["tx", "ty", "tz"])?;
    by_row(&table, row, |line| Ok(Task { start: pose(line, positions)?, target: point(line, target)? }))
}

/// Reads end states, each of a row among `tasks`.
///
/// # Errors
/// What is wrong with the file, by line.
pub fn ends(path: &Path, tasks: &ByRow<Task>) -> Result<ByRow<End>, InputError> {
    let table = Table::read(path)?;
    let row = table.column("row")?;
    let [score, distance] = columns(&table, ["score_x1000", "distance_um"])?;
    let [success, collision] = columns(&table, ["success", "collision"])?;
    let actions = table.column("nb_actions")?;
    let tpg_actions = table.column_if_there("nb_tpg_actions")?;
    by_row(&table, row, |line| {
        known(line, row, tasks)?;
        let state = EndState {
            score_x1000: line.number(score, ANY_COUNT)?,
            distance_um: line.number(distance, ANY_COUNT)?,
            success: line.flag(success)?,
            collision: line.flag(collision)?,
            actions: line.number(actions, ANY_ACTIONS)?,
        };
        let tpg_actions = tpg_actions.map(|column| line.number(column, 0..=*ANY_ACTIONS.end())).transpose()?;
        Ok(End { state, tpg_actions })
    })
}

/// Reads step traces, each of a row among `tasks`: the pose after every action, the first action's first.
///
/// # Errors
/// What is wrong with the file, by line.
pub fn traces(path: &Path, tasks: &ByRow<Task>) -> Result<ByRow<Vec<Pose>>, InputError> {
    let table = Table::read(path)?;
    let [row, step] = columns(&table, ["row", "step"])?;
    let positions = columns(&table, POSITIONS)?;
    let mut traces: ByRow<Vec<Pose>> = ByRow::new();
    for line in table.rows() {
        let trace = traces.entry(known(line, row, tasks)?).or_default();
        let step = line.number(step, ANY_ACTIONS)?;
        if step as usize != trace.len() + 1 {
            return Err(line.error(format!("step {step}"), format!("step {}: all steps in order", trace.len() + 1)));
        }
        trace.push(pose(line, positions)?);
    }
    Ok(traces)
}

/// Reads reference poses.
///
/// # Errors
/// What is wrong with the file, by line.
pub fn reference_poses(path: &Path) -> Result<Vec<ReferencePose>, InputError> {
    let table = Table::read(path)?;
    let positions = columns(&table, POSITIONS)?;
    let hand = columns(&table, ["x", "y", "z"])?;
    let code = table.column("collision_code")?;
    let read = |line: Row<'_>| {
        let collision = match line.number(code, 0..=3_u8)? {
            1 => Some(Collision::Table),
            2 => Some(Collision::HandCorner),
            3 => Some(Collision::Base),
            _ => None,
        };
        Ok(ReferencePose { pose: pose(line, positions)?, hand: point(line, hand)?, collision })
    };
    table.rows().map(read).collect()
}

fn by_row<'t, T>(
    table: &'t Table,
    row: Column,
    mut read: impl FnMut(Row<'t>) -> Result<T, InputError>,
) -> Result<ByRow<T>, InputError> {
    let mut seen = BTreeSet::new();
    table
        .rows()
        .map(|line| {
            let number = line.number(row, ANY_ROW)?;
            if !seen.insert(number) {
                return Err(line.error(format!("row {number} again"), "each row once"));
            }
            Ok((number, read(line)?))
        })
        .collect()
}

/// The row's number, which must be one of the tasks'.
fn known(line: Row<'_>, row: Column, tasks: &ByRow<Task>) -> Result<u32, InputError> {
    let number = line.number(row, ANY_ROW)?;
    if tasks.contains_key(&number) {
        return Ok(number);
    }
    Err(line.error(format!("row {number}"), "a row of the targets file"))
}

fn columns<const N: usize>(table: &Table, names: [&str; N]) -> Result<[Column; N], InputError> {
    let columns = names.iter().map(|name| table.column(name)).collect::<Result<Vec<_>, _>>()?;
    Ok(std::array::from_fn(|index| columns[index]))
}

fn pose(line: Row<'_>, [base, shoulder, elbow, wrist]: [Column; 4]) -> Result<Pose, InputError> {
    let position = |column| line.number(column, ANY_POSITION);
    Ok(Pose([position(base)?, position(shoulder)?, position(elbow)?, position(wrist)?]))
}

fn point(line: Row<'_>, [x, y, z]: [Column; 3]) -> Result<Vector<f64>, InputError> {
    let length = |column| line.number(column, ANY_LENGTH);
    Ok([length(x)?, length(y)?, length(z)?])
}
