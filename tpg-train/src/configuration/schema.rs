//! Settings with their descriptions, which the comments of their types contain: the one text of each.

use schemars::{JsonSchema, schema_for};
use serde_json::Value;
use std::fmt::Write as _;

/// Width of comments.
const WIDTH: usize = 100;

/// Returns the JSON Schema of a configuration, for editors.
pub(crate) fn schema<C: JsonSchema>() -> Value {
    schema_for!(C).to_value()
}

/// Returns the properties of an object's schema, in order.
pub(crate) fn properties(value: &Value) -> impl Iterator<Item = (&str, &Value)> {
    value["properties"].as_object().into_iter().flatten().map(|(key, value)| (key.as_str(), value))
}

/// Returns the definition that a schema refers to; of one or none, that of one.
pub(crate) fn resolved<'a>(schema: &'a Value, value: &'a Value) -> &'a Value {
    if let Some(reference) = value["$ref"].as_str() {
        return schema.pointer(reference.trim_start_matches('#')).unwrap_or(value);
    }
    let all = value["anyOf"].as_array().filter(|all| all.iter().any(|it| it["type"] == "null"));
    let some = all.and_then(|all| all.iter().find(|it| it["type"] != "null"));
    some.map_or(value, |some| resolved(schema, some))
}

/// Returns the description of a setting in one line, with those of the names that it may be.
pub(crate) fn description(schema: &Value, property: &Value) -> String {
    let inner = resolved(schema, property);
    let text = |value: &Value| value["description"].as_str().map(str::to_owned);
    let mut all = text(property).or_else(|| text(inner)).unwrap_or_default();
    for choice in inner["oneOf"].as_array().into_iter().flatten() {
        if let (Some(name), Some(about)) = (choice["const"].as_str(), text(choice)) {
            let _ = write!(all, " `{name}`: {about}");
        }
    }
    all.split_whitespace().collect::<Vec<_>>().join(" ")
}

/// Returns settings as TOML, each with its description as a comment.
pub(crate) fn commented(schema: &Value, table: &toml::Table) -> String {
    let mut text = String::new();
    for (section, property) in properties(schema) {
        let Some(toml::Value::Table(values)) = table.get(section) else { continue };
        comment(&mut text, &description(schema, property));
        let _ = writeln!(text, "[{section}]");
        for (key, value) in values {
            let known = resolved(schema, property)["properties"].get(key);
            known.into_iter().for_each(|known| comment(&mut text, &description(schema, known)));
            let _ = writeln!(text, "{key} = {value}");
        }
        text.push('\n');
    }
    text.truncate(text.trim_end().len());
    text + "\n"
}

fn comment(text: &mut String, description: &str) {
    let mut line = String::from("#");
    for word in description.split_whitespace() {
        if line.len() + word.len() >= WIDTH {
            let _ = writeln!(text, "{line}");
            line = String::from("#");
        }
        let _ = write!(line, " {word}");
    }
    let _ = writeln!(text, "{line}");
}
