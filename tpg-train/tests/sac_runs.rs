//! Soft actor-critics on built-in problems: they learn, resume to the same bytes, and what they trained goes on to `eval`,
//! `quantise` and `report`.

use assert_cmd::Command;
use serde_json::Value;
use std::fs;
use std::path::Path;
use std::process::Stdio;
use std::thread::sleep;
use std::time::{Duration, Instant};

fn tpg_train() -> Command {
    Command::new(env!("CARGO_BIN_EXE_tpg-train"))
}

fn error_of(arguments: &[&str]) -> String {
    let output = tpg_train().args(arguments).assert().code(2);
    String::from_utf8_lossy(&output.get_output().stderr).into_owned()
}

/// Writes the preset `general` with an early first validation of few episodes.
fn short(file: &Path) {
    let text = "[learning]\nrandom_decisions = 200\n[validation]\nevery = 1_000\nepisodes = 10\n";
    fs::write(file, text).expect("it can be written");
}

/// Trains for a few updates, beside a configuration that it writes.
fn train(folder: &Path, more: &[&str]) -> std::process::Command {
    let config = folder.with_extension("toml");
    short(&config);
    let mut command = std::process::Command::new(env!("CARGO_BIN_EXE_tpg-train"));
    command.args(["sac", "--problem", "pendulum", "--max-steps", "1500", "--config"]).arg(config);
    command.arg("--out").arg(folder).args(more);
    command.stdout(Stdio::null()).stderr(Stdio::null());
    command
}

/// Everything but the times.
fn results(folder: &Path) -> Vec<Vec<u8>> {
    ["policy.safetensors", "log.jsonl", "checkpoint", "config.toml"]
        .map(|name| fs::read(folder.join(name)).unwrap_or_else(|_| panic!("{name} is missing")))
        .to_vec()
}

#[test]
fn killed_and_resumed_a_run_ends_in_the_same_bytes() {
    let place = tempfile::tempdir().expect("a temporary folder");
    let (undisturbed, killed) = (place.path().join("undisturbed"), place.path().join("killed"));
    let start = Instant::now();
    assert!(train(&undisturbed, &[]).status().expect("it runs").success());
    let pause = (start.elapsed() / 4).max(Duration::from_millis(1));
    for _ in 0..4 {
        let mut run = train(&killed, &["--checkpoint-seconds", "0", "--resume"]).spawn().expect("it starts");
        sleep(pause);
        // SIGKILL: the program cannot do anything about it.
        run.kill().expect("it can be killed");
        run.wait().expect("it ends");
    }
    assert!(killed.join("checkpoint").exists(), "it was never saved before it was killed");
    assert!(train(&killed, &["--resume"]).status().expect("it runs").success());
    assert!(results(&killed) == results(&undisturbed), "other bytes");
}

#[test]
fn no_output_depends_on_how_the_configuration_is_called() {
    let place = tempfile::tempdir().expect("a temporary folder");
    fs::create_dir(place.path().join("other")).expect("it can be made");
    ["mine.toml", "other/same.toml"].iter().for_each(|name| short(&place.path().join(name)));
    let run = |config: &str, folder: &str| {
        let mut command = tpg_train();
        command.current_dir(place.path()).args(["sac", "--problem", "pendulum", "--max-steps", "600"]);
        command.args(["--config", config, "--out", folder]).assert().success();
        results(&place.path().join(folder))
    };
    let expected = run("mine.toml", "a");
    assert!(run("./mine.toml", "b") == expected && run("other/same.toml", "c") == expected, "other bytes");
}

