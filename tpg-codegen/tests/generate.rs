//! `tpg-codegen GRAPH` as a program: where files come from and go to, what `--check` says, and what is refused.

use assert_cmd::Command;
use std::fs;
use std::path::Path;
use tempfile::TempDir;
use tpg_graph::conversion;
use tpg_graph::sample::{self, Shape};
use tpg_graph::states::StateSet;
use tpg_graph::{Graph, MathsProvider, ScalarType};

fn tool(folder: &Path) -> Command {
    let mut command = Command::cargo_bin("tpg-codegen").expect("the program is built");
    command.current_dir(folder);
    command
}

/// A folder with a graph that computes in f64 with the system's maths and acts otherwise in f32.
fn folder() -> (TempDir, Graph) {
    let folder = tempfile::tempdir().expect("a temporary folder");
    let shape = Shape { scalar: ScalarType::F64, maths: MathsProvider::System, ..Shape::default() };
    let differs = |graph: &Graph| {
        let set = StateSet::sampled(graph, 20_000, 1);
        let (_, conversion) = conversion::convert(graph, ScalarType::F32, "", &set).expect("f32 holds it");
        conversion.agreement.equal < 20_000
    };
    let graph = (0..20).map(|seed| sample::graph(&shape, seed)).find(differs).expect("one that notices f32");
    fs::write(folder.path().join("arm.json"), graph.to_json()).expect("written");
    (folder, graph)
}

fn said(command: &mut Command, code: i32) -> (String, String) {
    let output = command.assert().code(code).get_output().clone();
    let [out, err] = [output.stdout, output.stderr].map(|bytes| String::from_utf8(bytes).expect("text"));
    (out, err)
}

fn generate(folder: &Path, args: &[&str], code: i32) -> (String, String) {
    said(tool(folder).args(["arm.json", "--no-verify"]).args(args), code)
}

#[test]
fn check_tells_fresh_from_stale_from_missing() {
    let (folder, _) = folder();
    let folder = folder.path();
    let (_, err) = generate(folder, &["-o", "out", "--check"], 1);
    assert_eq!(err.matches("No such file").count(), 3, "{err}");
    assert!(!folder.join("out").exists(), "--check writes nothing");
    generate(folder, &["-o", "out"], 0);
    assert_eq!(generate(folder, &["-o", "out", "--check"], 0), (String::new(), String::new()));
    // Other options give other files.
    let (_, err) = generate(folder, &["-o", "out", "--check", "--profile", "small"], 1);
    assert_eq!(err.matches(": stale: ").count(), 3, "{err}");
    let c = folder.join("out/arm.c");
    fs::write(&c, fs::read_to_string(&c).expect("C") + "\n").expect("written");
    let (_, err) = generate(folder, &["-o", "out", "--check"], 1);
    assert_eq!(err, "out/arm.c: stale: not what this graph and these options give\n");
    fs::remove_file(&c).expect("removed");
    let (_, err) = generate(folder, &["-o", "out", "--check"], 1);
    assert!(err.starts_with("out/arm.c: No such file") && err.lines().count() == 1, "{err}");
    assert!(!c.exists());
    // Only what is asked for is checked.
    generate(folder, &["-o", "out", "--check", "--lang", "rust"], 0);
}

#[test]
fn the_bytes_do_not_depend_on_the_folder_or_on_how_the_graph_comes() {
    let (folder, graph) = folder();
    let folder = folder.path();
    generate(folder, &["-o", "here"], 0);
    fs::create_dir(folder.join("elsewhere")).expect("made");
    let away = folder.join("elsewhere");
    said(tool(&away).args(["../arm.json", "--no-verify", "-o", "."]), 0);
    let input = graph.to_json();
    said(tool(folder).args(["-", "--no-verify", "--prefix", "arm", "-o", "piped"]).write_stdin(input.as_str()), 0);
    for name in ["arm.h", "arm.c", "arm.rs"] {
        let here = fs::read(folder.join("here").join(name)).expect("written");
        assert!(here == fs::read(away.join(name)).expect("written"), "{name}");
        assert!(here == fs::read(folder.join("piped").join(name)).expect("written"), "{name}");
    }
}

