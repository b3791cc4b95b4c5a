//! Hybrids of any problem: a weak graph with a network is better than alone, a study is the same for any number of
//! threads, and a user's own environment has them too.

use assert_cmd::Command;
use serde_json::Value;
use std::collections::BTreeMap;
use std::fs;
use std::path::{Path, PathBuf};
use tpg_engine::random::Stream;
use tpg_engine::{Act, ActionSpace, Choices, End, Environment, SourceSet, Step, Summary, TaskSet};
use tpg_graph::{Graph, SourceDocument};
use tpg_runtime::ops::Own;
use tpg_train::parts::{StudyArgs, study_on};
use tpg_train::{
    Acting, Detector, Episodes, Hybrid, Network, OwnProblem, ReportArgs, Setting, Shared, Span, report_with,
};

/// The pendulum's network, made by `tpg-train sac`.
pub(crate) const NETWORK: &str = concat!(env!("CARGO_MANIFEST_DIR"), "/../c-harness/pendulum/policy.q.json");

/// Swings up by the direction of rotation, and knows nothing else: pushes where the pendulum is already going.
const SWINGS: &str = r#"{
    "format": "tpg-graph", "version": 1, "scalar": "f32", "maths": "own", "registers": 1,
    "sources": [{ "name": "omega", "length": 1, "unit": "rad/s", "ranges": [[-8, 8]] }],
    "instructions": ["sub"],
    "actions": [{ "id": 0, "name": "torque -2" }, { "id": 1, "name": "torque 2" }],
    "root": 0,
    "teams": [{ "id": 0, "edges": [{ "program": 0, "action": 0 }, { "program": 1, "action": 1 }] }],
    "programs": [
        { "id": 0, "lines": [{ "to": 0, "op": "sub", "args": ["r0", "omega[0]"] }] },
        { "id": 1, "lines": [] }
    ]
}"#;

fn tpg_train() -> Command {
    Command::new(env!("CARGO_BIN_EXE_tpg-train"))
}

fn weak_graph(folder: &Path) -> PathBuf {
    let path = folder.join("weak.json");
    fs::write(&path, SWINGS).expect("a file");
    path
}

fn study(graph: &Path, out: &Path, more: &[&str]) -> assert_cmd::assert::Assert {
    let mut command = tpg_train();
    command.args(["hybrid", "--problem", "pendulum", "--episodes", "20", "--policy", NETWORK, "--out"]).arg(out);
    command.arg("--tpg").arg(graph).args(more).assert()
}

fn evaluated(arguments: &[&str], files: &[&Path]) -> Value {
    let mut eval = tpg_train();
    let eval = eval.args(["eval", "--problem", "pendulum", "--episodes", "100", "--json"]).args(arguments).args(files);
    serde_json::from_slice(&eval.assert().success().get_output().stdout).expect("JSON")
}

fn text(path: &Path) -> String {
    fs::read_to_string(path).unwrap_or_else(|error| panic!("{}: {error}", path.display()))
}

#[test]
fn a_weak_graph_with_a_network_is_better_than_alone() {
    let folder = tempfile::tempdir().expect("a temporary folder");
    let graph = weak_graph(folder.path());
    let out = folder.path().join("study");
    study(&graph, &out, &[]).success();

    let score = |report: &Value| report["mean_score"].as_f64().expect("a number");
    let hybrid = evaluated(&["--hybrid"], &[&out.join("hybrid.toml")]);
    let alone = evaluated(&["--tpg"], &[&graph]);
    assert!(score(&alone) < -900.0, "the graph is weak: {alone}");
    assert!(score(&hybrid) > -250.0, "the network helps: {hybrid}");
    for key in [
        "problem",
        "policy",
        "episodes",
        "seed",
        "mean_score",
        "std_score",
        "min_score",
        "mean_steps",
        "success_rate",
        "success_ci95",
        "tpg_action_ratio",
        "network_actions",
        "hand_overs",
        "hand_backs",
    ] {
        assert!(hybrid.get(key).is_some(), "{key} is missing: {hybrid}");
    }
    assert_eq!((hybrid["episodes"].as_u64(), hybrid["mean_steps"].as_f64()), (Some(100), Some(200.0)));
    assert!(hybrid["success_rate"].is_null(), "the pendulum knows no success");
    let ratio = hybrid["tpg_action_ratio"].as_f64().expect("a number");
    let network = hybrid["network_actions"].as_f64().expect("a number");
    assert!(ratio > 0.0 && ratio < 1.0 && (network - 200.0 * (1.0 - ratio)).abs() < 1e-9, "{hybrid}");
    let hand_overs: f64 =
        ["drift", "stall", "cycle"].map(|cause| hybrid["hand_overs"][cause].as_f64().unwrap()).iter().sum();
    assert!(hand_overs > 0.0, "{hybrid}");

    // The report shows the study's hybrid.
    let html = folder.path().join("report.html");
    tpg_train().arg("report").arg(&out).args(["--episodes", "20", "--out"]).arg(&html).assert().success();
    let html = text(&html);
    assert!(html.contains("hybrid") && html.contains("hands back after") && html.contains("<svg"), "{html}");
}

