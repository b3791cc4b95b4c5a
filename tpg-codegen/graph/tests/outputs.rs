//! Policies with outputs: what they answer, and how they are written.

use tpg_graph::interpret::{self, Answer};
use tpg_graph::sample::{self, Shape};
use tpg_graph::{Graph, states};

/// A swing-up of a pendulum by one program: torque = 2 · velocity, limited to ±2.
const FORMULA: &str = r#"{
  "format": "tpg-graph", "version": 2, "scalar": "f32", "maths": "own", "registers": 1,
  "sources": [{"name":"velocity","length":1,"unit":"rad/s","ranges":[[-8.0,8.0]]}],
  "instructions": ["mul"],
  "outputs": [{"name":"torque","unit":"N*m","min":-2.0,"max":2.0,"nan":0.5}],
  "leaves": [{"id":3,"programs":[0]}],
  "programs": [{"id":0,"lines":[{"to":0,"op":"mul","args":["velocity[0]",2]}]}]
}"#;

#[test]
fn an_output_is_limited_and_a_nan_has_its_value() {
    let graph = Graph::from_json("formula.json", FORMULA).expect("a valid graph");
    assert!(graph.is_formula() && graph.actions().is_empty());
    let states = [-0.0, 0.25, 7.0, -7.0, f64::INFINITY, f64::NEG_INFINITY, f64::NAN];
    let expected = [-0.0, 0.5, 2.0, -2.0, 2.0, -2.0, 0.5].map(|value| Answer::Values(vec![value]));
    for (found, expected) in interpret::answers(&graph, &states).iter().zip(&expected) {
        assert!(found.same_bits(expected), "{found} instead of {expected}");
    }
}

#[test]
fn a_formula_is_written_without_a_team() {
    let graph = Graph::from_json("formula.json", FORMULA).expect("a valid graph");
    let text = graph.to_json();
    assert!(!text.contains("teams") && !text.contains("root") && !text.contains("actions"), "{text}");
    assert_eq!(Graph::from_json("again.json", &text), Ok(graph));
}

#[test]
fn random_policies_are_read_as_they_were_written_and_answer_within_their_ranges() {
    let (mut formulas, mut at_an_end) = (0, 0);
    for seed in 0..200 {
        let graph = sample::graph(&Shape::random_with_outputs(seed), seed);
        let again = Graph::from_json("again.json", &graph.to_json()).unwrap_or_else(|error| panic!("{seed}: {error}"));
        assert_eq!(again, graph, "graph {seed}");
        formulas += usize::from(graph.is_formula());
        for answer in interpret::answers(&graph, &states::sample(&graph, 100, seed)) {
            let Answer::Values(values) = answer else { panic!("graph {seed}: {answer}") };
            for (value, output) in values.iter().zip(graph.outputs()) {
                assert!((output.range.min..=output.range.max).contains(value), "graph {seed}: {value}");
                at_an_end += usize::from([output.range.min, output.range.max].contains(value));
            }
        }
    }
    assert!(formulas == 40 && at_an_end > 1000, "{formulas} formulas, {at_an_end} values at an end");
}

#[test]
fn the_documented_example_is_a_graph() {
    let text = &graph_json_page();
    let example = text.split_once("```json\n").and_then(|(_, after)| after.split_once("```")).expect("an example").0;
    let graph = Graph::from_json("docs/graph-json.md", example).unwrap_or_else(|error| panic!("{error}"));
    assert_eq!((graph.memory(), graph.outputs().len()), (1, 2), "the memory is the last of the outputs");
    // 0.5 rad, 0.1 rad more than before.
    let answers = interpret::answers(&graph, &[0.5, f64::from(0.4_f32)]);
    let Answer::Values(values) = &answers[0] else { panic!("{answers:?}") };
    assert!((values[0] + 0.1 * 5.5 + 0.5 * 2.25).abs() < 1e-6 && values[1] == 0.5, "{values:?}");
    for word in tpg_graph::Word::ALL {
        assert!(text.contains(&format!("`{}`", word.name())), "{} is not documented", word.name());
    }
}

/// The page about the format. It is read, not included: a package holds no file from outside of its folder.
fn graph_json_page() -> String {
    let path = std::path::Path::new(env!("CARGO_MANIFEST_DIR")).join("../../docs/graph-json.md");
    std::fs::read_to_string(path).expect("the repository has it")
}
