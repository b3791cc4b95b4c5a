//! The profile `constant-time`, compiled for a Cortex-M4: nothing in the object decides by data what runs, no branch, no
//! predicated block, no table; and under QEMU every state takes exactly the instructions of the static bound. In C and in
//! Rust, at every level of optimisation.

use crate::common::{fixture, run, shaped};
use cortex_bound::{Analyser, LoopBounds, disassemble};
use std::fs;
use std::path::{Path, PathBuf};
use std::process::Command;
use tempfile::TempDir;

use tpg_codegen::emit::{self, Code, Language, Profile, Style};
use tpg_codegen::size::{RustForCortexM4, Target, build_c};
use tpg_graph::Word;
use tpg_graph::interpret::{Answer, Interpreter};
use tpg_graph::sample::{self, Constants, Shape};
use tpg_graph::{Graph, MathsProvider, ScalarType};
use tpg_graph::{import, states};
use tpg_runtime::ops::Own;

const STATES: usize = 10_000;
/// A language with a level of optimisation. (Not `z` of Rust: LLVM then calls a function through a register where it is
/// called often, and a static bound does not know where that goes.)
const BUILDS: [(Language, &str); 7] = [
    (Language::C, "-O0"),
    (Language::C, "-O1"),
    (Language::C, "-O2"),
    (Language::C, "-O3"),
    (Language::C, "-Os"),
    (Language::Rust, "3"),
    (Language::Rust, "s"),
];
const CORE: [&str; 4] = ["-mcpu=cortex-m4", "-mthumb", "-mfloat-abi=hard", "-mfpu=fpv4-sp-d16"];

/// This project's policies, the graph with every instruction, and random ones: all in f32 with own maths, which is what a
/// Cortex-M4F computes in itself.
fn graphs() -> Vec<(String, Graph)> {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("../generated");
    let own = ["widowx-fs", "widowx-rs"].map(|name| {
        let graph = import::load(&folder.join(name).join("graph.json"), None, None).expect("a committed graph");
        (name.to_owned(), graph)
    });
    let random = (0..tpg_testing::amount(2, 3)).map(|seed| {
        let shape = Shape { teams: 12, scalar: ScalarType::F32, maths: MathsProvider::Own, ..Shape::random(seed) };
        (format!("random {seed}"), sample::graph(&shape, seed))
    });
    let all = ("every instruction".to_owned(), fixture(ScalarType::F32, MathsProvider::Own));
    own.into_iter().chain([all, ("many teams".to_owned(), many_teams())]).chain(random).chain(with_values()).collect()
}

/// Policies that answer with values: a formula, leaves, memory, and random ones, most of which remember.
fn with_values() -> Vec<(String, Graph)> {
    let fixtures = [
        ("formula", include_str!("fixtures/formula.json")),
        ("swing_up", include_str!("fixtures/swing_up.json")),
        ("memory", include_str!("fixtures/memory.json")),
    ];
    let fixtures = fixtures.map(|(name, text)| (name.to_owned(), Graph::from_json(name, text).expect("a valid graph")));
    let random = (0..tpg_testing::amount(2, 4)).map(|seed| {
        let shape = Shape::random_with_outputs(seed + 4);
        let shape = Shape { teams: shape.teams.min(6), scalar: ScalarType::F32, maths: MathsProvider::Own, ..shape };
        (format!("random with values {seed}"), sample::graph(&shape, seed))
    });
    fixtures.into_iter().chain(random).collect()
}

/// A graph larger than any shipped one.
fn many_teams() -> Graph {
    // Without constants and divisions no bid is known beforehand: passes find little to leave out.
    let names = ["add", "sub", "mul", "negate_if_less", "cos"];
    let shape = Shape {
        teams: 100,
        edges: 2..=4,
        lines: 6..=12,
        registers: 3,
        scalar: ScalarType::F32,
        maths: MathsProvider::Own,
        instructions: names.iter().copied().filter_map(Word::from_name).collect(),
        constants: Constants::None,
        chain: true,
        ..Shape::default()
    };
    sample::graph(&shape, 1)
}

fn tools(what: &str, programs: &[(&str, &str)]) -> bool {
    programs.iter().all(|(program, package)| tpg_testing::tool(program, package, what))
}

/// The builds that the installed compilers can make.
fn builds() -> Vec<(Language, &'static str)> {
    let has_rust = tpg_testing::library::rust_target("thumbv7em-none-eabihf", "constant-time Rust on a Cortex-M4");
    BUILDS.into_iter().filter(|&(language, _)| has_rust || language == Language::C).collect()
}

