//! The artifact's files of text: targets, and recorded episodes.

use super::ROWS;
use std::fmt::Write as _;
use std::fs;
use std::path::Path;
use tpg_graph::error::{InputError, Place};

/// Header of a trace.
const TRACE_HEADER: &str = "row,step,m0,m1,m2,m3\n";
/// Header of end states, without the column that only some have and without the line's end.
pub(super) const ENDS_HEADER: &str = "row,score_x1000,distance_um,success,collision,nb_actions";

/// Reads a file of the artifact.
pub(super) fn read(path: &Path) -> Result<Vec<u8>, InputError> {
    fs::read(path).map_err(|error| InputError::io(path, &error, "a clone of gegelati/ECTA24 with this file"))
}

fn text(path: &Path) -> Result<String, InputError> {
    String::from_utf8(read(path)?).map_err(|error| {
        InputError::new(path.display().to_string(), Place::Whole, error.to_string(), "the artifact's file of text")
    })
}

/// Returns starts and targets as CSV: six motors and three coordinates a line, separated by spaces.
pub(super) fn targets(path: &Path) -> Result<String, InputError> {
    let mut csv = "row,m0,m1,m2,m3,tx,ty,tz\n".to_owned();
    for (row, line) in text(path)?.lines().take(ROWS).enumerate() {
        let refuse = |accepted: &str| {
            Err(InputError::new(path.display().to_string(), Place::Line(row + 1), format!("{line:?}"), accepted))
        };
        let words: Vec<&str> = line.split_whitespace().collect();
        let &[m0, m1, m2, m3, _, _, ref target @ ..] = &words[..] else { return refuse("six motors and a target") };
        let Ok(target) = target.iter().map(|word| word.parse()).collect::<Result<Vec<f64>, _>>() else {
            return refuse("coordinates in mm");
        };
        let &[x, y, z] = &target[..] else { return refuse("a target of three coordinates") };
        let _ = writeln!(csv, "{row},{m0},{m1},{m2},{m3},{x:?},{y:?},{z:?}");
    }
    Ok(csv)
}

/// The artifact's columns of an end state; some recordings lack the last.
const ENDS: [&str; 6] = ["Score", "Distance", "Success", "Collision", "NbActions", "NbIterationGegelati"];
/// The place of the number of actions among them.
const ACTIONS: usize = 4;

/// A recorded episode.
#[derive(Clone, Debug)]
pub(super) struct Run {
    /// The columns of [`ENDS`].
    end: Vec<i64>,
    /// Motor positions, four a step.
    motors: Vec<i64>,
}

impl Run {
    /// Returns the columns of the end state.
    pub(super) fn end(&self, row: usize) -> String {
        self.end.iter().fold(row.to_string(), |text, value| format!("{text},{value}"))
    }
}

/// A file of recorded episodes.
pub(super) struct Recording {
    file: String,
    pub(super) runs: Vec<Run>,
}

impl Recording {
    /// Reads a file: a line of names, then an episode a line with as many positions as it has steps.
    pub(super) fn read(path: &Path) -> Result<Self, InputError> {
        let (file, text) = (path.display().to_string(), text(path)?);
        let mut lines = text.lines();
        let names: Vec<&str> = lines.next().unwrap_or_default().split(',').collect();
        let place = |name: &str| names.iter().position(|found| found.trim_end_matches("*1000") == name);
        let column = |name: &str| {
            place(name)
                .ok_or_else(|| InputError::new(&file, Place::Line(1), names.join(","), format!("a column {name}")))
        };
        let mut ends = ENDS[..=ACTIONS].iter().map(|name| column(name)).collect::<Result<Vec<usize>, _>>()?;
        ends.extend(place(ENDS[ACTIONS + 1]));
        let motors = column("MotorPos")?;
        let runs = lines.zip(2..).map(|(line, number)| {
            let values: Vec<&str> = line.split(',').collect();
            let whole = |column: usize| {
                let value = values.get(column).copied().unwrap_or_default();
                let found = || format!("{value:?} in column {}", column + 1);
                value.parse().map_err(|_| InputError::new(&file, Place::Line(number), found(), "a whole number"))
            };
            let end = ends.iter().map(|&column| whole(column)).collect::<Result<_, _>>()?;
            Ok(Run { end, motors: (motors..values.len()).map(whole).collect::<Result<_, _>>()? })
        });
        Ok(Self { runs: runs.collect::<Result<_, InputError>>()?, file })
    }

