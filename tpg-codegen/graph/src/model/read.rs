//! Reading `graph.json`, with errors by line and column or by JSON path.

use super::document::{Document, VERSIONS};
use super::graph::Graph;
use crate::error::{InputError, Place, serde_message};

/// The accepted form, where nothing more specific can be said.
const SCHEMA: &str = "what `tpg-codegen schema` describes";

impl Graph {
    /// Reads `graph.json`.
    ///
    /// ```
    /// use tpg_graph::Graph;
    ///
    /// let text = r#"{
    ///     "format": "tpg-graph", "version": 1, "scalar": "f32", "maths": "own", "registers": 1,
    ///     "sources": [{ "name": "x", "length": 1, "unit": "mm", "ranges": [[-1, 1]] }],
    ///     "instructions": ["add"],
    ///     "actions": [{ "id": 0, "name": "left" }, { "id": 1, "name": "right" }],
    ///     "root": 0,
    ///     "teams": [{ "id": 0, "edges": [{ "program": 0, "action": 0 }, { "program": 1, "action": 1 }] }],
    ///     "programs": [
    ///         { "id": 0, "lines": [] },
    ///         { "id": 1, "lines": [{ "to": 0, "op": "add", "args": ["r0", "x[0]"] }] }
    ///     ]
    /// }"#;
    /// let graph = Graph::from_json("small.json", text)?;
    /// assert_eq!((graph.teams().len(), graph.programs().len()), (1, 2));
    ///
    /// let error = Graph::from_json("small.json", &text.replace("x[0]", "y[0]")).expect_err("there is no source y");
    /// assert_eq!(error.found, "unknown source \"y\"");
    /// # Ok::<(), tpg_graph::error::InputError>(())
    /// ```
    ///
    /// # Errors
    /// Any error: by line and column if the text is not JSON, by JSON path if its content is wrong.
    pub fn from_json(file: &str, text: &str) -> Result<Self, InputError> {
        let mut deserializer = serde_json::Deserializer::from_str(text);
        let document: Document = serde_path_to_error::deserialize(&mut deserializer).map_err(|error| {
            let path = match error.path().to_string().as_str() {
                "." => "$".to_owned(),
                path => format!("$.{path}"),
            };
            json_error(file, text, path, error.inner())
        })?;
        deserializer.end().map_err(|error| not_json(file, &error))?;
        Self::from_document(file, document)
    }
}

/// Explains why the text is not a document: by path if it is JSON, otherwise by line and column.
///
/// A wrong version is reported first, since other versions may have any fields.
fn json_error(file: &str, text: &str, path: String, error: &serde_json::Error) -> InputError {
    #[derive(serde::Deserialize)]
    struct VersionHeader {
        version: u64,
    }
    if let Ok(VersionHeader { version }) = serde_json::from_str(text)
        && !VERSIONS.iter().any(|&known| u64::from(known) == version)
    {
        return other_version(file, version);
    }
    let message = error.to_string();
    let (found, accepted) = serde_message(&message);
    if error.is_data() {
        return InputError::new(file, Place::Path(path), found, accepted.unwrap_or(SCHEMA));
    }
    if message.starts_with("number out of range") {
        return InputError::new(file, Place::Path(path), found, format!("a magnitude of at most {:e}", f64::MAX));
    }
    not_json(file, error)
}

pub(super) fn other_version(file: &str, version: u64) -> InputError {
    let accepted =
        format!("{}, the versions this tool knows", VERSIONS.map(|version| version.to_string()).join(" or "));
    InputError::new(file, Place::Path("$.version".to_owned()), version.to_string(), accepted)
}

fn not_json(file: &str, error: &serde_json::Error) -> InputError {
    let place = Place::Column(error.line(), error.column());
    let message = error.to_string();
    let message = message.rsplit_once(" at line ").map_or(message.as_str(), |(message, _)| message);
    let found = if error.is_eof() { "the file ends here, unfinished" } else { message };
    InputError::new(file, place, format!("not JSON: {found}"), SCHEMA)
}
