//! Policies with memory: their code, and what they answer over whole episodes.

use tpg_codegen::emit::{self, Language, Options, Profile};
use tpg_codegen::explain::explain;
use tpg_codegen::verify::Workshop;
use tpg_graph::engine::Engine;
use tpg_graph::interpret::{self, Answer};
use tpg_graph::sample::{self, Shape};
use tpg_graph::{Graph, states};

/// A controller of a pendulum that sees no velocity: it remembers the last angle.
const DIFFERENCE: &str = include_str!("fixtures/memory.json");

fn options(profile: Profile) -> Options {
    Options { profile: Some(profile), ..Options::new("hold".parse().expect("a prefix")) }
}

#[test]
fn the_code_takes_the_memory_from_its_caller() {
    let graph = Graph::from_json("memory.json", DIFFERENCE).expect("a graph");
    let text = |language, profile| -> String {
        let files = emit::emit(&graph, language, &options(profile));
        files.into_iter().map(|file| format!("{}\n{}\n", file.name, file.text)).collect()
    };
    insta::assert_snapshot!("memory.c", text(Language::C, Profile::Fast));
    insta::assert_snapshot!("memory.rs", text(Language::Rust, Profile::ConstantTime));
    insta::assert_snapshot!("memory.txt", explain(&graph, &options(Profile::Fast)));
}

/// Answers `steps` random observations one after another, each with the memory that the one before left behind.
fn episode(graph: &Graph, observations: &[f64], mut answer: impl FnMut(&[f64]) -> Answer) -> Vec<Answer> {
    let seen = graph.state_length() - graph.memory();
    let values = graph.outputs().len() - graph.memory();
    let mut memory: Vec<f64> = graph.outputs()[values..].iter().map(|value| value.nan).collect();
    (observations.chunks_exact(graph.state_length()))
        .map(|observation| {
            let answer = answer(&[&observation[..seen], &memory].concat());
            let Answer::Values(found) = &answer else { panic!("{answer}") };
            memory.copy_from_slice(&found[values..]);
            answer
        })
        .collect()
}

#[test]
fn whole_episodes_are_the_interpreters() {
    let steps = 200;
    let workshop = Workshop::new().expect("a workshop");
    let mut with_memory = 0;
    for seed in 0..tpg_testing::amount(6, 40) {
        let shape = Shape { memory: 1 + (seed % 4) as u32, ..Shape::random_with_outputs(seed) };
        let graph = sample::graph(&shape, seed);
        let observations = states::sample(&graph, steps, seed);
        let expected = episode(&graph, &observations, |state| interpret::answers(&graph, state).remove(0));
        let profile = Profile::ALL[seed as usize % Profile::ALL.len()];
        let (c, rust) = (workshop.c(&graph, &options(profile)), workshop.rust(&graph, &options(profile)));
        for mut process in [c.expect("C"), rust.expect("Rust")] {
            let found = episode(&graph, &observations, |state| {
                let mut answers = Vec::new();
                process.answer(state, &mut answers).expect("an answer");
                answers.remove(0)
            });
            for (step, (found, expected)) in found.iter().zip(&expected).enumerate() {
                assert!(found.same_bits(expected), "graph {seed}, step {step}: {found} instead of {expected}");
            }
        }
        with_memory += expected.windows(2).filter(|pair| pair[0] != pair[1]).count();
    }
    assert!(with_memory > 100, "answers change along the episodes");
}
