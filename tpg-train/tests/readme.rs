//! Every command of the README that trains, evaluates, reports or compiles, run as a new user would.

use std::path::Path;
use std::process::Command;
use tempfile::TempDir;
use tpg_testing::library::top;

/// Commands that other checks run: the tests themselves, and the example folder's, which `cargo xtask check` builds and
/// runs.
const ELSEWHERE: [&str; 4] = ["cargo xtask test", "cargo xtask library", "make && make run", "cd c-harness/example"];

/// Flags that shorten a command, after the words by which it is known.
const SHORTER: [(&str, &str); 2] = [("tpg --problem pendulum", "--generations 3"), ("verify ", "--states 2000")];

/// The lines of the README's shell blocks, without comments.
fn commands(readme: &str) -> Vec<String> {
    let mut blocks = readme.split("```");
    blocks.next();
    // Every other part stands inside a block.
    let shell = blocks.step_by(2).filter_map(|block| block.strip_prefix("sh\n"));
    let lines = shell.flat_map(|block| block.lines().map(|line| line.split(" #").next().unwrap_or("").trim()));
    lines.filter(|line| !line.is_empty() && !line.starts_with('#')).map(str::to_owned).collect()
}

/// The commands' programs as this test was built with them.
fn with_programs(line: &str, folder: &Path) -> String {
    let mut line = line.to_owned();
    for name in ["tpg-train", "tpg-codegen"] {
        for before in [format!("cargo run --release -p {name} --"), format!("cargo run -q -p {name} --")] {
            line = line.replace(&before, &folder.join(name).display().to_string());
        }
    }
    line
}

#[test]
fn the_commands_of_the_readme_run() {
    let programs = Path::new(env!("CARGO_BIN_EXE_tpg-train")).parent().expect("a folder");
    if !programs.join("tpg-codegen").exists() {
        tpg_testing::skip("README's commands: tpg-codegen is not built (cargo test --workspace builds it)");
        return;
    }
    if !tpg_testing::tool("arm-none-eabi-gcc", "gcc-arm-none-eabi", "README's commands") {
        return;
    }
    let readme = std::fs::read_to_string(top().join("README.md")).expect("the README");
    let place = TempDir::new().expect("a folder");
    std::os::unix::fs::symlink(top().join("generated"), place.path().join("generated")).expect("a link");
    let mut run = 0;
    for line in commands(&readme) {
        if ELSEWHERE.iter().any(|elsewhere| line.starts_with(elsewhere)) || line.contains("../../generated") {
            continue;
        }
        let mut words = with_programs(&line, programs);
        assert!(!words.starts_with("cargo"), "a command that this test does not know: {line}");
        for (known, shorter) in SHORTER {
            if words.contains(known) {
                words = format!("{words} {shorter}");
            }
        }
        let output = Command::new("sh").args(["-c", &words]).current_dir(place.path()).output().expect("sh starts");
        let text = String::from_utf8_lossy(&output.stderr);
        assert!(output.status.success(), "{line}\n{text}");
        run += 1;
    }
    assert!(run >= 6, "only {run} commands were found");
}
