//! The prover: shipped policies are proven in every profile, mutants never are, random graphs are proven or named.

use crate::common::shaped;
use crate::integers;
use std::time::Instant;
use tpg_codegen::emit::{Code, File, Language, Profile, Style};
use tpg_graph::interpret::Interpreter;
use tpg_graph::sample::{self, Shape};
use tpg_graph::{Graph, MathsProvider, ScalarType, Word};
use tpg_prove::c;
use tpg_prove::graph::{self, Graph as Meaning};
use tpg_prove::input::Missing;
use tpg_prove::product::Effort;
use tpg_prove::proof::{self, Proof, Verdict};
use tpg_prove::term::Terms;
use tpg_prove::term::evaluate::Evaluator;
use tpg_runtime::ops::Own;
use tpg_runtime::policy::ActionId;
use tpg_testing::amount;

/// The shipped graphs.
const SHIPPED: [&str; 19] = [
    "acrobot",
    "asterix",
    "bipedal-walker",
    "breakout",
    "cartpole",
    "dodge",
    "eye",
    "half-cheetah",
    "hopper",
    "inverted-double-pendulum",
    "lunar-lander",
    "lunar-lander-continuous",
    "mountain-car",
    "mountain-car-continuous",
    "pendulum",
    "space-invaders",
    "swimmer",
    "widowx-fs",
    "widowx-rs",
];

fn shipped(name: &str) -> String {
    let path = tpg_testing::library::top().join("generated").join(name).join("graph.json");
    std::fs::read_to_string(path).expect("a shipped graph")
}

/// The files of C of a graph.
fn c_of(text: &str, profile: Profile) -> Vec<File> {
    let graph = Graph::from_json("graph.json", text).expect("a graph");
    let options = shaped("policy", (Style::Pure, Some(profile)));
    Code::of_graph("graph.json", &graph, &options, Language::C).expect("whole numbers, if they are counts").files
}

/// A shipped graph in integers.
fn in_integers(name: &str, bits: u32) -> String {
    integers::quantised(name, bits).0.to_json()
}

/// Work that is a matter of a second.
const QUICK: Effort = Effort { cases: 100_000, pairs: 5_000 };

fn proof_of(text: &str, files: &[File], effort: Effort) -> Proof {
    let graph = Meaning::read("graph.json", text).expect("a graph in binary32");
    with(&graph, files, &|graph, read| proof::prove(graph, read, false, effort, None))
}

/// Reads the code anew.
type Reader<'a> = &'a dyn Fn() -> Result<c::Code, Missing>;

