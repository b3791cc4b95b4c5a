//! Every command of the README and of the guides that trains, evaluates, reports, compiles or bounds, run as a new user
//! would.

use std::env;
use std::ffi::OsStr;
use std::fmt::Write as _;
use std::fs;
use std::path::Path;
use std::process::Command;
use tempfile::TempDir;
use tpg_testing::library::top;
use tpg_testing::numbers::Numbers;
use tpg_train::parts::Tensors;

/// Commands that other checks run, the second on a URDF that is theirs.
const ELSEWHERE: [&str; 2] = ["cargo xtask ", "tpg-train arm import "];

/// Shorter forms of parts of commands.
const SHORTER: [(&str, &str); 6] = [
    ("tpg --problem dodge", "tpg --problem dodge --generations 1"),
    ("--generations 3000 --target 12", "--generations 2"),
    ("tpg --problem pendulum --out", "tpg --problem pendulum --generations 3 --out"),
    ("hybrid --problem pendulum", "hybrid --hand-back-after 20 --separation inf --patience 10 --problem pendulum"),
    ("verify ", "verify --states 2000 "),
    ("--episodes 10000", "--episodes 100"),
];

/// Files that a document's commands read, and the command by which its reader would have made each.
const BEFORE: [(&str, &str); 4] = [
    ("best.dot", "for kind in dot toml; do cp tpg-codegen/tests/fixtures/pole.$kind best.$kind; done"),
    ("runs/a/graph.json", "tpg-train tpg --problem pendulum --generations 3 --out runs/a"),
    ("prove graph.json", "cp generated/cartpole/graph.json . && tpg-codegen graph.json --lang c --prefix pole -o ."),
    ("package graph.json", "cp generated/cartpole/graph.json ."),
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

/// Runs a line of a shell, which succeeds.
fn shell(line: &str, place: &Path, path: &OsStr, what: &str) {
    let output = Command::new("sh").args(["-c", line]).current_dir(place).env("PATH", path).output();
    let output = output.expect("sh starts");
    assert!(output.status.success(), "{what}\n{}", String::from_utf8_lossy(&output.stderr));
}

/// A recording of `generated/cartpole` as a user's own program would make it: states, and the action by the README's formula.
fn recorded() -> String {
    let mut numbers = Numbers(1);
    let mut text = "x[0],v[0],theta[0],omega[0],action\n".to_owned();
    for _ in 0..300 {
        let [x, v, theta, omega] = [4_800_000, 500_000, 410_000, 500_000].map(|most| numbers.within(most) as f32 / 1e6);
        let action = u8::from(theta + omega >= v / -3.290_749_5);
        writeln!(text, "{x:?},{v:?},{theta:?},{omega:?},{action}").expect("a string takes everything");
    }
    text
}

/// An actor that Stable-Baselines3 wrote, cut to the three inputs and the output of Pendulum.
fn pendulum_actor() -> Tensors {
    let file = Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/fixtures/foreign-actors/sb3.safetensors");
    let mut actor = Tensors::read(&file, 1 << 20).expect("a fixture");
    for (name, rows, columns) in [
        ("latent_pi.0.weight", usize::MAX, 3),
        ("mu.weight", 1, usize::MAX),
        ("mu.bias", 1, usize::MAX),
        ("log_std.weight", 1, usize::MAX),
        ("log_std.bias", 1, usize::MAX),
    ] {
        let tensor = actor.tensors.get_mut(name).expect("a tensor of the fixture");
        let width = tensor.shape.get(1).copied().unwrap_or(1);
        let kept = tensor.values.chunks(width).take(rows).flat_map(|row| row.iter().take(columns).copied());
        tensor.values = kept.collect();
        for (length, most) in tensor.shape.iter_mut().zip([rows, columns]) {
            *length = (*length).min(most);
        }
    }
    actor
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
    for folder in ["generated", "tpg-codegen"] {
        std::os::unix::fs::symlink(top().join(folder), place.path().join(folder)).expect("a link");
    }
    for program in blocks(&text, "c").into_iter().filter(|block| block.contains("int main(void)")) {
        fs::create_dir_all(place.path().join("out")).expect("a folder");
        fs::write(place.path().join("out/main.c"), program).expect("written");
    }
    for block in blocks(&text, "toml") {
        for (content, file) in [("[law]", "pid.toml"), ("arm = \"so101\"", "so101.toml")] {
            if block.contains(content) {
                fs::write(place.path().join(file), block).expect("written");
            }
        }
    }
    for (file, line) in BEFORE {
        if text.contains(file) {
            shell(line, place.path(), &path, name);
        }
    }
    for file in ["recorded.csv", "visited.csv"] {
        fs::write(place.path().join(file), recorded()).expect("written");
    }
    pendulum_actor().write(&place.path().join("actor.safetensors")).expect("written");
    fs::write(place.path().join("LICENSE-MIT"), "MIT").expect("written");
    let mut run = 0;
    for line in commands(&text) {
        let mut words = line.clone();
        for program in ["tpg-train", "tpg-codegen"] {
            for before in [format!("cargo run --release -p {program} -- "), format!("cargo run -q -p {program} -- ")] {
                words = words.replace(&before, &format!("{program} "));
            }
        }
        if ELSEWHERE.iter().any(|start| words.starts_with(start)) {
            continue;
        }
        assert!(!words.starts_with("cargo"), "{name}: a command that this test does not know: {line}");
        for (known, shorter) in SHORTER {
            words = words.replace(known, shorter);
        }
        shell(&words, place.path(), &path, &format!("{name}: {line}"));
        run += 1;
    }
    run
}

#[test]
fn the_commands_of_the_readme_run() {
    assert!(run("README.md") >= 4, "commands were not found");
}

#[test]
fn the_commands_of_the_guides_run() {
    for (name, least) in [
        ("docs/first-graph.md", 8),
        ("docs/training.md", 12),
        ("docs/hybrid.md", 5),
        ("docs/importing.md", 9),
        ("docs/codegen.md", 10),
        ("docs/no-fpu.md", 7),
        ("docs/camera.md", 2),
        ("docs/compare.md", 1),
        ("docs/packages.md", 3),
        ("docs/proven.md", 4),
        ("docs/arm.md", 6),
    ] {
        assert!(run(name) >= least, "{name}: commands were not found");
    }
}
