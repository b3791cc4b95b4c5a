//! Recorded states: the observations of a policy, one per row, and what the policy answered.
//!
//! The file is CSV with a header. A column holds a value of the state and has its name in the graph, `target[0]`; columns
//! may come in any order, and others are ignored. Where answers are read too, the column `action` holds the number of the
//! action; for a policy with outputs, the column of each output's name holds its value.

use crate::error::{InputError, Place};
use crate::import;
use crate::interpret::Answer;
use crate::model::{ActionId, Graph, Input};
use std::path::Path;

/// The column of a policy's action.
const ACTION: &str = "action";

/// States with the answers that some tool gave.
#[derive(Clone, Debug, PartialEq)]
pub struct Recording {
    /// Flat states in the order of the graph's sources, rounded to its scalar type.
    pub states: Vec<f64>,
    /// The answer to each state.
    pub answers: Vec<Answer>,
    /// The line of the file that each state stands on, from 1.
    pub lines: Vec<usize>,
}

/// Reads flat states in the order of the graph's sources, rounded to its scalar type, and returns them with the file's
/// text.
///
/// # Errors
/// No such file, a value of the state with no column or more than one, a field that is not a number, no rows.
pub fn load(path: &Path, graph: &Graph) -> Result<(Vec<f64>, String), InputError> {
    let (file, text) = import::read(path)?;
    Ok((from_text(&file, &text, graph)?, text))
}

/// Reads states from text: see [`load`]. `file` is its name in messages.
///
/// # Errors
/// As [`load`].
pub fn from_text(file: &str, text: &str, graph: &Graph) -> Result<Vec<f64>, InputError> {
    let rows = Rows::read(file, text, &state_columns(graph))?;
    Ok(rows.values.iter().map(|&value| graph.scalar().round(value)).collect())
}

/// Reads states and the answers to them.
///
/// # Errors
/// As [`load`]; an action that the graph does not have.
pub fn recording(path: &Path, graph: &Graph) -> Result<Recording, InputError> {
    let (file, text) = import::read(path)?;
    recording_from_text(&file, &text, graph)
}

/// Reads states and the answers to them from text: see [`recording`]. `file` is its name in messages.
///
/// # Errors
/// As [`recording`].
pub fn recording_from_text(file: &str, text: &str, graph: &Graph) -> Result<Recording, InputError> {
    let mut columns = state_columns(graph);
    let length = columns.len();
    match graph.outputs() {
        [] => columns.push(ACTION.to_owned()),
        outputs => columns.extend(outputs.iter().map(|output| output.name.clone())),
    }
    let Rows { values, lines } = Rows::read(file, text, &columns)?;
    let mut recording = Recording { states: Vec::new(), answers: Vec::new(), lines };
    let round = |value: &f64| graph.scalar().round(*value);
    for (row, &line) in values.chunks_exact(columns.len()).zip(&recording.lines) {
        let (state, answer) = row.split_at(length);
        recording.states.extend(state.iter().map(round));
        recording.answers.push(if graph.outputs().is_empty() {
            let action = answer[0];
            let last = graph.actions().len() - 1;
            if action.fract() != 0.0 || !(0.0..=last as f64).contains(&action) {
                let found = format!("{action} in column {ACTION:?}");
                return Err(InputError::new(file, Place::Line(line), found, format!("an action, 0 to {last}")));
            }
            Answer::Action(ActionId(action as u16))
        } else {
            Answer::Values(answer.iter().map(round).collect())
        });
    }
    Ok(recording)
}

fn state_columns(graph: &Graph) -> Vec<String> {
    graph.inputs().map(|input: Input| graph.input_name(input)).collect()
}

/// Some columns of a file, row by row.
struct Rows {
    values: Vec<f64>,
    lines: Vec<usize>,
}

impl Rows {
    fn read(file: &str, text: &str, names: &[String]) -> Result<Self, InputError> {
        let mut reader = csv::ReaderBuilder::new().trim(csv::Trim::All).from_reader(text.as_bytes());
        let header = reader.headers().map_err(|error| malformed(file, &error))?.clone();
        let mut columns = Vec::with_capacity(names.len());
        for name in names {
            let mut found = (0..header.len()).filter(|&column| header.get(column) == Some(name));
            match (found.next(), found.next()) {
                (Some(column), None) => columns.push(column),
                (first, _) => {
                    let found = format!("{} column {name:?}", if first.is_some() { "more than one" } else { "no" });
                    let accepted = format!("a header that has each of these once: {}", names.join(","));
                    return Err(InputError::new(file, Place::Line(1), found, accepted));
                }
            }
        }
        let mut rows = Self { values: Vec::new(), lines: Vec::new() };
        for record in reader.records() {
            let record = record.map_err(|error| malformed(file, &error))?;
            let line = record.position().map_or(1, |position| position.line() as usize);
            rows.lines.push(line);
            for (&column, name) in columns.iter().zip(names) {
                let text = record.get(column).unwrap_or_default();
                rows.values.push(text.parse().map_err(|_| {
                    InputError::new(file, Place::Line(line), format!("{text:?} in column {name:?}"), "a number")
                })?);
            }
        }
        if rows.lines.is_empty() {
            return Err(InputError::new(file, Place::Whole, "no states", "a row for each recorded state"));
        }
        Ok(rows)
    }
}

