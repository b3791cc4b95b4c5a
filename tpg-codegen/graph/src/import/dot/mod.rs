//! Strict reader of GEGELATI's `.dot` format: every statement is either understood or rejected with its line.
//!
//! Each statement occupies one line, so a file is read line by line. [`lexer`] splits a line into tokens, [`parser`]
//! collects what they [declare](declared) ([`label`] parses programs), and [`resolve`] builds a document. The
//! graph's own validation then checks the whole, and its errors get the lines of the file.
//!
//! ```text
//! file        = comment* "digraph{" statement* "}"
//! statement   = "graph" attributes | "node" attributes                           drawing only
//!             | "T"n attributes                                                  a team
//!             | "P"n attributes "//" (number "|")*                               a program, its constants
//!             | "I"n "[… label="line*"]" ["//" (number "|")*]                    its lines; or its constants here, or theirs
//!             | "P"n "->" "I"n attributes                                        redundant
//!             | "A"n "[… label="action"]"                                        an action; equal labels are one action
//!             | "A"n "[… label="class("-"class)*"]"                              a leaf, and what its programs compute
//!             | "A"n "->" "P"n                                                   a leaf's next program
//!             | "T"n "->" "P"n "->" ("T"n | "A"n)                                an edge
//!             | "T"n "->" "P"n                                                   an edge to P's known destination
//!             | "{ rank= same" ("T"n | "A"n)* "}"                                the root
//! line        = instruction "|" register "&" operand ("#" operand)* "&#92;n"
//! operand     = source "|" location
//! ```

mod declared;
mod fault;
mod label;
mod leaves;
mod lexer;
mod parser;
mod program;
mod resolve;

use super::sidecar::Sidecar;
use crate::error::{InputError, Place};
use crate::model::Graph;
use resolve::Resolver;

/// Reads a `.dot` file whose sources, instructions and actions are described by `sidecar`.
pub(super) fn read(file: &str, text: &str, sidecar: &Sidecar) -> Result<Graph, InputError> {
    let resolver = Resolver { file, sidecar, declared: parser::declared(file, text)? };
    let (document, bases) = resolver.document()?;
    Graph::from_document(file, document.clone()).map_err(|error| match &error.place {
        Place::Path(path) => match resolver.line(path, &document, &bases) {
            Some(line) => InputError { place: Place::Line(line), ..error },
            None => sidecar.place_error(error),
        },
        _ => error,
    })
}
