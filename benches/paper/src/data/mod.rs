//! The recorded files: starts and targets, end states, step traces, reference poses.
//!
//! Columns are found by name because some files lack some of them.

mod table;

use super::episode::EndState;
use std::collections::{BTreeMap, BTreeSet};
use std::path::Path;
use table::{Column, Row, Table};
use tpg_arm::kinematics::Vector;
use tpg_arm::{Collision, Pose};
use tpg_graph::error::InputError;

/// The task of an episode.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Task {
    /// Start of the arm.
    pub start: Pose,
    /// Target of the hand, mm.
    pub target: Vector<f64>,
}

/// End of an episode.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct End {
    /// Recorded end state.
    pub state: EndState,
    /// Number of actions chosen by the TPG; `None` if the artifact has no such column.
    pub tpg_actions: Option<u32>,
}

/// A recorded hand position and collision result.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct ReferencePose {
    /// The pose.
    pub pose: Pose,
    /// Position of the hand, mm.
    pub hand: Vector<f64>,
    /// Collision in that pose.
    pub collision: Option<Collision>,
}

/// Values by row number.
pub type ByRow<T> = BTreeMap<u32, T>;

const POSITIONS: [&str; 4] = ["m0", "m1", "m2", "m3"];
const ANY_POSITION: std::ops::RangeInclusive<i16> = 0..=4095;
/// Far more than any recorded value, and a bound to name in error messages.
const ANY_LENGTH: std::ops::RangeInclusive<f64> = -1e6..=1e6;
const ANY_COUNT: std::ops::RangeInclusive<i64> = -1_000_000_000..=1_000_000_000;
const ANY_ROW: std::ops::RangeInclusive<u32> = 0..=u32::MAX;
const ANY_ACTIONS: std::ops::RangeInclusive<u32> = 1..=1_000_000;

/// Reads starts and targets.
///
/// # Errors
/// Any error in the file, with its line.
pub fn tasks(path: &Path) -> Result<ByRow<Task>, InputError> {
    let table = Table::read(path)?;
    let row = table.column("row")?;
    let positions = columns(&table, POSITIONS)?;
    let target = columns(&table, ["tx", "ty", "tz"])?;
    by_row(&table, row, |line| Ok(Task { start: pose(line, positions)?, target: point(line, target)? }))
}

/// Columns of an end state.
struct EndColumns {
    row: Column,
    score: Column,
    distance: Column,
    success: Column,
    collision: Column,
    actions: Column,
    tpg_actions: Option<Column>,
}

impl EndColumns {
    fn new(table: &Table) -> Result<Self, InputError> {
        let [row, score, distance] = columns(table, ["row", "score_x1000", "distance_um"])?;
        let [success, collision, actions] = columns(table, ["success", "collision", "nb_actions"])?;
        let tpg_actions = table.column_if_there("nb_tpg_actions")?;
        Ok(Self { row, score, distance, success, collision, actions, tpg_actions })
    }

    fn read(&self, line: Row<'_>, tasks: &ByRow<Task>) -> Result<End, InputError> {
        known(line, self.row, tasks)?;
        let state = EndState {
            score_x1000: line.number(self.score, ANY_COUNT)?,
            distance_um: line.number(self.distance, ANY_COUNT)?,
            success: line.flag(self.success)?,
            collision: line.flag(self.collision)?,
            actions: line.number(self.actions, ANY_ACTIONS)?,
        };
        let tpg_actions = self.tpg_actions.map(|column| line.number(column, 0..=*ANY_ACTIONS.end())).transpose()?;
        Ok(End { state, tpg_actions })
    }
}

/// Reads end states, each for a row of `tasks`.
///
/// # Errors
/// Any error in the file, with its line.
pub fn ends(path: &Path, tasks: &ByRow<Task>) -> Result<ByRow<End>, InputError> {
    let table = Table::read(path)?;
    let columns = EndColumns::new(&table)?;
    by_row(&table, columns.row, |line| columns.read(line, tasks))
}

/// End of a hybrid's episode.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct HybridEnd {
    /// Number of the recorded graph.
    pub tpg_seed: u32,
    /// Number of the recorded actor.
    pub sac_seed: u32,
    /// `sepDistance`, mm; infinite if it was disabled (10,000 in the file).
    pub separation_mm: f64,
    /// `nbItGoBackTPG`.
    pub hand_back_after: u32,
    /// Row of the task.
    pub row: u32,
    /// End of the episode.
    pub end: End,
}

/// The artifact's value for a separation that never causes a hand-over, mm.
const NO_SEPARATION: f64 = 10_000.0;

/// Reads end states of hybrids, each for a row of `tasks`.
///
/// # Errors
/// Any error in the file, with its line.
pub fn hybrid_ends(path: &Path, tasks: &ByRow<Task>) -> Result<Vec<HybridEnd>, InputError> {
    let table = Table::read(path)?;
    let [tpg_seed, sac_seed, separation, hand_back] = columns(&table, ["tpg_seed", "sac_seed", "sep_mm", "nb_it"])?;
    let ends = EndColumns::new(&table)?;
    table.column("nb_tpg_actions")?;
    let read = |line: Row<'_>| {
        let separation_mm: f64 = line.number(separation, 0.0..=NO_SEPARATION)?;
        Ok(HybridEnd {
            tpg_seed: line.number(tpg_seed, ANY_ROW)?,
            sac_seed: line.number(sac_seed, ANY_ROW)?,
            separation_mm: if separation_mm == NO_SEPARATION { f64::INFINITY } else { separation_mm },
            hand_back_after: line.number(hand_back, ANY_ACTIONS)?,
            row: line.number(ends.row, ANY_ROW)?,
            end: ends.read(line, tasks)?,
        })
    };
    table.rows().map(read).collect()
}

/// Reads step traces, each for a row of `tasks`: the pose after every action, in order.
///
/// # Errors
/// Any error in the file, with its line.
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
/// Any error in the file, with its line.
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

/// Returns the row's number, which must be that of a task.
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
