//! `tpg-paper replay` on small inputs: output, exit codes, and messages about bad input.

use assert_cmd::Command;
use std::fs;
use std::path::PathBuf;
use tempfile::TempDir;

/// One team with one program that bids 0: the base always turns by +3 ticks.
const GRAPH: &str = r#"{
  "format": "tpg-graph", "version": 1, "scalar": "f64", "maths": "system", "registers": 8,
  "sources": [{"name": "target", "length": 3, "unit": "mm", "ranges": [[-500, 500], [-500, 500], [-500, 700]]}],
  "instructions": ["add"],
  "actions": [{"id": 0, "name": "base+3", "move": [3, 0, 0, 0]}],
  "root": 0,
  "teams": [{"id": 0, "edges": [{"program": 0, "action": 0}]}],
  "programs": [{"id": 0, "lines": []}]
}"#;
const TARGETS: &str = "row,m0,m1,m2,m3,tx,ty,tz\n7,4088,2048,2048,2048,0,0,1000\n";
/// From 4088: 4091, 4094, then refused. The distance is about that from (0, ±346, 267) to (0, 0, 1000).
const ENDS: &str = "row,score_x1000,distance_um,success,collision,nb_actions\n7,-810558,810558,0,1,3\n";
const TRACE: &str = "row,step,m0,m1,m2,m3\n7,1,4091,2048,2048,2048\n7,2,4094,2048,2048,2048\n7,3,4094,2048,2048,2048\n";

/// Input files, which tests can modify.
struct Input {
    folder: TempDir,
}

impl Input {
    fn new() -> Self {
        let input = Self { folder: TempDir::new().unwrap() };
        for (name, text) in [("graph.json", GRAPH), ("targets.csv", TARGETS), ("ends.csv", ENDS), ("trace.csv", TRACE)]
        {
            input.write(name, text);
        }
        input
    }

    fn with(name: &str, text: impl AsRef<[u8]>) -> Self {
        let input = Self::new();
        input.write(name, text);
        input
    }

    fn write(&self, name: &str, text: impl AsRef<[u8]>) {
        fs::write(self.path(name), text).unwrap();
    }

    fn path(&self, name: &str) -> PathBuf {
        self.folder.path().join(name)
    }

    fn replay(&self) -> Command {
        let mut command = Command::cargo_bin("tpg-paper").unwrap();
        command.args(["replay", "--problem", "fs"]);
        for (option, file) in
            [("--graph", "graph.json"), ("--targets", "targets.csv"), ("--ends", "ends.csv"), ("--trace", "trace.csv")]
        {
            command.arg(option).arg(self.path(file));
        }
        command
    }

    /// Replays, expects exit status 2 and nothing on stdout, and returns stderr.
    fn refused(&self) -> String {
        let assert = self.replay().assert().code(2).stdout("");
        String::from_utf8(assert.get_output().stderr.clone()).unwrap()
    }
}

/// Checks that a message contains all parts.
fn assert_says(message: &str, parts: &[&str]) {
    for part in parts {
        assert!(message.contains(part), "{part:?} is not in: {message}");
    }
}

#[test]
fn what_is_exact_is_counted() {
    let expected = "ends: rows 1, exact_rows 1, steps 0, exact_steps 0\n\
                    trace: rows 1, exact_rows 1, steps 3, exact_steps 3\n";
    Input::new().replay().assert().code(0).stdout(expected);
}

#[test]
fn the_json_holds_the_same() {
    let assert = Input::new().replay().arg("--json").assert().code(0);
    let report: serde_json::Value = serde_json::from_slice(&assert.get_output().stdout).unwrap();
    assert_eq!(report["engine"], "interpreter");
    assert_eq!(report["comparisons"][1]["kind"], "trace");
    assert_eq!(report["comparisons"][1]["exact_steps"], 3);
    assert_eq!(report["comparisons"][1]["first_difference"], serde_json::Value::Null);
}

#[test]
fn generated_code_replays_too() {
    for engine in ["c", "rust"] {
        let assert = Input::new().replay().args(["--engine", engine]).assert().code(0);
        let stdout = String::from_utf8(assert.get_output().stdout.clone()).unwrap();
        assert_says(&stdout, &["exact_rows 1", "exact_steps 3"]);
    }
}