#[test]
fn threads_do_not_matter() {
    let folder = tempfile::tempdir().expect("a temporary folder");
    let graph = weak_graph(folder.path());
    let (one, two) = (folder.path().join("one"), folder.path().join("two"));
    study(&graph, &one, &["--threads", "1"]).success();
    study(&graph, &two, &["--threads", "2"]).success();
    let files = ["cells.csv", "alone.csv", "study.toml", "hybrid.toml"];
    let all = |folder: &Path| files.map(|name| text(&folder.join(name)));
    assert_eq!(all(&one), all(&two));

    study(&graph, &two, &[]).code(2);
}

#[test]
fn what_a_problem_does_not_have_is_refused() {
    let folder = tempfile::tempdir().expect("a temporary folder");
    let graph = weak_graph(folder.path());
    let refused = |command: &mut Command, says: &[&str]| {
        let stderr = String::from_utf8(command.assert().code(2).get_output().stderr.clone()).expect("text");
        for part in says {
            assert!(stderr.contains(part), "{part} in {stderr}");
        }
    };
    for (more, says) in [
        (&["--cycle-detector", "brent"][..], &["has no keys to detect cycles by", "accepted: none"][..]),
        (&["--guard", "both"], &["guard both for pendulum", "accepted: none"]),
        (&["--separation", "inf", "--patience", "never"], &["never hands over", "--patience in actions"]),
        (&["--separation=-1"], &["--separation -1", "distances from 0"]),
        (&["--patience", "0"], &["neither a number of actions"]),
    ] {
        let out = folder.path().join("refused");
        let mut command = tpg_train();
        command.args(["hybrid", "--problem", "pendulum", "--policy", NETWORK, "--tpg"]).arg(&graph);
        refused(command.arg("--out").arg(&out).args(more), says);
        assert!(!out.exists(), "{more:?} left a folder");
    }
    let eval = |problem: &str, more: &[&str]| {
        let mut command = tpg_train();
        command.args(["eval", "--problem", problem]).args(more);
        command
    };
    let graph = graph.to_str().expect("a path");
    refused(&mut eval("pendulum", &["--tpg", graph, "--policy", NETWORK]), &["it asks nobody", "--hybrid FILE"]);
    for (rule, says) in [
        ("cycle_detector = \"visited\"", "has no keys"),
        ("guard = \"both\"", "guard both for pendulum"),
        ("", "a patience"),
    ] {
        let file = folder.path().join("refused.toml");
        fs::write(&file, format!("graph = \"{graph}\"\nactor = \"{NETWORK}\"\n{rule}\n")).expect("a file");
        refused(&mut eval("pendulum", &["--hybrid", file.to_str().expect("a path")]), &[says]);
    }
    refused(&mut eval("cartpole", &["--policy", NETWORK]), &["cos_theta", "accepted: x v theta omega"]);
    let file = folder.path().join("hybrid.toml");
    let of_the_arm = format!(
        "graph = \"weak.json\"\nactor = \"{NETWORK}\"\nhand_back_after = 5\nseparation_mm = inf\n\
         guard = \"both\"\ncycle_detector = \"none\"\n"
    );
    fs::write(&file, of_the_arm).expect("a file");
    let file = file.to_str().expect("a path");
    refused(&mut eval("pendulum", &["--hybrid", file]), &["guard both for pendulum", "accepted: none"]);
}

