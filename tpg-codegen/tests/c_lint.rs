//! Generated C compiles without a warning, as C99 and as C++11, with gcc and clang; clang-tidy and cppcheck with its MISRA
//! addon report nothing. What may deviate, and why, is in `misra-deviations.txt`.

use crate::common::{COMBINATIONS, SHAPES, emit_into, fixture, run, shaped};
use crate::integers::quantised;
use std::fs;
use std::path::Path;
use std::process::Command;
use tempfile::TempDir;
use tpg_codegen::emit::{Language, Profile, Style};
use tpg_graph::Graph;
use tpg_graph::sample::{self, Constants, Shape};

const WARNINGS: [&str; 13] = [
    "-O2",
    "-c",
    "-Wall",
    "-Wextra",
    "-Wpedantic",
    "-Wconversion",
    "-Wsign-conversion",
    "-Wdouble-promotion",
    "-Wshadow",
    "-Wcast-qual",
    "-Wfloat-equal",
    "-Werror",
    "-ffp-contract=off",
];

const C99: &[&str] = &["-std=c99", "-Wstrict-prototypes"];
const CPP11: &[&str] = &["-x", "c++", "-std=c++11"];

/// A program, the Debian package that has it, and how it takes the language.
const COMPILERS: [(&str, &str, &[&str]); 4] =
    [("gcc", "gcc", C99), ("clang", "clang", C99), ("g++", "g++", CPP11), ("clang++", "clang", CPP11)];

/// Two parameters of one type are what `a < b` needs.
const TIDY: &str = "-*,bugprone-*,cert-*,clang-analyzer-*,-bugprone-easily-swappable-parameters";

/// Does `check` for the fixture in every scalar and maths and for random graphs, in every shape, each in a folder that
/// holds the C and a program that uses it.
fn everywhere(mut check: impl FnMut(&Path)) {
    let fixtures = COMBINATIONS[tpg_testing::amount(3, 0)..].iter().map(|&(scalar, maths)| fixture(scalar, maths));
    let random = (1..=tpg_testing::amount(0, 2)).map(|seed| sample::graph(&Shape::random(seed), seed));
    // More teams than one switch takes, which passes leave as they are.
    let many =
        Shape { teams: 70, edges: 2..=2, lines: 2..=3, registers: 2, constants: Constants::None, ..Shape::default() };
    // A formula, and leaves under teams.
    let outputs = [5, 7].map(|seed| sample::graph(&Shape::random_with_outputs(seed), seed));
    for graph in fixtures.chain(random).chain([sample::graph(&many, 1)]).chain(outputs) {
        for shape in SHAPES.into_iter().filter(|shape| shape.0 == Style::Pure || graph.outputs().is_empty()) {
            let folder = TempDir::new().expect("a temporary folder");
            emit_into(folder.path(), &graph, Language::C, &shaped("arm", shape));
            fs::write(folder.path().join("user.c"), user(&graph, shape.0)).expect("the folder can be written");
            check(folder.path());
        }
    }
    // Integers: actions, sums and a table of them, teams over leaves.
    let shipped = [("dodge", 16), ("bipedal-walker", 8), ("widowx-fs", 8)];
    for &(name, bits) in &shipped[..tpg_testing::amount(2, 3)] {
        let whole = quantised(name, bits).0;
        for profile in [Profile::Fast, Profile::Small] {
            let folder = TempDir::new().expect("a temporary folder");
            let shape = (Style::Pure, Some(profile));
            emit_into(folder.path(), &whole, Language::C, &shaped("arm", shape));
            fs::write(folder.path().join("user.c"), user(&whole, Style::Pure)).expect("the folder can be written");
            check(folder.path());
        }
    }
}

