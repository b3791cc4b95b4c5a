//! Graphs in integers: what is quantised and what is random decides in C and Rust as the interpreter does, and nothing overflows.
//!
//! C is compiled with the sanitizer of undefined behaviour where the compiler has one: an overflow, a shift or a division that C does
//! not define ends the program. `TPG_FULL_TESTS=1` compares 1,000 random graphs in C and 250 in Rust, and every shipped policy.

use assert_cmd::Command as Tool;
use std::fs;
use std::path::Path;
use std::process::Command;
use tempfile::TempDir;
use tpg_codegen::emit::{Code, Language, Options, Profile};
use tpg_codegen::quantise::{QuantiseReport, Request, quantise};
use tpg_codegen::report::explain;
use tpg_codegen::verify::{self, Workshop};
use tpg_graph::sample::{self, Constants, Shape};
use tpg_graph::states::StateSet;
use tpg_graph::{Counts, Document, Graph, MemoryDocument, OperandDocument, ScalarType, Word};
use tpg_runtime::ops::Instruction;

/// The words that whole numbers can have.
const WORDS: [&str; 13] = [
    "add",
    "sub",
    "mul",
    "multiply_add",
    "min",
    "max",
    "std_min",
    "abs",
    "negate_if_less",
    "gate",
    "quotient",
    "fmod",
    "copy",
];

/// A random graph of whole numbers: counts of every number of bits, small constants and great ones.
pub(crate) fn whole(seed: u64) -> Graph {
    let shape = if seed.is_multiple_of(2) { Shape::random(seed) } else { Shape::random_with_outputs(seed) };
    let words = WORDS.iter().filter_map(|name| Word::from_name(name));
    let instructions = words.filter(|word| *word != Word::Instruction(Instruction::Fmod) || seed.is_multiple_of(5));
    let shape = Shape {
        teams: shape.teams.div_ceil(4).min(shape.teams),
        lines: 0..=9,
        instructions: instructions.collect(),
        scalar: ScalarType::F64,
        constants: Constants::Integers,
        ..shape
    };
    let mut document = sample::graph(&shape, seed).to_document();
    document.version = 2;
    let mut number = seed as u32;
    for source in &mut document.sources {
        source.counts = (0..source.length)
            .map(|_| {
                number = number.wrapping_mul(1_664_525).wrapping_add(1_013_904_223);
                Counts { bits: 2 + (number >> 8) % 15, scale: 0.25, offset: 0.0 }
            })
            .collect();
        source.ranges = source.counts.iter().map(|counts| counts.limits()).collect();
    }
    for (place, output) in document.outputs.iter_mut().enumerate() {
        let counts = Counts { bits: if place % 2 == 0 { 16 } else { 7 }, scale: 0.5, offset: 1.0 };
        (output.min, output.max, output.nan) = (counts.limits()[0], 50.0, -3.0);
        output.counts = Some(counts);
    }
    for MemoryDocument { min, max, initial, .. } in &mut document.memory {
        (*min, *max, *initial) = (-70_000.0, 1_000_000.0, 12.0);
    }
    let operands = document.programs.iter_mut().flat_map(|program| &mut program.lines).flat_map(|line| &mut line.args);
    for (place, operand) in operands.enumerate() {
        if let OperandDocument::Constant(value) = operand
            && place % 5 != 0
        {
            *value %= 300.0;
        }
    }
    Graph::from_document("random", document).unwrap_or_else(|error| panic!("graph {seed}: {error}"))
}

/// C's compiler with the sanitizer, if it has one.
fn sanitized(folder: &Path) -> Command {
    let mut command = Command::new("gcc");
    command.current_dir(folder).args([
        "-std=c99",
        "-O1",
        "-Wall",
        "-Wextra",
        "-Wconversion",
        "-Werror",
        "-Wno-unused-function",
    ]);
    command.args([
        "-fsanitize=undefined,integer-divide-by-zero,shift,signed-integer-overflow",
        "-fno-sanitize-recover=all",
    ]);
    command
}

fn options(number: usize, profile: Profile) -> Options {
    Options { profile: Some(profile), ..Options::new(format!("p{number}").parse().expect("a prefix")) }
}

/// Tests for values in 64 bits.
fn is_wide(code: &Code<'_>) -> bool {
    code.files.iter().any(|file| file.text.contains("int64_t"))
}

