//! A CSV file whose columns are found by name. Gzip is recognised by its first bytes.

use csv::{ErrorKind, StringRecord};
use flate2::read::MultiGzDecoder;
use std::fmt::Display;
use std::fs;
use std::io::{self, Read};
use std::ops::RangeInclusive;
use std::path::Path;
use std::str::FromStr;
use tpg_graph::error::{InputError, Place};

const GZIP: [u8; 2] = [0x1f, 0x8b];

/// A file in memory.
#[derive(Debug)]
pub(super) struct Table {
    file: String,
    headers: StringRecord,
    records: Vec<StringRecord>,
}

/// A column that exists.
#[derive(Clone, Copy, Debug)]
pub(super) struct Column(usize);

/// A row of a table.
#[derive(Clone, Copy, Debug)]
pub(super) struct Row<'t> {
    table: &'t Table,
    record: &'t StringRecord,
}

impl Table {
    /// Reads a file; `-` is standard input.
    pub(super) fn read(path: &Path) -> Result<Self, InputError> {
        let bytes = read_bytes(path).map_err(|error| InputError::io(path, &error, "a CSV file, gzip allowed"))?;
        let bytes = unpacked(bytes).map_err(|error| InputError::io(path, &error, "a whole gzip file"))?;
        let file = if path == Path::new("-") { "<stdin>".to_owned() } else { path.display().to_string() };
        Self::parse(file, &bytes)
    }

    fn parse(file: String, bytes: &[u8]) -> Result<Self, InputError> {
        let mut reader = csv::Reader::from_reader(bytes);
        let headers = reader.headers().map_err(|error| bad_csv(&file, &error))?.clone();
        let records = reader.records().collect::<Result<Vec<_>, _>>().map_err(|error| bad_csv(&file, &error))?;
        if records.is_empty() {
            let found = if headers.is_empty() { "an empty file" } else { "a header without rows" };
            return Err(InputError::new(file, Place::Whole, found, "a header line and at least one row"));
        }
        Ok(Self { file, headers, records })
    }

    /// Finds a column by name.
    pub(super) fn column(&self, name: &str) -> Result<Column, InputError> {
        let mut places = self.headers.iter().enumerate().filter(|(_, header)| *header == name);
        match (places.next(), places.next()) {
            (Some((place, _)), None) => Ok(Column(place)),
            (Some(_), Some(_)) => Err(self.bad_header(format!("two columns {name:?}"), format!("one column {name:?}"))),
            (None, _) => {
                let names: Vec<&str> = self.headers.iter().collect();
                Err(self
                    .bad_header(format!("the columns {}", names.join(", ")), format!("an additional column {name:?}")))
            }
        }
    }

    /// Finds a column by name, if it exists.
    pub(super) fn column_if_there(&self, name: &str) -> Result<Option<Column>, InputError> {
        self.headers.iter().any(|header| header == name).then(|| self.column(name)).transpose()
    }

    fn bad_header(&self, found: String, accepted: String) -> InputError {
        InputError::new(&self.file, Place::Line(1), found, accepted)
    }

    /// Returns the rows, in order.
    pub(super) fn rows(&self) -> impl Iterator<Item = Row<'_>> {
        self.records.iter().map(|record| Row { table: self, record })
    }
}

impl Row<'_> {
    /// Parses the number in a column.
    pub(super) fn number<T>(&self, column: Column, allowed: RangeInclusive<T>) -> Result<T, InputError>
    where
        T: FromStr + PartialOrd + Display,
    {
        let text = &self.record[column.0];
        text.parse().ok().filter(|value| allowed.contains(value)).ok_or_else(|| {
            let name = &self.table.headers[column.0];
            let accepted = format!("a number from {} to {}", allowed.start(), allowed.end());
            self.error(format!("{text:?} in column {name:?}"), accepted)
        })
    }

    /// Parses the 0 or 1 in a column.
    pub(super) fn flag(&self, column: Column) -> Result<bool, InputError> {
        Ok(self.number(column, 0..=1)? == 1_u8)
    }

    /// Creates an error about this row.
    pub(super) fn error(&self, found: impl Into<String>, accepted: impl Into<String>) -> InputError {
        InputError::new(&self.table.file, Place::Line(self.line()), found, accepted)
    }

    /// Returns the row's line in the file.
    pub(super) fn line(&self) -> usize {
        self.record.position().map_or(0, |position| position.line() as usize)
    }
}

fn read_bytes(path: &Path) -> io::Result<Vec<u8>> {
    if path == Path::new("-") {
        let mut bytes = Vec::new();
        io::stdin().lock().read_to_end(&mut bytes)?;
        return Ok(bytes);
    }
    fs::read(path)
}

fn unpacked(bytes: Vec<u8>) -> io::Result<Vec<u8>> {
    if !bytes.starts_with(&GZIP) {
        return Ok(bytes);
    }
    let mut text = Vec::new();
    MultiGzDecoder::new(bytes.as_slice()).read_to_end(&mut text)?;
    Ok(text)
}

fn bad_csv(file: &str, error: &csv::Error) -> InputError {
    let place = error.position().map_or(Place::Whole, |position| Place::Line(position.line() as usize));
    match error.kind() {
        ErrorKind::UnequalLengths { expected_len, len, .. } => InputError::new(
            file,
            place,
            format!("{len} fields"),
            format!("{expected_len} fields, as in the first line"),
        ),
        ErrorKind::Utf8 { .. } => InputError::new(file, place, "bytes that are not UTF-8", "text"),
        _ => InputError::new(file, place, error.to_string(), "comma-separated values"),
    }
}
