//! Graphs that ask a network: they are trained at a price, act beside the network, and are refused alone.

use crate::hybrid_any::NETWORK;
use assert_cmd::Command;
use serde_json::Value;
use std::fs;
use std::path::{Path, PathBuf};
use tempfile::TempDir;
use tpg_engine::{Choices, TaskSet};
use tpg_graph::Graph;
use tpg_problems::{Pendulum, Problem, ProblemName};
use tpg_runtime::ops::Own;
use tpg_train::parts::AskConfig;
use tpg_train::{
    Acting, Asking, Config as EvolutionConfig, Configuration as _, Episodes, Network, OwnProblem, Shared as _,
};

/// Asks where the angular velocity is negative, else pushes with the highest torque.
const ASKS: &str = r#"{
    "format": "tpg-graph", "version": 1, "scalar": "f32", "maths": "own", "registers": 1,
    "sources": [{ "name": "omega", "length": 1, "unit": "rad/s", "ranges": [[-8, 8]] }],
    "instructions": ["sub"],
    "actions": [{ "id": 0, "name": "help", "ask": "network" }, { "id": 1, "name": "torque 2" }],
    "root": 0,
    "teams": [{ "id": 0, "edges": [{ "program": 0, "action": 0 }, { "program": 1, "action": 1 }] }],
    "programs": [
        { "id": 0, "lines": [{ "to": 0, "op": "sub", "args": ["r0", "omega[0]"] }] },
        { "id": 1, "lines": [] }
    ]
}"#;

fn config(problem: ProblemName, policy: &str) -> EvolutionConfig {
    let ask = Some(AskConfig { policy: policy.to_owned(), price: 2.0, sha256: None });
    let mut config = EvolutionConfig { problem: Problem::new(problem).to_table(), ask, ..EvolutionConfig::default() };
    (config.tpg.nb_roots, config.tpg.init_nb_roots) = (40, 60);
    config.start.share = 0.0;
    (config.learning.nb_iterations_per_policy_evaluation, config.learning.nb_generations) = (4, 8);
    config.selection.validation_episodes = 20;
    config
}

fn written(folder: &TempDir, config: &EvolutionConfig) -> PathBuf {
    let path = folder.path().join("ask.toml");
    fs::write(&path, config.to_toml()).expect("a file");
    path
}

fn tpg_train(arguments: &[&str]) -> Command {
    let mut command = Command::new(env!("CARGO_BIN_EXE_tpg-train"));
    command.args(arguments);
    command
}

fn train(config: &Path, out: &Path, more: &[&str]) -> Command {
    let mut command = tpg_train(&["tpg"]);
    command.arg("--config").arg(config).arg("--out").arg(out).args(more);
    command
}

fn refused(mut command: Command, says: &[&str]) {
    let stderr = String::from_utf8(command.assert().code(2).get_output().stderr.clone()).expect("text");
    for part in says {
        assert!(stderr.contains(part), "{part} in {stderr}");
    }
}

fn eval(graph: &Path, more: &[&str]) -> Command {
    let mut command = tpg_train(&["eval", "--problem", "pendulum", "--episodes", "50"]);
    command.arg("--tpg").arg(graph).args(more);
    command
}