/// Compares the code of graphs with the interpreter; returns how many values needed 64 bits.
fn assert_equal(language: Language, profile: Profile, graphs: &[Graph], states: usize) {
    let codes: Vec<Code<'_>> = (graphs.iter().enumerate())
        .map(|(number, graph)| {
            Code::of_graph("graph", graph, &options(number, profile), language).expect("whole numbers")
        })
        .collect();
    let floats = ["float", "double", "math.h", "f32", "f64"];
    for file in codes.iter().flat_map(|code| &code.files) {
        // A hash may hold any digits.
        let mut lines = file.text.lines().filter(|line| !line.contains("SHA-256"));
        assert!(lines.all(|line| !floats.iter().any(|word| line.contains(word))), "{}", file.text);
    }
    let workshop = Workshop::new().expect("a temporary folder");
    let is_sanitized = language == Language::C && tpg_testing::tool("gcc", "gcc", "whole numbers under a sanitizer");
    let sanitizer: Option<&dyn Fn(&Path) -> Command> = if is_sanitized { Some(&sanitized) } else { None };
    let batch = workshop.batch(&codes, sanitizer).expect("generated code compiles");
    for (place, graph) in graphs.iter().enumerate() {
        let mut process = batch.start(place, graph).expect("the program starts");
        let comparisons = verify::compare(graph, &mut [&mut process], states, place as u64);
        let comparisons = comparisons.unwrap_or_else(|error| panic!("graph {place}: {error}\n{}", graph.to_json()));
        assert_eq!(comparisons[0].differences, 0, "graph {place}: {:?}\n{}", comparisons[0], graph.to_json());
    }
}

#[test]
fn random_graphs_of_whole_numbers_are_the_interpreters_and_never_overflow() {
    let wanted = tpg_testing::amount(40, 1000);
    let (mut graphs, mut refused, mut wide) = (Vec::new(), 0, 0);
    for seed in 0.. {
        let graph = whole(seed);
        match Code::of_graph("random", &graph, &options(0, Profile::Fast), Language::C) {
            Ok(code) => {
                wide += usize::from(is_wide(&code));
                drop(code);
                graphs.push(graph);
            }
            Err(error) => {
                let error = error.to_string();
                assert!(error.contains("can reach") || error.contains("may divide by 0"), "{error}");
                refused += 1;
            }
        }
        if graphs.len() == wanted {
            break;
        }
    }
    assert!(refused > 0 && wide > wanted / 20, "{refused} refused, {wide} of {wanted} with 64 bits");
    for graphs in graphs.chunks(100) {
        assert_equal(Language::C, Profile::Fast, graphs, 500);
    }
    assert_equal(Language::Rust, Profile::Fast, &graphs[..wanted / 4], 500);
}

fn shipped(name: &str) -> Graph {
    let folder = concat!(env!("CARGO_MANIFEST_DIR"), "/../generated");
    let path = if name.ends_with(".json") { format!("{folder}/{name}") } else { format!("{folder}/{name}/graph.json") };
    tpg_graph::import::load(path.as_ref(), None, None).expect("a shipped graph")
}

pub(crate) fn quantised(name: &str, bits: u32) -> (Graph, QuantiseReport) {
    let graph = shipped(name);
    let states = StateSet::sampled(&graph, 2000, 1);
    let request = Request::of_bits(bits, &states);
    quantise(name, &graph, &request).unwrap_or_else(|error| panic!("{error}"))
}

#[test]
fn shipped_policies_keep_their_decisions_and_are_the_interpreters() {
    const ALL: [&str; 14] = [
        "cartpole",
        "pendulum",
        "bipedal-walker",
        "dodge",
        "acrobot",
        "mountain-car",
        "mountain-car-continuous",
        "lunar-lander",
        "lunar-lander-continuous",
        "inverted-double-pendulum",
        "swimmer",
        "hopper",
        "widowx-fs",
        "widowx-rs",
    ];
    let mut graphs = Vec::new();
    for name in &ALL[..tpg_testing::amount(4, ALL.len())] {
        for (bits, same, mean) in [(16, 0.999, 0.0005), (12, 0.98, 0.01), (8, 0.9, 0.05)] {
            let (graph, report) = quantised(name, bits);
            let found = &report.comparison;
            assert!(found.same as f64 >= same * found.states as f64, "{name} at {bits} bits: {report}");
            assert!(found.outputs.iter().all(|output| output.mean <= mean), "{name} at {bits} bits: {report}");
            assert!(report.bounds.iter().all(|(_, bound)| *bound <= 1 << 31), "{name} at {bits} bits: {report}");
            let code = Code::of_graph(name, &graph, &options(0, Profile::Fast), Language::C).expect("whole numbers");
            assert!(!is_wide(&code), "{name} at {bits} bits needs no 64");
            drop(code);
            graphs.push(graph);
        }
    }
    assert_equal(Language::C, Profile::Fast, &graphs, 2000);
    assert_equal(Language::C, Profile::Small, &graphs, 2000);
    assert_equal(Language::Rust, Profile::Fast, &graphs, 2000);
}