#[test]
fn a_difference_is_described_and_fails() {
    let input = Input::with("ends.csv", ENDS.replace(",0,1,3", ",1,1,4"));
    input.write("trace.csv", TRACE.replace("2,4094", "2,4093"));
    let assert = input.replay().assert().code(1);
    let stdout = String::from_utf8(assert.get_output().stdout.clone()).unwrap();
    assert_says(
        &stdout,
        &[
            "ends: rows 1, exact_rows 0",
            "row 7: success 0 instead of 1, nb_actions 3 instead of 4",
            "trace: rows 1, exact_rows 0, steps 3, exact_steps 2",
            "row 7: step 2: pose [4094, 2048, 2048, 2048] instead of [4093, 2048, 2048, 2048]",
        ],
    );
}

#[test]
fn a_trace_of_another_length_fails() {
    let input = Input::with("trace.csv", TRACE.lines().take(3).map(|line| format!("{line}\n")).collect::<String>());
    let assert = input.replay().assert().code(1);
    let stdout = String::from_utf8(assert.get_output().stdout.clone()).unwrap();
    assert_says(&stdout, &["exact_rows 0, steps 2, exact_steps 2", "row 7: 3 steps instead of 2"]);
}

#[test]
fn columns_are_found_by_name() {
    let ends = "nb_actions,row,extra,distance_um,success,score_x1000,collision\n3,7,x,810558,0,-810558,1\n";
    Input::with("ends.csv", ends).replay().assert().code(0);
}

#[test]
fn bad_files_are_refused_by_name_and_line() {
    let cases = [
        ("targets.csv", String::new(), vec!["no rows", "a header line and at least one row"]),
        ("targets.csv", TARGETS.replace("tz", "z"), vec!["line 2", "missing field `tz`"]),
        ("targets.csv", TARGETS.replace("4088", "4096"), vec!["line 2", "m0 = 4096", "0 to 4095"]),
        ("targets.csv", TARGETS.replace("1000", "NaN"), vec!["line 2", "tz = NaN"]),
        ("targets.csv", format!("{TARGETS}7,1,1,1,1,1,1,1\n"), vec!["line 3", "row = 7 again"]),
        ("ends.csv", ENDS.replace("\n7,", "\n8,"), vec!["line 2", "row = 8", "a row of the targets file"]),
        ("ends.csv", ENDS.replace(",0,1,3", ",2,1,3"), vec!["line 2", "success = 2", "0 to 1"]),
        ("ends.csv", ENDS.replace(",0,1,3", ",0,1"), vec!["line 2", "5 fields", "6 fields"]),
        ("ends.csv", ENDS.replace("nb_actions", "success"), vec!["line 2", "duplicate field `success`"]),
        ("trace.csv", TRACE.replace("7,2,", "7,3,"), vec!["line 3", "step = 3", "2: all steps in order"]),
        ("graph.json", "{".to_owned(), vec!["line 1"]),
        ("graph.json", GRAPH.replace("\"target\"", "\"aim\""), vec!["$.sources[0]", "\"aim\"", "target (3 values)"]),
        ("graph.json", GRAPH.replace(", \"move\": [3, 0, 0, 0]", ""), vec!["$.actions[0]", "base+3", "a move"]),
    ];
    for (file, text, parts) in cases {
        let message = Input::with(file, text).refused();
        assert_says(&message, &[file]);
        assert_says(&message, &parts);
    }
}

#[test]
fn bytes_that_are_no_text_are_refused() {
    assert_says(
        &Input::with("ends.csv", [ENDS.as_bytes(), b"\xff,1,1,1,1,1\n"].concat()).refused(),
        &["line 3", "UTF-8"],
    );
    // Only the start of a gzip stream.
    assert_says(&Input::with("trace.csv", b"\x1f\x8b\x08\x00\x00").refused(), &["trace.csv", "a whole gzip file"]);
}

#[test]
fn a_missing_file_is_refused() {
    let input = Input::new();
    fs::remove_file(input.path("ends.csv")).unwrap();
    assert_says(&input.refused(), &["ends.csv", "a CSV file"]);
}

#[test]
fn there_must_be_something_to_compare() {
    let input = Input::new();
    let mut command = Command::cargo_bin("tpg-paper").unwrap();
    command.args(["replay", "--problem", "fs", "--graph"]).arg(input.path("graph.json"));
    command.arg("--targets").arg(input.path("targets.csv")).assert().code(2).stdout("");
}
