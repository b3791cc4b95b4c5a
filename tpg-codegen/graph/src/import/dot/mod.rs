//! GEGELATI's `.dot` format, read strictly: every statement is understood or refused by its line.
//!
//! One statement stands on one line, so a file is read line by line: [`lexer`] makes tokens of a line, [`parser`] a
//! [`statement`] of the tokens ([`label`] takes programs apart), and [`resolve`] makes a document of the statements. The
//! graph's own validation then finds what is wrong with the whole, and [`lines`] tells on which line it stands.
//!
//! ```text
//! file        = comment* "digraph{" statement* "}"
//! statement   = "graph" attributes | "node" attributes                           drawing only
//!             | "T"n attributes                                                  a team
//!             | "P"n attributes "//" (integer "|")*                              a program, its constants
//!             | "I"n "[… label="line*"]" ["//" (number "|")*]                    its lines; GEGELATI 2 has constants here
//!             | "P"n "->" "I"n attributes                                        says nothing new
//!             | "A"n "[… label="action"]"                                        an action; equal labels are one action
//!             | "T"n "->" "P"n "->" ("T"n | "A"n)                                an edge
//!             | "T"n "->" "P"n                                                   an edge to where the program leads elsewhere
//!             | "{ rank= same" ("T"n)* "}"                                       the root
//! line        = instruction "|" register "&" operand ("#" operand)* "&#92;n"
//! operand     = source "|" location
//! ```

mod declared;
mod label;
mod lexer;
mod lines;
mod parser;
mod program;
mod resolve;
mod statement;

use super::sidecar::Sidecar;
use crate::error::{InputError, Place};
use crate::model::Graph;

/// What is wrong on one line.
#[derive(Debug)]
struct Fault {
    found: String,
    accepted: String,
}

impl Fault {
    fn new(found: impl Into<String>, accepted: impl Into<String>) -> Self {
        Self { found: found.into(), accepted: accepted.into() }
    }

    fn on(self, file: &str, line: usize) -> InputError {
        InputError::new(file, Place::Line(line), self.found, self.accepted)
    }
}

/// Reads a `.dot` file whose sources, instructions and actions are as `sidecar` says.
pub(super) fn read(file: &str, text: &str, sidecar: &Sidecar) -> Result<Graph, InputError> {
    let statements = parser::statements(file, text)?;
    let (document, lines) = resolve::document(file, &statements, sidecar)?;
    Graph::from_document(file, document).map_err(|error| match &error.place {
        Place::Path(path) => match lines.of(path) {
            Some(line) => InputError { place: Place::Line(line), ..error },
            None => sidecar.place_error(error),
        },
        _ => error,
    })
}
