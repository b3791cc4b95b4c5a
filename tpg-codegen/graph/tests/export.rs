//! Graphs survive every format unchanged.

use proptest::prelude::*;
use tpg_graph::export;
use tpg_graph::import::{self, Sidecar};
use tpg_graph::sample::{self, Constants, Shape};
use tpg_graph::{Effect, Graph};

fn through_dot(graph: &Graph) -> Graph {
    let sidecar = Sidecar::from_toml("x.toml", &export::sidecar::text(graph)).unwrap_or_else(|error| panic!("{error}"));
    import::from_text("x.dot", &dot(graph), Some(&sidecar)).unwrap_or_else(|error| panic!("{error}"))
}

fn dot(graph: &Graph) -> String {
    export::dot::text(graph).unwrap_or_else(|error| panic!("{error}"))
}

fn through_json(graph: &Graph) -> Graph {
    Graph::from_json("x.json", &graph.to_json()).unwrap_or_else(|error| panic!("{error}"))
}

/// The text is compared as well, because −0 and 0 are equal numbers.
fn assert_same(graph: &Graph, found: &Graph) {
    assert_eq!(graph, found);
    assert_eq!(graph.to_json(), found.to_json());
}

proptest! {
    #[test]
    fn random_graphs_survive(shape: u64, seed: u64) {
        let graph = sample::graph(&Shape::random(shape), seed);
        assert_same(&graph, &through_json(&graph));
        let again = through_dot(&graph);
        assert_same(&graph, &again);
        assert_eq!(dot(&graph), dot(&again));
    }

    #[test]
    fn random_graphs_with_outputs_survive(shape: u64, seed: u64) {
        let graph = sample::graph(&Shape { memory: 0, ..Shape::random_with_outputs(shape) }, seed);
        assert_same(&graph, &through_json(&graph));
        let again = through_dot(&graph);
        assert_same(&graph, &again);
        assert_eq!(dot(&graph), dot(&again));
    }
}

#[test]
fn ten_thousand_teams_survive() {
    for chain in [false, true] {
        let graph = sample::graph(&Shape { teams: 10_000, chain, ..Shape::default() }, 1);
        assert_same(&graph, &through_json(&graph));
        assert_same(&graph, &through_dot(&graph));
    }
}

#[test]
fn everything_of_a_hand_written_graph_survives() {
    let mut document = sample::graph(&Shape::random(3), 3).to_document();
    document.sources[0].unit = "\"m\" 'm' \\ é".to_owned();
    document.sources[0].ranges[0] = [-0.0, 5e-324];
    document.actions[0].name = "left's \"3\"".to_owned();
    document.actions[0].effect = Some(Effect::new("move", [-3.0, 0.0, 127.0, -128.5]));
    document.actions[1].ask = Some("network".to_owned());
    document.scalar = tpg_graph::ScalarType::F64;
    document.provenance.seed = Some(u64::MAX);
    document.provenance.config =
        Some(serde_json::json!({"null": null, "list": [1, "two", {"three": 3.0}], "'''": "\"\"\"\n"}));
    document.provenance.scores.insert("success".to_owned(), 0.1);
    let graph = Graph::from_document("x", document).expect("valid");
    assert_same(&graph, &through_json(&graph));
    assert_same(&graph, &through_dot(&graph));
}

#[test]
fn constants_stand_where_gegelati_has_them() {
    let text = |constants| {
        let shape = Shape { constants, lines: 1..=8, ..Shape::default() };
        dot(&sample::graph(&shape, 2))
    };
    let starts = |text: &str, start: &str| -> Vec<String> {
        text.lines().map(str::trim).filter(|line| line.starts_with(start)).map(str::to_owned).collect()
    };
    let bare = |line: &String| line.ends_with("//");
    let none = text(Constants::None);
    assert!(starts(&none, "P").iter().filter(|line| line.contains("fill")).all(bare) && !none.contains("] //0"));
    let integers = text(Constants::Integers);
    assert!(!starts(&integers, "P").iter().filter(|line| line.contains("fill")).any(bare));
    assert!(starts(&integers, "I").iter().all(|line| line.ends_with("\"]")));
    // GEGELATI 2 has them in the same place, behind a label that it cannot do without.
    let reals = text(Constants::Reals);
    let programs = starts(&reals, "P");
    let mut programs = programs.iter().filter(|line| line.contains("fill"));
    assert!(programs.all(|line| line.contains(" label=\"0\"] //") && line.ends_with('|')));
    assert!(starts(&reals, "I").iter().all(|line| line.ends_with("\"]")));
}

#[test]
fn the_text_of_a_small_graph() {
    let shape = Shape { teams: 2, edges: 2..=2, lines: 1..=2, sources: vec![2, 1], actions: 2, ..Shape::default() };
    let graph = sample::graph(&shape, 5);
    insta::assert_snapshot!("small.dot", dot(&graph));
    insta::assert_snapshot!("small.toml", export::sidecar::text(&graph));
    let shape = Shape { outputs: 2, sources: vec![2], ..shape };
    let graph = sample::graph(&shape, 5);
    insta::assert_snapshot!("outputs.dot", dot(&graph));
    insta::assert_snapshot!("outputs.toml", export::sidecar::text(&graph));
}

#[test]
fn memory_is_what_the_format_cannot_say() {
    let shape = Shape { outputs: 1, memory: 2, ..Shape::default() };
    let error = export::dot::text(&sample::graph(&shape, 5)).expect_err("memory");
    assert!(error.to_string().starts_with("a policy with memory (m0, m1): "), "{error}");
}

/// The documented example of a sidecar is valid and matches the code.
#[test]
fn the_example_sidecar_is_one() {
    let sidecar = Sidecar::from_toml("sidecar.example.toml", Sidecar::EXAMPLE);
    let sidecar = sidecar.unwrap_or_else(|error| panic!("{error}"));
    assert_eq!(sidecar.document().sources[1].ranges, [[0.0, 4095.0], [512.0, 512.0]]);
    assert_eq!(sidecar.document().provenance.note.as_deref(), Some("An example."));
}
