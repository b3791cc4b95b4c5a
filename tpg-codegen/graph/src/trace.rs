//! Recorded states: the observations of a policy, one per row.
//!
//! The file is CSV with a header. A column holds a value of the state and has its name in the graph, `target[0]`;
//! columns may come in any order, and others are ignored.

use crate::error::{InputError, Place};
use crate::import;
use crate::model::{Graph, Input};
use std::path::Path;

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
    let mut reader = csv::ReaderBuilder::new().trim(csv::Trim::All).from_reader(text.as_bytes());
    let header = reader.headers().map_err(|error| malformed(file, &error))?.clone();
    let names: Vec<String> = (0..graph.state_length()).map(|place| graph.input_name(Input(place as u16))).collect();
    let mut columns = Vec::with_capacity(names.len());
    for name in &names {
        let mut found = (0..header.len()).filter(|&column| header.get(column) == Some(name));
        match (found.next(), found.next()) {
            (Some(column), None) => columns.push(column),
            (first, _) => {
                let found = format!("{} column {name:?}", if first.is_some() { "more than one" } else { "no" });
                let accepted = format!("a header that names every value of the state once: {}", names.join(","));
                return Err(InputError::new(file, Place::Line(1), found, accepted));
            }
        }
    }
    let mut states = Vec::new();
    for record in reader.records() {
        let record = record.map_err(|error| malformed(file, &error))?;
        for (&column, name) in columns.iter().zip(&names) {
            let text = record.get(column).unwrap_or_default();
            let value: f64 = text.parse().map_err(|_| {
                let line = record.position().map_or(1, |position| position.line() as usize);
                InputError::new(file, Place::Line(line), format!("{text:?} in column {name:?}"), "a number")
            })?;
            states.push(graph.scalar().round(value));
        }
    }
    if states.is_empty() {
        return Err(InputError::new(file, Place::Whole, "no states", "a row for each recorded state"));
    }
    Ok(states)
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
    use super::from_text;
    use crate::sample::{self, Shape};

    #[test]
    fn columns_are_found_by_name() {
        let graph = sample::graph(&Shape { sources: vec![2, 1], ..Shape::default() }, 1);
        let states = from_text("t.csv", "s1[0],step,s0[1],s0[0]\n3,9,2,1\n-0.5,10,inf,1e3\n", &graph);
        assert_eq!(states.expect("states"), [1.0, 2.0, 3.0, 1e3, f64::INFINITY, -0.5]);
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