#[test]
fn standard_output_gets_the_files_and_nothing_else() {
    let (folder, graph) = folder();
    let folder = folder.path();
    generate(folder, &["-o", "out"], 0);
    let file = |name: &str| fs::read_to_string(folder.join("out").join(name)).expect("written");
    let (rust, err) = generate(folder, &["--lang", "rust", "-o", "-"], 0);
    assert_eq!((rust.as_str(), err.as_str()), (file("arm.rs").as_str(), ""), "one file comes as it is");
    let piped = ["-", "--lang", "c", "-o", "-"];
    let (c, _) = said(tool(folder).args(piped).args(["--prefix", "arm"]).write_stdin(graph.to_json()), 0);
    assert_eq!(c, format!("/* ---- arm.h ---- */\n{}/* ---- arm.c ---- */\n{}", file("arm.h"), file("arm.c")));
    let (c, _) = said(tool(folder).args(piped).write_stdin(graph.to_json()), 0);
    assert!(c.contains("policy_action_t policy_infer("), "a graph without a file has a name, too");
    assert_eq!(fs::read_dir(folder).expect("a folder").count(), 2, "arm.json and out");
}

#[cfg(unix)]
#[test]
fn no_folder_is_left_where_nothing_could_be_written() {
    let (folder, _) = folder();
    let program = tool(folder.path()).get_program().to_owned();
    let mut shell = Command::new("sh");
    // A limit on file sizes stands for a full disk.
    shell.args(["-c", "trap '' XFSZ; ulimit -f 1; exec \"$@\"", "sh"]);
    shell.current_dir(&folder).arg(program).args(["arm.json", "-o", "new/folder"]);
    let (_, err) = said(&mut shell, 2);
    assert!(err.contains("File too large"), "{err}");
    assert!(!folder.path().join("new").exists());
}

#[test]
fn another_scalar_type_is_never_silent() {
    let (folder, graph) = folder();
    let folder = folder.path();
    let (out, _) = generate(folder, &["--scalar", "f32", "-o", "out"], 0);
    let sentence =
        out.lines().next().expect("a line").strip_prefix("f32 instead of f64: ").expect("says so").to_owned();
    assert!(sentence.contains(" of 20000 actions equal ("), "{sentence}");
    for name in ["arm.h", "arm.c", "arm.rs"] {
        let text = fs::read_to_string(folder.join("out").join(name)).expect("written");
        assert!(text.contains(&sentence), "{name}: {sentence}");
        assert!(text.contains(" --scalar f32\n") && text.contains(&graph.sha256()), "{name}");
        assert!(text.contains("Computes in f32 with own maths.\n"), "{name}");
    }
    assert!(fs::read_to_string(folder.join("out/arm.h")).expect("written").contains("    float "));
    // The type that the graph says is no change.
    generate(folder, &["--scalar", "f64", "-o", "same"], 0);
    generate(folder, &["-o", "same", "--check"], 0);
}

#[test]
fn agreement_is_measured_on_recorded_states_where_there_are_some() {
    let (folder, graph) = folder();
    let folder = folder.path();
    let names: Vec<String> = (graph.sources().iter())
        .flat_map(|source| (0..source.ranges.len()).map(move |place| format!("{}[{place}]", source.name)))
        .collect();
    let row = vec!["0.5"; names.len()].join(",");
    fs::write(folder.join("trace.csv"), format!("{}\n{row}\n{row}\n", names.join(","))).expect("written");
    let (out, _) = generate(folder, &["--scalar", "f32", "--trace", "trace.csv", "-o", "out"], 0);
    assert!(out.contains(" of 2 actions equal (") && out.contains(": 2 recorded states, SHA-256 "), "{out}");
    fs::write(folder.join("trace.csv"), "step\n1\n").expect("written");
    let (_, err) = generate(folder, &["--scalar", "f32", "--trace", "trace.csv", "-o", "other"], 2);
    assert!(err.starts_with("error: trace.csv: line 1: no column ") && !folder.join("other").exists(), "{err}");
}

#[test]
fn an_explanation_instead_of_code() {
    let folder = tempfile::tempdir().expect("a temporary folder");
    let folder = folder.path();
    fs::write(folder.join("arm.json"), include_str!("fixtures/all_instructions.json")).expect("written");
    let (text, err) = generate(folder, &["--explain"], 0);
    assert_eq!(err, "");
    insta::assert_snapshot!(text);
    generate(folder, &["--explain=why.txt"], 0);
    assert_eq!(fs::read_to_string(folder.join("why.txt")).expect("written"), text);
    assert_eq!(fs::read_dir(folder).expect("a folder").count(), 2, "no code is written");
    let (_, err) = generate(folder, &["--explain", "--check"], 2);
    assert!(err.contains("cannot be used with"), "{err}");
}

#[test]
fn a_misspelt_command_is_answered_by_the_nearest_one() {
    let (folder, _) = folder();
    let (_, error) = said(tool(folder.path()).args(["verfy", "arm.json"]), 2);
    assert!(error.contains("unrecognized subcommand 'verfy'") && error.contains("'verify'"), "{error}");
    let (_, error) = said(tool(folder.path()).arg("missing.json"), 2);
    assert!(error.contains("missing.json"), "a file: {error}");
}
