//! Lists of tasks as CSV files.

use super::Task;
use csv::{Reader, ReaderBuilder, StringRecord, Trim, Writer};
use std::fs;
use std::path::Path;
use tpg_arm::{Arm, JOINTS, Pose};
use tpg_graph::error::{InputError, Place};

const HEADER: [&str; JOINTS + 3] =
    ["start_base", "start_shoulder", "start_elbow", "start_wrist", "target_x_mm", "target_y_mm", "target_z_mm"];

/// Header of the paper's recorded targets: the same columns after a row number.
const RECORDED_HEADER: [&str; JOINTS + 4] = ["row", "m0", "m1", "m2", "m3", "tx", "ty", "tz"];

/// Writes tasks as CSV: a header, then start (ticks) and target (mm, the shortest digits that give the same number).
///
/// # Panics
/// Never: memory can be written.
pub fn to_csv(tasks: &[Task]) -> String {
    let mut writer = Writer::from_writer(Vec::new());
    writer.write_record(HEADER).expect("memory can be written");
    for task in tasks {
        let start = task.start.0.iter().map(ToString::to_string);
        let target = task.target.iter().map(ToString::to_string);
        writer.write_record(start.chain(target)).expect("memory can be written");
    }
    String::from_utf8(writer.into_inner().expect("memory can be written")).expect("numbers are text")
}

/// Reads a file that [`to_csv`] wrote, or the paper's recorded targets.
///
/// # Errors
/// If the file cannot be read, has a different header, or contains a value that is not a number in the arm's range.
pub fn read_csv(arm: &Arm<f64>, path: &Path) -> Result<Vec<Task>, InputError> {
    let text = fs::read_to_string(path).map_err(|error| InputError::io(path, &error, "a file of episodes"))?;
    parse_csv(arm, &path.display().to_string(), &text)
}

/// Reads the text of such a file; `file` is its name, for messages.
///
/// # Errors
/// If it has a different header, or contains a value that is not a number in the arm's range.
pub fn parse_csv(arm: &Arm<f64>, file: &str, text: &str) -> Result<Vec<Task>, InputError> {
    let mut reader = ReaderBuilder::new().trim(Trim::All).flexible(true).from_reader(text.as_bytes());
    let first = first_column(file, &mut reader)?;
    let row = |record: Result<StringRecord, csv::Error>| {
        let record = record.map_err(|error| unreadable(file, &error))?;
        let line = record.position().map_or(0, csv::Position::line) as usize;
        task(arm, &record, first, &|found, accepted| InputError::new(file, Place::Line(line), found, accepted))
    };
    reader.records().map(row).collect()
}

/// Returns the index of the first column that belongs to a task, according to the header.
fn first_column(file: &str, reader: &mut Reader<&[u8]>) -> Result<usize, InputError> {
    let header = reader.headers().map_err(|error| unreadable(file, &error))?;
    if header == HEADER.as_slice() {
        Ok(0)
    } else if header == RECORDED_HEADER.as_slice() {
        Ok(1)
    } else {
        let found = format!("{:?}", header.iter().collect::<Vec<_>>().join(","));
        let accepted = format!("the header {}, or {}", HEADER.join(","), RECORDED_HEADER.join(","));
        Err(InputError::new(file, Place::Line(1), found, accepted))
    }
}

fn unreadable(file: &str, error: &csv::Error) -> InputError {
    let line = error.position().map_or(1, |position| position.line() as usize);
    InputError::new(file, Place::Line(line), error.to_string(), "comma-separated text in UTF-8")
}

/// Parses one row; `refuse` makes an error of the text found and what is accepted instead.
fn task(
    arm: &Arm<f64>,
    record: &StringRecord,
    first: usize,
    refuse: &dyn Fn(String, String) -> InputError,
) -> Result<Task, InputError> {
    let fields: Vec<&str> = record.iter().skip(first).collect();
    let Ok([base, shoulder, elbow, wrist, x, y, z]) = <[&str; JOINTS + 3]>::try_from(fields) else {
        return Err(refuse(format!("{} fields", record.len()), format!("{} fields", HEADER.len() + first)));
    };
    let mut start = Pose([0; JOINTS]);
    for ((ticks, field), range) in start.0.iter_mut().zip([base, shoulder, elbow, wrist]).zip(&arm.ranges) {
        let accepted = || format!("a whole number of ticks from {} to {}", range.min, range.max);
        *ticks = field
            .parse()
            .ok()
            .filter(|&t| range.contains(t))
            .ok_or_else(|| refuse(format!("{field:?}"), accepted()))?;
    }
    let mut target = [0.0; 3];
    for (value, field) in target.iter_mut().zip([x, y, z]) {
        let finite = field.parse().ok().filter(|v: &f64| v.is_finite());
        *value = finite.ok_or_else(|| refuse(format!("{field:?}"), "a finite number of mm".to_owned()))?;
    }
    Ok(Task { start, target })
}

#[cfg(test)]
mod tests {
    use super::{parse_csv, to_csv};
    use crate::arm::targets::{Set, Start, Task, tasks};
    use tpg_arm::WIDOWX;
    use tpg_graph::error::Place;

    #[test]
    fn csv_gives_back_the_same_tasks() {
        let list = tasks(&WIDOWX, 7, Set::Validation, Start::Rs, 50);
        assert_eq!(parse_csv(&WIDOWX, "tasks.csv", &to_csv(&list)), Ok(list));
    }

    #[test]
    fn the_papers_recorded_targets_are_read() {
        let text = "row,m0,m1,m2,m3,tx,ty,tz\n0,2048,2048,2048,2048,1.5,-250.25,30\n";
        let task = Task { start: WIDOWX.home, target: [1.5, -250.25, 30.0] };
        assert_eq!(parse_csv(&WIDOWX, "tasks.csv", text), Ok(vec![task]));
    }

    #[test]
    fn a_wrong_file_is_refused_with_its_place() {
        let good = to_csv(&tasks(&WIDOWX, 7, Set::Validation, Start::Rs, 2));
        for (wrong, line) in [
            (good.replace("start_base", "base"), 1),
            (String::new(), 1),
            (format!("{good}1,2,3\n"), 4),
            (format!("{good}1,2048,2048,2048,0,0,0\n"), 4),
            (format!("{good}2048,2048,2048,2048,0,NaN,0\n"), 4),
        ] {
            let error = parse_csv(&WIDOWX, "tasks.csv", &wrong).expect_err("refused");
            assert_eq!((error.file.as_str(), error.place), ("tasks.csv", Place::Line(line)), "{wrong}");
        }
    }
}
