//! The book's page of configurations, made from the program's types.

use crate::configuration::schema::{description, properties, resolved, schema};
use crate::evolution::config::EvolutionConfig;
use crate::sac::config::SacConfig;
use schemars::JsonSchema;
use serde_json::Value;
use std::fmt::Write as _;
use tpg_problems::arm::arms::ARMS;
use tpg_problems::{acrobot, arm, cartpole, dodge, mountain_car, mountain_car_continuous, pendulum};
use tpg_testing::book::page;

const HEAD: &str = "| key | type | default | meaning |\n| --- | --- | --- | --- |\n";

#[test]
fn the_page_of_configurations_is_fresh() {
    let mut text = "# Configuration

Every setting, made from the program's types by a test; do not edit. `--preset NAME`, `--config FILE` and `--set KEY=VALUE` of
`tpg-train tpg` and `sac` change each other in this order, and a file may have one line. `tpg-train config NAME` prints a preset with
comments, `tpg-train config --schema` a schema for editors. An unknown key, a value out of range and a contradiction are refused with
their place and what is accepted.
"
    .to_owned();
    text += "\n## `tpg-train tpg`\n\nThe default is the preset `thorough`; others are `quick` and `gegelati`.\n";
    tables::<EvolutionConfig>(&mut text);
    text += "\n## `tpg-train sac`\n";
    tables::<SacConfig>(&mut text);

    text += "\n## The section `[problem]`\n\n`name` is the problem's, as `tpg-train problems` lists them. Its other keys:\n";
    problem::<cartpole::Config>(&mut text, "cartpole");
    problem::<acrobot::Config>(&mut text, "acrobot");
    problem::<mountain_car::Config>(&mut text, "mountain-car");
    problem::<mountain_car_continuous::Config>(&mut text, "mountain-car-continuous");
    problem::<pendulum::Config>(&mut text, "pendulum");
    problem::<arm::Config>(&mut text, "fs` and `rs` with `tpg");
    let names = ARMS.map(|arm| format!("`\"{}\"`", arm.name)).join(", ");
    let _ = write!(text, "\nIn the place of the section, `arm` may be a name: {names}.\n");
    problem::<arm::motors::Config>(&mut text, "fs` and `rs` with `sac");
    problem::<dodge::Config>(&mut text, "dodge");
    page("configuration.md", &text);
}

fn problem<T: JsonSchema>(text: &mut String, name: &str) {
    let _ = write!(text, "\n### `{name}`\n\n{HEAD}");
    let schema = schema::<T>();
    rows(text, &schema, &schema, "", false);
}

/// Writes a table for each section.
fn tables<T: JsonSchema>(text: &mut String) {
    let schema = schema::<T>();
    for (section, value) in properties(&schema).filter(|&(section, _)| section != "problem") {
        let description = description(&schema, value);
        let _ = write!(text, "\n### `[{section}]`\n\n{description}\n\n{HEAD}");
        rows(text, &schema, resolved(&schema, value), "", true);
    }
}

/// Writes a row for each key; those of tables inside have a dot.
fn rows(text: &mut String, schema: &Value, value: &Value, before: &str, section: bool) {
    let required: Vec<&str> = value["required"].as_array().into_iter().flatten().filter_map(Value::as_str).collect();
    for (key, property) in properties(value) {
        let inner = resolved(schema, property);
        let meaning = description(schema, property).replace('|', "\\|");
        if inner.get("properties").is_some() && !section {
            rows(text, schema, inner, &format!("{before}{key}."), false);
            continue;
        }
        let default = match &property["default"] {
            Value::Null if required.contains(&key) => "must be given".to_owned(),
            Value::Null => "left out".to_owned(),
            value => format!("`{value}`"),
        };
        let _ = writeln!(
            text,
            "| `{before}{key}` | {} | {default} | {meaning} |",
            kind(schema, property).replace('|', "\\|")
        );
    }
}

/// Names a type.
fn kind(schema: &Value, value: &Value) -> String {
    let value = resolved(schema, value);
    let choices = |key: &str| {
        value[key].as_array().map(|all| all.iter().map(|one| kind(schema, one)).collect::<Vec<_>>().join(" or "))
    };
    if let Some(constant) = value["const"].as_str() {
        return format!("`\"{constant}\"`");
    }
    if let Some(all) = value["enum"].as_array() {
        return all.iter().map(|one| format!("`{one}`")).collect::<Vec<_>>().join(" or ");
    }
    if let Some(choices) = choices("oneOf").or_else(|| choices("anyOf")) {
        return choices;
    }
    let name = match &value["type"] {
        Value::Array(all) => all.iter().filter_map(Value::as_str).find(|name| *name != "null").unwrap_or_default(),
        one => one.as_str().unwrap_or_default(),
    };
    match name {
        "integer" => "whole number".to_owned(),
        "boolean" => "true or false".to_owned(),
        "string" => "text".to_owned(),
        "object" => "table".to_owned(),
        "array" => match value["maxItems"].as_u64() {
            Some(length) => format!("[{}]", vec![kind(schema, &value["items"]); length as usize].join(", ")),
            None => format!("list of {}", kind(schema, &value["items"])),
        },
        other => other.to_owned(),
    }
}
