//! Compile times from 10 to 10,000 teams: this project's compiler, then the C or Rust compiler on its output, with the
//! usual optimisation (`-O2`, `-O`).
//!
//! `cargo bench -p tpg-benches --bench compile_time`; `-- TEAMS` stops at that number of teams. Times are CPU seconds,
//! including children; each is a single run because large ones take long enough. A step that would take more than five
//! minutes, extrapolated linearly, is skipped, and the table says so.

use std::path::Path;
use std::process::Command;
use std::{env, fs};
use tempfile::TempDir;
use tpg_codegen::emit::{self, Language, Options, Profile, Style};
use tpg_codegen::verify;
use tpg_graph::Word;
use tpg_graph::sample::{self, Constants, Shape};
use tpg_graph::{Graph, ScalarType};
use tpg_train::evolution::logs;

const SIZES: [usize; 4] = [10, 100, 1_000, 10_000];
/// Longest step to attempt, seconds.
const PATIENCE: f64 = 300.0;

fn main() {
    let testing = !env::args().any(|word| word == "--bench");
    let limit = env::args().skip(1).find_map(|word| word.parse().ok()).unwrap_or(if testing { 10 } else { 10_000 });
    let sizes: Vec<usize> = SIZES.into_iter().filter(|&teams| teams <= limit).collect();
    println!("\nCPU seconds to compile a graph; in brackets, the ratio to the time for a tenth of the teams\n");
    let heads: Vec<String> = sizes.iter().map(|teams| format!("{teams} teams")).collect();
    println!("| what | {} |\n| --- |{}", heads.join(" | "), " --- |".repeat(sizes.len()));
    let graphs: Vec<Graph> = sizes.iter().map(|&teams| graph(teams)).collect();
    for (language, style, profile) in shapes() {
        let name = profile.map_or("gegelati".to_owned(), |profile| profile.name().to_owned());
        let options = Options { style, profile, ..Options::new("large".parse().expect("a prefix")) };
        let mut compiler = Vec::new();
        let mut other = Vec::new();
        for graph in &graphs {
            let before = cpu_seconds();
            let files = emit::emit(graph, language, &options);
            compiler.push(Some(cpu_seconds() - before));
            let last: Option<f64> = other.last().copied().flatten();
            let hopeless = !other.is_empty() && last.is_none_or(|last| last * 10.0 > PATIENCE);
            other.push((!hopeless).then(|| {
                let folder = TempDir::new().expect("a temporary folder");
                for file in &files {
                    fs::write(folder.path().join(&file.name), &file.text).expect("the folder can be written");
                }
                build(folder.path(), language)
            }));
        }
        row(&format!("{language:?} {name}: tpg-codegen"), &compiler);
        row(&format!("{language:?} {name}: the {language:?} compiler"), &other);
    }
}

fn shapes() -> impl Iterator<Item = (Language, Style, Option<Profile>)> {
    let pure = |language| Profile::ALL.map(move |profile| (language, Style::Pure, Some(profile)));
    [(Language::C, Style::Gegelati, None)].into_iter().chain(pure(Language::C)).chain(pure(Language::Rust))
}

/// Creates a graph without constants and divisions, so that no bid is known at compile time: passes find little to
/// remove.
fn graph(teams: usize) -> Graph {
    let names = ["add", "sub", "mul", "negate_if_less", "cos"];
    let shape = Shape {
        teams,
        edges: 2..=8,
        lines: 2..=10,
        registers: 3,
        scalar: ScalarType::F32,
        instructions: names.iter().copied().filter_map(Word::from_name).collect(),
        constants: Constants::None,
        ..Shape::default()
    };
    sample::graph(&shape, 1)
}

/// Compiles to an object file and returns the time that took.
fn build(folder: &Path, language: Language) -> f64 {
    let command = match language {
        Language::C => {
            let mut command = verify::c_command(folder).unwrap_or_else(|error| panic!("{error}"));
            command.args(["-c", "large.c"]);
            command
        }
        Language::Rust => {
            verify::runtime_library(folder).unwrap_or_else(|error| panic!("{error}"));
            let mut command: Command = verify::rustc(folder);
            command.args(["-Coverflow-checks=off", "--crate-type=lib", "--emit=obj", "large.rs"]);
            command.arg("--extern=tpg_runtime=libtpg_runtime.rlib");
            command
        }
    };
    let before = cpu_seconds();
    verify::compile(if language == Language::C { "C" } else { "Rust" }, command)
        .unwrap_or_else(|error| panic!("{error}"));
    cpu_seconds() - before
}

fn row(name: &str, seconds: &[Option<f64>]) {
    let cells: Vec<String> = (0..seconds.len())
        .map(|place| {
            let before = place.checked_sub(1).and_then(|before| seconds[before]);
            match (seconds[place], before) {
                (Some(now), Some(before)) if before > 0.0 => format!("{now:.2} ({:.1})", now / before),
                (Some(now), _) => format!("{now:.2}"),
                (None, _) => "not tried".to_owned(),
            }
        })
        .collect();
    println!("| {name} | {} |", cells.join(" | "));
}

fn cpu_seconds() -> f64 {
    logs::cpu_seconds().expect("Linux's account of this process")
}