    /// Returns the end states as CSV.
    pub(super) fn ends(&self) -> String {
        let by_tpg = if self.runs.iter().any(|run| run.end.len() == ENDS.len()) { ",nb_tpg_actions" } else { "" };
        let rows = self.runs.iter().take(ROWS).enumerate().map(|(row, run)| run.end(row) + "\n");
        format!("{ENDS_HEADER}{by_tpg}\n{}", rows.collect::<String>())
    }

    /// Returns the steps as CSV.
    pub(super) fn trace(&self) -> Result<String, InputError> {
        let mut text = TRACE_HEADER.to_owned();
        for (row, run) in self.runs.iter().take(ROWS).enumerate() {
            if run.motors.len() as i64 != 4 * run.end[ACTIONS] {
                let found = format!("{} positions", run.motors.len());
                let accepted = format!("four for each of {} actions", run.end[ACTIONS]);
                return Err(InputError::new(&self.file, Place::Line(row + 2), found, accepted));
            }
            for (step, motors) in run.motors.chunks_exact(4).enumerate() {
                let _ = writeln!(text, "{row},{},{},{},{},{}", step + 1, motors[0], motors[1], motors[2], motors[3]);
            }
        }
        Ok(text)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use std::path::PathBuf;

    fn written(text: &str) -> (tempfile::TempDir, PathBuf) {
        let folder = tempfile::tempdir().expect("a temporary folder");
        let path = folder.path().join("file");
        fs::write(&path, text).expect("the folder can be written");
        (folder, path)
    }

    #[test]
    fn a_recording_becomes_ends_and_steps() {
        let (_folder, path) = written(
            "armPos0,Duration(ms),Score,Distance*1000,Success,Collision,NbActions,NbIterationGegelati,MotorPos\n\
             1,9,-5,70,0,1,2,1,1,2,3,4,5,6,7,8\n",
        );
        let recording = Recording::read(&path).expect("a recording");
        assert_eq!(recording.ends(), format!("{ENDS_HEADER},nb_tpg_actions\n0,-5,70,0,1,2,1\n"));
        assert_eq!(recording.trace().expect("steps"), format!("{TRACE_HEADER}0,1,1,2,3,4\n0,2,5,6,7,8\n"));
    }

    #[test]
    fn what_is_no_recording_is_refused_with_its_line() {
        let head = "Score,Distance,Success,Collision,NbActions,MotorPos\n";
        for (text, found) in [("a,b\n1,2\n", "line 1"), (&*format!("{head}1,2,x,0,1,7\n"), "line 2")] {
            let (_folder, path) = written(text);
            let Err(error) = Recording::read(&path) else { panic!("{text} is read") };
            assert!(error.to_string().contains(found), "{error}");
        }
        let (_folder, path) = written(&format!("{head}1,2,0,0,3,7,8\n"));
        let error = Recording::read(&path).expect("numbers").trace().expect_err("too few positions");
        assert!(error.to_string().contains("four for each of 3 actions"), "{error}");
    }

    #[test]
    fn targets_have_a_row_each() {
        let (_folder, path) = written("1 2 3 4 512 256 -1.5 224 3 \n");
        assert_eq!(targets(&path).expect("a target"), "row,m0,m1,m2,m3,tx,ty,tz\n0,1,2,3,4,-1.5,224.0,3.0\n");
        let (_folder, path) = written("1 2 3\n");
        assert!(targets(&path).is_err());
    }
}
