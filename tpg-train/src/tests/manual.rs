//! The book's page of configurations, made from the program's types.

use crate::configuration::schema::{description, properties, resolved, schema};
use crate::evolution::config::EvolutionConfig;
use crate::sac::config::SacConfig;
use schemars::JsonSchema;
use serde_json::Value;
use std::fmt::Write as _;
use tpg_problems::arm::arms::ARMS;
use tpg_problems::varied::VariedSettings;
use tpg_problems::{acrobot, arm, cartpole, dodge, mountain_car, mountain_car_continuous, pendulum};
use tpg_testing::book::page;

const HEAD: &str = "| key | type | default | meaning |\n| --- | --- | --- | --- |\n";

#[test]
fn the_page_of_configurations_is_fresh() {
    let mut text = "# Configuration

You want to change a setting. `tpg-train tpg` and `sac` take `--preset NAME`, `--config FILE` and `--set KEY=VALUE`; later ones override
earlier ones in this order. Unknown keys, values out of range and contradictions are refused with their place and what is accepted.
`tpg-train config NAME` prints a preset with comments, `tpg-train config --schema` a schema for editors. A test writes this page from the
program's types: do not edit it.

## `tpg-train tpg`

The default is the preset `thorough`; `tpg-train config --list` names the others.

"
    .to_owned();
    sections::<EvolutionConfig>(&mut text);
    text += "\n## `tpg-train sac`\n\nEvery setting comes from a preset: `tpg-train config --list`.\n\n";
    sections::<SacConfig>(&mut text);

    text += "\n## The section `[problem]`\n\n`name` is the problem's, as `tpg-train problems` lists them. Its other keys:\n";
    problem::<VariedSettings<cartpole::Amounts>>(
        &mut text,
        "CartPole, Acrobot, MountainCar and Pendulum",
        is_disturbance,
    );
    text += "\nEach `physics` is a number, or `[low, high]`, from which each episode draws.\n";
    problem::<VariedSettings<cartpole::Amounts>>(&mut text, "`cartpole`", is_own);
    problem::<VariedSettings<acrobot::Amounts>>(&mut text, "`acrobot`", is_own);
    problem::<VariedSettings<mountain_car::Amounts>>(&mut text, "`mountain-car`", is_own);
    problem::<VariedSettings<mountain_car_continuous::Amounts>>(&mut text, "`mountain-car-continuous`", is_own);
    problem::<pendulum::PendulumConfig>(&mut text, "`pendulum`", is_own);
    problem::<arm::ArmConfig>(&mut text, "`fs` and `rs` with `tpg`", is_own);
    problem::<arm::motors::MotorsConfig>(&mut text, "`fs` and `rs` with `sac`", is_own);
    problem::<arm::ArmConfig>(&mut text, "The arm of `fs` and `rs`", is_arm);
    let names = ARMS.map(|arm| format!("`\"{}\"`", arm.name)).join(", ");
    let _ = write!(text, "\nLengths are in mm. Instead of the section, `arm` may be a name: {names}.\n");
    problem::<dodge::DodgeConfig>(&mut text, "`dodge`", is_own);
    page("configuration.md", &text);
}

/// Tests for a key that several problems have alike.
fn is_disturbance(key: &str) -> bool {
    key.starts_with("disturbance.")
}

/// Tests for a key that describes an arm.
fn is_arm(key: &str) -> bool {
    key.starts_with("arm.")
}

/// Tests for a key that only one problem has.
fn is_own(key: &str) -> bool {
    !is_disturbance(key) && !is_arm(key)
}

fn problem<T: JsonSchema>(text: &mut String, title: &str, is_shown: fn(&str) -> bool) {
    let _ = write!(text, "\n### {title}\n\n{HEAD}");
    let schema = schema::<T>();
    let mut all = Vec::new();
    rows(&mut all, &schema, &schema, "");
    all.iter().filter(|row| is_shown(&row.0)).for_each(|(_, row)| text.push_str(row));
}

/// Writes a table with a row for each section and for each of its keys.
fn sections<T: JsonSchema>(text: &mut String) {
    text.push_str(HEAD);
    let schema = schema::<T>();
    for (section, value) in properties(&schema).filter(|&(section, _)| section != "problem") {
        let _ = writeln!(text, "| **`[{section}]`** | | | {} |", description(&schema, value));
        let mut all = Vec::new();
        rows(&mut all, &schema, resolved(&schema, value), &format!("{section}."));
        all.iter().for_each(|(_, row)| text.push_str(row));
    }
}

/// Adds a row for each key, with the key; those of tables inside have a dot.
fn rows(all: &mut Vec<(String, String)>, schema: &Value, value: &Value, before: &str) {
    let required: Vec<&str> = value["required"].as_array().into_iter().flatten().filter_map(Value::as_str).collect();
    for (key, property) in properties(value) {
        let name = format!("{before}{key}");
        let inner = resolved(schema, property);
        if inner.get("properties").is_some() {
            rows(all, schema, inner, &format!("{name}."));
            continue;
        }
        let default = match &property["default"] {
            Value::Null if required.contains(&key) => "required".to_owned(),
            Value::Null => "–".to_owned(),
            value => format!("`{value}`"),
        };
        let [kind, meaning] =
            [kind(schema, property), description(schema, property)].map(|text| text.replace('|', "\\|"));
        let row = format!("| `{name}` | {kind} | {default} | {meaning} |\n");
        all.push((name, row));
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
        "object" => "table".to_owned(),
        "array" => match value["maxItems"].as_u64() {
            Some(length) => format!("[{}; {length}]", kind(schema, &value["items"])),
            None => format!("list of {}s", kind(schema, &value["items"])),
        },
        other => other.to_owned(),
    }
}
