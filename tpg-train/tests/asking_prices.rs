//! Several prices of an ask: a run for each, and one front.

use crate::asking::{config, eval, refused, tpg_train, train, written};
use crate::hybrid_any::NETWORK;
use serde_json::Value;
use std::fs;
use std::path::Path;
use tpg_problems::ProblemName;
use tpg_train::evolution::config::{EvolutionConfig, Price};

const FILES: [&str; 5] = ["front.json", "front.csv", "front.html", "hybrid.toml", "sweep.toml"];

fn prices(prices: &[f64]) -> EvolutionConfig {
    let mut config = config(ProblemName::Pendulum, NETWORK);
    let ask = config.ask.as_mut().expect("a section");
    (ask.price, ask.memory) = (Price::Several(prices.to_vec()), true);
    config.learning.nb_generations = 4;
    config
}

fn text(path: &Path) -> String {
    fs::read_to_string(path).unwrap_or_else(|error| panic!("{}: {error}", path.display()))
}

#[test]
fn a_list_of_prices_gives_one_front_on_any_threads_and_after_an_interruption() {
    let folder = tempfile::tempdir().expect("a temporary folder");
    let config = written(&folder, &prices(&[0.0, 1000.0]));
    let out = |name: &str| folder.path().join(name);
    let all = |name: &str| FILES.map(|file| text(&out(name).join(file)));
    train(&config, &out("one"), &["--threads", "1", "--seeds", "1..3"]).assert().success();
    train(&config, &out("two"), &["--threads", "2", "--seeds", "1..3"]).assert().success();
    assert!(all("one") == all("two"), "threads matter");

    let front: Value = serde_json::from_str(&text(&out("one").join("front.json"))).expect("JSON");
    let points = front["points"].as_array().expect("a list");
    let of = |kind: &str, setting: &str| {
        let wanted = |point: &&Value| point["kind"] == kind && setting.is_empty() || point["setting"] == setting;
        points.iter().find(wanted).unwrap_or_else(|| panic!("{kind} {setting} in {front}"))
    };
    let calls = |point: &Value| point["mean"]["network_actions"].as_f64().expect("a number");
    let (free, dear, graph) = (of("asking", "price 0"), of("asking", "price 1000"), of("graph", ""));
    assert!(calls(free) > 100.0 && calls(dear) < 20.0 && calls(graph) == 0.0, "{free} {dear} {graph}");
    assert!(calls(of("mixture", "50 %")) > 90.0 && calls(of("network", "")) == 200.0);
    let work = |point: &Value, which: &str| point["mean"]["operations"][which].as_f64().expect("a number");
    let [alone, network] = [graph, of("network", "")].map(|point| work(point, "worst"));
    assert!(alone > 0.0 && work(free, "worst") > network && work(dear, "mean") < work(free, "mean"), "{front}");
    assert_eq!(network, 640.0, "16 and 16 units with three inputs and one output: 320 weights");
    assert_eq!(front["rules_tried"].as_u64().map(|count| count > 10), Some(true));
    assert_eq!(points.iter().filter(|point| point["chosen"] == true).count(), 1);
    for point in points {
        let seeds = point["seeds"].as_array().expect("a list").len();
        assert_eq!(seeds, if point["kind"] == "network" { 1 } else { 2 }, "{point}");
    }
    let csv = text(&out("one").join("front.csv"));
    assert_eq!(csv.lines().filter(|line| line.starts_with("asking,price 0,")).count(), 3, "{csv}");

    // The chosen graph and the network are a hybrid without rules.
    let hybrid = out("one").join("hybrid.toml");
    let mut evaluated = tpg_train(&["eval", "--problem", "pendulum", "--episodes", "20", "--json", "--hybrid"]);
    let report = evaluated.arg(&hybrid).assert().success();
    let report: Value = serde_json::from_slice(&report.get_output().stdout).expect("JSON");
    let handed: f64 =
        ["drift", "stall", "cycle"].iter().map(|cause| report["hand_overs"][cause].as_f64().unwrap()).sum();
    assert!(report["asks"].is_number() && handed == 0.0, "{report}");

    // A run that was stopped before its second price, and files that were lost.
    fs::remove_dir_all(out("two").join("price-1000")).expect("a folder");
    FILES[..4].iter().for_each(|file| fs::remove_file(out("two").join(file)).expect("a file"));
    train(&config, &out("two"), &["--resume", "--seeds", "1..3"]).assert().success();
    assert!(all("one") == all("two"), "an interruption matters");

    let page = out("report.html");
    let mut report = tpg_train(&["report", "--episodes", "20", "--out"]);
    report.arg(&page).arg(out("one")).assert().success();
    let page = text(&page);
    for part in ["Asking at several prices", "graphs that ask; line", "price-1000", "alone"] {
        assert!(page.contains(part), "{part} in {page}");
    }

    let other = written(&folder, &prices(&[0.0, 5.0]));
    refused(train(&other, &out("two"), &["--resume", "--seeds", "1..3"]), &["sweep.toml", "another sweep"]);
    refused(train(&other, &out("two"), &[]), &["a run", "--resume"]);
    for (wrong, found) in [(&[][..], "ask.price = []"), (&[1.0, 1.0], "ask.price = [1.0, 1.0]")] {
        refused(train(&written(&folder, &prices(wrong)), &out("three"), &[]), &["ask.toml", found, "each once"]);
    }
    refused(train(&written(&folder, &prices(&[1.0, -1.0])), &out("three"), &[]), &["ask.price = -1", "0 to 10"]);
    assert!(!out("three").exists());
}

