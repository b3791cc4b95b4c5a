//! Arms other than the WidowX on the command line: classical controllers, networks and hybrids on an SO-101.

use assert_cmd::Command;
use serde_json::Value;
use std::fs;
use std::path::{Path, PathBuf};

fn tpg_train() -> Command {
    Command::new(env!("CARGO_BIN_EXE_tpg-train"))
}

fn generated(name: &str) -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("../generated").join(name)
}

/// Writes a graph's configuration for the SO-101 with more lines in `[problem]`.
fn config(folder: &Path, more: &str) -> PathBuf {
    let path = folder.join("so101.toml");
    let text = format!("[problem]\nname = \"rs\"\narm = \"so101\"\ntolerance = 10.0\n{more}\n");
    fs::write(&path, text).expect("it can be written");
    path
}

fn evaluated(arguments: &[&str], config: Option<&Path>) -> Value {
    let mut command = tpg_train();
    command.args(["eval", "--problem", "rs", "--json", "--episodes", "20"]).args(arguments);
    if let Some(config) = config {
        command.arg("--config").arg(config);
    }
    serde_json::from_slice(&command.assert().success().get_output().stdout).expect("JSON")
}

fn success(report: &Value) -> f64 {
    report["success_rate"].as_f64().expect("a rate")
}

#[test]
fn classical_controllers_drive_any_planar_arm() {
    let folder = tempfile::tempdir().expect("a temporary folder");
    let rigid = config(folder.path(), "");
    for (policy, least) in [("planner", 0.9), ("nearest-goal", 0.7), ("closed-form", 0.7)] {
        let report = evaluated(&["--policy", policy], Some(&rigid));
        assert!(success(&report) >= least, "{policy}: {report}");
        assert_eq!((report["policy"].as_str(), report["problem"].as_str()), (Some(policy), Some("rs")));
        assert!(report["success_ci95"].is_array() && report["failures"]["joint_limit"].is_number());
    }
    let distance = |report: &Value| report["mean_distance_mm"].as_f64().expect("a distance");
    let tight = evaluated(&["--policy", "closed-form"], Some(&rigid));
    // 100 ticks are up to 60 mm at the hand.
    let loose = evaluated(&["--policy", "closed-form"], Some(&config(folder.path(), "backlash = 100")));
    assert!(success(&loose) < success(&tight) && distance(&loose) > distance(&tight), "{tight} {loose}");
}

/// Writes the preset `best-rs` for the SO-101, small and short.
fn short(folder: &Path) -> PathBuf {
    let path = folder.join("sac.toml");
    let text = "[problem]\nname = \"rs\"\narm = \"so101\"\ntest_tolerance = 10.0\ntolerance = 10.0\n\
                [actor]\nhidden = [8]\n\
                [critic]\nhidden = [8]\n\
                [learning]\ndecisions = 1_000\nrandom_decisions = 200\nreplay = 2_000\n\
                [retry]\nevery = 1_000\nepisodes = 4\n\
                [validation]\nevery = 1_000\nepisodes = 4\n";
    fs::write(&path, text).expect("it can be written");
    path
}

#[test]
fn a_network_is_trained_quantised_and_joined_to_a_graph_on_its_own_arm() {
    let folder = tempfile::tempdir().expect("a temporary folder");
    let place = |name: &str| folder.path().join(name);
    let text = |name: &str| place(name).display().to_string();
    tpg_train().arg("sac").arg("--config").arg(short(folder.path())).arg("--out").arg(place("sac")).assert().success();
    let network = text("sac/policy.safetensors");
    let own = evaluated(&["--policy", &network], None);
    let rules = config(folder.path(), "");
    assert_eq!(evaluated(&["--policy", &network], Some(&rules))["failures"], own["failures"], "it knows arm and rules");

    let integers = text("policy.q.json");
    tpg_train().args(["quantise", &network, "--out", &integers]).assert().success();
    // Integers name no arm: the configuration does.
    let report = evaluated(&["--policy", &integers], Some(&rules));
    assert!(report["failures"] != evaluated(&["--policy", &integers], None)["failures"], "{report}");

    let graph = generated("widowx-rs/graph.json").display().to_string();
    let study = |config: Option<&Path>| {
        let mut command = tpg_train();
        command.args(["hybrid", "--problem", "rs", "--episodes", "2", "--guard", "none", "--separation", "20,inf"]);
        command.args(["--hand-back-after", "10", "--patience", "never", "--tpg", &graph, "--policy"]);
        command.arg(&network).arg("--out").arg(place("study"));
        if let Some(config) = config {
            command.arg("--config").arg(config);
        }
        command.assert()
    };
    let refused = study(None).code(2);
    let error = String::from_utf8_lossy(&refused.get_output().stderr).into_owned();
    assert!(error.contains("policy.safetensors: a network for another arm"), "{error}");
    study(Some(&rules)).success();
    let asked = fs::read_to_string(place("study/study.toml")).expect("a study");
    assert!(asked.contains("[problem.arm]") && asked.contains("tolerance = 10.0"), "{asked}");
    let hybrid = place("hybrid.toml");
    let rule =
        format!("graph = \"{graph}\"\nactor = \"{network}\"\nhand_back_after = 10\ncycle_detector = \"visited\"\n");
    fs::write(&hybrid, rule).expect("a file");
    assert!(evaluated(&["--hybrid", hybrid.to_str().expect("a path")], Some(&rules))["hand_overs"].is_object());
}