#[test]
fn a_factor_that_is_computed_is_kept_until_its_product_is_added() {
    let (graph, report) = quantised("seeds/tpg-fs-7.json", 16);
    assert!(report.comparison.same as f64 >= 0.99 * report.comparison.states as f64, "{report}");
    assert_equal(Language::C, Profile::Fast, &[graph], 2000);
}

#[test]
fn memory_is_kept_in_counts() {
    let path = concat!(env!("CARGO_MANIFEST_DIR"), "/../c-harness/pendulum/recall.json");
    let graph = tpg_graph::import::load(path.as_ref(), None, None).expect("a graph with memory");
    assert!(graph.memory() > 0);
    let states = StateSet::sampled(&graph, 2000, 1);
    let request = Request::of_bits(16, &states);
    let (whole, report) = quantise("recall", &graph, &request).expect("integers");
    assert!(report.comparison.outputs.iter().all(|output| output.mean < 0.001), "{report}");
    assert_equal(Language::C, Profile::Fast, std::slice::from_ref(&whole), 2000);
    assert_equal(Language::Rust, Profile::Fast, &[whole], 2000);
}

#[test]
fn the_code_reads_as_an_engineer_would_write_it() {
    for (name, profile) in
        [("lunar-lander-continuous", Profile::Fast), ("mountain-car", Profile::Fast), ("swimmer", Profile::Small)]
    {
        let (graph, _) = quantised(name, 16);
        let options = Options { profile: Some(profile), ..Options::new("policy".parse().expect("a prefix")) };
        let code = Code::of_graph(name, &graph, &options, Language::C).expect("whole numbers");
        let text: String = code.files.iter().map(|file| format!("{}\n{}\n", file.name, file.text)).collect();
        insta::assert_snapshot!(
            format!("integers-{name}.c"),
            text.split("_NO_SELFTEST\n\n").next().expect("a first part")
        );
    }
}

#[test]
fn sums_are_explained_in_units() {
    let text = explain(&quantised("pendulum", 16).0, &options(0, Profile::Fast));
    for expected in ["torque is limited to -2 to 2 N·m", "\n  torque = -15.126 * sin_theta - 2.8415 * omega\n"] {
        assert!(text.contains(expected), "{text}");
    }
    let bids = explain(&quantised("cartpole", 16).0, &options(0, Profile::Fast));
    assert!(bids.contains("-> right: 0.99998 * theta + omega"), "{bids}");
    let constant = explain(&quantised("mountain-car-continuous", 16).0, &options(0, Profile::Fast));
    assert!(
        constant.contains("-> leaf 0: 0 (in counts)") && constant.contains("force = 4.8467 * velocity"),
        "{constant}"
    );
    assert!(!explain(&quantised("lunar-lander", 8).0, &options(0, Profile::Fast)).contains("(in counts)"));
}

/// A graph of one output: `x * a / b`, and its refusal.
fn refused(change: impl Fn(&mut Document)) -> String {
    let (graph, _) = quantised("mountain-car-continuous", 16);
    let mut document = graph.to_document();
    document.instructions = Word::ALL.map(Word::name).map(str::to_owned).to_vec();
    change(&mut document);
    let graph = Graph::from_document("graph.json", document).unwrap_or_else(|error| panic!("{error}"));
    let error = Code::of_graph("graph.json", &graph, &options(0, Profile::Fast), Language::C).map(|_| ());
    error.expect_err("no whole number").to_string()
}

#[test]
fn what_does_not_fit_is_named() {
    let line = |op: &'static str, other: f64| {
        move |document: &mut Document| {
            let program = document.leaves[0].programs[0];
            let lines = &mut document.programs.iter_mut().find(|it| it.id == program).expect("its program").lines;
            lines.push(tpg_graph::LineDocument {
                to: 0,
                op: op.to_owned(),
                args: vec![OperandDocument::Place("r0".to_owned()), OperandDocument::Constant(other)],
            });
        }
    };
    assert!(refused(line("mul", 0.5)).contains("0.5, which may be a fraction"), "{}", refused(line("mul", 0.5)));
    assert!(refused(line("div", 3.0)).contains("/ 3, which may be a fraction"), "{}", refused(line("div", 3.0)));
    assert!(refused(line("mul", 1e13)).contains("can reach"), "{}", refused(line("mul", 1e13)));
    assert!(refused(line("fmod", 0.0)).contains("may divide by 0"), "{}", refused(line("fmod", 0.0)));
}

