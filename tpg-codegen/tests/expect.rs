//! `tpg-codegen verify --expect`: a recording of another tool finds a wrong description of its graph.

use assert_cmd::Command;
use std::fmt::Write as _;
use std::fs;
use std::path::Path;
use tpg_graph::import::{self, Sidecar};
use tpg_graph::{Graph, interpret, states};

const STATES: usize = 200;

/// A graph, and what its interpreter answers: as if another tool had recorded it.
fn recorded(graph: &Graph) -> String {
    let states = states::sample_in_range(graph, STATES, 1);
    let names: Vec<String> = graph.inputs().map(|input| graph.input_name(input)).collect();
    let mut text = format!("{},action\n", names.join(","));
    for (state, action) in states.chunks_exact(graph.state_length()).zip(interpret::actions(graph, &states)) {
        for value in state {
            let _ = write!(text, "{value:?},");
        }
        let _ = writeln!(text, "{}", action.0);
    }
    text
}

/// Runs `verify --expect` and returns its exit status and its first line.
fn verify(folder: &Path, sidecar: &str, options: &[&str]) -> (Option<i32>, String) {
    fs::write(folder.join("x.toml"), sidecar).expect("written");
    let mut command = Command::cargo_bin("tpg-codegen").expect("the program is built");
    command.current_dir(folder).args(["verify", "x.dot", "--sidecar", "x.toml", "--expect", "x.csv"]);
    command.args(["--lang", "c", "--profile", "fast", "--states", "100"]).args(options);
    let output = command.output().expect("it starts");
    let said = String::from_utf8([output.stdout, output.stderr].concat()).expect("text");
    (output.status.code(), said.lines().next().unwrap_or_default().to_owned())
}

#[test]
fn a_wrong_sidecar_is_found() {
    let (text, sidecar) = (include_str!("fixtures/pole.dot"), include_str!("fixtures/pole.toml"));
    let described = Sidecar::from_toml("x.toml", sidecar).expect("a sidecar");
    let graph = import::from_text("x.dot", text, Some(&described)).expect("a graph");
    let folder = tempfile::tempdir().expect("a folder");
    fs::write(folder.path().join("x.dot"), text).expect("written");
    fs::write(folder.path().join("x.csv"), recorded(&graph)).expect("written");
    assert_eq!(verify(folder.path(), sidecar, &[]), (Some(0), "interpreter = x.csv on 200 states".to_owned()));
    assert_eq!(verify(folder.path(), sidecar, &["--quiet"]), (Some(0), String::new()));

    let reordered = sidecar.replace(r#""sub", "add""#, r#""add", "sub""#);
    assert_ne!(reordered, sidecar);
    for options in [&[][..], &["--quiet"]] {
        let (code, said) = verify(folder.path(), &reordered, options);
        assert_eq!(code, Some(1), "{said}");
        assert!(
            said.starts_with("interpreter differs from x.csv on ") && said.contains(" of 200 states; the first, line ")
        );
    }

    let without = recorded(&graph).replace("action", "act");
    fs::write(folder.path().join("x.csv"), without).expect("written");
    let (code, said) = verify(folder.path(), sidecar, &[]);
    assert_eq!(code, Some(2), "{said}");
}

#[test]
fn an_example_of_a_sidecar_is_printed() {
    let mut command = Command::cargo_bin("tpg-codegen").expect("the program is built");
    let output = command.args(["sidecar"]).output().expect("it starts");
    let text = String::from_utf8(output.stdout).expect("text");
    Sidecar::from_toml("printed", &text).expect("a sidecar");
}