/// Tests whether a build is claimed to take the same time: in Rust a square root is libm's, which branches, and optimisers see
/// through masks of the other words.
fn is_claimed(graph: &Graph, language: Language) -> bool {
    let is_not = |word: &str| ["sqrt", "atan", "tanh", "quotient"].contains(&word);
    language == Language::C || !graph.to_json().split(|c: char| !c.is_ascii_alphanumeric()).any(is_not)
}

/// Emits a graph in C into a folder.
fn emit_c(folder: &Path, graph: &Graph, profile: Profile) {
    for file in emit::emit(graph, Language::C, &shaped("ct", (Style::Pure, Some(profile)))) {
        fs::write(folder.join(&file.name), file.text).expect("the folder can be written");
    }
}

fn gcc(folder: &Path, level: &str, arguments: &[&str]) {
    let mut command = Command::new("arm-none-eabi-gcc");
    command.current_dir(folder).args(CORE).args(["-std=gnu99", "-ffp-contract=off", "-DCT_NO_SELFTEST", level]);
    run(command.args(arguments)).unwrap_or_else(|message| panic!("{message}"));
}

/// The compiler of a language at a level.
enum Compiler {
    C(&'static str),
    Rust(RustForCortexM4, &'static str),
}

impl Compiler {
    fn new(language: Language, level: &'static str) -> Self {
        match language {
            Language::C => Self::C(level),
            Language::Rust => Self::Rust(RustForCortexM4::new(level).expect("the toolchain has the target"), level),
        }
    }

    /// Compiles a graph to `ct.o` in a folder, with the function `ct_infer`.
    fn compile(&self, folder: &Path, graph: &Graph, profile: Profile) {
        match self {
            Self::C(level) => {
                emit_c(folder, graph, profile);
                gcc(folder, level, &["-c", "ct.c", "-o", "ct.o"]);
            }
            Self::Rust(compiler, level) => {
                let options = shaped("ct", (Style::Pure, Some(profile)));
                let object = compiler
                    .object(&Code::of(tpg_codegen::compile(graph, &options, Language::Rust)), level)
                    .unwrap_or_else(|error| panic!("{error}"));
                fs::write(folder.join("ct.o"), object).expect("the folder can be written");
            }
        }
    }
}

fn compile(folder: &Path, graph: &Graph, profile: Profile, (language, level): (Language, &'static str)) {
    Compiler::new(language, level).compile(folder, graph, profile);
}

#[test]
fn nothing_in_the_object_decides_by_data_what_runs() {
    let binutils = [("arm-none-eabi-gcc", "gcc-arm-none-eabi"), ("arm-none-eabi-objdump", "gcc-arm-none-eabi")];
    if !tools("branches of constant-time code on a Cortex-M4", &binutils) {
        return;
    }
    let bounds = LoopBounds::new();
    let listing = |graph: &Graph, profile, build| {
        let folder = TempDir::new().expect("a temporary folder");
        compile(folder.path(), graph, profile, build);
        disassemble(&folder.path().join("ct.o")).expect("a listing")
    };
    for (name, graph) in graphs() {
        for build in builds().into_iter().filter(|build| is_claimed(&graph, build.0)) {
            let listing = listing(&graph, Profile::ConstantTime, build);
            let mut analyser = Analyser::new(&listing, &bounds);
            let sites = analyser.decisions("ct_infer").unwrap_or_else(|refusal| panic!("{name} {build:?}: {refusal}"));
            assert!(sites.is_empty(), "{name} {build:?}: {sites:?}");
            analyser.bound("ct_infer").unwrap_or_else(|refusal| panic!("{name} {build:?}: {refusal}"));
        }
    }
    // The check finds what is there: a fast policy decides, by branches or a table.
    let (_, graph) = &graphs()[0];
    for build in builds() {
        let listing = listing(graph, Profile::Fast, build);
        let sites = Analyser::new(&listing, &bounds).decisions("ct_infer");
        assert!(sites.is_err() || sites.is_ok_and(|sites| !sites.is_empty()), "{build:?}");
    }
}

/// If a comparison has a constant operand and is inlined, the optimiser knows more of the mask that it makes.
#[test]
fn nor_where_operands_are_constants() {
    let binutils = [("arm-none-eabi-gcc", "gcc-arm-none-eabi"), ("arm-none-eabi-objdump", "gcc-arm-none-eabi")];
    if !tools("branches of constant-time code with constants on a Cortex-M4", &binutils) {
        return;
    }
    let names = ["add", "min", "max", "negate_if_less"];
    let bounds = LoopBounds::new();
    for seed in 0..tpg_testing::amount(6, 15) {
        let shape = Shape {
            teams: 6,
            scalar: ScalarType::F32,
            instructions: names.iter().copied().filter_map(Word::from_name).collect(),
            ..Shape::random(seed)
        };
        let graph = sample::graph(&shape, seed);
        for level in ["-O1", "-O2", "-O3", "-Os"] {
            let folder = TempDir::new().expect("a temporary folder");
            compile(folder.path(), &graph, Profile::ConstantTime, (Language::C, level));
            let listing = disassemble(&folder.path().join("ct.o")).expect("a listing");
            let sites = Analyser::new(&listing, &bounds).decisions("ct_infer").expect("no unknown calls");
            assert!(sites.is_empty(), "graph {seed} at {level}: {sites:?}");
        }
    }
}

/// A graph of one team, as evolution finds for a cart with a pole, or of one formula; its programs have no sines.
fn tiny(seed: u64) -> Graph {
    let names = ["add", "sub", "mul", "div", "negate_if_less", "abs", "min", "max", "multiply_add"];
    let shape = Shape {
        teams: usize::from(!seed.is_multiple_of(4)),
        edges: 2..=2 + seed as usize % 3,
        lines: 2..=8,
        registers: 3,
        sources: vec![1; 4],
        actions: 2 + seed as u32 % 2,
        outputs: u32::from(seed.is_multiple_of(4)),
        scalar: ScalarType::F32,
        instructions: names.iter().copied().filter_map(Word::from_name).collect(),
        constants: Constants::Reals,
        ..Shape::default()
    };
    sample::graph(&shape, seed)
}

/// At most, for any state: the bound of fast code is that of its longest way. Of random graphs a compiler may find that most
/// of their bids cannot win, which masks hide from it: they are taken together. In Rust, what hides a shift from the optimiser
/// takes 8 instructions of each.
#[test]
fn a_tiny_graph_takes_at_most_twice_the_instructions_of_fast_code() {
    let binutils = [("arm-none-eabi-gcc", "gcc-arm-none-eabi"), ("arm-none-eabi-objdump", "gcc-arm-none-eabi")];
    if !tools("instructions of tiny constant-time graphs on a Cortex-M4", &binutils) {
        return;
    }
    let fixture = |name: &str, text| Graph::from_json(name, text).expect("a valid graph");
    let formula = vec![fixture("formula", include_str!("fixtures/formula.json"))];
    let cartpole = vec![fixture("cartpole", include_str!("fixtures/cartpole.json"))];
    let random: Vec<Graph> = (0..tpg_testing::amount(12, 40)).map(tiny).collect();
    let both = [(Language::C, "-Os", 0), (Language::Rust, "s", 8)];
    for (language, level, hiding) in both.into_iter().filter(|&(it, level, _)| builds().contains(&(it, level))) {
        let compiler = Compiler::new(language, level);
        let instructions = |graph: &Graph, profile| {
            let folder = TempDir::new().expect("a temporary folder");
            compiler.compile(folder.path(), graph, profile);
            let listing = disassemble(&folder.path().join("ct.o")).expect("a listing");
            let bound = Analyser::new(&listing, &LoopBounds::new()).bound("ct_infer");
            bound.unwrap_or_else(|refusal| panic!("{language:?}, {profile:?}: {refusal}")).instructions
        };
        for graphs in [&formula, &cartpole, &random] {
            let [constant, fast] = [Profile::ConstantTime, Profile::Fast]
                .map(|profile| graphs.iter().map(|graph| instructions(graph, profile)).sum::<u64>());
            let accepted = 2 * fast + if graphs.len() > 1 { hiding * graphs.len() as u64 } else { 0 };
            assert!(
                constant <= accepted,
                "{} graphs, {language:?}: {constant} instructions, fast {fast}",
                graphs.len()
            );
        }
    }
}

/// A policy's memory at first.
fn remembered(graph: &Graph) -> Vec<f64> {
    graph.outputs()[graph.outputs().len() - graph.memory()..].iter().map(|value| value.nan).collect()
}

/// A hash of the interpreter's answers to states one after another, with what is remembered between them.
fn hash_of(graph: &Graph, seen: &[Vec<f64>]) -> u32 {
    let mut memory = remembered(graph);
    let interpreter = Interpreter::<f32, Own>::new(graph);
    let mut hash = 2_166_136_261_u32;
    let mut add = |bits: u32| hash = (hash ^ bits).wrapping_mul(16_777_619);
    for seen in seen {
        let state: Vec<f32> = seen.iter().chain(&memory).map(|&value| value as f32).collect();
        match interpreter.answer(&state) {
            Answer::Action(action) => add(u32::from(action.0)),
            Answer::Values(values) => {
                let (answered, next) = values.split_at(values.len() - memory.len());
                answered.iter().for_each(|&value| add((value as f32).to_bits()));
                memory.copy_from_slice(next);
            }
        }
    }
    hash
}

/// Links an image that decides what it sees.
fn image(
    folder: &Path,
    graph: &Graph,
    seen: &[Vec<f64>],
    profile: Profile,
    build: (Language, &'static str),
) -> PathBuf {
    compile(folder, graph, profile, build);
    let memory = remembered(graph);
    let numbers = memory.iter().chain(seen.iter().flatten());
    let bytes: Vec<u8> = numbers.flat_map(|&value| (value as f32).to_le_bytes()).collect();
    fs::write(folder.join("states"), bytes).expect("the folder can be written");
    let fixtures = Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/fixtures/cortex-m4");
    for file in ["main.c", "image.s", "image.ld"] {
        fs::copy(fixtures.join(file), folder.join(file)).expect("the folder can be written");
    }
    let language = if build.0 == Language::Rust { "-DRUST" } else { "-DC" };
    let counts = [
        format!("-DSTATES={}", seen.len()),
        format!("-DOBSERVED={}", graph.state_length() - memory.len()),
        format!("-DVALUES={}", graph.outputs().len() - memory.len()),
        format!("-DMEMORY={}", memory.len()),
    ];
    let counts = counts.each_ref().map(String::as_str);
    let sources = ["ct.o", "main.c", "image.s", "-nostartfiles", "-nostdlib", "-T", "image.ld", "-o", "image.elf"];
    gcc(folder, "-O2", &[&[language], &counts[..], &sources, &["-lc"]].concat());
    folder.join("image.elf")
}

/// The states that a policy is run on.
fn seen_by(graph: &Graph) -> Vec<Vec<f64>> {
    let observed = graph.state_length() - graph.memory();
    states::sample(graph, STATES, 1)
        .chunks_exact(graph.state_length())
        .map(|state| state[..observed].to_vec())
        .collect()
}

/// Runs an image; returns the fewest and the most instructions of a decision, and the hash of the answers.
fn counted(image: &Path) -> (u64, u64, u32) {
    let mut command = Command::new("qemu-system-arm");
    command.args(["-machine", "mps2-an386", "-nographic", "-monitor", "none", "-serial", "none"]);
    command.args(["-icount", "shift=10,align=off,sleep=off"]);
    command.args(["-semihosting-config", "enable=on,target=native", "-kernel"]).arg(image);
    let text = run(&mut command).unwrap_or_else(|message| panic!("{}: {message}", image.display()));
    let numbers: Vec<u32> = text.lines().filter_map(|line| line.trim().parse().ok()).collect();
    let [nothing, least, most, hash] = numbers[..] else { panic!("{}: {text}", image.display()) };
    // Less the call of nothing, whose only instruction is its return.
    let instructions = |ticks: u32| ((f64::from(ticks) - f64::from(nothing)) / 25.6).round() as u64 + 1;
    (instructions(least), instructions(most), hash)
}

/// Code that loops over tables, with the turns that `report` takes for granted.
#[test]
fn no_state_takes_more_than_the_bound_of_a_report() {
    let emulator = [("arm-none-eabi-gcc", "gcc-arm-none-eabi"), ("qemu-system-arm", "qemu-system-arm")];
    if !tools("instructions of tables under QEMU", &emulator) {
        return;
    }
    let mut compared = 0;
    for (name, graph) in graphs() {
        let seen = seen_by(&graph);
        for profile in [Profile::Fast, Profile::Balanced, Profile::Small] {
            let code = Code::of(tpg_codegen::compile(&graph, &shaped("ct", (Style::Pure, Some(profile))), Language::C));
            let built = build_c(&code, Target::M4f).expect("it compiles");
            let linked = built.link(&code).expect("it links").expect("an image");
            let Some(Ok(bound)) = linked.bound else { continue };
            let folder = TempDir::new().expect("a temporary folder");
            let (_, most, hash) = counted(&image(folder.path(), &graph, &seen, profile, (Language::C, "-Os")));
            assert_eq!(hash, hash_of(&graph, &seen), "{name}, {profile:?}");
            assert!(most <= bound.instructions, "{name}, {profile:?}: {most} of {}", bound.instructions);
            compared += 1;
        }
    }
    assert!(compared >= 20, "{compared} bounds");
}

#[test]
fn every_state_takes_the_instructions_of_the_static_bound() {
    let emulator = [
        ("arm-none-eabi-gcc", "gcc-arm-none-eabi"),
        ("arm-none-eabi-objdump", "gcc-arm-none-eabi"),
        ("qemu-system-arm", "qemu-system-arm"),
    ];
    if !tools("instructions of constant-time code under QEMU", &emulator) {
        return;
    }
    for (name, graph) in graphs() {
        let seen = seen_by(&graph);
        let expected = hash_of(&graph, &seen);
        for build in builds().into_iter().filter(|build| is_claimed(&graph, build.0)) {
            let folder = TempDir::new().expect("a temporary folder");
            let image = image(folder.path(), &graph, &seen, Profile::ConstantTime, build);
            let listing = disassemble(&image).expect("a listing");
            let bounds = LoopBounds::new();
            let bound = Analyser::new(&listing, &bounds).bound("ct_infer").expect("a bound");
            let (least, most, hash) = counted(&image);
            assert_eq!(hash, expected, "{name} {build:?}: other answers than the interpreter's");
            assert_eq!((least, most), (bound.instructions, bound.instructions), "{name} {build:?}");
        }
    }
}

/// A graph of operations without sines, in f64.
fn in_doubles() -> Graph {
    let names = ["add", "sub", "mul", "div", "negate_if_less", "abs", "min", "max", "gate", "multiply_add"];
    let shape = Shape {
        teams: 3,
        edges: 2..=4,
        lines: 3..=8,
        outputs: 2,
        memory: 1,
        scalar: ScalarType::F64,
        instructions: names.iter().copied().filter_map(Word::from_name).collect(),
        ..Shape::default()
    };
    sample::graph(&shape, 3)
}

/// A library computes doubles for an FPU that has none, by code that branches on them: no bound is claimed for that.
#[test]
fn doubles_take_the_same_time_where_the_fpu_has_them() {
    let binutils = [("arm-none-eabi-gcc", "gcc-arm-none-eabi"), ("arm-none-eabi-objdump", "gcc-arm-none-eabi")];
    if !tools("constant-time code in f64 on a Cortex-M4F and a Cortex-M7", &binutils) {
        return;
    }
    let graph = in_doubles();
    let folder = TempDir::new().expect("a temporary folder");
    emit_c(folder.path(), &graph, Profile::ConstantTime);
    let text = fs::read_to_string(folder.path().join("ct.c")).expect("it was written");
    assert!(text.contains("Every decision takes the same time only where the FPU has doubles"), "the file says so");
    let bounds = LoopBounds::new();
    for level in ["-O1", "-O2", "-O3", "-Os"] {
        let listing = |core: [&str; 4]| {
            let mut command = Command::new("arm-none-eabi-gcc");
            command.current_dir(folder.path()).args(core).args(["-DCT_NO_SELFTEST", level, "-c", "ct.c", "-o", "ct.o"]);
            run(&mut command).unwrap_or_else(|message| panic!("{message}"));
            disassemble(&folder.path().join("ct.o")).expect("a listing")
        };
        let single = listing(CORE);
        let refusal = Analyser::new(&single, &bounds).decisions("ct_infer").expect_err("a library computes");
        assert!(refusal.to_string().contains("in software"), "{level}: {refusal}");
        let double = listing(["-mcpu=cortex-m7", "-mthumb", "-mfloat-abi=hard", "-mfpu=fpv5-d16"]);
        let mut analyser = Analyser::new(&double, &bounds);
        let sites = analyser.decisions("ct_infer").unwrap_or_else(|refusal| panic!("{level}: {refusal}"));
        assert!(sites.is_empty(), "{level}: {sites:?}");
        analyser.bound("ct_infer").unwrap_or_else(|refusal| panic!("{level}: {refusal}"));
    }
}
