//! Errors in input files, worded so that the file's author can fix them.

use std::fmt::{self, Display};
use std::path::Path;

/// A place in an input file.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Place {
    /// The file as a whole.
    Whole,
    /// A line of a text file, counted from 1.
    Line(usize),
    /// A line and column, both counted from 1.
    Column(usize, usize),
    /// A path into a JSON or TOML document: `$.teams[3].edges[1].program`.
    Path(String),
}

impl fmt::Display for Place {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Whole => Ok(()),
            Self::Line(line) => write!(f, "line {line}: "),
            Self::Column(line, column) => write!(f, "line {line}, column {column}: "),
            Self::Path(path) => write!(f, "{path}: "),
        }
    }
}

/// A path into a document.
impl From<String> for Place {
    fn from(path: String) -> Self {
        Self::Path(path)
    }
}

/// A path into a document.
impl From<&str> for Place {
    fn from(path: &str) -> Self {
        Self::Path(path.to_owned())
    }
}

/// A rejected input: the place, what was found, and what is accepted instead.
#[derive(Clone, Debug, PartialEq, Eq, thiserror::Error)]
#[error("{file}: {place}{found}; accepted: {accepted}")]
pub struct InputError {
    /// Name of the file, `<stdin>` for standard input.
    pub file: String,
    /// Place in the file.
    pub place: Place,
    /// The text or value found there.
    pub found: String,
    /// The text or value that would be accepted there.
    pub accepted: String,
}

impl InputError {
    /// Creates an error.
    pub fn new(
        file: impl Into<String>,
        place: impl Into<Place>,
        found: impl Into<String>,
        accepted: impl Into<String>,
    ) -> Self {
        Self { file: file.into(), place: place.into(), found: found.into(), accepted: accepted.into() }
    }

    /// Creates an error for a file that cannot be read or written.
    pub fn io(path: &Path, error: &std::io::Error, accepted: impl Into<String>) -> Self {
        Self::new(path.display().to_string(), Place::Whole, error.to_string(), accepted)
    }
}

/// A rejected setting: its key, the value found and the values accepted. The reader of the file adds the place.
#[derive(Clone, Debug, PartialEq, Eq, thiserror::Error)]
#[error("{key} = {found}; accepted: {accepted}")]
pub struct Finding {
    /// The key, preceded by its tables: `learning.batch`.
    pub key: String,
    /// The value found.
    pub found: String,
    /// The values that would be accepted.
    pub accepted: String,
}

impl Finding {
    /// Creates a finding.
    pub fn new(key: impl Into<String>, found: impl ToString, accepted: impl Into<String>) -> Self {
        Self { key: key.into(), found: found.to_string(), accepted: accepted.into() }
    }

    /// Checks that a value lies in a range whose ends are included. NaN lies in no range.
    ///
    /// # Errors
    /// The finding, if the value lies outside.
    ///
    /// ```
    /// use tpg_graph::error::Finding;
    ///
    /// assert!(Finding::range("pool.share", 0.2, 0.0, 1.0).is_ok());
    /// let finding = Finding::range("pool.share", 2.0, 0.0, 1.0).expect_err("above 1");
    /// assert_eq!(finding.to_string(), "pool.share = 2; accepted: 0 to 1");
    /// ```
    pub fn range<T: PartialOrd + Display>(key: &str, value: T, low: T, high: T) -> Result<(), Self> {
        if value >= low && value <= high {
            return Ok(());
        }
        Err(Self::new(key, value, format!("{low} to {high}")))
    }
}

/// Splits a serde message into what was found and what was expected, in the terms of the file.
///
/// A position at the end (`at line 3 column 7`) is kept in brackets with what was found.
pub fn serde_message(message: &str) -> (String, Option<&str>) {
    let (message, position) = match message.rsplit_once(" at line ") {
        Some((message, position)) => (message, format!(" (line {})", position.replace(" column", ", column"))),
        None => (message, String::new()),
    };
    match message.split_once(", expected ") {
        Some((found, accepted)) => (format!("{found}{position}"), Some(plain(accepted))),
        None => (format!("{message}{position}"), None),
    }
}

/// Describes the values that a Rust type accepts, for authors of files.
fn plain(expected: &str) -> &str {
    match expected {
        "u32" => "a whole number, 0 to 4294967295",
        "u64" => "a whole number, 0 to 18446744073709551615",
        "i8" => "a whole number, -128 to 127",
        "f64" => "a number",
        "a sequence" => "a list",
        "a map" => "an object",
        _ if expected.starts_with("struct ") => "an object",
        _ => expected,
    }
}

/// Formats a count with its noun: `1 edge`, `2 edges`, `2 leaves`.
pub fn counted(count: usize, what: &str) -> String {
    match what.strip_suffix('f') {
        _ if count == 1 => format!("1 {what}"),
        Some(stem) => format!("{count} {stem}ves"),
        None => format!("{count} {what}s"),
    }
}
