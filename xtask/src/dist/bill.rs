//! The bill of materials, in CycloneDX's JSON: every crate that is compiled into what is shipped, and the standard library, with
//! licences.

use super::{PROGRAMS, STATIC};
use serde_json::{Value, json};
use std::collections::BTreeMap;
use std::io;
use std::process::Command;
use tpg_testing::library::{self, cargo};

/// The crate of the libraries.
const LIBRARY: &str = "tpg-runtime-capi";

/// The bill, the same for the same Cargo.lock.
pub(super) fn text() -> io::Result<String> {
    let mut components = tree(&PROGRAMS, STATIC)?;
    for target in library::TARGETS.into_iter().chain([library::host()]) {
        components.extend(tree(&[LIBRARY], target)?);
    }
    let components: Vec<Value> = components.into_values().chain([standard_library()?]).collect();
    let bill = json!({
        "bomFormat": "CycloneDX",
        "specVersion": "1.5",
        "version": 1,
        "metadata": { "component": { "type": "application", "name": "tpg", "version": env!("CARGO_PKG_VERSION") } },
        "components": components,
    });
    Ok(format!("{bill:#}\n"))
}

/// The crates of a build of packages for a target, with the features that it turns on, by name and version: tests aside, what runs
/// while compiling included.
fn tree(packages: &[&str], target: &str) -> io::Result<BTreeMap<(String, String), Value>> {
    let mut command =
        cargo(&["tree", "--locked", "--edges", "normal,build", "--prefix", "none", "--format", "{p}|{l}"]);
    command.args(["--target", target]);
    packages.iter().for_each(|package| {
        command.args(["--package", package]);
    });
    let output = command.output()?;
    if !output.status.success() {
        return Err(io::Error::other(String::from_utf8_lossy(&output.stderr).into_owned()));
    }
    let mut components = BTreeMap::new();
    for line in String::from_utf8_lossy(&output.stdout).lines().filter(|line| !line.is_empty()) {
        let read = line.split_once('|').and_then(|(package, license)| {
            let (name, rest) = package.split_once(" v")?;
            // A star follows a crate that was listed before.
            Some((name, rest.split(' ').next()?, license.trim_end_matches(" (*)")))
        });
        let (name, version, license) = read.ok_or_else(|| io::Error::other(format!("cargo tree says {line:?}")))?;
        let component = json!({
            "type": "library",
            "name": name,
            "version": version,
            "purl": format!("pkg:cargo/{name}@{version}"),
            "licenses": [{ "expression": license.replace('/', " OR ") }],
        });
        components.insert((name.to_owned(), version.to_owned()), component);
    }
    Ok(components)
}

/// Rust's own library, which is in every program and archive. The static programs' C library comes with it.
fn standard_library() -> io::Result<Value> {
    let output = Command::new("rustc").current_dir(library::top()).arg("--version").output()?;
    let text = String::from_utf8_lossy(&output.stdout).into_owned();
    let version = text.split(' ').nth(1).filter(|_| output.status.success());
    let version = version.ok_or_else(|| io::Error::other("rustc says no version"))?;
    Ok(json!({
        "type": "library",
        "name": "rust-std",
        "version": version,
        "description": "Rust's standard library; in static programs also musl (MIT), which comes with it",
        "purl": format!("pkg:generic/rust-std@{version}"),
        "licenses": [{ "expression": "MIT OR Apache-2.0" }],
    }))
}

#[cfg(test)]
mod tests {
    use serde_json::Value;

    fn list(value: &Value) -> &[Value] {
        value.as_array().map_or(&[], Vec::as_slice)
    }

    #[test]
    fn what_is_shipped_is_listed_and_what_only_tests_use_is_not() {
        let bill: Value = serde_json::from_str(&super::text().expect("cargo is there")).expect("JSON");
        let has = |name: &str| list(&bill["components"]).iter().any(|component| component["name"] == name);
        for name in
            ["tpg-codegen", "tpg-train", "tpg-runtime-capi", "clap", "serde", "libm", "serde_derive", "rust-std"]
        {
            assert!(has(name), "{name} is not listed");
        }
        for name in ["proptest", "insta", "assert_cmd", "pyo3", "xtask", "tpg-testing", "glam"] {
            assert!(!has(name), "{name} is listed");
        }
        for component in list(&bill["components"]) {
            let license = component["licenses"][0]["expression"].as_str().unwrap_or_default();
            assert!(!license.is_empty() && !license.contains('/'), "{component}");
        }
    }
}
