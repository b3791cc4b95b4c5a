//! Generated code acts like the interpreter: compiled and run.

use tpg_codegen::emit::{Options, Style};
use tpg_codegen::engine::Engine;
use tpg_codegen::graph::{Document, Graph, MathsProvider, ScalarType};
use tpg_codegen::verify::{self, Workshop};

fn fixture(scalar: ScalarType, maths: MathsProvider) -> Graph {
    let text = include_str!("fixtures/all_instructions.json");
    let document: Document = serde_json::from_str(text).expect("the fixture is a document");
    Graph::from_document("all_instructions.json", Document { scalar, maths, ..document }).expect("a valid graph")
}

fn assert_equal(graph: &Graph, states: usize) {
    let workshop = Workshop::new().expect("a temporary folder");
    let pure = Options { prefix: "all_ops".parse().expect("a prefix"), style: Style::Pure };
    let gegelati = Options { style: Style::Gegelati, ..pure.clone() };
    let mut c = workshop.c(graph, &pure).expect("C compiles");
    let mut drop_in = workshop.c(graph, &gegelati).expect("GEGELATI-style C compiles");
    let mut rust = workshop.rust(graph, &pure).expect("Rust compiles");
    let engines: &mut [&mut dyn Engine] = &mut [&mut c, &mut drop_in, &mut rust];
    for comparison in verify::compare(graph, engines, states, 1).expect("the programs run") {
        assert_eq!(comparison.states, states);
        assert_eq!(comparison.differences, 0, "{comparison:?}");
    }
}

#[test]
fn every_instruction_in_f64_with_the_systems_maths() {
    assert_equal(&fixture(ScalarType::F64, MathsProvider::System), 50_000);
}

#[test]
fn every_instruction_in_f32_with_the_systems_maths() {
    assert_equal(&fixture(ScalarType::F32, MathsProvider::System), 50_000);
}

#[test]
fn every_instruction_in_f64_with_own_maths() {
    assert_equal(&fixture(ScalarType::F64, MathsProvider::Own), 50_000);
}

#[test]
fn every_instruction_in_f32_with_own_maths() {
    assert_equal(&fixture(ScalarType::F32, MathsProvider::Own), 50_000);
}

#[test]
fn a_different_policy_is_found_out() {
    let graph = fixture(ScalarType::F64, MathsProvider::System);
    let mut document = graph.to_document();
    document.teams[0].edges.swap(0, 2);
    let other = Graph::from_document("other", document).expect("a valid graph");
    let workshop = Workshop::new().expect("a temporary folder");
    let options = Options { prefix: "other".parse().expect("a prefix"), style: Style::Pure };
    let mut c = workshop.c(&other, &options).expect("C compiles");
    let comparisons = verify::compare(&graph, &mut [&mut c], 20_000, 1).expect("the program runs");
    assert!(comparisons[0].differences > 0, "swapped edges change ties: {comparisons:?}");
    assert!(comparisons[0].first.is_some());
}