/// A walk along a line to 10, in steps of −1 to 1. Every place has a key.
struct Line;

impl Environment<f64> for Line {
    type Task = f64;
    type Episode = f64;

    fn sources(&self) -> Vec<SourceDocument> {
        let ranges = vec![[-20.0, 20.0]];
        vec![SourceDocument::new("place", "m", ranges)]
    }
    fn actions(&self) -> ActionSpace {
        let (name, unit) = ("step".into(), "m".into());
        ActionSpace::Box(vec![tpg_engine::Output { name, unit, min: -1.0, max: 1.0 }])
    }
    fn time_limit(&self) -> u32 {
        60
    }
    fn draw(&self, random: &mut Stream) -> f64 {
        random.below(10) as f64
    }
    fn start(&self, task: &f64) -> f64 {
        *task
    }
    fn observe(&self, place: &mut f64, _wanted: SourceSet, state: &mut [f64]) {
        state[0] = *place;
    }
    fn step(&self, place: &mut f64, act: Act<'_, f64>) -> Step {
        *place += act.values()[0];
        let step = Step::reward(-1.0);
        let end = End { success: Some(true), ..End::new(0) };
        if *place >= 10.0 { step.ending(end) } else { step }
    }
    fn timeout(&self, _: &f64) -> End {
        End { success: Some(false), ..End::new(1) }
    }
    fn key(&self, place: &f64) -> Option<u64> {
        Some(place.to_bits())
    }
    fn distance(&self, place: &f64) -> Option<f64> {
        Some(10.0 - place)
    }
}

/// Goes up to 4 and then back and forth: `place < 4` is 4 − place > 0.
const UP_TO_4: &str = r#"{
    "format": "tpg-graph", "version": 1, "scalar": "f64", "maths": "own", "registers": 1,
    "sources": [{ "name": "place", "length": 1, "unit": "m", "ranges": [[-20, 20]] }],
    "instructions": ["sub"],
    "actions": [{ "id": 0, "name": "step -1" }, { "id": 1, "name": "step 1" }],
    "root": 0,
    "teams": [{ "id": 0, "edges": [{ "program": 0, "action": 0 }, { "program": 1, "action": 1 }] }],
    "programs": [
        { "id": 0, "lines": [] },
        { "id": 1, "lines": [{ "to": 0, "op": "sub", "args": [4.0, "place[0]"] }] }
    ]
}"#;

/// Always a step of 1: its bias alone saturates.
const UPWARDS: &str = r#"{"format": "tpg network in integers", "version": 2,
    "source_sha256": "0000000000000000000000000000000000000000000000000000000000000000",
    "observation": ["place"], "feature_one": 4096,
    "rounding": "(acc * factor + 2^(shift - 1)) >> shift in 64 bits, then clipped",
    "output": {"values": [{"name": "step", "min": -1.0, "max": 1.0, "squash": "clamp", "exponent": 10}]},
    "layers": [{"inputs": 1, "outputs": 1, "weights": [0], "bias": [1000000], "factor": [16384], "shift": [20]}]}"#;

/// Test episodes.
const EPISODES: Episodes<'static> = Episodes { set: TaskSet::Test, count: 50, seed: 1, file: None };

fn line(folder: &Path) -> (OwnProblem<f64, Own, Line>, Hybrid) {
    let problem = OwnProblem::new("line", Choices::new(Line, Some(3)).expect("few actions"));
    let network = folder.join("upwards.q.json");
    fs::write(&network, UPWARDS).expect("a file");
    let graph = Graph::from_json("up.json", UP_TO_4).expect("a good graph");
    let setting = Setting {
        hand_back_after: Span(3),
        separation: f64::INFINITY,
        patience: Span::NEVER,
        detector: Detector::Visited,
        guard: "none".to_owned(),
    };
    let network = ("upwards.q.json".to_owned(), Network::read(&network).expect("a good network"));
    (problem, Hybrid { problem: Some("line".to_owned()), graph: ("up.json".to_owned(), graph), network, setting })
}

