//! Compares compilers: random graphs in every profile, built by each compiler at each level of optimisation, and every
//! decision beside the interpreter's.
//!
//! `cargo xtask compilers`, or `cargo run --release -p tpg-benches --bin compilers -- [GRAPHS] [STATES]`. Exit status 1 if
//! anything differs or a compiler refuses generated code. Compilers that are not installed are skipped loudly.

use std::env;
use std::path::Path;
use std::process::{Command, ExitCode};
use tpg_codegen::emit::{Language, Options, Profile};
use tpg_codegen::verify::{self, BuildError, Workshop};
use tpg_graph::Graph;
use tpg_graph::sample::{self, Shape};

/// Graphs that are compiled into one program.
const BATCH: usize = 40;
/// The first seed of the graphs; tests draw from others.
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
    Compiler { program: "gcc", package: "gcc", language: Language::C, options: C, levels: C_LEVELS },
    Compiler { program: "clang", package: "clang", language: Language::C, options: C, levels: C_LEVELS },
    // It has no levels: it does not optimise.
    Compiler { program: "tcc", package: "tcc", language: Language::C, options: &["-std=c99"], levels: &[""] },
    Compiler { program: "g++", package: "g++", language: Language::C, options: CPP, levels: C_LEVELS },
    Compiler { program: "clang++", package: "clang", language: Language::C, options: CPP, levels: C_LEVELS },
    Compiler { program: "rustc", package: "rustup", language: Language::Rust, options: RUST, levels: RUST_LEVELS },
];

impl Compiler {
    /// Returns the command in a folder.
    fn command(&self, level: &str, folder: &Path) -> Command {
        let mut command = Command::new(self.program);
        command.current_dir(folder).args(self.options).args((!level.is_empty()).then_some(level));
        command
    }
}

/// Counts of a compiler at a level.
#[derive(Clone, Copy, Default)]
struct InstructionCount {
    policies: usize,
    decisions: usize,
    differences: usize,
}

fn main() -> Result<ExitCode, Box<dyn std::error::Error>> {
    let numbers: Vec<usize> = env::args().skip(1).map(|word| word.parse()).collect::<Result<_, _>>()?;
    let (graphs, states) = (numbers.first().copied().unwrap_or(40), numbers.get(1).copied().unwrap_or(2000));
    let graphs: Vec<Graph> = (FIRST_SEED..).take(graphs).map(graph).collect();
    println!("| compiler | level | graphs | policies | decisions | differences |");
    println!("| --- | --- | --- | --- | --- | --- |");
    let mut good = true;
    for compiler in &COMPILERS {
        let what = format!("generated {} by {}", compiler.language.name(), compiler.program);
        if !tpg_testing::tool(compiler.program, compiler.package, &what) {
            continue;
        }
        for level in compiler.levels {
            let mut count = InstructionCount::default();
            for (graphs, seed) in graphs.chunks(BATCH).zip(0..) {
                good &= compare(compiler, level, graphs, (states, seed), &mut count)?;
            }
            let InstructionCount { policies, decisions, differences } = count;
            let (program, graphs) = (compiler.program, graphs.len());
            println!("| {program} | {level} | {graphs} | {policies} | {decisions} | {differences} |");
        }
    }
    Ok(if good { ExitCode::SUCCESS } else { ExitCode::FAILURE })
}

/// Every second graph has outputs.
fn graph(seed: u64) -> Graph {
    let shape = if seed.is_multiple_of(2) { Shape::random(seed) } else { Shape::random_with_outputs(seed) };
    sample::graph(&shape, seed)
}

/// Compares some graphs; returns true if nothing differs. A compiler that refuses them is reported.
fn compare(
    compiler: &Compiler,
    level: &str,
    graphs: &[Graph],
    (states, seed): (usize, u64),
    count: &mut InstructionCount,
) -> Result<bool, Box<dyn std::error::Error>> {
    let policies: Vec<(&Graph, Options)> = (graphs.iter().enumerate())
        .flat_map(|(number, graph)| Profile::ALL.map(|profile| (graph, options(number, profile))))
        .collect();
    let workshop = Workshop::new()?;
    let batch = workshop.batch_by(compiler.language, &policies, Some(&|folder| compiler.command(level, folder)));
    let batch = match batch {
        Ok(batch) => batch,
        Err(BuildError::Refused { message, .. }) => {
            println!("{} {level} refuses generated code:\n{message}", compiler.program);
            return Ok(false);
        }
        Err(error) => return Err(error.into()),
    };
    let before = count.differences;
    for (place, (graph, options)) in policies.iter().enumerate() {
        let mut process = batch.start(place, graph)?;
        for comparison in verify::compare(graph, &mut [&mut process], states, seed)? {
            count.policies += 1;
            count.decisions += comparison.states;
            count.differences += comparison.differences;
            if let Some(first) = comparison.first {
                println!("{} {level}, {}: {first:?}\n{}", compiler.program, options.prefix, graph.to_json());
            }
        }
    }
    Ok(count.differences == before)
}

fn options(number: usize, profile: Profile) -> Options {
    let name = profile.name().replace('-', "_");
    let prefix = format!("p{number}_{name}").parse().unwrap_or_else(|_| unreachable!("a letter, digits, letters"));
    Options { profile: Some(profile), ..Options::new(prefix) }
}
