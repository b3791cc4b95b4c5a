//! Lists of tasks as CSV files: a header, then a row for each task.

use csv::{ReaderBuilder, Trim, Writer};
use std::fmt::Display;
use std::str::FromStr;
use tpg_arm::{JOINTS, JointRange, Pose};
use tpg_graph::error::{InputError, Place};

/// An error in a row: the text found, and what is accepted instead.
pub(crate) type RowRefusal = (String, String);

/// Returns a header and rows as CSV.
///
/// # Panics
/// Never: memory can be written.
pub(crate) fn write<const N: usize>(header: [&str; N], rows: impl Iterator<Item = [String; N]>) -> String {
    let mut writer = Writer::from_writer(Vec::new());
    writer.write_record(header).expect("memory can be written");
    rows.for_each(|row| writer.write_record(row).expect("memory can be written"));
    String::from_utf8(writer.into_inner().expect("memory can be written")).expect("numbers are text")
}

/// Reads each row below a header; `file` is the text's name, for messages.
pub(crate) fn read<T, const N: usize>(
    file: &str,
    text: &str,
    header: [&str; N],
    read: impl Fn([&str; N]) -> Result<T, RowRefusal>,
) -> Result<Vec<T>, InputError> {
    let mut reader = ReaderBuilder::new().trim(Trim::All).flexible(true).from_reader(text.as_bytes());
    let refuse =
        |line: usize, found: String, accepted: String| InputError::new(file, Place::Line(line), found, accepted);
    let unreadable = |error: csv::Error| {
        let line = error.position().map_or(1, |position| position.line() as usize);
        refuse(line, error.to_string(), "comma-separated text in UTF-8".to_owned())
    };
    let found = reader.headers().map_err(unreadable)?;
    if found != header.as_slice() {
        let found = format!("{:?}", found.iter().collect::<Vec<_>>().join(","));
        return Err(refuse(1, found, format!("the header {}", header.join(","))));
    }
    let row = |record: Result<csv::StringRecord, csv::Error>| {
        let record = record.map_err(unreadable)?;
        let line = record.position().map_or(0, csv::Position::line) as usize;
        let fields = <[&str; N]>::try_from(record.iter().collect::<Vec<_>>());
        let fields =
            fields.map_err(|fields| refuse(line, format!("{} fields", fields.len()), format!("{N} fields")))?;
        read(fields).map_err(|(found, accepted)| refuse(line, found, accepted))
    };
    reader.records().map(row).collect()
}

/// Reads a fixed number of numbers.
pub(crate) fn numbers<'t, T: FromStr, const N: usize>(
    texts: impl IntoIterator<Item = &'t str>,
    unit: &str,
) -> Result<[T; N], RowRefusal> {
    let texts: Vec<&str> = texts.into_iter().collect();
    let values = texts.iter().map(|text| text.parse().ok()).collect::<Option<Vec<T>>>();
    let values = values.and_then(|values| values.try_into().ok());
    values.ok_or_else(|| (format!("{:?}", texts.join(" ")), format!("{N} numbers ({unit})")))
}

/// Returns numbers that are finite.
pub(crate) fn finite<T: Copy + Display + Into<f64>, const N: usize>(values: [T; N]) -> Result<[T; N], RowRefusal> {
    match values.iter().find(|&&value| !value.into().is_finite()) {
        Some(value) => Err((value.to_string(), "finite numbers".to_owned())),
        None => Ok(values),
    }
}

/// Returns a pose of an arm.
pub(crate) fn pose(ranges: &[JointRange; JOINTS], pose: [i16; JOINTS]) -> Result<Pose, RowRefusal> {
    match pose.iter().zip(ranges).find(|&(&ticks, range)| !range.contains(ticks)) {
        Some((ticks, range)) => Err((ticks.to_string(), format!("ticks from {} to {}", range.min, range.max))),
        None => Ok(Pose(pose)),
    }
}
