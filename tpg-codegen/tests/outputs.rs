//! Policies with outputs: their code, their reports and their formulas, as a user sees them.

use assert_cmd::Command;
use std::fs;
use tempfile::TempDir;
use tpg_codegen::emit;
use tpg_codegen::emit::{Language, Options, Profile};
use tpg_codegen::report::explain;
use tpg_graph::Graph;

/// A controller of a pendulum: an energy pump far from the top, a linear law near it.
const SWING_UP: &str = include_str!("fixtures/swing_up.json");
/// The linear law alone.
const FORMULA: &str = include_str!("fixtures/formula.json");

fn graph(text: &str) -> Graph {
    Graph::from_json("fixture", text).unwrap_or_else(|error| panic!("{error}"))
}

fn options(profile: Profile) -> Options {
    Options { profile: Some(profile), ..Options::new("swing".parse().expect("a prefix")) }
}

fn c(text: &str, profile: Profile) -> String {
    let files = emit::emit(&graph(text), Language::C, &options(profile));
    files.into_iter().map(|file| format!("{}\n{}\n", file.name, file.text)).collect()
}

#[test]
fn a_formula_is_straight_code_in_every_profile() {
    insta::assert_snapshot!("formula.c", c(FORMULA, Profile::Fast));
    for profile in Profile::ALL {
        let text = c(FORMULA, profile);
        let body = text.split_once("void swing_infer(").expect("an entry point").1;
        let body = body.split_once("void swing_infer(").expect("after the declaration, the definition").1;
        let body = body.split_once("\n}\n").expect("an end").0;
        assert!(!["if ", "for ", "switch ", "goto "].iter().any(|word| body.contains(word)), "{profile:?}: {body}");
    }
}

#[test]
fn leaves_are_computed_where_the_walk_ends() {
    insta::assert_snapshot!("swing_up.c", c(SWING_UP, Profile::Fast));
}

#[test]
fn a_policy_is_explained_as_formulas() {
    insta::assert_snapshot!("swing_up.txt", explain(&graph(SWING_UP), &options(Profile::Fast)));
}

fn tpg_codegen() -> Command {
    Command::cargo_bin("tpg-codegen").expect("the program is built")
}

#[test]
fn generate_proves_the_values_it_wrote() {
    let folder = TempDir::new().expect("a temporary folder");
    fs::write(folder.path().join("swing.json"), SWING_UP).expect("writable");
    let output = tpg_codegen().current_dir(folder.path()).arg("swing.json").output().expect("it runs");
    let text = String::from_utf8_lossy(&output.stdout).into_owned() + &String::from_utf8_lossy(&output.stderr);
    assert!(output.status.success(), "{text}");
    assert!(text.contains("C, fast = interpreter") && text.contains("Rust, constant-time = interpreter"), "{text}");
}

#[test]
fn what_has_no_outputs_says_so() {
    let folder = TempDir::new().expect("a temporary folder");
    fs::write(folder.path().join("swing.json"), SWING_UP).expect("writable");
    let output = tpg_codegen().current_dir(folder.path()).args(["swing.json", "--style", "gegelati"]).output();
    let output = output.expect("it runs");
    let text = String::from_utf8_lossy(&output.stderr).into_owned();
    assert_eq!(output.status.code(), Some(2), "{text}");
    assert!(text.contains("--style gegelati for a policy with outputs"), "{text}");
    assert_eq!(fs::read_dir(folder.path()).expect("readable").count(), 1, "nothing was written");
}