/// Calls a function with a graph and with what reads the code.
fn with<R>(graph: &Meaning, files: &[File], call: &dyn Fn(&Meaning, Reader<'_>) -> R) -> R {
    let text = |name: &str| files.iter().find(|file| file.name == name).map(|file| file.text.clone());
    let source = text("policy.c").expect("a file of C");
    call(graph, &|| c::read_with("policy.c", &source, &text, None, graph.interface()))
}

/// With `--nocapture` it prints the table of times.
#[test]
fn shipped_policies_are_proven_in_every_profile() {
    for name in SHIPPED {
        let text = shipped(name);
        let mut times = Vec::new();
        // All bids of this one in constant time are more cases than are tried.
        let is_tried = |profile: &Profile| (name, *profile) != ("space-invaders", Profile::ConstantTime);
        for profile in Profile::ALL.into_iter().filter(is_tried) {
            let files = c_of(&text, profile);
            let start = Instant::now();
            let proof = proof_of(&text, &files, Effort::default());
            times.push(format!("{:.3} s", start.elapsed().as_secs_f32()));
            assert!(matches!(proof.verdict, Verdict::Proven), "{name} {profile:?}: {proof}");
            assert!(proof.in_range != Some(false), "{name}: outputs in their ranges");
        }
        println!("| {name} | {} |", times.join(" | "));
    }
}

/// In integers, tables are the only thing that profiles differ in.
#[test]
fn shipped_policies_in_integers_are_proven() {
    for name in SHIPPED {
        for (bits, profile) in [(8, Profile::Fast), (8, Profile::Small), (16, Profile::Fast), (16, Profile::Small)] {
            let text = in_integers(name, bits);
            let files = c_of(&text, profile);
            let is_dense =
                ["swimmer", "hopper", "half-cheetah", "bipedal-walker"].contains(&name) && profile == Profile::Small;
            assert_eq!(files[1].text.contains("policy_weights["), is_dense, "{name}: a table");
            let start = Instant::now();
            let proof = proof_of(&text, &files, Effort::default());
            println!("| {name} | {bits} | {:.3} s |", start.elapsed().as_secs_f32());
            assert!(matches!(proof.verdict, Verdict::Proven), "{name}, {bits} bits: {proof}");
            assert!(proof.in_range != Some(false), "{name}: outputs in their ranges");
        }
    }
}

/// On an AVR an `int` has 16 bits: sums of bytes that need more are not proven, though others compute them.
#[test]
fn an_int_may_have_16_bits() {
    let text = in_integers("bipedal-walker", 8);
    let mut files = c_of(&text, Profile::Fast);
    let proven = |files: &[File]| matches!(proof_of(&text, files, Effort::default()).verdict, Verdict::Proven);
    assert!(proven(&files));
    let (first, second) = files[1].text.split_once(") + (int32_t)(").expect("two sums of bytes");
    files[1].text = format!("{first} + {second}");
    assert!(!proven(&files), "one sum of both");
}

/// Replaces one token of the function in each possible way: numbers, comparisons, operators, names of fields.
fn mutants(source: &str) -> Vec<String> {
    let source = &without_comments(source);
    let start = source.find("policy_infer(const").expect("the function");
    let end = source.find("#ifndef POLICY_NO_SELFTEST").expect("its end");
    let body = &source[start..end];
    let mut mutants = Vec::new();
    let mut change = |at: usize, length: usize, by: &str| {
        mutants.push([&source[..start + at], by, &source[start + at + length..]].concat());
    };
    let swaps = [
        (" >= ", " > "),
        (" > ", " >= "),
        (" <= ", " < "),
        (" < ", " <= "),
        (" == ", " != "),
        (" + ", " - "),
        (" - ", " + "),
        (" * ", " / "),
        (" / ", " * "),
        ("[0]", "[1]"),
        ("[1]", "[0]"),
        ("-FLT_MAX", "0.0f"),
        ("(-", "("),
        ("1U", "2U"),
        ("2U", "1U"),
        (" ? ", " ? -"),
    ];
    for (from, to) in swaps {
        for (at, _) in body.match_indices(from) {
            change(at, from.len(), to);
        }
    }
    for (at, _) in body.match_indices(|letter: char| letter.is_ascii_digit()) {
        let before = body[..at].chars().next_back().unwrap_or(' ');
        let length = body[at..].find(|letter: char| !(letter.is_ascii_digit() || letter == '.')).unwrap_or(0);
        let number = &body[at..at + length];
        let is_name = before.is_ascii_alphanumeric() || before == '_' || before == '.';
        if let Ok(whole) = number.parse::<i64>()
            && !is_name
            && !body[at + length..].starts_with('U')
        {
            change(at, length, &(whole + 1).to_string());
            change(at, length, &(2 * whole + 3).to_string());
        }
        if number.contains('.') && !(before.is_ascii_alphanumeric() || before == '.' || before == '_') {
            let value: f32 = number.parse().expect("a number");
            change(at, length, &format!("{:?}", value * 1.000_001 + f32::MIN_POSITIVE));
            change(at, length, &format!("{:?}", value * 1.01 + 0.01));
        }
    }
    mutants
}

fn without_comments(source: &str) -> String {
    source.split("/*").map(|part| part.split_once("*/").map_or(part, |(_, behind)| behind)).collect()
}

/// Every constant, comparison and operator of the small policies, changed: none that differs in a sampled state is called proven.
#[test]
fn no_mutant_that_differs_is_called_proven() {
    assert_differ(&shipped);
    assert_differ(&|name| in_integers(name, 8));
}

fn assert_differ(graph_of: &dyn Fn(&str) -> String) {
    let (mut refuted, mut undecided, mut equal) = (0, 0, 0);
    for name in &SHIPPED[..15] {
        let text = graph_of(name);
        let graph = Meaning::read(name, &text).expect("a graph");
        let files = c_of(&text, Profile::Fast);
        let source = &files.iter().find(|file| file.name == "policy.c").expect("C").text;
        let all = mutants(source);
        let step = amount(all.len().div_ceil(12), all.len().div_ceil(40));
        for mutant in all.into_iter().step_by(step) {
            let mut files = files.clone();
            files.iter_mut().filter(|file| file.name == "policy.c").for_each(|file| file.text.clone_from(&mutant));
            match proof_of(&text, &files, QUICK).verdict {
                Verdict::Proven => {
                    let states = amount(500, 2_000);
                    let found = with(&graph, &files, &|graph, read| proof::sampled(graph, read, states, 7));
                    assert!(found.is_none(), "{name}: proven, but {found:?} in\n{mutant}");
                    equal += 1;
                }
                Verdict::Different(_) => refuted += 1,
                Verdict::Undecided(_) => undecided += 1,
            }
        }
    }
    println!("refuted {refuted}, not decided {undecided}, proven equal {equal}");
    assert!(refuted > equal, "mutants differ: {refuted} refuted, {equal} equal");
}

/// Random graphs in each profile: proven, or named as not decided, and never called different.
#[test]
fn random_graphs_are_proven_or_named() {
    let count = amount(12, 60);
    let (mut proven, mut open) = (0, Vec::new());
    for seed in 0..count {
        let shape = if seed % 2 == 0 { Shape::random(seed) } else { Shape::random_with_outputs(seed) };
        let decided = |word: &Word| !["fmod", "quotient"].contains(&word.name());
        let instructions: Vec<Word> = shape.instructions.iter().copied().filter(decided).collect();
        if instructions.is_empty() {
            continue;
        }
        let teams = shape.teams.min(8);
        let shape = Shape { teams, instructions, scalar: ScalarType::F32, maths: MathsProvider::Own, ..shape };
        let text = sample::graph(&shape, seed).to_json();
        for profile in Profile::ALL {
            match proof_of(&text, &c_of(&text, profile), QUICK).verdict {
                Verdict::Proven => proven += 1,
                Verdict::Different(difference) => panic!("seed {seed}, {profile:?}: {difference:?}"),
                Verdict::Undecided(missing) => open.push(format!("seed {seed}, {profile:?}: {missing}")),
            }
        }
    }
    println!("proven {proven}, open {}:\n{}", open.len(), open.join("\n"));
    assert!(proven > 0);
}

/// Random graphs of counts: proven or named, and never called different.
#[test]
fn random_graphs_of_counts_are_proven_or_named() {
    let (mut proven, mut open) = (0, Vec::new());
    for seed in 0..amount(60, 1_000) {
        let graph = integers::whole(seed);
        let options = shaped("policy", (Style::Pure, Some(Profile::Fast)));
        let Ok(code) = Code::of_graph("random", &graph, &options, Language::C) else { continue };
        match proof_of(&graph.to_json(), &code.files, QUICK).verdict {
            Verdict::Proven => proven += 1,
            Verdict::Different(difference) => panic!("seed {seed}: {difference:?}"),
            Verdict::Undecided(missing) => open.push(format!("seed {seed}: {missing}")),
        }
    }
    println!("proven {proven}, open {}:\n{}", open.len(), open.join("\n"));
    assert!(proven > 2 * open.len(), "{open:?}");
}

/// The prover's own definition of sine and the like is that of the runtime, bit for bit.
#[test]
fn own_maths_is_the_runtimes() {
    let mut bits: Vec<u32> = (0..amount(500, 4_000)).map(|at: u32| at.wrapping_mul(0x9e37_79b9)).collect();
    bits.extend(
        [0, 1, 0x7f7f_ffff, 0x7f80_0000, 0x7fc0_0000, 0x3f80_0000, 0x42d0_0000].map(|bits: u32| bits | 0x8000_0000),
    );
    for word in ["sin", "cos", "tan", "ln", "exp", "atan", "tanh", "sqrt"] {
        let text = format!(
            r#"{{ "format": "tpg-graph", "version": 2, "scalar": "f32", "maths": "own", "registers": 1,
            "sources": [{{ "name": "x", "length": 1, "unit": "", "ranges": [[-4, 4]] }}], "instructions": ["{word}"],
            "outputs": [{{ "name": "y", "unit": "", "min": -3.4028234663852886e38, "max": 3.4028234663852886e38, "nan": 7 }}],
            "leaves": [{{ "id": 0, "programs": [0] }}],
            "programs": [{{ "id": 0, "lines": [{{ "to": 0, "op": "{word}", "args": ["x[0]"] }}] }}] }}"#
        );
        let (graph, reference) =
            (Meaning::read(word, &text).expect("a graph"), Graph::from_json(word, &text).expect("a graph"));
        let interpreter = Interpreter::<f32, Own>::new(&reference);
        for &bits in &bits {
            let terms = Terms::for_state(&[bits]);
            let values = graph::meaning::Meaning::new(&graph).values(&terms, 0).expect("the definition");
            let found = Evaluator::new(&[bits]).bits(&terms, values[0]);
            let expected = interpreter.outputs(ActionId(0), &[f32::from_bits(bits)])[0];
            assert_eq!(found, expected.to_bits(), "{word} of {bits:#x}");
        }
    }
}
