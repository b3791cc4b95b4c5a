//! Strict reader of TOML files: every error names its line.

use crate::error::{Finding, InputError, Place};
use crate::files::read_text;
use serde::de::DeserializeOwned;
use std::path::Path;
use toml::de::{DeTable, DeValue};

/// Reads a TOML text into a type that rejects unknown keys.
///
/// # Errors
/// The first error, with its line; `accepted` describes what the file may hold.
pub fn from_toml<T: DeserializeOwned>(file: &str, text: &str, accepted: &str) -> Result<T, InputError> {
    toml::from_str(text).map_err(|error| {
        let place = error.span().map_or(Place::Whole, |span| Place::Line(line(text, span.start)));
        InputError::new(file, place, error.message().trim(), accepted)
    })
}

/// Reads a TOML file: see [`from_toml`].
///
/// # Errors
/// As [`from_toml`], or if the file cannot be read.
pub fn read<T: DeserializeOwned>(path: &Path, accepted: &str) -> Result<T, InputError> {
    let text = read_text(path, accepted)?;
    from_toml(&path.display().to_string(), &text, accepted)
}

/// Locates a finding in its file: at the line of its value, or else of the innermost enclosing table in the text.
pub fn place(file: &str, text: &str, finding: Finding) -> InputError {
    let Finding { key, found, accepted } = finding;
    let place = position(text, &key).map_or(Place::Path(key.clone()), |byte| Place::Line(line(text, byte)));
    InputError::new(file, place, format!("{key} = {found}"), accepted)
}

/// Returns the first byte of the value that a path of keys and places leads to, `a.b[2]`, or of the innermost one around it that the
/// text has.
pub(crate) fn position(text: &str, path: &str) -> Option<usize> {
    let parsed = DeTable::parse(text).ok()?;
    let mut steps = path.trim_start_matches('$').split(['.', '[']).filter(|step| !step.is_empty());
    let mut value = parsed.get_ref().get(steps.next()?)?;
    for step in steps {
        let inner = match value.get_ref() {
            DeValue::Table(table) => table.get(step),
            DeValue::Array(array) => step.trim_end_matches(']').parse().ok().and_then(|place: usize| array.get(place)),
            _ => None,
        };
        let Some(inner) = inner else { break };
        value = inner;
    }
    Some(value.span().start)
}

/// Returns the line, from 1, of a byte of the text.
fn line(text: &str, byte: usize) -> usize {
    1 + text.bytes().take(byte).filter(|&b| b == b'\n').count()
}

#[cfg(test)]
mod tests {
    use super::{from_toml, place};
    use crate::error::{Finding, Place};

    const TEXT: &str = "# comment\n[a]\nb = 1\n\n[a.c]\nd = 2\n";

    #[test]
    fn a_finding_is_placed_at_its_key_or_at_its_table() {
        for (key, line) in [("a.b", 3), ("a.c.d", 6), ("a.c.missing", 5), ("a.b.e", 3)] {
            assert_eq!(place("x.toml", TEXT, Finding::new(key, 0, "1")).place, Place::Line(line), "{key}");
        }
        let nowhere = place("x.toml", TEXT, Finding::new("z", 0, "1"));
        assert_eq!(nowhere.to_string(), "x.toml: z: z = 0; accepted: 1");
    }

    #[test]
    fn a_value_of_another_type_has_its_line() {
        #[derive(Debug, serde::Deserialize)]
        #[allow(dead_code, reason = "only its type matters")]
        struct Settings {
            a: String,
        }
        let error = from_toml::<Settings>("x.toml", "\na = 1\n", "a text").expect_err("a number");
        assert_eq!(error.place, Place::Line(2));
    }
}