#[test]
fn every_trigger_hands_over_in_an_environment_of_ones_own() {
    let folder = tempfile::tempdir().expect("a temporary folder");
    let (problem, hybrid) = line(folder.path());
    let report = |setting: Setting| {
        let done = problem.play(Acting::Both(&hybrid.graph, &hybrid.network, &setting), EPISODES).expect("it runs");
        let causes = ["guard", "drift", "stall", "cycle"].into_iter().zip(done.hand_overs);
        (Summary::new(&done.endings).success, causes.collect::<BTreeMap<_, _>>())
    };
    let alone = problem.play(Acting::Graph(&hybrid.graph), EPISODES).expect("it runs");
    assert!(alone.endings.iter().all(|ending| ending.success == Some(false)), "the graph alone never arrives");

    let none = Setting { detector: Detector::None, hand_back_after: Span::NEVER, ..hybrid.setting.clone() };
    for (setting, trigger) in [
        (Setting { detector: Detector::Visited, ..none.clone() }, "cycle"),
        (Setting { detector: Detector::Brent, ..none.clone() }, "cycle"),
        (Setting { separation: 0.5, ..none.clone() }, "drift"),
        (Setting { patience: Span(4), ..none.clone() }, "stall"),
    ] {
        let (success, hand_overs) = report(setting.clone());
        assert_eq!(success, Some(1.0), "{setting:?}");
        assert_eq!(hand_overs[trigger], 1.0, "once an episode, for good: {setting:?} {hand_overs:?}");
        assert_eq!(hand_overs.values().sum::<f64>(), 1.0, "{setting:?} {hand_overs:?}");
    }
    // A short turn: from 4 by 3 to 7, back to the graph, which goes down and hands over again.
    let (success, hand_overs) = report(Setting { separation: 0.5, hand_back_after: Span(3), ..none });
    assert!(success == Some(1.0) && hand_overs["drift"] > 1.0, "{hand_overs:?}");
}

#[test]
fn an_environment_of_ones_own_has_studies_and_reports() {
    let folder = tempfile::tempdir().expect("a temporary folder");
    let (problem, _) = line(folder.path());
    let graph = folder.path().join("up.json");
    fs::write(&graph, UP_TO_4).expect("a file");
    let out = folder.path().join("study");
    let args = StudyArgs {
        tpg: vec![graph],
        policy: vec![folder.path().join("upwards.q.json")],
        out: out.clone(),
        episodes: 20,
        seed: 1,
        cycle_detector: Vec::new(),
        hand_back_after: Vec::new(),
        separation: Vec::new(),
        patience: Vec::new(),
        guard: Vec::new(),
        threads: 1,
    };
    study_on(&problem, &args).expect("it runs");
    let chosen = Hybrid::read(&out.join("hybrid.toml")).expect("a good file");
    assert_eq!((chosen.problem.as_deref(), chosen.setting.detector), (Some("line"), Detector::Visited), "it has keys");
    let done = problem.play(Acting::Both(&chosen.graph, &chosen.network, &chosen.setting), EPISODES).expect("it runs");
    assert_eq!(Summary::new(&done.endings).success, Some(1.0));

    let page = folder.path().join("report.html");
    let args = ReportArgs { runs: vec![out], out: page.clone(), episodes: 30, seed: 1 };
    report_with(&args, Some(&problem)).expect("it reports");
    assert!(text(&page).contains("100.0"), "every episode is a success");
}

/// Balances by the greatest of two outputs: right where 8 theta + omega is positive.
const BALANCES: &str = r#"{"format": "tpg network in integers", "version": 2,
    "source_sha256": "0000000000000000000000000000000000000000000000000000000000000000",
    "observation": ["x", "v", "theta", "omega"], "feature_one": 4096,
    "rounding": "(acc * factor + 2^(shift - 1)) >> shift in 64 bits, then clipped",
    "output": {"argmax": ["left", "right"]},
    "layers": [{"inputs": 4, "outputs": 2, "weights": [0, 0, 0, 0, 2, 6, 32, 16], "bias": [0, 0],
                "factor": [16384, 16384], "shift": [20, 20]}]}"#;