#[test]
fn bad_input_is_named() {
    let with = |change: &dyn Fn(&mut Document)| {
        let mut document = shipped("mountain-car-continuous").to_document();
        change(&mut document);
        let graph = Graph::from_document("graph.json", document).unwrap_or_else(|error| panic!("{error}"));
        let states = StateSet::sampled(&graph, 100, 1);
        let request = Request::of_bits(8, &states);
        quantise("graph.json", &graph, &request).map(|_| ()).expect_err("refused").to_string()
    };
    let zero = with(&|document| document.sources[1].ranges[0] = [0.5, 0.5]);
    assert!(zero.contains("velocity: 0.5 to 0.5, a range of zero width"), "{zero}");
    let unbounded = with(&|document| {
        (document.outputs[0].min, document.outputs[0].max) = (-2f64.powi(120), 2f64.powi(120));
    });
    assert!(
        unbounded.contains("\"force\" limited to") && unbounded.ends_with("limits that the actuator has"),
        "{unbounded}"
    );
    let sine = with(&|document| {
        document.instructions.push("sin".to_owned());
        for program in &mut document.programs {
            let args = vec![OperandDocument::Place("r0".to_owned())];
            program.lines.push(tpg_graph::LineDocument { to: 0, op: "sin".to_owned(), args });
        }
    });
    assert!(sine.contains("sin(") && sine.contains("no integers yet"), "{sine}");
}

#[test]
fn a_user_goes_from_floats_to_integers() {
    let folder = TempDir::new().expect("a temporary folder");
    let tool = || {
        let mut tool = Tool::cargo_bin("tpg-codegen").expect("the program");
        tool.current_dir(folder.path());
        tool
    };
    fs::write(folder.path().join("pole.json"), shipped("cartpole").to_json()).expect("a file");
    let said = tool()
        .args(["quantise", "pole.json", "--inputs", "8", "--weights", "8", "-o", "whole.json"])
        .assert()
        .success();
    let said = String::from_utf8_lossy(&said.get_output().stdout).into_owned();
    assert!(said.contains("8-bit inputs") && said.contains("actions are the same"), "{said}");
    let said = tool().args(["whole.json", "--lang", "c", "--prefix", "pole"]).assert().success();
    let said = String::from_utf8_lossy(&said.get_output().stdout).into_owned();
    assert!(said.contains("C, integers, fast = interpreter on 10000 states"), "{said}");
    let header = fs::read_to_string(folder.path().join("pole.h")).expect("a header");
    assert!(header.contains("int8_t") && header.contains("a count"), "{header}");
    tool().args(["verify", "whole.json", "--lang", "c", "--states", "2000"]).assert().success();
    tool().args(["pole.json", "--fixed", "16", "--lang", "c", "--prefix", "fixed"]).assert().success();
    tool().args(["whole.json", "--style", "gegelati", "-o", "no"]).assert().code(2);
    assert!(!folder.path().join("no").exists());
    fs::write(folder.path().join("seen.csv"), "cart_position[0]\n1\n").expect("a file");
    tool().args(["quantise", "pole.json", "--ranges", "seen.csv", "-o", "whole.json"]).assert().code(2);
}

#[test]
fn a_sensor_keeps_its_own_counts() {
    let folder = TempDir::new().expect("a temporary folder");
    let tool = |args: &[&str]| {
        let mut tool = Tool::cargo_bin("tpg-codegen").expect("the program");
        tool.current_dir(folder.path()).args(args).assert()
    };
    fs::write(folder.path().join("pole.json"), shipped("cartpole").to_json()).expect("a file");
    let quantise =
        |adc: &str| tool(&["quantise", "pole.json", "--adc", "v=raw*0.001", "--adc", adc, "-o", "whole.json"]);
    let said = quantise("omega[0]=(raw-2048)*0.0008").success();
    let said = String::from_utf8_lossy(&said.get_output().stdout).into_owned();
    assert!(said.contains("(99.9"), "{said}");
    tool(&["whole.json", "--lang", "c", "--prefix", "pole"]).success();
    let header = fs::read_to_string(folder.path().join("pole.h")).expect("a header");
    assert!(header.contains("int16_t omega; /* 0.0008 rad/s a count from 2048 on"), "{header}");
    assert!(header.contains("int16_t v; /* 0.001 m/s a count"), "{header}");
    for (bad, said) in [
        ("omega=raw", "accepted: VALUE=raw*SCALE"),
        ("omega=raw*-1", "accepted: VALUE=raw*SCALE"),
        ("omega=(raw-0.5)*1", "accepted: VALUE=raw*SCALE"),
        ("spin=raw*1", "no value \"spin\"; accepted: x, v, theta, omega"),
    ] {
        let refused = quantise(bad).code(2);
        let found = String::from_utf8_lossy(&refused.get_output().stderr).into_owned();
        assert!(found.contains(said), "{found}");
    }
}
