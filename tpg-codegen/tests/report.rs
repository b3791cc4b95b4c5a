//! `tpg-codegen report` as a program.

use assert_cmd::Command;
use serde_json::Value;
use std::fs;
use tempfile::TempDir;

fn folder() -> TempDir {
    let folder = tempfile::tempdir().expect("a temporary folder");
    fs::write(folder.path().join("arm.json"), include_str!("fixtures/all_instructions.json")).expect("written");
    folder
}

fn report(folder: &TempDir, args: &[&str], code: i32) -> String {
    let mut tool = Command::cargo_bin("tpg-codegen").expect("the program is built");
    let output =
        tool.current_dir(folder).args(["report", "arm.json"]).args(args).assert().code(code).get_output().clone();
    String::from_utf8(output.stdout).expect("text")
}

fn json(folder: &TempDir, args: &[&str]) -> Value {
    serde_json::from_str(&report(folder, &[args, &["--json"]].concat(), 0)).expect("one JSON object")
}

#[test]
fn sizes_come_from_the_compiler() {
    let folder = folder();
    let host = json(&folder, &["--target", "host"]);
    let sizes = host["sizes"].as_array().expect("sizes");
    let profiles: Vec<&str> = sizes.iter().filter_map(|size| size["profile"].as_str()).collect();
    assert_eq!(profiles, ["fast", "balanced", "small", "constant-time", "gegelati"]);
    for size in sizes {
        assert_eq!(size["target"], "host");
        assert!(size["flash"].as_u64().is_some_and(|flash| flash > 300), "{size}");
        assert_eq!(size["ram"], 0, "{size}");
    }
    if tpg_testing::tool("arm-none-eabi-gcc", "gcc-arm-none-eabi", "the report's sizes on a Cortex-M4F") {
        for size in json(&folder, &["--target", "thumbv7em"])["sizes"].as_array().expect("sizes") {
            assert!(size["flash"].as_u64().is_some_and(|flash| flash > 300), "{size}");
            assert!(size["stack"]["bytes"].as_u64().is_some_and(|stack| stack > 0), "{size}");
            let calls = size["stack"]["without"].as_array().expect("names");
            assert!(calls.iter().any(|name| name == "sin"), "the platform's sine has a stack, too: {size}");
        }
    }
}

#[test]
fn the_rust_has_a_size_on_a_cortex_m4() {
    if !tpg_testing::library::rust_target("thumbv7em-none-eabihf", "the size of Rust on a Cortex-M4F") {
        return;
    }
    let folder = folder();
    let report = json(&folder, &["--target", "thumbv7em"]);
    let sizes = report["rust_sizes"].as_array().expect("sizes");
    let profiles: Vec<&str> = sizes.iter().filter_map(|size| size["profile"].as_str()).collect();
    assert_eq!(profiles, ["fast", "balanced", "small", "constant-time"]);
    for size in sizes {
        assert!(size["flash"].as_u64().is_some_and(|flash| (300..20_000).contains(&flash)), "{size}");
    }
    assert_eq!(json(&folder, &["--target", "host"])["rust_sizes"], Value::Array(Vec::new()));
}

/// The counts by hand are in `cost`.
#[test]
fn costs_are_those_of_the_header() {
    let folder = folder();
    let report = json(&folder, &["--target", "host"]);
    for cost in report["costs"].as_array().expect("costs") {
        let mut tool = Command::cargo_bin("tpg-codegen").expect("the program is built");
        let shape = match cost["profile"].as_str().expect("a name") {
            "gegelati" => ["--style", "gegelati"],
            profile => ["--profile", profile],
        };
        let output = tool.current_dir(&folder).args(["arm.json", "--lang", "c", "-o", "-"]).args(shape);
        let text = String::from_utf8(output.assert().success().get_output().stdout.clone()).expect("text");
        for (name, key) in [("OPERATIONS", "operations"), ("MATHS_CALLS", "maths_calls"), ("BIDS", "bids")] {
            let line = format!("#define ARM_WORST_{name} {}U\n", cost["worst"][key]);
            assert!(text.contains(&line), "{line}");
        }
        assert!(text.contains(&format!("#define ARM_DEPTH {}U\n", cost["worst"]["teams"])));
    }
}

#[test]
fn for_people() {
    let text = report(&folder(), &["--target", "host"], 0);
    // Sizes are the compiler's; everything before them is this tool's.
    let (ours, sizes) = text.split_once("\nbytes on ").expect("two parts");
    insta::assert_snapshot!(ours);
    assert!(sizes.starts_with("this machine, compiled with -Os"), "{sizes}");
}

#[test]
fn another_scalar_type_is_said() {
    let folder = folder();
    let report = json(&folder, &["--target", "host", "--scalar", "f32"]);
    assert_eq!((&report["scalar"], &report["maths"]), (&Value::from("f32"), &Value::from("own")));
    assert_eq!(report["conversion"]["from"], "f64");
    assert_eq!(report["conversion"]["agreement"]["states"], 20_000);
    assert_ne!(report["conversion"]["agreement"]["equal"], 0);
}

#[test]
fn a_limit_is_a_verdict() {
    let folder = folder();
    assert!(report(&folder, &["--target", "host", "--max-flash", "10"], 1).contains("bytes on this machine"));
    report(&folder, &["--target", "host", "--max-flash", "1000000", "--profile", "small"], 0);
}

#[test]
fn without_a_cross_compiler_it_is_an_estimate_and_says_so() {
    let folder = folder();
    let run = |args: &[&str]| {
        let mut tool = Command::cargo_bin("tpg-codegen").expect("the program is built");
        let tool = tool.current_dir(&folder).args(["report", "arm.json", "--target", "thumbv7em"]).args(args);
        String::from_utf8(tool.env("PATH", "").assert().success().get_output().stdout.clone()).expect("text")
    };
    assert!(run(&[]).contains("\nbytes on Cortex-M4F: an ESTIMATE, for arm-none-eabi-gcc: "));
    let report: Value = serde_json::from_str(&run(&["--json"])).expect("one JSON object");
    for size in report["sizes"].as_array().expect("sizes") {
        assert_eq!((&size["estimated"], &size["stack"]), (&Value::from(true), &Value::Null));
        assert!(size["flash"].as_u64().is_some_and(|flash| (200..20_000).contains(&flash)), "{size}");
    }
    assert!(run(&[]).contains("\nbytes of the Rust: not known: "));
}

/// All states of the sample at once would take 2.6 GB.
#[cfg(target_os = "linux")]
#[test]
fn a_wide_graph_takes_little_memory() {
    use tpg_graph::sample::{self, Shape};
    let shape = Shape { sources: vec![tpg_testing::amount(8_192, 16_384)], teams: 2, edges: 1..=2, ..Shape::default() };
    let folder = tempfile::tempdir().expect("a temporary folder");
    fs::write(folder.path().join("wide.json"), sample::graph(&shape, 1).to_json()).expect("written");
    let tool = assert_cmd::cargo::cargo_bin("tpg-codegen");
    let mut limited = Command::new("sh");
    limited
        .current_dir(&folder)
        .args(["-c", "ulimit -v 1000000 && exec \"$0\" report wide.json --target host"])
        .arg(tool);
    let output = limited.assert().code(0).get_output().clone();
    assert!(String::from_utf8_lossy(&output.stdout).contains("constant-time"));
}
