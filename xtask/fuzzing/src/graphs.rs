//! Graphs: their files, and the code made of them.

use crate::{Bytes, accepted};
use std::sync::LazyLock;
use tpg_codegen::emit::{self, Code, Language, Options, Profile, Style};
use tpg_codegen::verify::{self, Workshop};
use tpg_graph::import::{self, Sidecar};
use tpg_graph::interpret::Answer;
use tpg_graph::sample::{self, Shape};
use tpg_graph::{Graph, interpret, states};

/// The longest state that a graph is run on.
const LONGEST: usize = 5000;

/// A `graph.json` of either version: what is accepted is interpreted, written, read again and compiled.
pub fn json(data: &[u8]) {
    let text = String::from_utf8_lossy(data);
    if let Some(graph) = accepted(import::from_text("fuzzed.json", &text, None)) {
        exercise(&graph);
    }
}

/// A sidecar, a line `%%` and a `.dot`; without that line a `.dot` as in the paper's artifact.
pub fn dot(data: &[u8]) {
    let text = String::from_utf8_lossy(data);
    let (sidecar, dot) = match text.split_once("\n%%\n") {
        Some((sidecar, dot)) => (Sidecar::from_toml("fuzzed.toml", sidecar), dot),
        None => (Ok(import::Profile::Ecta24.sidecar()), &*text),
    };
    if let Some(graph) = accepted(sidecar.and_then(|sidecar| import::from_text("fuzzed.dot", dot, Some(&sidecar)))) {
        exercise(&graph);
    }
}

/// The graph whose states were recorded.
static RECORDED: LazyLock<Graph> =
    LazyLock::new(|| sample::graph(&Shape { sources: vec![2, 1], ..Shape::default() }, 1));

/// Recorded states of a graph.
pub fn trace(data: &[u8]) {
    let graph = &*RECORDED;
    if let Some(states) = accepted(tpg_graph::trace::from_text("fuzzed.csv", &String::from_utf8_lossy(data), graph)) {
        assert_eq!(states.len() % graph.state_length(), 0);
    }
}

/// Recorded states of a graph with the answers of another tool.
pub fn recording(data: &[u8]) {
    let graph = &*RECORDED;
    if let Some(recording) =
        accepted(tpg_graph::trace::recording_from_text("fuzzed.csv", &String::from_utf8_lossy(data), graph))
    {
        assert_eq!(recording.states.len(), graph.state_length() * recording.answers.len());
        assert_eq!(recording.lines.len(), recording.answers.len());
        let actions = graph.actions().len();
        let known = |answer: &Answer| matches!(answer, Answer::Action(action) if usize::from(action.0) < actions);
        assert!(recording.answers.iter().all(known), "every answer is an action of the graph");
    }
}

fn exercise(graph: &Graph) {
    let written = graph.to_json();
    let again = Graph::from_json("written.json", &written).expect("what is written is read");
    assert!(again == *graph, "what is read is what was written");
    if graph.state_length() > LONGEST || written.len() > 200_000 {
        return;
    }
    let states = states::sample(graph, 4, 1);
    assert_eq!(interpret::answers(graph, &states).len(), 4);
    let options = || Options::new("fuzzed".parse().expect("a prefix"));
    for language in [Language::C, Language::Rust] {
        for profile in Profile::ALL {
            let options = Options { profile: Some(profile), ..options() };
            assert!(!emit::emit(graph, language, &options).is_empty());
        }
    }
    if graph.outputs().is_empty() {
        emit::emit(graph, Language::C, &Options { style: Style::Gegelati, ..options() });
    }
}

/// A random graph of a chosen shape in every profile, compiled as C and compared with the interpreter.
///
/// # Panics
/// If there is no C compiler.
pub fn compiled(data: &[u8]) {
    let mut bytes = Bytes(data);
    let (seed, states) = (bytes.u64(), bytes.u64());
    let shape = if bytes.below(3) == 0 { Shape::random_with_outputs(seed) } else { Shape::random(seed) };
    let edges = 1..=1 + bytes.below(8);
    let shape = Shape {
        teams: if shape.teams == 0 { 0 } else { 1 + bytes.below(12) },
        edges,
        lines: 0..=bytes.below(12),
        registers: 1 + bytes.below(6) as u32,
        ..shape
    };
    let graph = sample::graph(&shape, seed);
    let codes = Profile::ALL.map(|profile| {
        let prefix = profile.name().replace('-', "_").parse().expect("a prefix");
        let options = Options { profile: Some(profile), ..Options::new(prefix) };
        Code::of_graph("fuzzed.json", &graph, &options, Language::C).expect("a graph of numbers")
    });
    let workshop = Workshop::new().expect("a temporary folder");
    let batch = workshop.batch(&codes, None).expect("generated code compiles");
    for (place, profile) in Profile::ALL.into_iter().enumerate() {
        let mut process = batch.start(place, &graph).expect("the program starts");
        let comparisons = verify::compare(&graph, &mut [&mut process], 500, states).expect("it runs");
        assert_eq!(comparisons[0].differences, 0, "{}: {:?}\n{}", profile.name(), comparisons[0], graph.to_json());
    }
}
