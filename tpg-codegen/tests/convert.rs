//! `tpg-codegen convert` and `schema` as programs: what is written, and that nothing is where it cannot be.

use assert_cmd::Command;
use std::fs;
use std::path::Path;
use tempfile::TempDir;
use tpg_graph::Graph;
use tpg_graph::sample::{self, Shape};

fn tool() -> Command {
    Command::cargo_bin("tpg-codegen").expect("the program is built")
}

/// A folder with a graph that is larger than a disk block.
fn folder() -> (TempDir, Graph) {
    let folder = tempfile::tempdir().expect("a temporary folder");
    let graph = sample::graph(&Shape::default(), 1);
    fs::write(folder.path().join("x.json"), graph.to_json()).expect("written");
    (folder, graph)
}

fn names(folder: &Path) -> Vec<String> {
    let entries = fs::read_dir(folder).expect("a folder").map(|entry| entry.expect("an entry").file_name());
    let mut names: Vec<String> = entries.map(|name| name.into_string().expect("a plain name")).collect();
    names.sort();
    names
}

/// Runs a command that must fail with 2 and returns what it said.
fn refused(command: &mut Command) -> String {
    let output = command.assert().code(2).get_output().clone();
    assert!(output.stdout.is_empty());
    let said = String::from_utf8(output.stderr).expect("text");
    assert!(said.starts_with("error: ") && said.contains("; accepted: ") && said.lines().count() == 1, "{said}");
    said
}

#[test]
fn dot_to_json() {
    let (folder, _) = folder();
    for (name, original) in [("pole", "../generated/cartpole/graph.json"), ("swing", "tests/fixtures/swing_up.json")] {
        let fixtures = Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/fixtures");
        let mut convert = tool();
        convert.current_dir(&folder).arg("convert").arg(fixtures.join(format!("{name}.dot")));
        convert.arg("--sidecar").arg(fixtures.join(format!("{name}.toml"))).arg("z.json").assert().success().stdout("");
        let read = |path: &Path| Graph::from_json("x", &fs::read_to_string(path).expect("a graph")).expect("valid");
        let original = read(&Path::new(env!("CARGO_MANIFEST_DIR")).join(original));
        let found = read(&folder.path().join("z.json"));
        assert_eq!(found.teams(), original.teams(), "{name}");
        assert_eq!(found.programs(), original.programs(), "{name}");
        assert_eq!(found.leaves(), original.leaves(), "{name}");
        assert_eq!(found.sources(), original.sources(), "{name}");
    }
}

#[test]
fn stdin_to_stdout() {
    let (_folder, graph) = folder();
    tool().args(["convert", "-", "-"]).write_stdin(graph.to_json()).assert().success().stdout(graph.to_json());
    let said = refused(tool().args(["convert", "-", "-"]).write_stdin(""));
    assert!(said.contains("<stdin>: an empty file"), "{said}");
}

#[test]
fn the_schema() {
    tool().arg("schema").assert().success().stdout(tpg_graph::schema());
}

#[test]
fn bad_input_writes_nothing() {
    let (folder, graph) = folder();
    fs::write(folder.path().join("bad.json"), &graph.to_json()[..1000]).expect("written");
    fs::write(folder.path().join("bad.dot"), "digraph{\n\tT0 []\n").expect("written");
    fs::write(folder.path().join("bytes.json"), b"{\n\"\xff\"").expect("written");
    let before = names(folder.path());
    for (args, expected) in [
        (["convert", "bad.json", "out.json"].as_slice(), "bad.json: line "),
        (&["convert", "bytes.json", "out.json"], "bytes.json: line 2: bytes that are not UTF-8"),
        (&["convert", "missing.json", "out.json"], "missing.json: No such file"),
        (&["convert", "bad.dot", "out.json"], "bad.dot: a .dot file"),
        (&["convert", "bad.dot", "--profile-of", "ecta24", "out.json"], "bad.dot: line 2: the file ends"),
        (&["convert", "bad.dot", "--sidecar", "missing.toml", "out.json"], "missing.toml: No such file"),
        (&["convert", "x.json", "--profile-of", "ecta24", "out.json"], "x.json: a graph.json with"),
        (&["convert", "x.json", "no/folder/out.json"], "no/folder/out.json: No such file"),
        (&["convert", "x.json", "x.json/out.json"], "x.json/out.json: Not a directory"),
        (&["generate", "bad.json", "-o", "out"], "bad.json: line "),
        (&["verify", "bad.json"], "bad.json: line "),
    ] {
        let said = refused(tool().current_dir(&folder).args(args));
        assert!(said.contains(expected), "{args:?}: {said}");
        assert_eq!(names(folder.path()), before, "{args:?}");
    }
}

/// A limit on file sizes stands for a full disk: the write fails half-way.
#[cfg(unix)]
#[test]
fn a_full_disk_leaves_no_half_file() {
    let (folder, _) = folder();
    fs::write(folder.path().join("old.json"), "old").expect("written");
    let before = names(folder.path());
    for args in [["convert", "x.json", "old.json"], ["convert", "x.json", "new.json"], ["generate", "x.json", "-o."]] {
        let mut shell = Command::new("sh");
        // Without the trap the system ends a program that writes too much, where a full disk is only an error.
        shell.args(["-c", "trap '' XFSZ; ulimit -f 1; exec \"$@\"", "sh"]);
        let program = tool().get_program().to_owned();
        let said = refused(shell.current_dir(&folder).arg(program).args(args));
        assert!(said.contains("File too large"), "{said}");
        assert_eq!(names(folder.path()), before, "{args:?}");
        assert_eq!(fs::read_to_string(folder.path().join("old.json")).expect("old.json"), "old");
    }
}
