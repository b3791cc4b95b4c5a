//! `tpg-codegen` proves the text that it wrote: compilers that keep what they are given, that refuse, that are not there.
#![cfg(unix)]

use assert_cmd::Command;
use std::fs;
use std::os::unix::fs::PermissionsExt;
use std::path::{Path, PathBuf};
use tempfile::TempDir;
use tpg_graph::sample::{self, Shape};

/// A folder with a graph, `arm.json`.
fn folder() -> TempDir {
    let folder = tempfile::tempdir().expect("a temporary folder");
    let graph = sample::graph(&Shape::default(), 3);
    fs::write(folder.path().join("arm.json"), graph.to_json()).expect("written");
    folder
}

/// Writes a program that runs lines of shell.
fn script(folder: &Path, name: &str, lines: &str) -> PathBuf {
    let path = folder.join(name);
    fs::write(&path, format!("#!/bin/sh\n{lines}\n")).expect("written");
    fs::set_permissions(&path, fs::Permissions::from_mode(0o755)).expect("made a program");
    path
}

/// A compiler that puts a copy of the folder it works in under `kept` and then does its work.
fn keeper(folder: &Path, name: &str, compiler: &str) -> PathBuf {
    let kept = folder.join("kept").join(name);
    fs::create_dir_all(&kept).expect("made");
    script(folder, name, &format!("cp -r . '{}'/$$\nexec {compiler} \"$@\"", kept.display()))
}

fn tool(folder: &Path) -> Command {
    let mut command = Command::cargo_bin("tpg-codegen").expect("the program is built");
    command.current_dir(folder);
    command
}

fn said(command: &mut Command, code: i32) -> (String, String) {
    let output = command.assert().code(code).get_output().clone();
    let [out, err] = [output.stdout, output.stderr].map(|bytes| String::from_utf8(bytes).expect("text"));
    (out, err)
}

/// Every kept file of a name, and whether it lay beside the program that compares.
fn kept(folder: &Path, compiler: &str, name: &str) -> Vec<(Vec<u8>, bool)> {
    let runs = fs::read_dir(folder.join("kept").join(compiler)).expect("a folder");
    let runs = runs.map(|run| run.expect("an entry").path());
    let is_harness = |run: &Path| run.join("main-policies.c").exists() || run.join("main-policies.rs").exists();
    runs.filter_map(|run| Some((fs::read(run.join(name)).ok()?, is_harness(&run)))).collect()
}

#[test]
fn what_is_proven_is_what_was_written() {
    let folder = folder();
    let folder = folder.path();
    let rustc = std::env::var("RUSTC").unwrap_or_else(|_| "rustc".to_owned());
    let [cc, rustc] = [keeper(folder, "cc", "cc"), keeper(folder, "rustc", &rustc)];
    let args = ["arm.json", "--profile", "fast", "-o", "out"];
    let (out, err) = said(tool(folder).args(args).env("CC", cc).env("RUSTC", rustc), 0);
    let proven = |language: &str| format!("{language}, fast = interpreter on 10000 states\n");
    assert!(out.ends_with(&format!("{}{}", proven("C"), proven("Rust"))), "{out}{err}");
    for (compiler, name) in [("cc", "arm.c"), ("cc", "arm.h"), ("rustc", "arm.rs")] {
        let written = fs::read(folder.join("out").join(name)).expect("written");
        let kept = kept(folder, compiler, name);
        assert!(kept.iter().any(|(_, is_compared)| *is_compared), "{name} was compiled to be compared");
        for (text, _) in kept {
            assert!(text == written, "{name}: compiled text is not what was written");
        }
    }
}

#[test]
fn only_the_language_that_was_asked_for_is_compiled() {
    let folder = folder();
    let folder = folder.path();
    let (out, _) = said(tool(folder).args(["arm.json", "--lang", "c", "-o", "out"]).env("RUSTC", "/no/such/rustc"), 0);
    assert!(out.ends_with("\nC, fast = interpreter on 10000 states\n"), "{out}");
    assert_eq!(out.matches(" = interpreter").count(), 1, "{out}");
}

#[test]
fn a_compiler_that_refuses_is_a_failed_check() {
    let folder = folder();
    let folder = folder.path();
    let refuses = script(folder, "refuses", "echo 'arm.c: error: no' >&2\nexit 1");
    let (out, err) = said(tool(folder).args(["arm.json", "-o", "out"]).env("CC", &refuses), 1);
    assert!(err.contains("not verified: C, fast: the C compiler refused generated code:\narm.c: error: no"), "{err}");
    assert!(out.ends_with("\nRust, constant-time = interpreter on 10000 states\n"), "Rust is proven: {out}");
    assert!(!out.contains("C, fast ="), "{out}");
    said(tool(folder).args(["arm.json", "-o", "out", "--no-verify"]).env("CC", &refuses), 0);
}

#[test]
fn a_missing_compiler_is_a_failed_check() {
    let folder = folder();
    let folder = folder.path();
    let args = ["arm.json", "--lang", "c", "-o", "out"];
    let (out, err) = said(tool(folder).args(args).env("CC", "/no/such/cc"), 1);
    assert!(err.contains("not verified: C, fast: C compiler \"/no/such/cc\" cannot be started: "), "{err}");
    assert!(!out.contains("interpreter"), "{out}");
    assert!(folder.join("out/arm.c").exists(), "what was written stays");
    let args = ["arm.json", "--lang", "rust", "-o", "out"];
    let (_, err) = said(tool(folder).args(args).env("RUSTC", "/no/such/rustc"), 1);
    assert!(err.contains("not verified: Rust, constant-time: Rust compiler "), "{err}");
    let (out, _) = said(tool(folder).args(["verify", "arm.json", "--lang", "c", "--json"]).env("CC", "/no/such/cc"), 1);
    assert_eq!(out.matches("cannot be started").count(), 5, "{out}");
}

#[test]
fn code_on_standard_output_is_proven_too() {
    let folder = folder();
    let folder = folder.path();
    let args = ["arm.json", "--lang", "c", "-o", "-"];
    let (out, err) = said(tool(folder).args(args), 0);
    assert_eq!(err, "C, fast = interpreter on 10000 states\n");
    assert!(out.ends_with("\n}\n") || out.ends_with("#endif\n"), "{out}");
    said(tool(folder).args(args).env("CC", "/no/such/cc"), 1);
}

#[test]
fn verify_takes_the_flags_of_generate() {
    let folder = folder();
    let folder = folder.path();
    let verify = |args: &[&str]| {
        let (out, _) = said(tool(folder).args(["verify", "arm.json", "--states", "2000"]).args(args), 0);
        out.lines().map(|line| line.split(" = ").next().unwrap_or("").to_owned()).collect::<Vec<_>>()
    };
    let gegelati = "C in GEGELATI's style";
    let profiles = ["fast", "balanced", "small", "constant-time"];
    let of = |language| profiles.map(|profile| format!("{language}, {profile}"));
    let everything = [&[gegelati.to_owned()][..], &of("C"), &of("Rust")].concat();
    assert_eq!(verify(&[]), everything);
    assert_eq!(verify(&["--lang", "c"]), everything[..5]);
    assert_eq!(verify(&["--style", "gegelati", "--lang", "c"]), [gegelati]);
    assert_eq!(verify(&["--profile", "small"]), ["C, small", "Rust, small"]);
    assert_eq!(verify(&["--profile", "fast", "--prefix", "other"]), ["C, fast", "Rust, fast"]);
    assert_eq!(
        verify(&["--lang", "rust", "--profile", "small", "--scalar", "f64"]),
        ["Rust, small"],
        "the type that the graph has is no change"
    );
}
