//! Assumptions of optimisers: numbers in place of NaN, and functions of constants that are not the platform's.
//!
//! LLVM takes `if v > 0 { v } else { 0 }` of a `v = max(0, x)` for v, which it is not where x is NaN, and computes the cosine of a
//! constant itself, rounded another way than the platform's. Generated code hides both from it.

use crate::common::codes;
use std::path::Path;
use std::process::Command;
use tpg_codegen::emit::{Language, Options, Profile};
use tpg_codegen::verify::{Workshop, rustc};
use tpg_graph::engine::{Engine, Reference};
use tpg_graph::sample::{self, Constants, Shape};
use tpg_graph::{Document, Graph, LineDocument, MathsProvider, OperandDocument, ScalarType, Word};

/// Numbers without a pattern: SplitMix64.
struct Numbers(u64);

impl Numbers {
    fn below(&mut self, end: usize) -> usize {
        self.0 = self.0.wrapping_add(0x9e37_79b9_7f4a_7c15);
        let mixed = (self.0 ^ (self.0 >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
        ((mixed ^ (mixed >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb) >> 33) as usize % end
    }

    fn one_of<T: Copy>(&mut self, all: &[T]) -> T {
        all[self.below(all.len())]
    }
}

fn words(names: &[&str]) -> Vec<Word> {
    names.iter().map(|name| Word::from_name(name).expect("a word")).collect()
}

/// A graph of a few short programs, with its operands changed.
fn changed(shape: &Shape, seed: u64, change: impl Fn(&mut Numbers, &str, &mut Vec<OperandDocument>)) -> Graph {
    let mut document: Document =
        serde_json::from_str(&sample::graph(shape, seed).to_json()).expect("its own text is a document");
    let mut numbers = Numbers(seed);
    for line in document.programs.iter_mut().flat_map(|program| &mut program.lines) {
        change(&mut numbers, &line.op, &mut line.args);
    }
    Graph::from_document("changed", document).expect("a valid graph")
}

/// A graph whose bids are greatest and least values, differences and quotients of a value with itself, and zeros: NaN decides.
fn about_nan(seed: u64) -> Graph {
    let names =
        ["min", "max", "std_min", "std_max", "negate_if_less", "gate", "sub", "add", "mul", "div", "abs", "copy"];
    // Two of three have teams so small that an optimiser turns their loops into straight code and knows what is best when.
    let is_tiny = !seed.is_multiple_of(3);
    let shape = Shape {
        teams: if is_tiny { 1 } else { 1 + seed as usize % 4 },
        edges: if is_tiny { 3..=4 } else { 2..=5 },
        lines: if is_tiny { 0..=1 } else { 0..=4 },
        registers: if is_tiny { 1 } else { 2 },
        sources: vec![3],
        actions: 4,
        outputs: (seed % 4 / 3) as u32,
        instructions: words(if is_tiny { &names[..6] } else { &names }),
        scalar: if seed.is_multiple_of(5) { ScalarType::F64 } else { ScalarType::F32 },
        maths: MathsProvider::Own,
        constants: Constants::Integers,
        ..Shape::default()
    };
    changed(&shape, seed, |numbers, _, operands| {
        for place in 0..operands.len() {
            if numbers.below(3) == 0 {
                operands[place] = OperandDocument::Constant(numbers.one_of(&[0.0, -0.0, 0.0, 1.0]));
            } else if numbers.below(4) == 0 {
                operands[place] = operands[0].clone();
            }
        }
    })
}

/// States of which a third is NaN.
fn full_of_nan(graph: &Graph, count: usize, seed: u64) -> Vec<f64> {
    const VALUES: [f64; 12] =
        [f64::NAN, f64::NAN, f64::NAN, -f64::NAN, 0.0, -0.0, 1.0, -1.0, f64::INFINITY, f64::NEG_INFINITY, 0.5, 3e38];
    let mut numbers = Numbers(seed);
    (0..count * graph.state_length()).map(|_| graph.scalar().round(numbers.one_of(&VALUES))).collect()
}

/// Compares every profile with the interpreter; returns the number of answers.
fn compare(
    language: Language,
    graphs: &[Graph],
    compiler: impl Fn(&Path) -> Command,
    states: impl Fn(&Graph, u64) -> Vec<f64>,
) -> usize {
    let policies: Vec<(&Graph, Options)> = (graphs.iter().enumerate())
        .flat_map(|(number, graph)| {
            Profile::ALL.map(|profile| {
                let prefix = format!("p{number}_{}", profile.name().replace('-', "_")).parse().expect("a prefix");
                (graph, Options { profile: Some(profile), ..Options::new(prefix) })
            })
        })
        .collect();
    let workshop = Workshop::new().expect("a temporary folder");
    let batch = workshop.batch(&codes(language, &policies), Some(&compiler));
    let batch = batch.unwrap_or_else(|error| panic!("{}: {error}", compiler(Path::new(".")).get_program().display()));
    let mut compared = 0;
    for (place, (graph, options)) in policies.iter().enumerate() {
        let states = states(graph, place as u64);
        let (mut expected, mut found) = (Vec::new(), Vec::new());
        Reference::new(graph).answer(&states, &mut expected).expect("the interpreter answers");
        let mut process = batch.start(place, graph).expect("the program starts");
        process.answer(&states, &mut found).unwrap_or_else(|error| panic!("{}: {error}", options.prefix));
        let rows = states.chunks_exact(graph.state_length()).zip(expected.iter().zip(&found));
        for (state, (expected, found)) in rows {
            let same = expected.same_bits(found);
            assert!(same, "{}, {state:?}: {found}, not {expected}\n{}", options.prefix, graph.to_json());
        }
        compared += found.len();
    }
    compared
}

/// The Rust compiler at a level of optimisation.
fn rust_at(level: &str) -> impl Fn(&Path) -> Command {
    let option = format!("-Copt-level={level}");
    move |folder| {
        let mut command = rustc(folder);
        command.arg(&option);
        command
    }
}

#[test]
fn nan_decides_in_rust_as_it_does_in_the_interpreter() {
    let graphs: Vec<Graph> = (0..tpg_testing::amount(8, 30)).map(about_nan).collect();
    for level in tpg_testing::amount(&["3"][..], &["1", "2", "3", "s"][..]) {
        let compared = compare(Language::Rust, &graphs, rust_at(level), |graph, seed| full_of_nan(graph, 1000, seed));
        println!("opt-level {level}: {} graphs in every profile, {compared} answers", graphs.len());
    }
}

/// Constant parts are folded, and may be NaN in the middle of a formula.
#[test]
fn nan_is_a_constant_of_generated_code() {
    let line = |to, op: &str, args: &[&str]| LineDocument {
        to,
        op: op.to_owned(),
        args: args
            .iter()
            .map(|text| {
                text.parse().map_or_else(|_| OperandDocument::Place((*text).to_owned()), OperandDocument::Constant)
            })
            .collect(),
    };
    let graphs = [ScalarType::F32, ScalarType::F64].map(|scalar| {
        let text = include_str!("fixtures/swing_up.json");
        let mut document: Document = serde_json::from_str(text).expect("the fixture is a document");
        document.scalar = scalar;
        document.instructions = ["div", "gate", "std_max"].map(str::to_owned).to_vec();
        for program in &mut document.programs {
            program.lines = vec![
                line(0, "div", &["0", "0"]),
                line(0, "gate", &["r0", "sin_theta[0]"]),
                line(0, "std_max", &["cos_theta[0]", "r0"]),
            ];
        }
        Graph::from_document("NaN", document).expect("a valid graph")
    });
    let states = |graph: &Graph, seed| full_of_nan(graph, 500, seed);
    compare(Language::Rust, &graphs, rust_at("3"), states);
    if tpg_testing::tool("gcc", "gcc", "NaN as a constant in C") {
        compare(Language::C, &graphs, gcc, states);
    }
}

fn gcc(folder: &Path) -> Command {
    let mut command = Command::new("gcc");
    command.current_dir(folder).args(["-std=c99", "-O2"]);
    command
}

/// A graph whose tangents and the like are of constants, as the platform computes them: of a tangent in `f32`, GCC knows some three
/// of a hundred better.
fn of_constants(seed: u64) -> Graph {
    let shape = Shape {
        teams: seed as usize % 2,
        edges: 2..=3,
        lines: 1..=1,
        registers: 1,
        outputs: 9,
        instructions: words(&["tan", "cos", "exp"]),
        scalar: if seed.is_multiple_of(8) { ScalarType::F64 } else { ScalarType::F32 },
        maths: MathsProvider::System,
        constants: Constants::Reals,
        ..Shape::default()
    };
    let scalar = shape.scalar;
    changed(&shape, seed, |numbers, _, operands| {
        operands[0] = OperandDocument::Constant(scalar.round((1.0 + numbers.below(1_000_000) as f64) / 3e4));
    })
}

#[test]
fn the_platforms_functions_of_constants_are_the_platforms() {
    let graphs: Vec<Graph> = (0..tpg_testing::amount(8, 40)).map(of_constants).collect();
    let states = |graph: &Graph, seed| tpg_graph::states::sample(graph, 20, seed);
    compare(Language::Rust, &graphs, rust_at("3"), states);
    if tpg_testing::tool("gcc", "gcc", "the platform's functions of constants in C") {
        compare(Language::C, &graphs, gcc, states);
    }
}
