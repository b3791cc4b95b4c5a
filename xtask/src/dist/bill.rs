//! The bill of materials, in CycloneDX's JSON: every crate that is compiled into what is shipped, with its licence.

use super::{PROGRAMS, STATIC};
use crate::check::cargo;
use serde_json::{Value, json};
use std::collections::BTreeMap;
use std::io;

/// The crate of the libraries.
const LIBRARY: &str = "tpg-runtime-capi";

/// The bill, the same for the same Cargo.lock.
pub(super) fn text() -> io::Result<String> {
    let output = cargo(&["metadata", "--format-version", "1", "--locked", "--filter-platform", STATIC]).output()?;
    if !output.status.success() {
        return Err(io::Error::other(String::from_utf8_lossy(&output.stderr).into_owned()));
    }
    let metadata: Value = serde_json::from_slice(&output.stdout)?;
    let components = components(&metadata);
    let bill = json!({
        "bomFormat": "CycloneDX",
        "specVersion": "1.5",
        "version": 1,
        "metadata": { "component": { "type": "application", "name": "tpg", "version": env!("CARGO_PKG_VERSION") } },
        "components": components,
    });
    Ok(format!("{bill:#}\n"))
}

fn list(value: &Value) -> &[Value] {
    value.as_array().map_or(&[], Vec::as_slice)
}

/// The crates that the shipped ones reach, tests aside, in the order of names.
fn components(metadata: &Value) -> Vec<Value> {
    let packages: BTreeMap<&str, &Value> =
        list(&metadata["packages"]).iter().filter_map(|package| Some((package["id"].as_str()?, package))).collect();
    let nodes: BTreeMap<&str, &Value> =
        list(&metadata["resolve"]["nodes"]).iter().filter_map(|node| Some((node["id"].as_str()?, node))).collect();
    let shipped = |id: &&str| {
        let name = packages[id]["name"].as_str().unwrap_or_default();
        packages[id]["source"].is_null() && (PROGRAMS.contains(&name) || name == LIBRARY)
    };
    let mut open: Vec<&str> = packages.keys().copied().filter(shipped).collect();
    let mut reached = BTreeMap::new();
    while let Some(id) = open.pop() {
        let package = packages[id];
        let text = |key: &str| package[key].as_str().unwrap_or_default();
        let (name, version) = (text("name"), text("version"));
        let component = json!({
            "type": "library",
            "name": name,
            "version": version,
            "purl": format!("pkg:cargo/{name}@{version}"),
            "licenses": [{ "expression": text("license").replace('/', " OR ") }],
        });
        if reached.insert((name, version), component).is_none() {
            let used = |dependency: &&Value| list(&dependency["dep_kinds"]).iter().any(|kind| kind["kind"] != "dev");
            let dependencies = nodes.get(id).map_or(&[][..], |node| list(&node["deps"]));
            open.extend(dependencies.iter().filter(used).filter_map(|dependency| dependency["pkg"].as_str()));
        }
    }
    reached.into_values().collect()
}

#[cfg(test)]
mod tests {
    use serde_json::Value;

    #[test]
    fn what_is_shipped_is_listed_and_what_only_tests_use_is_not() {
        let bill: Value = serde_json::from_str(&super::text().expect("cargo is there")).expect("JSON");
        let has = |name: &str| super::list(&bill["components"]).iter().any(|component| component["name"] == name);
        for name in ["tpg-codegen", "tpg-train", "tpg-runtime-capi", "clap", "serde", "libm", "serde_derive"] {
            assert!(has(name), "{name} is not listed");
        }
        for name in ["proptest", "insta", "assert_cmd", "pyo3", "xtask", "tpg-testing"] {
            assert!(!has(name), "{name} is listed");
        }
        for component in super::list(&bill["components"]) {
            let license = component["licenses"][0]["expression"].as_str().unwrap_or_default();
            assert!(!license.is_empty() && !license.contains('/'), "{component}");
        }
    }
}
