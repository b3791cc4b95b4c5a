//! Generated code acts like the interpreter: compiled and run.

use crate::common::code;
use tpg_codegen::compile;
use tpg_codegen::emit::{Code, Language, Options, Profile, Style};
use tpg_codegen::verify::{self, Proof, Workshop};
use tpg_graph::engine::Engine;
use tpg_graph::sample::{self, Shape};
use tpg_graph::{Document, Graph, MathsProvider, ScalarType};

fn fixture(scalar: ScalarType, maths: MathsProvider) -> Graph {
    let text = include_str!("fixtures/all_instructions.json");
    let document: Document = serde_json::from_str(text).expect("the fixture is a document");
    Graph::from_document("all_instructions.json", Document { scalar, maths, ..document }).expect("a valid graph")
}

fn assert_equal(graph: &Graph, states: usize) {
    let workshop = Workshop::new().expect("a temporary folder");
    let pure = Options::new("all_ops".parse().expect("a prefix"));
    let gegelati = Options { style: Style::Gegelati, ..pure.clone() };
    let mut programs = vec![workshop.start(&code(Language::C, graph, &gegelati)).expect("GEGELATI-style C compiles")];
    for profile in Profile::ALL {
        let options = Options { profile: Some(profile), ..pure.clone() };
        programs.push(workshop.start(&code(Language::C, graph, &options)).expect("C compiles"));
        programs.push(workshop.start(&code(Language::Rust, graph, &options)).expect("Rust compiles"));
    }
    let mut engines: Vec<&mut dyn Engine> = programs.iter_mut().map(|program| program as &mut dyn Engine).collect();
    let engines = engines.as_mut_slice();
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
fn more_teams_than_one_switch_takes() {
    let shape = Shape { teams: 150, edges: 1..=3, lines: 0..=3, chain: true, ..Shape::default() };
    assert_equal(&sample::graph(&shape, 1), 20_000);
}

/// Where no bid is a number, the last edge wins: also where bids are not compared in the order of the edges, and where the code
/// of another edge's team follows.
#[test]
fn nobody_wins_beside_a_bid_that_is_compared_late() {
    let text = r#"{
        "format": "tpg-graph", "version": 1, "scalar": "f64", "maths": "system", "registers": 1,
        "sources": [{"name": "x", "length": 3, "unit": "", "ranges": [[-1, 1], [-1, 1], [-1, 1]]}],
        "instructions": ["exp", "copy", "sub"],
        "actions": [{"id": 0, "name": "a"}, {"id": 1, "name": "b"}, {"id": 2, "name": "c"}],
        "root": 0,
        "teams": [
            {"id": 0, "edges": [{"program": 0, "action": 0}, {"program": 1, "team": 1}, {"program": 2, "action": 1}]},
            {"id": 1, "edges": [{"program": 4, "action": 2}, {"program": 3, "action": 0}]}
        ],
        "programs": [
            {"id": 0, "lines": [{"to": 0, "op": "exp", "args": ["x[0]"]}]},
            {"id": 1, "lines": [{"to": 0, "op": "copy", "args": ["x[1]"]}]},
            {"id": 2, "lines": [{"to": 0, "op": "copy", "args": ["x[2]"]}]},
            {"id": 3, "lines": [{"to": 0, "op": "sub", "args": ["x[0]", "x[2]"]}]},
            {"id": 4, "lines": [{"to": 0, "op": "copy", "args": ["x[1]"]}]}
        ]
    }"#;
    let document: Document = serde_json::from_str(text).expect("a document");
    for maths in [MathsProvider::System, MathsProvider::Own] {
        let graph = Graph::from_document("nobody", Document { maths, ..document.clone() }).expect("a valid graph");
        assert_equal(&graph, 5000);
    }
}

#[test]
fn a_different_policy_is_found_out() {
    let graph = fixture(ScalarType::F64, MathsProvider::System);
    let mut document = graph.to_document();
    document.teams[0].edges.swap(0, 2);
    let other = Graph::from_document("other", document).expect("a valid graph");
    let workshop = Workshop::new().expect("a temporary folder");
    let options = Options::new("other".parse().expect("a prefix"));
    let mut c = workshop.start(&code(Language::C, &other, &options)).expect("C compiles");
    let comparisons = verify::compare(&graph, &mut [&mut c], 20_000, 1).expect("the program runs");
    assert!(comparisons[0].differences > 0, "swapped edges change ties: {comparisons:?}");
    assert!(comparisons[0].first.is_some());
}

/// Generated code whose last file says something else.
fn changed<'g>(graph: &'g Graph, language: Language, from: &str, to: &str) -> Code<'g> {
    let mut code = Code::of(compile(graph, &Options::new("arm".parse().expect("a prefix")), language));
    let file = code.files.last_mut().expect("a file");
    assert!(file.text.contains(from), "{}", file.text);
    file.text = file.text.replace(from, to);
    code
}

#[test]
fn the_text_is_proven_and_not_the_graph_it_came_from() {
    let graph = fixture(ScalarType::F64, MathsProvider::Own);
    let of = |language, from, to| Proof::of(&[changed(&graph, language, from, to)], 500, 1);
    let [c, rust] = ["double best = -DBL_MAX;", ".wrapping_sub(3) as u16)"];
    for (language, same) in [(Language::C, c), (Language::Rust, rust)] {
        assert!(of(language, same, same).expect("it runs").holds(), "{language:?}");
    }
    let proof = of(Language::Rust, rust, ".wrapping_sub(3) as u16 ^ 1)").expect("it runs");
    assert!(!proof.holds() && proof.unproven.is_empty(), "{proof:?}");
    assert_eq!(proof.comparisons[0].differences, 500, "{proof:?}");
    let error = of(Language::C, c, "double best = DBL_MAX;").expect_err("its self-test notices");
    assert_eq!(error.to_string(), "C, fast: the self-test in the code differs from the interpreter");
}