/// A program that uses all of the interface: without one, whole-program checks take the interface for unused.
fn user(graph: &Graph, style: Style) -> String {
    let scalar = if graph.scalar().name() == "f32" { "float" } else { "double" };
    let (answers, memory) = graph.outputs().split_at(graph.outputs().len() - graph.memory());
    let uses = |of: &str, name: &str| format!("({of}.{name} <= {of}.{name})");
    let uses_outputs: Vec<String> = (answers.iter().map(|output| uses("action", &output.name)))
        .chain(memory.iter().map(|value| uses("memory", &value.name)))
        .collect();
    let check = if uses_outputs.is_empty() {
        "(uint32_t)action < ARM_ACTIONS".to_owned()
    } else {
        format!("(ARM_OUTPUTS > 0U) && {}", uses_outputs.join(" && "))
    };
    let (definitions, call) = match style {
        Style::Pure if graph.memory() > 0 => (
            String::new(),
            "static arm_state_t state;\n    arm_memory_t memory;\n    arm_action_t action;\n\n    \
             arm_reset(&memory);\n    arm_infer(&state, &memory, &action);"
                .to_owned(),
        ),
        Style::Pure if !graph.outputs().is_empty() => (
            String::new(),
            "static arm_state_t state;\n    arm_action_t action;\n\n    arm_infer(&state, &action);".to_owned(),
        ),
        Style::Pure => {
            (String::new(), "static arm_state_t state;\n    const arm_action_t action = arm_infer(&state);".to_owned())
        }
        Style::Gegelati => (
            (graph.sources().iter().zip(1..))
                .map(|(source, number)| {
                    let (name, length) = (&source.name, source.ranges.len());
                    format!("static {scalar} {name}[{length}];\n{scalar} *in{number} = {name};\n")
                })
                .collect(),
            "uint32_t action = (uint32_t)inferenceTPG();".to_owned(),
        ),
    };
    format!(
        "#include \"arm.h\"\n{definitions}int main(void)\n{{\n    {call}\n    \
         return (({check}) && (arm_selftest() == 0U)) ? 0 : 1;\n}}\n"
    )
}

#[test]
fn no_compiler_warns() {
    for (program, package, language) in COMPILERS {
        if !tpg_testing::tool(program, package, "warnings of generated C") {
            continue;
        }
        everywhere(|folder| {
            let mut command = Command::new(program);
            command.current_dir(folder).args(language).args(WARNINGS).args(["arm.c", "user.c"]);
            run(&mut command).unwrap_or_else(|message| panic!("{message}"));
        });
    }
}

#[test]
fn clang_tidy_reports_nothing() {
    if !tpg_testing::tool("clang-tidy", "clang-tidy", "clang-tidy on generated C") {
        return;
    }
    everywhere(|folder| {
        let mut command = Command::new("clang-tidy");
        command.current_dir(folder).args(["--quiet", "--warnings-as-errors=*"]).arg(format!("--checks={TIDY}"));
        command.args(["arm.c", "user.c", "--", "-std=c99", "-ffp-contract=off"]);
        run(&mut command).unwrap_or_else(|message| panic!("{message}"));
    });
}

#[test]
fn cppcheck_and_its_misra_addon_report_nothing() {
    if !tpg_testing::tool("cppcheck", "cppcheck", "cppcheck and its MISRA addon on generated C") {
        return;
    }
    let deviations = Path::new(env!("CARGO_MANIFEST_DIR")).join("misra-deviations.txt");
    everywhere(|folder| {
        let mut command = Command::new("cppcheck");
        command.current_dir(folder).args([
            "--std=c99",
            "--enable=all",
            "--addon=misra",
            "--quiet",
            "--error-exitcode=1",
        ]);
        command.arg(format!("--suppressions-list={}", deviations.display())).args(["arm.c", "user.c"]);
        run(&mut command).unwrap_or_else(|message| panic!("{message}"));
    });
}

#[test]
fn the_linters_see_what_is_bad() {
    let folder = TempDir::new().expect("a temporary folder");
    // An octal constant, and a null pointer read.
    fs::write(folder.path().join("bad.c"), "int main(void)\n{\n    int *p = 0;\n    return *p + 010;\n}\n")
        .expect("the folder can be written");
    if tpg_testing::tool("clang-tidy", "clang-tidy", "clang-tidy on bad C") {
        let mut command = Command::new("clang-tidy");
        command.current_dir(folder.path()).args(["--quiet", "--warnings-as-errors=*"]).arg(format!("--checks={TIDY}"));
        let found = run(command.args(["bad.c", "--", "-std=c99"]));
        assert!(found.as_ref().is_err_and(|text| text.contains("clang-analyzer-core.NullDereference")), "{found:?}");
    }
    if tpg_testing::tool("cppcheck", "cppcheck", "cppcheck on bad C") {
        let mut command = Command::new("cppcheck");
        command.current_dir(folder.path()).args(["--enable=all", "--addon=misra", "--quiet", "--error-exitcode=1"]);
        let found = run(command.arg("bad.c"));
        assert!(found.as_ref().is_err_and(|text| text.contains("misra-c2012-7.1")), "{found:?}");
    }
}