#[test]
fn a_run_with_a_price_ends_in_a_graph_that_asks_on_any_threads() {
    let folder = tempfile::tempdir().expect("a temporary folder");
    let config = written(&folder, &config(ProblemName::Pendulum, NETWORK));
    let out = |name: &str| folder.path().join(name);
    for (name, more) in [("one", ["--threads", "1"]), ("two", ["--threads", "2"])] {
        train(&config, &out(name), &more).assert().success();
    }
    let bytes = |name: &str, file: &str| fs::read(out(name).join(file)).expect("a file of the run");
    for file in ["graph.json", "hall.jsonl", "generations.jsonl", "config.toml", "checkpoint"] {
        assert!(bytes("one", file) == bytes("two", file), "{file}");
    }
    let path = out("one").join("graph.json");
    let graph = Graph::from_json("graph.json", &fs::read_to_string(&path).expect("text")).expect("a graph");
    let names: Vec<String> = graph.actions().iter().map(ToString::to_string).collect();
    assert_eq!(names, ["torque -2", "torque 0", "torque 2", "ask (asks network)"]);

    // The run names the network's bytes: it goes on with them, and with no others.
    let again = out("one").join("config.toml");
    assert!(fs::read_to_string(&again).expect("text").contains("sha256 = \""));
    train(&again, &out("one"), &["--resume", "--generations", "9"]).assert().success();
    let other = out("other.q.json");
    fs::write(&other, fs::read_to_string(NETWORK).expect("text") + "\n").expect("a file");
    let text = fs::read_to_string(&again).expect("text");
    let changed = out("changed.toml");
    fs::write(&changed, text.replace(NETWORK, other.to_str().expect("a path"))).expect("a file");
    refused(train(&changed, &out("three"), &[]), &["other.q.json", "sha256", "as ask.sha256 says"]);
    assert!(!out("three").exists());

    // Reports find the network by the configuration, also for the hall of fame.
    let text = fs::read_to_string(out("two").join("graph.json")).expect("text");
    let mut other: serde_json::Value = serde_json::from_str(&text).expect("JSON");
    other["provenance"]["scores"]["generation"] = 77.into();
    fs::write(out("two").join("hall.jsonl"), other.to_string()).expect("a file");
    let page = out("report.html");
    tpg_train(&["report", "--episodes", "20", "--out"]).arg(&page).arg(out("two")).assert().success();
    let page = fs::read_to_string(page).expect("a page");
    assert!(page.contains("only asks") && page.contains("two, generation 77"), "{page}");
}

#[test]
fn evaluation_counts_the_asks_that_training_pays_for() {
    let folder = tempfile::tempdir().expect("a temporary folder");
    let path = folder.path().join("asks.json");
    fs::write(&path, ASKS).expect("a file");
    let output = eval(&path, &["--json", "--policy", NETWORK]).assert().success();
    let report: Value = serde_json::from_slice(&output.get_output().stdout).expect("JSON");
    let number = |key: &str| report[key].as_f64().expect("a number");
    let asks = number("asks");
    assert!(asks > 10.0 && asks < 190.0 && number("network_actions") == asks, "{report}");
    let [low, high] = [0, 1].map(|end| report["asks_ci95"][end].as_f64().expect("a number"));
    assert!(low < asks && asks < high && (low + high - 2.0 * asks).abs() < 1e-6, "{report}");
    let table = eval(&path, &["--policy", NETWORK]).assert().success();
    let table = String::from_utf8(table.get_output().stdout.clone()).expect("text");
    assert!(table.contains(&format!("asks           {asks:.2} an episode (95 %: ")), "{table}");

    // The same episodes as training sees them: each ask costs its price.
    let network = Network::read(NETWORK.as_ref()).expect("a policy");
    let choices = Choices::new(Pendulum, Some(3)).expect("few actions");
    let asking = Asking::new(choices, |state: &[f32]| network.deciding()(state), 2.0);
    let graph = Graph::from_json("asks.json", ASKS).expect("a graph");
    let problem = OwnProblem::<f32, Own, _>::new("pendulum", Choices::new(asking, None).expect("named actions"));
    let episodes = Episodes { set: TaskSet::Test, count: 50, seed: 1, file: None };
    let paid = problem.play(Acting::Graph(&("asks.json".to_owned(), graph)), episodes).expect("they run").endings;
    let paid = paid.iter().map(|ending| ending.score).sum::<f64>() / 50.0;
    assert!((paid - (number("mean_score") - 2.0 * asks)).abs() < 1e-9, "{paid} {report}");

    // Rules go on beside asking.
    let hybrid = folder.path().join("rules.toml");
    fs::write(
        &hybrid,
        format!("graph = \"asks.json\"\nactor = \"{NETWORK}\"\nseparation = 3\nhand_back_after = 100\n"),
    )
    .expect("a file");
    let mut both = tpg_train(&["eval", "--problem", "pendulum", "--episodes", "50", "--json", "--hybrid"]);
    let both = both.arg(&hybrid).assert().success();
    let both: Value = serde_json::from_slice(&both.get_output().stdout).expect("JSON");
    let number = |key: &str| both[key].as_f64().expect("a number");
    assert!(both["hand_overs"]["drift"].as_f64().expect("a number") > 0.0, "{both}");
    assert!(number("asks") > 0.0 && number("network_actions") > number("asks"), "{both}");
}

