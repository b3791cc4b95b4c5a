//! Graphs in integers play the problems of the graphs that they were made from.

use std::fs;
use std::path::Path;
use std::process::Command;
use tempfile::TempDir;
use tpg_codegen::quantise::{Request, quantise};
use tpg_graph::import;
use tpg_graph::states::StateSet;

fn mean_score(problem: &str, graph: &Path) -> f64 {
    let mut eval = Command::new(env!("CARGO_BIN_EXE_tpg-train"));
    let graph = graph.display().to_string();
    let output = eval.args(["eval", "--problem", problem, "--tpg", &graph, "--episodes", "20", "--json"]).output();
    let output = output.expect("the program starts");
    assert!(output.status.success(), "{}", String::from_utf8_lossy(&output.stderr));
    let report: serde_json::Value = serde_json::from_slice(&output.stdout).expect("a report");
    report["mean_score"].as_f64().expect("a score")
}

#[test]
fn a_return_is_kept_in_integers() {
    let folder = TempDir::new().expect("a folder");
    for (name, problem, most) in [
        ("cartpole", "cartpole", 0.0),
        ("pendulum", "pendulum", 2.0),
        ("mountain-car-continuous", "mountain-car-continuous", 0.2),
        ("widowx-fs", "fs", 5.0),
    ] {
        let path = format!("{}/../generated/{name}/graph.json", env!("CARGO_MANIFEST_DIR"));
        let graph = import::load(Path::new(&path), None, None).expect("a shipped graph");
        let states = StateSet::sampled(&graph, 100, 1);
        let request = Request::of_bits(16, &states);
        let (whole, _) = quantise(name, &graph, &request).expect("integers");
        let file = folder.path().join(format!("{name}.json"));
        fs::write(&file, whole.to_json()).expect("a file");
        let (float, whole) = (mean_score(problem, Path::new(&path)), mean_score(problem, &file));
        assert!((float - whole).abs() <= most, "{name}: {float} and {whole}");
    }
}