#[test]
fn a_network_that_chooses_helps_on_the_cartpole() {
    let folder = tempfile::tempdir().expect("a temporary folder");
    let (graph, network) = (folder.path().join("left.json"), folder.path().join("balances.q.json"));
    // Bids nothing for right and nothing for left: always left.
    let always = SWINGS
        .replace(
            "\"omega\", \"length\": 1, \"unit\": \"rad/s\", \"ranges\": [[-8, 8]]",
            "\"theta\", \"length\": 1, \"unit\": \"rad\", \"ranges\": [[-1, 1]]",
        )
        .replace("torque -2", "left")
        .replace("torque 2", "right")
        .replace(
            "[{ \"to\": 0, \"op\": \"sub\", \"args\": [\"r0\", \"omega[0]\"] }]",
            "[{ \"to\": 0, \"op\": \"sub\", \"args\": [1.0, \"r0\"] }]",
        );
    fs::write(&graph, always).expect("a file");
    fs::write(&network, BALANCES).expect("a file");
    let score = |more: &[&str]| {
        let mut eval = tpg_train();
        eval.args(["eval", "--problem", "cartpole", "--episodes", "50", "--json"]).args(more);
        let output = eval.assert().success().get_output().stdout.clone();
        let report: Value = serde_json::from_slice(&output).expect("JSON");
        report["mean_score"].as_f64().expect("a number")
    };
    let [graph, network] = [&graph, &network].map(|path| path.to_str().expect("a path"));
    let (alone, helper) = (score(&["--tpg", graph]), score(&["--policy", network]));
    let hybrid = folder.path().join("hybrid.toml");
    let rules = format!("graph = \"{graph}\"\nactor = \"{network}\"\nseparation = 0.2\nhand_back_after = 20\n");
    fs::write(&hybrid, rules).expect("a file");
    let both = score(&["--hybrid", hybrid.to_str().expect("a path")]);
    assert!(alone < 12.0 && helper > 400.0, "graph {alone}, network {helper}");
    assert!(both > 3.0 * alone, "graph {alone}, together {both}");
}

#[test]
fn two_policies_are_compared_on_the_same_episodes() {
    let folder = tempfile::tempdir().expect("a temporary folder");
    let graph = weak_graph(folder.path());
    let name = graph.display().to_string();
    let (alone, network) = (evaluated(&["--tpg"], &[&graph]), evaluated(&["--policy", NETWORK], &[]));
    let score = |report: &Value| report["mean_score"].as_f64().expect("a number");
    let both = evaluated(&["--against", NETWORK, "--tpg"], &[&graph]);
    let difference = |report: &Value| report["against"]["difference"].as_f64().expect("a number");
    assert_eq!((score(&both), score(&both["against"]["other"])), (score(&alone), score(&network)));
    assert!((difference(&both) - (score(&alone) - score(&network))).abs() < 1e-9, "{both}");
    let other = evaluated(&["--against", &name, "--policy", NETWORK], &[]);
    assert!((difference(&both) + difference(&other)).abs() < 1e-9, "{other}");
    let interval: [f64; 2] = serde_json::from_value(both["against"]["difference_ci95"].clone()).expect("two numbers");
    assert!(interval[0] < difference(&both) && difference(&both) < interval[1] && interval[1] < 0.0, "{both}");
    let same = evaluated(&["--against", &name, "--tpg"], &[&graph]);
    assert_eq!(same["against"]["difference_ci95"], serde_json::json!([0.0, 0.0]), "the episodes are the same");

    // A relay with a memory, which counts with it, is at a bound in every step.
    let law = folder.path().join("relay.toml");
    fs::write(&law, "[law]\ntorque = \"-9e9 * omega + old\"\nold = \"omega\"\n[memory]\nold = [0.5, 0.75]\n")
        .expect("a file");
    let relay = evaluated(&["--against", &law.display().to_string(), "--policy", NETWORK], &[]);
    let effort = |report: &Value, key: &str| report["effort"][key].as_f64().expect("a number");
    let other = &relay["against"]["other"];
    assert_eq!(effort(other, "saturated"), 1.0, "{relay}");
    assert!(effort(&relay, "saturated") < 0.9 && effort(&relay, "chatter") > 0.0, "{relay}");
    assert!(both.get("effort").is_none(), "torques by name: {both}");

    for (more, found) in [(&["--against", "none.json"][..], "none.json"), (&["--against", "none.toml"], "none.toml")] {
        let mut eval = tpg_train();
        let eval = eval.args(["eval", "--problem", "pendulum", "--policy", NETWORK]).args(more).assert().code(2);
        let said = String::from_utf8_lossy(&eval.get_output().stderr).into_owned();
        assert!(said.contains(found), "{said}");
    }
}
