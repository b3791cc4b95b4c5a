//! `tpg-train report`: one self-contained file, the same bytes for the same runs, and errors that name the folder.

use assert_cmd::Command;
use serde_json::json;
use std::fs;
use std::path::Path;

fn tpg_train() -> Command {
    Command::new(env!("CARGO_BIN_EXE_tpg-train"))
}

fn evolve(folder: &Path, problem: &str, seeds: &str) {
    let mut command = tpg_train();
    command.args(["tpg", "--problem", problem, "--generations", "2", "--seeds", seeds, "--out"]).arg(folder);
    command.assert().success();
}

#[test]
fn a_report_shows_every_run_and_is_the_same_wherever_the_runs_are() {
    let place = tempfile::tempdir().expect("a temporary folder");
    let evolved = place.path().join("evolved");
    evolve(&evolved, "fs", "1..3");
    let sac = place.path().join("sac");
    let mut command = tpg_train();
    command
        .args([
            "sac",
            "--problem",
            "rs",
            "--set",
            tpg_testing::amount("learning.decisions=1500", "learning.decisions=3000"),
            "--out",
        ])
        .arg(&sac);
    command.assert().success();

    let report = |runs: &[&Path]| {
        let output = tpg_train()
            .arg("report")
            .args(runs)
            .args(["--episodes", tpg_testing::amount("20", "50"), "--out", "-"])
            .assert()
            .success();
        String::from_utf8(output.get_output().stdout.clone()).expect("text")
    };
    let html = report(&[&evolved, &sac]);
    for part in
        ["evolved/seed-1", "evolved/seed-2", ">sac<", "TPG", "SAC", "<svg", "test episodes", "target, in the last"]
    {
        assert!(html.contains(part), "{part} is missing");
    }
    for never in ["<script", "http:", "https:", "NaN", "inf,"] {
        assert!(!html.contains(never), "{never} has no place in a report");
    }
    let tags = |tag: &str| html.matches(tag).count();
    assert_eq!(tags("<svg"), tags("</svg>"));
    assert_eq!(tags("<table"), 1);

    let moved = place.path().join("elsewhere/evolved");
    fs::create_dir_all(moved.parent().expect("a folder above")).expect("it can be made");
    fs::rename(&evolved, &moved).expect("it can be moved");
    assert!(report(&[&moved, &sac]) == html, "paths or the clock are in the report");
}

#[test]
fn a_report_of_another_problem_has_a_headline_formulas_and_units() {
    let place = tempfile::tempdir().expect("a temporary folder");
    let (run, file) = (place.path().join("pole"), place.path().join("report.html"));
    evolve(&run, "cartpole", "1..2");
    let output = tpg_train().arg("report").arg(&run).args(["--episodes", "20", "--out"]).arg(&file).assert().success();
    let said = String::from_utf8_lossy(&output.get_output().stderr).into_owned();
    assert!(said.contains("1 run in 1 group\n"), "{said}");
    let html = fs::read_to_string(&file).expect("a report");
    for part in [
        "class=\"headline\"",
        "95 % interval",
        "bytes of C on a Cortex-M4F",
        "href=\"#section-1\"",
        "Evolution: cartpole",
        "Policy of ",
        "theta in rad",
        "the root: the highest bid wins",
    ] {
        assert!(html.contains(part), "{part} is missing");
    }
    assert!(!html.contains("success %"), "a column that says nothing");
    let quiet =
        tpg_train().arg("report").arg(&run).args(["--quiet", "--episodes", "5", "--out"]).arg(&file).assert().success();
    assert!(quiet.get_output().stderr.is_empty());
}

#[test]
fn a_run_of_ones_own_environment_is_tested_where_that_is() {
    let place = tempfile::tempdir().expect("a temporary folder");
    let (run, file) = (place.path().join("pole/seed-1"), place.path().join("report.html"));
    evolve(&place.path().join("pole"), "cartpole", "1..2");
    let read = |name: &str| fs::read_to_string(run.join(name)).expect("readable");
    let mut config: toml::Table = read("config.toml").parse().expect("settings");
    config.remove("problem").expect("the built-in problem");
    fs::write(run.join("config.toml"), config.to_string()).expect("it can be written");
    let graph = tpg_graph::Graph::from_json("graph.json", &read("graph.json")).expect("a graph").sha256();
    let headline = |graph: &str| {
        let result = |score: u32| json!({"outcome": 0, "success": null, "score": score, "measure": 0.0, "actions": 9});
        let effort = json!({"saturated": 0.25, "chatter": 0.5});
        let rival = json!({"name": "pid", "law": "push = -2 theta", "scores": [10, 13], "effort": effort});
        let tested = json!({"graph": graph, "episodes": [result(14), result(16)], "effort": null, "rivals": [rival]});
        fs::write(run.join("tested.jsonl"), format!("{tested}\n")).expect("it can be written");
        tpg_train().arg("report").arg(&run).arg("--out").arg(&file).assert().success();
        fs::read_to_string(&file).expect("a report")
    };
    let html = headline(&graph);
    assert!(html.contains("return 15.00 ± ") && html.contains("on 2 test episodes"), "not tested");
    let row = "<td>pid</td><td>11.50 ± 2.94</td><td>25.0</td><td>0.5000</td><td>3.50 ± 0.98</td>";
    assert!(html.contains(row) && html.contains("push = -2 theta"), "{html}");
    assert!(headline("0").contains("not tested: evaluate()"), "another graph's episodes");
}

#[test]
fn a_folder_without_a_run_is_refused_by_name() {
    let place = tempfile::tempdir().expect("a temporary folder");
    for (name, files, found) in [
        ("nothing", &[][..], "nothing"),
        ("empty", &[], "not a run folder"),
        ("half", &[("config.toml", "")], "not a run folder"),
        ("torn", &[("config.toml", ""), ("log.jsonl", "{\"decisions\": 1}\n{")], "line 2"),
    ] {
        let folder = place.path().join(name);
        if name != "nothing" {
            fs::create_dir(&folder).expect("it can be made");
        }
        for (file, text) in files {
            fs::write(folder.join(file), text).expect("it can be written");
        }
        let output = tpg_train().arg("report").arg(&folder).assert().code(2);
        let error = String::from_utf8_lossy(&output.get_output().stderr).into_owned();
        assert!(error.contains(name), "{error}");
        assert!(error.contains(found), "{error}");
    }
}

#[test]
fn the_hall_of_fame_stands_in_return_against_size_and_a_damaged_one_is_refused() {
    let place = tempfile::tempdir().expect("a temporary folder");
    let (run, file) = (place.path().join("pole"), place.path().join("report.html"));
    evolve(&run, "cartpole", "1..3");
    let hall = |seed: u32| run.join(format!("seed-{seed}/hall.jsonl"));
    let lines = |seed: u32| fs::read_to_string(hall(seed)).expect("a hall of fame");
    fs::write(hall(1), lines(2) + &lines(1)).expect("it can be written");
    let report = || {
        let mut command = tpg_train();
        command.arg("report").arg(run.join("seed-1")).args(["--episodes", "5", "--out"]).arg(&file);
        command
    };
    report().assert().success();
    let html = fs::read_to_string(&file).expect("a report");
    assert!(html.contains("Return against size") && html.contains("seed-1, generation "), "no policy of the hall");

    fs::write(hall(1), "{}\n").expect("it can be written");
    let output = report().assert().code(2);
    let said = String::from_utf8_lossy(&output.get_output().stderr).into_owned();
    assert!(said.contains("hall.jsonl:1"), "{said}");
}
