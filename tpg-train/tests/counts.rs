//! Graphs in integers play the problems of the graphs that they were made from.

use assert_cmd::assert::Assert;
use std::fs;
use std::path::Path;
use std::process::Command;
use tempfile::TempDir;
use tpg_codegen::quantise::{self, Request};
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
        let path = generated(&format!("{name}/graph.json"));
        let graph = import::load(Path::new(&path), None, None).expect("a shipped graph");
        let states = StateSet::sampled(&graph, 100, 1);
        let request = Request::of_bits(16, &states);
        let (whole, _) = quantise::quantise(name, &graph, &request).expect("integers");
        let file = folder.path().join(format!("{name}.json"));
        fs::write(&file, whole.to_json()).expect("a file");
        let (float, whole) = (mean_score(problem, Path::new(&path)), mean_score(problem, &file));
        assert!((float - whole).abs() <= most, "{name}: {float} and {whole}");
    }
}

fn quantise(arguments: &[&str]) -> Assert {
    assert_cmd::Command::new(env!("CARGO_BIN_EXE_tpg-train")).arg("quantise").args(arguments).assert()
}

fn generated(name: &str) -> String {
    format!("{}/../generated/{name}", env!("CARGO_MANIFEST_DIR"))
}

#[test]
fn a_graph_has_the_fewest_bits_that_keep_its_return() {
    let folder = TempDir::new().expect("a folder");
    for (name, bits, tried) in [
        ("cartpole", 8, "8 bits   500.00"),
        // A gain that is a little too low does not climb the hill.
        ("mountain-car-continuous", 12, "  10 bits  "),
    ] {
        let file = folder.path().join(name);
        let out = file.display().to_string();
        let graph = generated(&format!("{name}/graph.json"));
        let said = quantise(&[&graph, "--out", &out, "--episodes", "40"]).success();
        let said = String::from_utf8_lossy(&said.get_output().stdout).into_owned();
        for part in [
            &format!("{bits}-bit inputs, {bits}-bit weights; 0 weights were rounded to 0\n"),
            "states that the integers visit\n",
            "0.000 % of states have a value beyond its counts\nmean return of 40 episodes\n  floats ",
            tried,
            &format!("with {bits} bits, it is at most one standard error lower"),
        ] {
            assert!(said.contains(part), "{part}: {said}");
        }
        let text = fs::read_to_string(&file).expect("a graph");
        assert!(text.contains(&format!("\"bits\":{bits}")));
        assert!((mean_score(name, Path::new(&graph)) - mean_score(name, &file)).abs() < 0.1);
        let again = quantise(&[&out, "--out", "new.json"]).code(2);
        let error = String::from_utf8_lossy(&again.get_output().stderr).into_owned();
        assert!(error.contains("in counts; accepted: values"), "{error}");
    }
}

#[test]
fn a_memory_is_kept_in_integers_too() {
    let folder = TempDir::new().expect("a folder");
    let [run, out] = ["run", "whole.json"].map(|name| folder.path().join(name).display().to_string());
    let mut train = assert_cmd::Command::new(env!("CARGO_BIN_EXE_tpg-train"));
    train.args(["tpg", "--problem", "pendulum", "--set", "language.memory=2", "--seed", "1", "--out", &run]);
    train.args(["--preset", "quick", "--max-steps", "300000"]).assert().success();
    let graph = format!("{run}/graph.json");
    quantise(&[&graph, "--out", &out, "--bits", "16", "--episodes", "40"]).success();
    assert!(fs::read_to_string(&out).expect("a graph").contains("\"memory\": ["));
    let [float, whole] = [&graph, &out].map(|file| mean_score("pendulum", Path::new(file)));
    assert!((float - whole).abs() < 0.02 * float.abs(), "{float} and {whole}");
}

#[test]
fn bits_that_are_asked_for_are_taken_whatever_they_lose() {
    let folder = TempDir::new().expect("a folder");
    let config = folder.path().join("slow.toml");
    fs::write(&config, "[problem]\nname = \"pendulum\"\n[problem.physics]\ngravity = 5.0\n").expect("a file");
    let [out, config] = [folder.path().join("two.json"), config].map(|path| path.display().to_string());
    let graph = generated("pendulum/graph.json");
    let asked = ["--problem", "pendulum", "--config", &config, "--bits", "2", "--episodes", "20", "--seed", "2"];
    let said = quantise(&[&[&graph[..], "--out", &out], &asked[..]].concat()).success();
    let said = String::from_utf8_lossy(&said.get_output().stdout).into_owned();
    assert!(said.contains("torque differs by") && !said.contains("8 bits"), "{said}");
    assert!(said.contains("with 2 bits, it is more than one standard error lower"), "{said}");
}

#[test]
fn what_cannot_be_put_into_integers_is_refused_with_the_reason() {
    let [graph, arm] = ["cartpole", "widowx-fs"].map(|name| generated(&format!("{name}/graph.json")));
    let (network, integers) = (generated("widowx-sac/policy.safetensors"), generated("widowx-sac/policy.q.json"));
    let folder = TempDir::new().expect("a folder");
    let out = folder.path().join("whole.json").display().to_string();
    for (arguments, found) in [
        (&[&graph[..], "--out", &graph][..], "the policy itself as --out; accepted: another file"),
        (&[&graph, "--out", &out, "--problem", "pole"], "invalid value 'pole' for '--problem"),
        (&[&graph, "--out", &out, "--problem", "pendulum"], "\"x\"; accepted: cos_theta"),
        (&[&graph, "--out", &out, "--bits", "1"], "1 is not in 2..=16"),
        (&[&graph, "--out", &out, "--bits", "40"], "40 is not in 2..=16"),
        (&[&graph, "--out", &out, "--kind", "w8a16"], "a graph with --kind; accepted: --bits"),
        (&[&arm, "--out", &out], "a graph that names no problem; accepted: one of fs, rs"),
        (&[&network, "--out", &out, "--bits", "8"], "a network with options for graphs; accepted: --kind"),
        (&[&integers, "--out", &out], "unknown field"),
        (&[&out, "--out", &graph], "whole.json: No such file"),
    ] {
        let error = String::from_utf8_lossy(&quantise(arguments).code(2).get_output().stderr).into_owned();
        assert!(error.contains(found), "{error}");
    }
    assert_eq!(fs::read_dir(&folder).expect("it is there").count(), 0, "nothing was written");
}
