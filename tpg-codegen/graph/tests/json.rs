//! Graphs survive `graph.json` unchanged.

use proptest::prelude::*;
use tpg_graph::import::Sidecar;
use tpg_graph::sample::{self, Shape};
use tpg_graph::{Effect, Graph};

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
    }

    #[test]
    fn random_graphs_with_outputs_survive(shape: u64, seed: u64) {
        let graph = sample::graph(&Shape::random_with_outputs(shape), seed);
        assert_same(&graph, &through_json(&graph));
    }
}

#[test]
fn ten_thousand_teams_survive() {
    for chain in [false, true] {
        let graph = sample::graph(&Shape { teams: 10_000, chain, ..Shape::default() }, 1);
        assert_same(&graph, &through_json(&graph));
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
}

/// The documented example of a sidecar is valid and matches the code.
#[test]
fn the_example_sidecar_is_one() {
    let sidecar = Sidecar::from_toml("sidecar.example.toml", Sidecar::EXAMPLE);
    let sidecar = sidecar.unwrap_or_else(|error| panic!("{error}"));
    assert_eq!(sidecar.document().sources[1].ranges, [[0.0, 4095.0], [512.0, 512.0]]);
}
