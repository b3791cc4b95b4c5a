//! Numbers as text that C programs read and write.

use std::fmt::Write as _;

/// An initialiser of C.
pub(crate) fn braces<T: ToString>(values: impl IntoIterator<Item = T>) -> String {
    format!("{{ {} }}", values.into_iter().map(|value| value.to_string()).collect::<Vec<_>>().join(", "))
}

/// A number of C that is this one to the bit.
pub(crate) fn float(value: f32) -> String {
    format!("{value:.9e}F")
}

/// Appends numbers as the C programs print them: their bits in hexadecimal digits.
pub(crate) fn push_bits(text: &mut String, values: &[f32]) {
    values.iter().for_each(|value| {
        let _ = write!(text, "{:08x} ", value.to_bits());
    });
}
