//! `tpg-train hybrid`: the same bytes for any number of threads; existing folders are not overwritten.

use assert_cmd::Command;
use std::fs;
use std::path::Path;

fn study(out: &Path, more: &[&str]) -> assert_cmd::assert::Assert {
    let generated = |name: &str| Path::new(env!("CARGO_MANIFEST_DIR")).join("../generated").join(name);
    let mut command = Command::cargo_bin("tpg-train").expect("the program");
    command.args([
        "hybrid",
        "--problem",
        "fs",
        "--episodes",
        "4",
        "--guard",
        "collisions",
        "--cycle-detector",
        "visited",
    ]);
    command
        .args(["--hand-back-after", "1,100,never", "--separation", "3,inf", "--patience", "20,never", "--out"])
        .arg(out);
    command.arg("--tpg").arg(generated("widowx-fs/graph.json")).arg(generated("widowx-rs/graph.json"));
    command.arg("--policy").arg(generated("widowx-sac/policy.q.json"));
    command.args(more).assert()
}

fn text(out: &Path, name: &str) -> String {
    fs::read_to_string(out.join(name)).unwrap_or_else(|error| panic!("{name}: {error}"))
}

#[test]
fn threads_do_not_matter() {
    let folder = tempfile::tempdir().expect("a temporary folder");
    let (one, two) = (folder.path().join("one"), folder.path().join("two"));
    study(&one, &["--threads", "1"]).success();
    study(&two, &["--threads", "2"]).success();
    let cells = text(&one, "cells.csv");
    assert_eq!(cells.lines().count(), 1 + 2 * 12, "two pairs, 12 settings");
    assert_eq!(text(&two, "cells.csv"), cells);

    // The chosen hybrid can be used, and shown beside runs.
    let mut report = Command::cargo_bin("tpg-train").expect("the program");
    let output = report.arg("report").arg(&two).args(["--episodes", "3", "--out", "-"]).assert().success();
    let html = String::from_utf8(output.get_output().stdout.clone()).expect("text");
    assert!(html.contains("guard collisions") && html.contains("mean distance mm"), "{html}");
    let mut eval = Command::cargo_bin("tpg-train").expect("the program");
    let eval = eval.args(["eval", "--problem", "fs", "--episodes", "3", "--json", "--hybrid"]);
    let output = eval.arg(two.join("hybrid.toml")).assert().success().get_output().stdout.clone();
    let report: serde_json::Value = serde_json::from_slice(&output).expect("JSON");
    assert_eq!(report["episodes"], 3);
    assert!(report["tpg_action_ratio"].as_f64().is_some_and(|ratio| (0.0..=1.0).contains(&ratio)));
    assert!(report["hand_overs"]["cycle"].is_number());
}

#[test]
fn a_study_is_not_overwritten() {
    let folder = tempfile::tempdir().expect("a temporary folder");
    study(folder.path(), &[]).success();
    let stderr = String::from_utf8(study(folder.path(), &[]).code(2).get_output().stderr.clone()).expect("text");
    assert!(stderr.contains("another folder"), "{stderr}");
}
