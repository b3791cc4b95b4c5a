//! The rules of the architecture: what no crate may know, however the code grows.

use serde_json::Value;
use std::collections::{BTreeMap, BTreeSet};
use std::fs;
use std::path::{Path, PathBuf};
use std::process::Command;
use tpg_testing::library::top;

/// The crates that know no arm.
const GENERAL: [&str; 4] = ["tpg-runtime", "tpg-graph", "tpg-engine", "tpg-codegen"];

/// The crates that users install or link: none of them knows the shipped policies or the paper.
const PRODUCT: [&str; 14] = [
    "tpg-runtime",
    "tpg-kernels",
    "tpg-arm",
    "tpg-runtime-capi",
    "tpg-graph",
    "tpg-picture",
    "tpg-prove",
    "tpg-codegen",
    "tpg-engine",
    "tpg-nn",
    "tpg-problems",
    "tpg-train",
    "tpg-mpi",
    "tpg-python",
];

/// The workspace's crates: their folders, and the other crates of the workspace that they depend on, tests aside.
pub(crate) fn crates() -> BTreeMap<String, (PathBuf, Vec<String>)> {
    let cargo = std::env::var_os("CARGO").unwrap_or_else(|| "cargo".into());
    let output = Command::new(cargo)
        .args(["metadata", "--format-version", "1", "--no-deps", "--offline"])
        .current_dir(top())
        .output()
        .expect("cargo runs this test");
    let metadata: Value = serde_json::from_slice(&output.stdout).expect("cargo prints JSON");
    let text = |value: &Value| value.as_str().expect("a text").to_owned();
    let package = |package: &Value| {
        let folder = Path::new(&text(&package["manifest_path"])).parent().expect("a folder").to_owned();
        let dependencies = package["dependencies"].as_array().expect("a list").iter();
        let names = dependencies.filter(|of| of["kind"] != "dev" && !of["path"].is_null()).map(|of| text(&of["name"]));
        (text(&package["name"]), (folder, names.collect()))
    };
    metadata["packages"].as_array().expect("a list").iter().map(package).collect()
}

/// Everything that a crate depends on, however far.
fn reach(crates: &BTreeMap<String, (PathBuf, Vec<String>)>, name: &str) -> BTreeSet<String> {
    let mut reached = BTreeSet::new();
    let mut open = vec![name.to_owned()];
    while let Some(name) = open.pop() {
        for next in crates.get(&name).map(|(_, next)| next.clone()).unwrap_or_default() {
            if reached.insert(next.clone()) {
                open.push(next);
            }
        }
    }
    reached
}

/// The Rust sources and templates below a folder.
fn sources(folder: &Path) -> Vec<PathBuf> {
    let mut files = Vec::new();
    for entry in fs::read_dir(folder).into_iter().flatten().flatten() {
        let path = entry.path();
        if path.is_dir() {
            files.extend(sources(&path));
        } else {
            files.push(path);
        }
    }
    files
}

/// The lines of code below a folder that hold one of the words; comments and test modules aside.
fn lines_with(folder: &Path, words: &[&str]) -> Vec<String> {
    let mut found = Vec::new();
    for path in sources(folder) {
        let text = fs::read_to_string(&path).unwrap_or_default();
        let code = text.split("#[cfg(test)]").next().unwrap_or_default();
        for (number, line) in (1..).zip(code.lines()) {
            if !line.trim_start().starts_with("//") && words.iter().any(|word| line.contains(word)) {
                found.push(format!("{}:{number}: {}", path.display(), line.trim()));
            }
        }
    }
    found
}

#[test]
fn general_crates_know_no_arm() {
    let crates = crates();
    for name in GENERAL {
        assert!(crates.contains_key(name), "{name} is no crate of the workspace any more");
        let reached = reach(&crates, name);
        assert!(!reached.contains("tpg-arm") && !reached.contains("tpg-problems"), "{name} depends on {reached:?}");
        let words = ["tpg_arm", "WIDOWX", "Pose", "Arm<", "JOINTS"];
        let lines = lines_with(&crates[name].0.join("src"), &words);
        assert!(lines.is_empty(), "{name} names the arm:\n{}", lines.join("\n"));
    }
}

#[test]
fn the_prover_shares_nothing_with_what_it_checks() {
    let crates = crates();
    assert!(crates["tpg-prove"].1.is_empty(), "tpg-prove depends on {:?}", crates["tpg-prove"].1);
}

#[test]
fn the_product_knows_neither_its_own_output_nor_the_paper() {
    let crates = crates();
    for name in PRODUCT {
        assert!(crates.contains_key(name), "{name} is no crate of the workspace any more");
        for never in ["tpg-generated", "tpg-paper", "tpg-benches", "tpg-harness"] {
            assert!(!reach(&crates, name).contains(never), "{name} depends on {never}");
        }
    }
}

#[test]
fn no_shipped_default_is_a_path_of_the_maintainers() {
    let crates = crates();
    for name in PRODUCT.into_iter().chain(["tpg-paper"]) {
        let lines = lines_with(&crates[name].0.join("src"), &["../shared"]);
        assert!(lines.is_empty(), "{name} names a folder outside of the repository:\n{}", lines.join("\n"));
    }
}

/// Parts of the trainer that know problems by their environments only.
const OF_ANY_PROBLEM: [&str; 3] = ["hybrid", "evaluate", "report"];

#[test]
fn what_works_on_any_problem_knows_neither_the_arm_nor_the_paper() {
    let train = crates()["tpg-train"].0.join("src");
    for part in OF_ANY_PROBLEM {
        let words = ["tpg_arm", "WIDOWX", "Pose", "JOINTS", "arm::", "PAPER", "paper", "nbItGoBack", "sepDistance"];
        let mut lines = lines_with(&train.join(part), &words);
        // The seed of the committed test tasks is that of reports.
        lines.retain(|line| !line.contains("TEST_SEED"));
        assert!(lines.is_empty(), "{part}/ names the arm or the paper:\n{}", lines.join("\n"));
    }
}

#[test]
fn no_template_of_the_product_names_the_paper() {
    let crates = crates();
    for name in PRODUCT {
        let lines = lines_with(&crates[name].0.join("templates"), &["the paper", "armlearn", "nbItGoBack"]);
        assert!(lines.is_empty(), "{name} names the paper:\n{}", lines.join("\n"));
    }
}

#[test]
fn soft_actor_critics_know_the_environment_and_no_arm() {
    let folder = crates()["tpg-train"].0.join("src/sac");
    let lines = lines_with(&folder, &["tpg_arm", "WIDOWX", "arm::ik", "JOINTS"]);
    assert!(lines.is_empty(), "sac/ names the arm:\n{}", lines.join("\n"));
    assert!(!lines_with(&folder, &["Environment"]).is_empty(), "sac/ does not use the environment");
}