#[test]
fn neither_trainer_overwrites_a_run_of_the_other() {
    let place = tempfile::tempdir().expect("a temporary folder");
    let run = |trainer: &str, folder: &str, more: &[&str]| {
        let mut command = tpg_train();
        command.current_dir(place.path()).args([trainer, "--problem", "pendulum", "--max-steps", "1"]);
        if trainer == "tpg" {
            command.args(["--generations", "1"]);
        }
        let output = command.args(["--out", folder]).args(more).output().expect("it starts");
        (output.status.code(), String::from_utf8_lossy(&output.stderr).into_owned())
    };
    for (first, second) in [("tpg", "sac"), ("sac", "tpg")] {
        assert_eq!(run(first, first, &[]).0, Some(0));
        let before = fs::read(place.path().join(first).join("checkpoint")).expect("a checkpoint");
        let (code, error) = run(second, first, &[]);
        assert!(code == Some(2) && error.contains("already holds a run; accepted: another folder"), "{error}");
        let (code, error) = run(second, first, &["--resume"]);
        assert!(code == Some(2) && error.contains(&format!("tpg-train {first}, checkpoint version")), "{error}");
        assert!(fs::read(place.path().join(first).join("checkpoint")).is_ok_and(|left| left == before));
    }
}

#[test]
fn a_trained_network_is_evaluated_put_into_integers_and_reported() {
    let place = tempfile::tempdir().expect("a temporary folder");
    let run = place.path().join("run");
    assert!(train(&run, &["--target", "-5000"]).status().expect("it runs").success());
    let log = fs::read_to_string(run.join("log.jsonl")).expect("a log");
    assert_eq!(log.lines().count(), 1, "the first validation reaches the target");
    let (float, fixed) = (run.join("policy.safetensors"), place.path().join("policy.q.json"));
    let eval = |policy: &Path| -> Value {
        let mut command = tpg_train();
        command.args(["eval", "--problem", "pendulum", "--episodes", "20", "--json", "--policy"]).arg(policy);
        serde_json::from_slice(&command.assert().success().get_output().stdout).expect("JSON")
    };
    let mut command = tpg_train();
    command.arg("quantise").arg(&float).arg("--out").arg(&fixed).args(["--kind", "w16a16"]);
    command.assert().success();
    let (float, fixed) = (eval(&float), eval(&fixed));
    assert_eq!(float["mean_steps"], 200.0);
    assert!(float["success_rate"].is_null());
    let score = |report: &Value| report["mean_score"].as_f64().expect("a number");
    assert!((score(&float) - score(&fixed)).abs() < 0.1 * score(&float).abs(), "{float} {fixed}");

    let output = tpg_train().arg("report").arg(&run).args(["--episodes", "20", "--out", "-"]).assert().success();
    let html = String::from_utf8_lossy(&output.get_output().stdout).into_owned();
    for part in ["SAC", "3 inputs, 64-64", "Soft actor-critic", "trained in"] {
        assert!(html.contains(part), "{part} is missing");
    }
    assert!(!html.contains("distance"), "a pendulum has none");
}

#[test]
fn what_a_network_cannot_do_is_refused_with_the_reason() {
    assert!(error_of(&["sac"]).contains("no problem"));
    assert!(error_of(&["sac", "--problem", "pendulum", "--preset", "huge"]).contains("general, long, best-fs"));
    let place = tempfile::tempdir().expect("a temporary folder");
    let config = place.path().join("config.toml");
    let name = config.display().to_string();
    let arguments = ["sac", "--problem", "pendulum", "--config", &name];
    for (text, found) in [
        ("[learning]\nlanes = 0\n", "line 2: learning.lanes = 0"),
        ("[problem]\nname = \"pendulum\"\nlevels = 0\n", "line 3: problem.levels = 0"),
        ("[retry]\nshare = 0.5\nevery = 10\nepisodes = 5\nremembered = 9\n", "knows no failure"),
    ] {
        fs::write(&config, text).expect("it can be written");
        let error = error_of(&arguments);
        assert!(error.contains(found), "{error}");
    }
    let arm = [env!("CARGO_MANIFEST_DIR"), "/../generated/widowx-sac/policy.q.json"].concat();
    let error = error_of(&["eval", "--problem", "pendulum", "--policy", &arm]);
    assert!(error.contains("policy.q.json: the inputs base shoulder") && error.contains("cos_theta"), "{error}");
}
