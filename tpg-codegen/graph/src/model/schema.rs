//! The JSON Schema of `graph.json`.

use super::document::Document;

/// Returns the schema as text, the same for the same version of this crate. It is committed as `graph.schema.json`.
pub fn schema() -> String {
    let schema = schemars::schema_for!(Document);
    let mut text = serde_json::to_string_pretty(&schema).expect("a schema has only strings as keys");
    text.push('\n');
    text
}
