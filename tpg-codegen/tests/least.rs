//! The profile `small` is near the least: on a Cortex-M4F at -Os, beside every other profile.

use std::fs;
use std::path::Path;
use tpg_codegen::compile;
use tpg_codegen::emit::{Code, Language, Options, Profile};
use tpg_codegen::size::{RustForCortexM4, Target, build_c, measure};
use tpg_graph::sample::{self, Constants, Shape};
use tpg_graph::{Graph, MathsProvider, ScalarType, Word};

/// A graph as evolution finds for a small problem.
fn small(seed: u64) -> Graph {
    let names = ["add", "sub", "mul", "div", "negate_if_less", "abs", "min", "max", "multiply_add"];
    let functions = if seed.is_multiple_of(3) { &["sin", "cos", "ln", "exp"][..] } else { &[] };
    let outputs = if seed.is_multiple_of(2) { 1 + seed as u32 / 2 % 3 } else { 0 };
    let shape = Shape {
        teams: if seed.is_multiple_of(8) { 0 } else { 1 + seed as usize / 7 % 6 },
        edges: 2..=2 + seed as usize / 5 % 5,
        lines: 1..=2 + seed as usize / 11 % 8,
        registers: 4,
        sources: vec![1; 2 + seed as usize / 13 % 4],
        actions: 2 + seed as u32 / 3 % 4,
        outputs,
        memory: u32::from(seed.is_multiple_of(10)),
        scalar: if seed % 5 == 1 { ScalarType::F64 } else { ScalarType::F32 },
        maths: if seed % 7 == 1 { MathsProvider::System } else { MathsProvider::Own },
        constants: Constants::Reals,
        instructions: names.iter().chain(functions).copied().filter_map(Word::from_name).collect(),
        ..Shape::default()
    };
    sample::graph(&shape, seed)
}

fn fixture(name: &str) -> Graph {
    let path = Path::new(env!("CARGO_MANIFEST_DIR")).join(name);
    let text = fs::read_to_string(&path).expect("readable");
    Graph::from_json(name, &text).expect("a valid graph")
}

/// The flash of a graph in every profile.
fn flash(graph: &Graph, language: Language, compiled: impl Fn(&Code<'_>) -> u64) -> Vec<(Profile, u64)> {
    let of = |profile| {
        let options = Options { profile: Some(profile), ..Options::new("policy".parse().expect("a prefix")) };
        (profile, compiled(&Code::of(compile(graph, &options, language))))
    };
    Profile::ALL.map(of).to_vec()
}

/// Holds `small` to the least: near it for each known graph, nearer for all graphs together.
fn assert_least(language: Language, random: u64, compiled: impl Fn(&Code<'_>) -> u64) {
    let small_and_least = |graph: &Graph| {
        let sizes = flash(graph, language, &compiled);
        let small = sizes.iter().find(|(profile, _)| *profile == Profile::Small).expect("it is a profile").1;
        (small, sizes.iter().map(|(_, flash)| *flash).min().unwrap_or(0))
    };
    let mut total = (0, 0);
    for (name, graph) in
        KNOWN.map(|name| (name, fixture(name))).into_iter().chain((0..random).map(|n| ("random", small(n))))
    {
        let (small, least) = small_and_least(&graph);
        println!("{}, {name}: {small} bytes, at least {least}", language.name());
        assert!(small as f64 <= FARTHEST * least as f64 || name == "random", "{name}: {small} bytes, at least {least}");
        total = (total.0 + small, total.1 + least);
    }
    assert!(total.0 as f64 <= MARGIN * total.1 as f64, "{}: {total:?} bytes, and at least", language.name());
}

/// Graphs of every size: a team of two bids, one formula, some teams with leaves, memory, this project's own, dozens of teams.
const KNOWN: [&str; 18] = [
    "../generated/dodge/graph.json",
    "../generated/lunar-lander/graph.json",
    "tests/fixtures/cartpole.json",
    "tests/fixtures/formula.json",
    "tests/fixtures/swing_up.json",
    "tests/fixtures/memory.json",
    "../generated/cartpole/graph.json",
    "../generated/acrobot/graph.json",
    "../generated/mountain-car/graph.json",
    "../generated/mountain-car-continuous/graph.json",
    "../generated/pendulum/graph.json",
    "../generated/lunar-lander-continuous/graph.json",
    "../generated/inverted-double-pendulum/graph.json",
    "../generated/swimmer/graph.json",
    "../generated/hopper/graph.json",
    "../generated/bipedal-walker/graph.json",
    "../generated/widowx-fs/graph.json",
    "../generated/widowx-rs/graph.json",
];

/// `small` takes at most this times the least of a known graph.
const FARTHEST: f64 = 1.05;

/// And of all graphs together.
const MARGIN: f64 = 1.1;

#[test]
fn no_profile_in_c_is_much_smaller() {
    if tpg_testing::tool("arm-none-eabi-gcc", "gcc-arm-none-eabi", "the profile small beside the others") {
        assert_least(Language::C, tpg_testing::amount(5, 30) as u64, |code| {
            let built = build_c(code, Target::M4f).expect("it compiles");
            measure(&built.object).expect("an object file").flash()
        });
    }
}

#[test]
fn no_profile_in_rust_is_much_smaller() {
    if !tpg_testing::library::rust_target("thumbv7em-none-eabihf", "the profile small beside the others, in Rust") {
        return;
    }
    let compiler = RustForCortexM4::new("s").expect("the toolchain has the target");
    assert_least(Language::Rust, tpg_testing::amount(5, 12) as u64, |code| {
        compiler.size(code, "s").expect("it compiles").flash()
    });
}
