//! Habits of the command line: closed pipes, `--quiet`, completions, manual pages, the report as a page.

use assert_cmd::Command;
use std::process;

const GRAPH: &str = concat!(env!("CARGO_MANIFEST_DIR"), "/tests/fixtures/cartpole.json");

fn codegen(words: &[&str]) -> String {
    let output = Command::new(env!("CARGO_BIN_EXE_tpg-codegen")).args(words).assert().success();
    String::from_utf8(output.get_output().stdout.clone()).expect("text")
}

#[test]
fn a_reader_that_has_gone_ends_the_program_quietly() {
    for words in [&["report", "--json", "--target", "host", GRAPH][..], &["schema"], &["man"], &["completions", "bash"]]
    {
        // Gone before the program starts: another test that starts one at this moment would hold the reader's end a little longer.
        let (reader, writer) = std::io::pipe().expect("a pipe");
        drop(reader);
        let mut command = process::Command::new(env!("CARGO_BIN_EXE_tpg-codegen"));
        let output = command.args(words).stdout(writer).output().expect("it ends");
        assert_eq!(output.status.code(), Some(141), "{words:?}");
        assert!(output.stderr.is_empty(), "{words:?}: {}", String::from_utf8_lossy(&output.stderr));
    }
}

#[test]
fn quiet_prints_no_sentence_about_success() {
    let words = ["verify", GRAPH, "--lang", "rust", "--profile", "fast", "--states", "100"];
    assert!(codegen(&words).contains("= interpreter on 100 states"));
    assert_eq!(codegen(&[&words[..], &["--quiet"]].concat()), "");
    for quiet in ["-q", "--quiet"] {
        assert_eq!(codegen(&[&[quiet], &words[..]].concat()), "");
        assert!(codegen(&[quiet, "schema"]).starts_with('{'));
        let folder = tempfile::tempdir().expect("a folder");
        let out = folder.path().to_str().expect("a name");
        assert_eq!(codegen(&[quiet, GRAPH, "-o", out, "--lang", "c", "--no-verify"]), "");
        assert!(folder.path().join("cartpole.c").exists());
    }
}

#[test]
fn completions_and_manual_pages_know_the_options() {
    for shell in ["bash", "zsh", "fish"] {
        assert!(codegen(&["completions", shell]).contains("max-flash"), "{shell}");
    }
    let page = codegen(&["man", "report"]);
    assert!(page.contains(".TH") && page.contains("max\\-flash"), "{page}");
    assert!(codegen(&["man"]).contains("Exit status"));
    let output = Command::new(env!("CARGO_BIN_EXE_tpg-codegen")).args(["man", "reprot"]).assert().code(2);
    let error = String::from_utf8_lossy(&output.get_output().stderr).into_owned();
    assert!(error.contains("reprot") && error.contains("generate, verify, report"), "{error}");
}