#[test]
fn a_study_of_a_graph_that_asks_has_a_hybrid_without_rules() {
    let folder = tempfile::tempdir().expect("a temporary folder");
    let (graph, study) = (folder.path().join("asks.json"), folder.path().join("study"));
    fs::write(&graph, crate::asking::ASKS).expect("a file");
    let mut hybrid = tpg_train(&["hybrid", "--problem", "pendulum", "--episodes", "20", "--policy", NETWORK]);
    hybrid.args(["--hand-back-after", "5", "--separation", "3", "--patience", "never", "--tpg"]).arg(&graph);
    hybrid.arg("--out").arg(&study).assert().success();
    let cells = text(&study.join("cells.csv"));
    assert_eq!(cells.lines().count(), 3, "rules, and none: {cells}");
    let only_asks = cells.lines().find(|line| line.contains(",never,inf,never,")).expect("a row without rules");
    let alone = text(&study.join("alone.csv"));
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
    fs::write(
        &quiet,
        crate::asking::ASKS.replace("\"name\": \"help\", \"ask\": \"network\"", "\"name\": \"torque -2\""),
    )
    .expect("a file");
    fs::write(&file, text(&file).replace("asks.json", "quiet.json")).expect("a file");
    let mut eval = tpg_train(&["eval", "--problem", "pendulum", "--hybrid"]);
    eval.arg(&file);
    refused(eval, &["asks.toml", "separation = inf", "or a graph that asks"]);
}

#[test]
fn a_graph_with_a_memory_is_trained_and_evaluated() {
    let folder = tempfile::tempdir().expect("a temporary folder");
    let mut with = prices(&[]);
    with.ask.as_mut().expect("a section").price = Price::One(1.0);
    let out = folder.path().join("run");
    train(&written(&folder, &with), &out, &[]).assert().success();
    let graph: Value = serde_json::from_str(&text(&out.join("graph.json"))).expect("JSON");
    let names: Vec<&str> =
        graph["sources"].as_array().expect("a list").iter().filter_map(|source| source["name"].as_str()).collect();
    assert_eq!(names, ["cos_theta", "sin_theta", "omega", "drift", "since_progress", "since_asked"]);
    eval(&out.join("graph.json"), &["--policy", NETWORK]).assert().success();
    // Without the network there is no such memory.
    refused(eval(&out.join("graph.json"), &[]), &["graph.json", "\"drift\"", "cos_theta, sin_theta, omega"]);
}
