//! Recorded states: the observations of a policy, one per row, and what the policy answered.
//!
//! The file is CSV with a header. A column holds a value of the state and has its name in the graph, `target[0]`; columns
//! may come in any order, and others are ignored. Where answers are read too, the column `action` holds the number or the name of
//! the action; for a policy with outputs, the column of each output's name holds its value.

use crate::error::{InputError, Place::*};
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
    let rows = TraceRows::read(file, text, &state_columns(graph), |_| None)?;
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
    let action = |name: &str| graph.actions().iter().position(|action| action.name == name);
    let TraceRows { values, lines } = TraceRows::read(file, text, &columns, action)?;
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
                return Err(InputError::new(file, Line(line), found, format!("an action, 0 to {last}")));
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
struct TraceRows {
    values: Vec<f64>,
    lines: Vec<usize>,
}

impl TraceRows {
    /// Reads the columns of these names. `action` finds the number of an action by its name.
    fn read(
        file: &str,
        text: &str,
        names: &[String],
        action: impl Fn(&str) -> Option<usize>,
    ) -> Result<Self, InputError> {
        let mut reader = csv::ReaderBuilder::new().trim(csv::Trim::All).from_reader(text.as_bytes());
        let header = reader.headers().map_err(|error| malformed(file, text, &error))?.clone();
        let mut columns = Vec::with_capacity(names.len());
        for name in names {
            let mut found = (0..header.len()).filter(|&column| header.get(column) == Some(name));
            match (found.next(), found.next()) {
                (Some(column), None) => columns.push(column),
                (first, _) => {
                    let found = format!("{} column {name:?}", if first.is_some() { "more than one" } else { "no" });
                    let accepted = format!("a header that has each of these once: {}", names.join(","));
                    return Err(InputError::new(file, Line(1), found, accepted));
                }
            }
        }
        let mut rows = Self { values: Vec::new(), lines: Vec::new() };
        let mut lines = LineNumbers { text, line: 1, counted: 0 };
        for record in reader.records() {
            let record = record.map_err(|error| malformed(file, text, &error))?;
            let line = record.position().map_or(1, |position| lines.number(position));
            rows.lines.push(line);
            for (&column, name) in columns.iter().zip(names) {
                let text = record.get(column).unwrap_or_default();
                let number = text.parse().ok();
                let named = || action(text).filter(|_| name == ACTION).map(|action| action as f64);
                rows.values.push(number.or_else(named).ok_or_else(|| {
                    InputError::new(file, Line(line), format!("{text:?} in column {name:?}"), "a number")
                })?);
            }
        }
        if rows.lines.is_empty() {
            return Err(InputError::new(file, Whole, "no states", "a row for each recorded state"));
        }
        Ok(rows)
    }
}

/// Counts lines: a reader's own count is behind where lines end with CR and LF.
struct LineNumbers<'t> {
    text: &'t str,
    /// The line of the first byte that has not been counted.
    line: usize,
    counted: usize,
}

impl LineNumbers<'_> {
    /// Returns the line, from 1, on which the record at a position begins; positions ascend.
    fn number(&mut self, position: &csv::Position) -> usize {
        let bytes = self.text.as_bytes();
        let mut start = (position.byte() as usize).clamp(self.counted, bytes.len());
        start += bytes[start..].iter().take_while(|byte| b"\r\n".contains(byte)).count();
        self.line += bytes[self.counted..start].iter().filter(|&&byte| byte == b'\n').count();
        self.counted = start;
        self.line
    }
}

fn malformed(file: &str, text: &str, error: &csv::Error) -> InputError {
    let line = |position: &csv::Position| LineNumbers { text, line: 1, counted: 0 }.number(position);
    let place = error.position().map_or(Whole, |position| Line(line(position)));
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
        let named = format!("action,s0[0],s0[1]\r\n\r\n{},1,0.5\r\n", graph.actions()[1].name);
        let recording = recording_from_text("t.csv", &named, &graph).expect("an action by its name");
        assert_eq!((recording.answers, recording.lines), (vec![Answer::Action(ActionId(1))], vec![3]));
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
        let refused = |text: &str| from_text("t.csv", text, &graph).expect_err("refused").to_string();
        assert!(refused("s0[0]\n1\n").starts_with("t.csv: line 1: no column \"s0[1]\"; accepted: "));
        assert!(refused("s0[0],s0[1],s0[1]\n").contains("more than one column \"s0[1]\""));
        assert!(
            refused("s0[0],s0[1]\n1,2\n3,x\n")
                .starts_with("t.csv: line 3: \"x\" in column \"s0[1]\"; accepted: a number")
        );
        assert!(refused("s0[0],s0[1]\n1,2\n3\n").starts_with("t.csv: line 3: 1 fields under 2 columns"));
        for ends in ["\n", "\r\n"] {
            let text = ["s0[0],s0[1]", "1,2", "3,4", "5,x"].join(ends);
            assert!(refused(&text).starts_with("t.csv: line 4: \"x\""), "{ends:?}");
            let text = ["s0[0],s0[1]", "1,2", "3,4", "5"].join(ends);
            assert!(refused(&text).starts_with("t.csv: line 4: 1 fields"), "{ends:?}");
        }
        assert!(refused("s0[0],s0[1]\n").starts_with("t.csv: no states"));
        assert!(refused("").contains("no column"));
    }
}
