//! Every target on a stable compiler: its seeds as they are, then mutants of them by fixed random numbers.
//!
//! `cargo xtask fuzz` runs the same functions under libFuzzer, which chooses by what it covers.

#[path = "smoke/mutation.rs"]
mod mutation;

use mutation::mutate;
use rand::SeedableRng;
use rand_chacha::ChaCha8Rng;
use std::collections::BTreeSet;
use std::fs;
use std::path::{Path, PathBuf};
use tpg_fuzzing::{TARGETS, Target};
use tpg_testing::library::top;

fn folder() -> PathBuf {
    top().join("fuzz")
}

/// The entries of a libFuzzer dictionary, a quoted word a line.
fn words(text: &str) -> Vec<Vec<u8>> {
    let quoted = |line: &str| line.strip_prefix('"')?.strip_suffix('"').map(|word| word.replace("\\\"", "\""));
    text.lines().filter_map(quoted).map(String::into_bytes).collect()
}

fn seeds(folder: &Path) -> Vec<Vec<u8>> {
    let mut paths: Vec<PathBuf> =
        fs::read_dir(folder).expect("a folder of seeds").map(|entry| entry.expect("an entry").path()).collect();
    paths.sort_unstable();
    paths.iter().map(|path| fs::read(path).expect("a seed")).collect()
}

/// Mutants of each target: those that compile a program for each are few.
fn mutants(target: &Target) -> usize {
    match target.name {
        "compiled" => tpg_testing::amount(6, 20),
        "graph_json" | "dot" | "checkpoint_file" => tpg_testing::amount(1_000, 3_000),
        _ => tpg_testing::amount(3_000, 10_000),
    }
}

fn check(name: &str) {
    let target = TARGETS.iter().find(|target| target.name == name).expect("a target");
    let seeds = seeds(&folder().join("corpus").join(name));
    let words = words(&fs::read_to_string(folder().join("tpg.dict")).expect("a dictionary"));
    seeds.iter().for_each(|seed| (target.run)(seed));
    let mut random = ChaCha8Rng::seed_from_u64(1);
    for mutant in 0..mutants(target) {
        (target.run)(&mutate(&mut random, &seeds[mutant % seeds.len()], &words, &seeds));
    }
}

macro_rules! targets {
    ($($name:ident),*) => {
        $(#[test]
        fn $name() {
            check(stringify!($name));
        })*

        const TESTED: &[&str] = &[$(stringify!($name)),*];
    };
}

targets!(
    graph_json,
    dot,
    trace,
    recording,
    compiled,
    policy,
    packed_words,
    safetensors,
    targets,
    scenes,
    urdf,
    hybrid,
    tpg_config,
    sac_config,
    checkpoint_file
);

#[test]
fn every_target_has_a_test_a_program_and_seeds() {
    let names: BTreeSet<String> = TARGETS.iter().map(|target| target.name.to_owned()).collect();
    assert_eq!(names, TESTED.iter().map(ToString::to_string).collect());
    for (part, suffix) in [("fuzz_targets", ".rs"), ("corpus", "")] {
        let entries = fs::read_dir(folder().join(part)).expect("a folder");
        let found = entries.map(|entry| entry.expect("an entry").file_name().to_string_lossy().replace(suffix, ""));
        assert_eq!(names, found.collect(), "{part}");
    }
}
