//! Generated code by each compiler at each level of optimisation: every decision is the interpreter's.
//!
//! Short tests take only tcc, which takes C99 to the letter and optimises nothing; `TPG_FULL_TESTS=1` takes all.

use crate::common::codes;
use std::path::Path;
use std::process::Command;
use tpg_codegen::emit::{self, Language, Options, Profile};
use tpg_codegen::verify::{self, Workshop};
use tpg_graph::Graph;
use tpg_graph::sample::{self, Shape};

const STATES: usize = 600;
/// The first seed of the graphs of both kinds; other tests draw from others.
const FIRST_SEED: u64 = 20_000_000;

/// A compiler.
struct Compiler {
    program: &'static str,
    /// The Debian package, or what else installs it.
    package: &'static str,
    language: Language,
    options: &'static [&'static str],
    /// Options of each level of optimisation.
    levels: &'static [&'static str],
}

const C: &[&str] = &["-std=c99", "-ffp-contract=off"];
const CPP: &[&str] = &["-x", "c++", "-std=c++11", "-ffp-contract=off"];
const RUST: &[&str] = &["--edition=2024", "-Coverflow-checks=on", "-Awarnings"];
const C_LEVELS: &[&str] = &["-O0", "-O1", "-O2", "-O3", "-Os"];
const RUST_LEVELS: &[&str] =
    &["-Copt-level=0", "-Copt-level=1", "-Copt-level=2", "-Copt-level=3", "-Copt-level=s", "-Copt-level=z"];

const COMPILERS: [Compiler; 6] = [
    Compiler { program: "tcc", package: "tcc", language: Language::C, options: &[], levels: &["-std=c99"] },
    Compiler { program: "gcc", package: "gcc", language: Language::C, options: C, levels: C_LEVELS },
    Compiler { program: "clang", package: "clang", language: Language::C, options: C, levels: C_LEVELS },
    Compiler { program: "g++", package: "g++", language: Language::C, options: CPP, levels: C_LEVELS },
    Compiler { program: "clang++", package: "clang", language: Language::C, options: CPP, levels: C_LEVELS },
    Compiler { program: "rustc", package: "rustup", language: Language::Rust, options: RUST, levels: RUST_LEVELS },
];

fn options(number: usize, profile: Profile) -> Options {
    let name = profile.name().replace('-', "_");
    let prefix = format!("p{number}_{name}").parse().expect("a prefix");
    Options { profile: Some(profile), ..Options::new(prefix) }
}

/// The first graphs, up to one of each scalar with minus infinity among the constants of its tables; then some of both kinds.
fn graphs() -> Vec<Graph> {
    let mut wanted = vec!["= -INFINITY;", "= -(double)INFINITY;"];
    let mut graphs = Vec::new();
    for seed in 0..500 {
        let graph = sample::graph(&Shape::random(seed), seed);
        let text: String =
            emit::emit(&graph, Language::C, &options(0, Profile::Small)).into_iter().map(|file| file.text).collect();
        let before = wanted.len();
        wanted.retain(|constant| !text.contains(&format!("] {constant}")));
        if graphs.len() < 10 || wanted.len() < before {
            graphs.push(graph);
        }
        if wanted.is_empty() {
            break;
        }
    }
    assert!(wanted.is_empty(), "no graph has a constant minus infinity");
    let shape = |seed: u64| if seed.is_multiple_of(2) { Shape::random(seed) } else { Shape::random_with_outputs(seed) };
    let both = (FIRST_SEED..).take(tpg_testing::amount(2, 30));
    graphs.extend(both.map(|seed| sample::graph(&shape(seed), seed)));
    graphs
}

fn compare(compiler: &Compiler, level: &str, graphs: &[Graph]) {
    let policies: Vec<(&Graph, Options)> = (graphs.iter().enumerate())
        .flat_map(|(number, graph)| Profile::ALL.map(|profile| (graph, options(number, profile))))
        .collect();
    let workshop = Workshop::new().expect("a temporary folder");
    let command = |folder: &Path| {
        let mut command = Command::new(compiler.program);
        command.current_dir(folder).args(compiler.options).arg(level);
        command
    };
    let place = format!("{} {level}", compiler.program);
    let batch = workshop.batch(&codes(compiler.language, &policies), Some(&command));
    let batch = batch.unwrap_or_else(|error| panic!("{place}: {error}"));
    for (number, (graph, options)) in policies.iter().enumerate() {
        let mut process = batch.start(number, graph).expect("the program starts");
        let comparisons = verify::compare(graph, &mut [&mut process], STATES, 1).expect("it runs");
        assert_eq!(comparisons[0].differences, 0, "{place}, {}: {:?}", options.prefix, comparisons[0]);
    }
}

#[test]
fn every_compiler_at_every_level_takes_every_profile_and_it_acts_like_the_interpreter() {
    let graphs = graphs();
    for compiler in &COMPILERS[..tpg_testing::amount(1, COMPILERS.len())] {
        let what = format!("generated {} by {}", compiler.language.name(), compiler.program);
        if tpg_testing::tool(compiler.program, compiler.package, &what) {
            compiler.levels.iter().for_each(|level| compare(compiler, level, &graphs));
        }
    }
}
