//! Policies live side by side: two in one C program, two in one Rust program, and names that a language keeps for itself.

use crate::common::{code, emit_into, fixture, options, run};
use std::fs;
use std::process::Command;
use tempfile::TempDir;
use tpg_codegen::emit::{Language, Style};
use tpg_codegen::verify::{self, Workshop};
use tpg_graph::{Document, Graph, MathsProvider, ScalarType};
use tpg_graph::{interpret, states};
use tpg_runtime::standalone;

/// The fixture, and one like it that decides differently.
fn pair() -> [Graph; 2] {
    let left = fixture(ScalarType::F32, MathsProvider::Own);
    let mut document = fixture(ScalarType::F64, MathsProvider::System).to_document();
    document.teams[0].edges.swap(0, 2);
    document.teams[1].edges.truncate(2);
    let right = Graph::from_document("right", document).expect("a valid graph");
    [left, right]
}

/// The interpreter's answers for the state that the programs below ask about.
fn expected([left, right]: &[Graph; 2]) -> String {
    let action = |graph: &Graph| {
        let state = vec![1.0; graph.state_length()];
        interpret::actions(graph, &state)[0].0
    };
    format!("{} {}\n", action(left), action(right))
}

#[test]
fn two_in_one_c_program() {
    const MAIN: &str = r#"
#include "left.h"
#include "right.h"
#include <stdio.h>

int main(void)
{
    const left_state_t left = { { 1.0F, 1.0F, 1.0F }, { 1.0F, 1.0F, 1.0F }, { 1.0F, 1.0F, 1.0F, 1.0F } };
    const right_state_t right = { { 1.0, 1.0, 1.0 }, { 1.0, 1.0, 1.0 }, { 1.0, 1.0, 1.0, 1.0 } };

    if ((left_selftest() != 0U) || (right_selftest() != 0U)) {
        return 1;
    }
    return (printf("%u %u\n", (unsigned)left_infer(&left), (unsigned)right_infer(&right)) > 0) ? 0 : 1;
}
"#;
    let folder = TempDir::new().expect("a temporary folder");
    let graphs = pair();
    for (graph, prefix) in graphs.iter().zip(["left", "right"]) {
        emit_into(folder.path(), graph, Language::C, &options(prefix, Style::Pure));
    }
    fs::write(folder.path().join("main.c"), MAIN).expect("the folder can be written");
    let mut command = Command::new("cc");
    command.current_dir(folder.path()).args(["-std=c99", "-O2", "-Wall", "-Wextra", "-Werror"]);
    run(command.args(["main.c", "left.c", "right.c", "-o", "main", "-lm"]))
        .unwrap_or_else(|message| panic!("{message}"));
    let answer = run(&mut Command::new(folder.path().join("main"))).unwrap_or_else(|message| panic!("{message}"));
    assert_eq!(answer, expected(&graphs));
}

#[test]
fn two_in_one_rust_program() {
    const MAIN: &str = "
mod left;
mod right;
use tpg_runtime::policy::Policy;

fn main() {
    let (left, right) = (left::Left.decide(&[1.0; 10]), right::Right.decide(&[1.0; 10]));
    println!(\"{} {}\", left.0, right.0);
}
";
    let folder = TempDir::new().expect("a temporary folder");
    let graphs = pair();
    for (graph, prefix) in graphs.iter().zip(["left", "right"]) {
        emit_into(folder.path(), graph, Language::Rust, &options(prefix, Style::Pure));
    }
    fs::write(folder.path().join("main.rs"), MAIN).expect("the folder can be written");
    for (name, text) in standalone::FILES {
        let path = folder.path().join("runtime").join(name);
        fs::create_dir_all(path.parent().expect("it has a folder")).expect("the folder can be written");
        fs::write(path, text).expect("the folder can be written");
    }
    let rustc = |arguments: &[&str]| {
        let mut command = Command::new("rustc");
        command.current_dir(folder.path()).args(["--edition=2024", "-O"]).args(arguments);
        run(&mut command).unwrap_or_else(|message| panic!("{message}"));
    };
    rustc(&["--crate-type=rlib", "--crate-name=tpg_runtime", "--cfg=feature=\"std\"", "-Awarnings", "runtime/lib.rs"]);
    rustc(&["--extern=tpg_runtime=libtpg_runtime.rlib", "-Dwarnings", "-Adead_code", "main.rs"]);
    let answer = run(&mut Command::new(folder.path().join("main"))).unwrap_or_else(|message| panic!("{message}"));
    assert_eq!(answer, expected(&graphs));
}

#[test]
fn names_that_generated_code_uses_itself() {
    let mut document: Document = fixture(ScalarType::F32, MathsProvider::Own).to_document();
    let text = serde_json::to_string(&document).expect("JSON");
    let text = text.replace("target", "state").replace("difference", "index").replace("motors", "bids");
    document = serde_json::from_str(&text).expect("a document");
    let graph = Graph::from_document("named", document).expect("a valid graph");
    let workshop = Workshop::new().expect("a temporary folder");
    for prefix in ["match", "policy", "self", "source", "state", "move"] {
        let pure = options(prefix, Style::Pure);
        let mut c = workshop.start(&code(Language::C, &graph, &pure)).expect("C compiles");
        let mut drop_in = workshop
            .start(&code(Language::C, &graph, &options(prefix, Style::Gegelati)))
            .expect("GEGELATI-style C compiles");
        let mut rust = workshop.start(&code(Language::Rust, &graph, &pure)).expect("Rust compiles");
        let comparisons = verify::compare(&graph, &mut [&mut c, &mut drop_in, &mut rust], 100, 1).expect("they run");
        assert!(comparisons.iter().all(|comparison| comparison.differences == 0), "{prefix}: {comparisons:?}");
    }
}

#[test]
fn the_pair_differs() {
    let [left, right] = pair();
    let states = states::sample(&left, 2000, 1);
    assert_ne!(interpret::actions(&left, &states), interpret::actions(&right, &states));
}
