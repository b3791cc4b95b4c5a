//! CSV as text in memory, its numbers with the fewest digits that give the same number again.

/// Returns a header and rows as CSV.
pub(crate) fn table<Header, Row>(header: Header, rows: impl IntoIterator<Item = Row>) -> Vec<u8>
where
    Header: IntoIterator<Item: AsRef<[u8]>>,
    Row: IntoIterator<Item: AsRef<[u8]>>,
{
    let mut text = row(header);
    rows.into_iter().for_each(|fields| text.extend(row(fields)));
    text
}

/// Returns one row as CSV.
///
/// # Panics
/// Never: memory can be written.
pub(crate) fn row<Row: IntoIterator<Item: AsRef<[u8]>>>(fields: Row) -> Vec<u8> {
    let mut writer = csv::Writer::from_writer(Vec::new());
    writer.write_record(fields).expect("memory can be written");
    writer.into_inner().expect("memory can be written")
}

/// Returns a number as text; nothing where there is none.
pub(crate) fn optional(value: Option<f64>) -> String {
    value.map(|value| value.to_string()).unwrap_or_default()
}
