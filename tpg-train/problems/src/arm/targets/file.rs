//! Lists of tasks as CSV files.

use super::Task;
use crate::rows::{self, finite, numbers, pose};
use std::path::Path;
use tpg_arm::{Arm, JOINTS, Pose};
use tpg_graph::error::InputError;
use tpg_graph::files::read_text;

const HEADER: [&str; JOINTS + 3] =
    ["start_base", "start_shoulder", "start_elbow", "start_wrist", "target_x_mm", "target_y_mm", "target_z_mm"];

/// Writes tasks as CSV: a header, then start (ticks) and target (mm, the shortest digits that give the same number).
pub fn to_csv(tasks: &[Task]) -> String {
    let row = |&Task { start: Pose([base, shoulder, elbow, wrist]), target }: &Task| {
        let [x, y, z] = target.map(|mm| mm.to_string());
        let [base, shoulder, elbow, wrist] = [base, shoulder, elbow, wrist].map(|ticks| ticks.to_string());
        [base, shoulder, elbow, wrist, x, y, z]
    };
    rows::write(HEADER, tasks.iter().map(row))
}

/// Reads a file that [`to_csv`] wrote.
///
/// # Errors
/// If the file cannot be read, has a different header, or contains a value that is not a number in the arm's range.
pub fn read_csv(arm: &Arm<f64>, path: &Path) -> Result<Vec<Task>, InputError> {
    let text = read_text(path, "a file of episodes")?;
    parse_csv(arm, &path.display().to_string(), &text)
}

/// Reads the text of such a file; `file` is its name, for messages.
///
/// # Errors
/// If it has a different header, or contains a value that is not a number in the arm's range.
pub fn parse_csv(arm: &Arm<f64>, file: &str, text: &str) -> Result<Vec<Task>, InputError> {
    rows::read(file, text, HEADER, |[base, shoulder, elbow, wrist, x, y, z]| {
        let start = pose(&arm.ranges, numbers([base, shoulder, elbow, wrist], "ticks")?)?;
        Ok(Task { start, target: finite(numbers([x, y, z], "mm")?)? })
    })
}

#[cfg(test)]
mod tests {
    use super::{parse_csv, to_csv};
    use crate::arm::targets::{Set, Start, tasks};
    use tpg_arm::WIDOWX;
    use tpg_graph::error::Place;

    #[test]
    fn csv_gives_back_the_same_tasks() {
        let list = tasks(&WIDOWX, 7, Set::Validation, Start::Rs, 50);
        assert_eq!(parse_csv(&WIDOWX, "tasks.csv", &to_csv(&list)), Ok(list));
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