fn malformed(file: &str, error: &csv::Error) -> InputError {
    let place = error.position().map_or(Place::Whole, |position| Place::Line(position.line() as usize));
    let found = match error.kind() {
        csv::ErrorKind::UnequalLengths { expected_len, len, .. } => {
            format!("{len} fields under {expected_len} columns")
        }
        _ => error.to_string(),
    };
    InputError::new(file, place, found, "CSV with as many fields in each row as in the header")
}

#[cfg(test)]
mod tests {
    use super::{Recording, from_text, recording_from_text};
    use crate::interpret::Answer;
    use crate::model::ActionId;
    use crate::sample::{self, Shape};

    #[test]
    fn columns_are_found_by_name() {
        let graph = sample::graph(&Shape { sources: vec![2, 1], ..Shape::default() }, 1);
        let states = from_text("t.csv", "s1[0],step,s0[1],s0[0]\n3,9,2,1\n-0.5,10,inf,1e3\n", &graph);
        assert_eq!(states.expect("states"), [1.0, 2.0, 3.0, 1e3, f64::INFINITY, -0.5]);
    }

    #[test]
    fn a_recording_has_an_answer_for_each_state() {
        let graph = sample::graph(&Shape { sources: vec![2], actions: 3, ..Shape::default() }, 1);
        let recording = recording_from_text("t.csv", "action,s0[0],s0[1]\n2,1,0.5\n0,-3,nan\n", &graph);
        let Recording { states, answers, lines } = recording.expect("a recording");
        assert_eq!((&states[..3], lines), (&[1.0, 0.5, -3.0][..], vec![2, 3]));
        assert!(states[3].is_nan());
        assert_eq!(answers, [2, 0].map(|action| Answer::Action(ActionId(action))));
        for bad in ["3", "-1", "0.5", "nan"] {
            let text = format!("action,s0[0],s0[1]\n{bad},1,2\n");
            let error = recording_from_text("t.csv", &text, &graph).expect_err(bad).to_string();
            assert!(error.starts_with("t.csv: line 2: ") && error.ends_with("an action, 0 to 2"), "{error}");
        }
        let error = recording_from_text("t.csv", "s0[0],s0[1]\n1,2\n", &graph).expect_err("no answers");
        assert!(error.to_string().starts_with("t.csv: line 1: no column \"action\""), "{error}");
    }

    #[test]
    fn the_values_of_outputs_have_columns_of_their_names() {
        let shape = Shape { sources: vec![1], outputs: 2, ..Shape::default() };
        let graph = sample::graph(&shape, 1);
        let names: Vec<&str> = graph.outputs().iter().map(|output| &*output.name).collect();
        let text = format!("s0[0],{}\n1,0.1,-2\n", names.join(","));
        let recording = recording_from_text("t.csv", &text, &graph).expect("a recording");
        assert_eq!(recording.answers, [Answer::Values(vec![graph.scalar().round(0.1), -2.0])]);
    }

    #[test]
    fn what_is_wrong_is_said() {
        let graph = sample::graph(&Shape { sources: vec![2], ..Shape::default() }, 1);
        let refused = |text| from_text("t.csv", text, &graph).expect_err("refused").to_string();
        assert!(refused("s0[0]\n1\n").starts_with("t.csv: line 1: no column \"s0[1]\"; accepted: "));
        assert!(refused("s0[0],s0[1],s0[1]\n").contains("more than one column \"s0[1]\""));
        assert!(
            refused("s0[0],s0[1]\n1,2\n3,x\n")
                .starts_with("t.csv: line 3: \"x\" in column \"s0[1]\"; accepted: a number")
        );
        assert!(refused("s0[0],s0[1]\n1,2\n3\n").starts_with("t.csv: line 3: 1 fields under 2 columns"));
        assert!(refused("s0[0],s0[1]\n").starts_with("t.csv: no states"));
        assert!(refused("").contains("no column"));
    }
}
