//! Every command of the README and of the guides that trains, evaluates, reports, compiles or bounds, run as a new user
//! would.

use std::env;
use std::fs;
use std::path::Path;
use std::process::Command;
use tempfile::TempDir;
use tpg_testing::library::top;

/// Commands that other checks run, and those with files that only a user has: a graph of GEGELATI's, an actor of another
/// trainer's.
const ELSEWHERE: [&str; 4] = [
    "cargo xtask ",
    "tpg-codegen verify best.dot",
    "tpg-codegen policy policy.q.json",
    "tpg-train import actor.safetensors",
];

/// Commands that take what such an import made.
const IMPORTED: &str = " policy.safetensors";

/// Shorter forms of parts of commands.
const SHORTER: [(&str, &str); 4] = [
    ("tpg --problem pendulum --out", "tpg --problem pendulum --generations 3 --out"),
    ("hybrid --problem pendulum", "hybrid --hand-back-after 20 --separation inf --patience 10 --problem pendulum"),
    ("verify ", "verify --states 2000 "),
    ("--episodes 10000", "--episodes 100"),
];

/// The blocks of a document in a language.
fn blocks<'a>(text: &'a str, language: &str) -> Vec<&'a str> {
    // Every other part stands inside a block.
    text.split("```").skip(1).step_by(2).filter_map(|block| block.strip_prefix(language)?.strip_prefix('\n')).collect()
}

/// The lines of a document's shell blocks, without comments; a line that ends with a backslash goes on.
fn commands(text: &str) -> Vec<String> {
    let blocks: Vec<String> = blocks(text, "sh").into_iter().map(|block| block.replace("\\\n", " ")).collect();
    let lines = blocks.iter().flat_map(|block| block.lines().map(|line| line.split(" #").next().unwrap_or("").trim()));
    lines.filter(|line| !line.is_empty() && !line.starts_with('#')).map(str::to_owned).collect()
}

/// Runs the commands of a document in a folder of its own; returns how many.
fn run(name: &str) -> usize {
    let programs = Path::new(env!("CARGO_BIN_EXE_tpg-train")).parent().expect("a folder");
    for program in ["tpg-codegen", "cortex-bound"] {
        if !programs.join(program).exists() {
            tpg_testing::skip(&format!("{name}: {program} is not built (cargo test --workspace builds it)"));
            return usize::MAX;
        }
    }
    if !tpg_testing::tool("arm-none-eabi-gcc", "gcc-arm-none-eabi", name) {
        return usize::MAX;
    }
    let before = env::var_os("PATH").unwrap_or_default();
    let path = env::join_paths([programs.to_owned()].into_iter().chain(env::split_paths(&before))).expect("a path");
    let text = fs::read_to_string(top().join(name)).expect("a document");
    let place = TempDir::new().expect("a folder");
    std::os::unix::fs::symlink(top().join("generated"), place.path().join("generated")).expect("a link");
    for program in blocks(&text, "c").into_iter().filter(|block| block.contains("int main(void)")) {
        fs::create_dir_all(place.path().join("out")).expect("a folder");
        fs::write(place.path().join("out/main.c"), program).expect("written");
    }
    let mut run = 0;
    for line in commands(&text) {
        let mut words = line.clone();
        for program in ["tpg-train", "tpg-codegen"] {
            for before in [format!("cargo run --release -p {program} -- "), format!("cargo run -q -p {program} -- ")] {
                words = words.replace(&before, &format!("{program} "));
            }
        }
        if ELSEWHERE.iter().any(|other| words.starts_with(other)) || words.contains(IMPORTED) {
            continue;
        }
        assert!(!words.starts_with("cargo"), "{name}: a command that this test does not know: {line}");
        for (known, shorter) in SHORTER {
            words = words.replace(known, shorter);
        }
        let output = Command::new("sh").args(["-c", &words]).current_dir(place.path()).env("PATH", &path).output();
        let output = output.expect("sh starts");
        assert!(output.status.success(), "{name}: {line}\n{}", String::from_utf8_lossy(&output.stderr));
        run += 1;
    }
    run
}

#[test]
fn the_commands_of_the_readme_run() {
    assert!(run("README.md") >= 6, "commands were not found");
}

#[test]
fn the_commands_of_the_guides_run() {
    for (name, least) in [
        ("docs/first-graph.md", 8),
        ("docs/training.md", 12),
        ("docs/hybrid.md", 5),
        ("docs/importing.md", 4),
        ("docs/proving.md", 8),
    ] {
        assert!(run(name) >= least, "{name}: commands were not found");
    }
}