#[test]
fn what_cannot_be_asked_is_refused() {
    let folder = tempfile::tempdir().expect("a temporary folder");
    let path = folder.path().join("asks.json");
    fs::write(&path, ASKS).expect("a file");
    let alone = ["asks.json: $.actions[0].ask: \"network\"", "does not act alone", "--tpg GRAPH --policy FILE"];
    refused(eval(&path, &[]), &alone);
    let out = folder.path().join("run");
    let refuses = |config: &EvolutionConfig, says: &[&str]| {
        refused(train(&written(&folder, config), &out, &[]), says);
        assert!(!out.exists(), "{says:?} left a folder");
    };
    let mut costly = config(ProblemName::Pendulum, NETWORK);
    costly.ask.as_mut().expect("a section").price = -1.0;
    refuses(&costly, &["ask.toml:", "ask.price = -1", "accepted: 0 to 1000000000"]);
    refuses(&config(ProblemName::Cartpole, NETWORK), &["policy.q.json", "cos_theta", "accepted: x v theta omega"]);
    refuses(
        &config(ProblemName::Fs, NETWORK),
        &["ask = a section [ask] for fs", "a problem whose hybrid has no guard"],
    );
    refuses(&config(ProblemName::Pendulum, "none.q.json"), &["none.q.json", "a policy.q.json"]);
    let network = folder.path().join("network");
    let mut sac = tpg_train(&["sac", "--problem", "pendulum", "--max-steps", "300", "--out"]);
    sac.arg(&network).assert().success();
    let float = network.join("policy.safetensors");
    let float = config(ProblemName::Pendulum, float.to_str().expect("a path"));
    refuses(&float, &["policy.safetensors", "a network in floating point", "tpg-train quantise"]);
}

fn read(path: &Path) -> String {
    fs::read_to_string(path).unwrap_or_else(|error| panic!("{}: {error}", path.display()))
}

#[test]
fn a_study_of_a_graph_that_asks_has_a_hybrid_without_rules() {
    let folder = tempfile::tempdir().expect("a temporary folder");
    let (graph, study) = (folder.path().join("asks.json"), folder.path().join("study"));
    fs::write(&graph, ASKS).expect("a file");
    let mut hybrid = tpg_train(&["hybrid", "--problem", "pendulum", "--episodes", "20", "--policy", NETWORK]);
    hybrid.args(["--hand-back-after", "5", "--separation", "3", "--patience", "never", "--tpg"]).arg(&graph);
    hybrid.arg("--out").arg(&study).assert().success();
    let cells = read(&study.join("cells.csv"));
    assert_eq!(cells.lines().count(), 3, "rules, and none: {cells}");
    let only_asks = cells.lines().find(|line| line.contains(",never,inf,never,")).expect("a row without rules");
    let alone = read(&study.join("alone.csv"));
    assert!(alone.contains("sac,") && !alone.contains("tpg,"), "a graph that asks does not act alone: {alone}");

    // Written by hand: what is left out is off.
    let file = study.join("asks.toml");
    fs::write(&file, format!("problem = \"pendulum\"\ngraph = \"../asks.json\"\nactor = \"{NETWORK}\"\n"))
        .expect("a file");
    let run = |more: &[&str]| {
        let mut eval = tpg_train(&["eval", "--problem", "pendulum", "--episodes", "50", "--json"]);
        let output = eval.args(more).assert().success();
        serde_json::from_slice::<Value>(&output.get_output().stdout).expect("JSON")
    };
    let by_file = run(&["--hybrid", file.to_str().expect("a path")]);
    let by_arguments = run(&["--policy", NETWORK, "--tpg", graph.to_str().expect("a path")]);
    for key in ["mean_score", "asks", "network_actions"] {
        assert!(by_file[key].is_number() && by_file[key] == by_arguments[key], "{key} {by_file} {by_arguments}");
    }
    assert!(by_file["asks"].as_f64() > Some(10.0) && only_asks.contains(",20,"), "{by_file} {only_asks}");

    // A graph that asks nobody needs a rule.
    let quiet = folder.path().join("quiet.json");
    fs::write(&quiet, ASKS.replace("\"name\": \"help\", \"ask\": \"network\"", "\"name\": \"torque -2\""))
        .expect("a file");
    fs::write(&file, read(&file).replace("asks.json", "quiet.json")).expect("a file");
    let mut eval = tpg_train(&["eval", "--problem", "pendulum", "--hybrid"]);
    eval.arg(&file);
    refused(eval, &["asks.toml", "separation = inf", "or a graph that asks"]);
}
