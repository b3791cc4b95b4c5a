//! `tpg-codegen verify --expect`: the interpreter beside another tool's recording.

use serde::Serialize;
use std::fmt;
use std::path::Path;
use tpg_graph::Graph;
use tpg_graph::error::InputError;
use tpg_graph::interpret;
use tpg_graph::trace::{self, Recording};

/// The interpreter's answers compared with recorded ones.
#[derive(Clone, Debug, Serialize)]
pub(super) struct Expected {
    file: String,
    /// States compared.
    states: usize,
    /// States whose answers differ.
    pub(super) differences: usize,
    /// The first difference.
    first: Option<Mismatch>,
}

#[derive(Clone, Debug, Serialize)]
struct Mismatch {
    line: usize,
    recorded: String,
    interpreter: String,
}

impl Expected {
    pub(super) fn check(path: &Path, graph: &Graph) -> Result<Self, InputError> {
        let Recording { states, answers: recorded, lines } = trace::recording(path, graph)?;
        let answers = interpret::answers(graph, &states);
        let mut differing = (recorded.iter().zip(&answers).zip(lines))
            .filter(|((recorded, answer), _)| !recorded.same_bits(answer))
            .peekable();
        let first = differing.peek().map(|((recorded, answer), line)| Mismatch {
            line: *line,
            recorded: recorded.to_string(),
            interpreter: answer.to_string(),
        });
        let differences = differing.count();
        Ok(Self { file: path.display().to_string(), states: recorded.len(), differences, first })
    }
}

impl fmt::Display for Expected {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let Self { file, states, differences, first } = self;
        match first {
            None => write!(f, "interpreter = {file} on {states} states"),
            Some(Mismatch { line, recorded, interpreter }) => write!(
                f,
                "interpreter differs from {file} on {differences} of {states} states; the first, line {line}: \
                 {interpreter} instead of {recorded}"
            ),
        }
    }
}
