//! CSV as text in memory.

use serde::Serialize;

/// Returns rows as CSV, below a header of the names of their fields.
///
/// # Panics
/// Never: memory can be written.
pub(crate) fn to_csv(rows: impl IntoIterator<Item = impl Serialize>) -> Vec<u8> {
    let mut writer = csv::Writer::from_writer(Vec::new());
    rows.into_iter().for_each(|row| writer.serialize(row).expect("plain data in memory"));
    writer.into_inner().expect("memory can be written")
}
