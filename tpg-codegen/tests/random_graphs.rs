//! Random graphs, compiled in every profile and language: the interpreter's action for every state, in range and out of it.
//!
//! The graphs hold ties, shared and empty programs, constants of every kind; the states hold NaN, infinities, denormals.
//! `TPG_RANDOM_GRAPHS` says how many graphs, and there are ten times as many small ones, where a difference has fewer places
//! to hide (in Rust, a quarter of both: its compiler takes longer), and some of more teams than a function has. As many again
//! have outputs: formulas, leaves under teams, one to three values, each equal to the bit. Those with memory live through an
//! episode, too.
//!
//! The long form, of graphs with leaves and memory alone: `TPG_RANDOM_GRAPHS=1000 TPG_RANDOM_STATES=10000 cargo test --release -p
//! tpg-codegen --test all interpreters_episodes -- --nocapture`, 1,000 graphs in C and 250 in Rust.

use crate::common::codes;
use tpg_codegen::emit::{Language, Options, Profile};
use tpg_codegen::verify::{self, Workshop};
use tpg_graph::Graph;
use tpg_graph::engine::Engine;
use tpg_graph::interpret::{self, Answer};
use tpg_graph::sample::{self, Shape};
use tpg_graph::states;

/// A kind of graphs.
#[derive(Clone, Copy)]
struct Kind {
    shape: fn(u64) -> Shape,
    /// Graphs in one program.
    batch: usize,
    /// States for each graph.
    states: usize,
}

const LARGE: Kind = Kind { shape: Shape::random, batch: 60, states: 2000 };
const SMALL: Kind = Kind { shape: small, batch: 200, states: 600 };

const MANY: Kind = Kind { shape: many, batch: 4, states: 600 };

/// More teams than a function has.
fn many(seed: u64) -> Shape {
    Shape { teams: 65 + seed as usize % 50, edges: 1..=4, ..Shape::random(seed) }
}

/// A few teams with a few bids each.
fn small(seed: u64) -> Shape {
    let shape = Shape::random(seed);
    let edges = 1..=(*shape.edges.end()).min(5);
    Shape { teams: shape.teams.div_ceil(8), edges, ..shape }
}

const WITH_OUTPUTS: Kind = Kind { shape: Shape::random_with_outputs, batch: 60, states: 2000 };
const SMALL_WITH_OUTPUTS: Kind = Kind { shape: small_with_outputs, batch: 200, states: 600 };
const MANY_WITH_OUTPUTS: Kind = Kind { shape: many_with_outputs, batch: 4, states: 600 };

/// Few teams, and often none.
fn small_with_outputs(seed: u64) -> Shape {
    let Shape { teams, outputs, .. } = Shape::random_with_outputs(seed);
    Shape { teams: teams.div_ceil(8), outputs, ..small(seed) }
}

fn many_with_outputs(seed: u64) -> Shape {
    Shape { outputs: 1 + (seed % 3) as u32, ..many(seed) }
}

fn count() -> usize {
    let usual = tpg_testing::amount(2, 12);
    std::env::var("TPG_RANDOM_GRAPHS").map_or(usual, |text| text.parse().expect("TPG_RANDOM_GRAPHS is a number"))
}

/// Every profile.
const FORMS: usize = Profile::ALL.len();

fn forms(number: usize) -> [Options; FORMS] {
    Profile::ALL.map(|profile| {
        let prefix = format!("p{number}_{}", profile.name().replace('-', "_"));
        Options { profile: Some(profile), ..Options::new(prefix.parse().expect("a prefix")) }
    })
}

fn assert_equal(language: Language, kind: Kind, seeds: std::ops::Range<u64>) {
    let seeds: Vec<u64> = seeds.collect();
    for seeds in seeds.chunks(kind.batch) {
        let graphs: Vec<Graph> = seeds.iter().map(|&seed| sample::graph(&(kind.shape)(seed), seed)).collect();
        let policies: Vec<(&Graph, Options)> = (graphs.iter().enumerate())
            .flat_map(|(number, graph)| forms(number).map(|options| (graph, options)))
            .collect();
        let workshop = Workshop::new().expect("a temporary folder");
        let batch = workshop.batch(&codes(language, &policies), None).expect("generated code compiles");
        for (place, (graph, options)) in policies.iter().enumerate() {
            let mut process = batch.start(place, graph).expect("the program starts");
            let seed = seeds[place / FORMS];
            let comparisons = verify::compare(graph, &mut [&mut process], kind.states, seed).expect("it runs");
            let [comparison] = &comparisons[..] else { panic!("one engine, one comparison") };
            assert_eq!(comparison.states, kind.states);
            assert_eq!(comparison.differences, 0, "graph {seed}, {}: {comparison:?}", options.prefix);
        }
    }
}

#[test]
fn c_in_every_profile_acts_like_the_interpreter() {
    assert_equal(Language::C, LARGE, 0..count() as u64);
    assert_equal(Language::C, SMALL, 2_000_000..2_000_000 + count() as u64 * 10);
    assert_equal(Language::C, MANY, 4_000_000..4_000_000 + count() as u64 / 5);
}

#[test]
fn rust_in_every_profile_acts_like_the_interpreter() {
    assert_equal(Language::Rust, LARGE, 1_000_000..1_000_000 + count() as u64 / 4);
    assert_equal(Language::Rust, SMALL, 3_000_000..3_000_000 + count() as u64 * 10 / 4);
    assert_equal(Language::Rust, MANY, 5_000_000..5_000_000 + count() as u64 / 15);
}

#[test]
fn c_answers_with_the_interpreters_values_to_the_bit() {
    assert_equal(Language::C, WITH_OUTPUTS, 6_000_000..6_000_000 + count() as u64);
    assert_equal(Language::C, SMALL_WITH_OUTPUTS, 7_000_000..7_000_000 + count() as u64 * 10);
    assert_equal(Language::C, MANY_WITH_OUTPUTS, 8_000_000..8_000_000 + count().div_ceil(5) as u64);
}

#[test]
fn rust_answers_with_the_interpreters_values_to_the_bit() {
    assert_equal(Language::Rust, WITH_OUTPUTS, 9_000_000..9_000_000 + count().div_ceil(4) as u64);
    assert_equal(Language::Rust, SMALL_WITH_OUTPUTS, 10_000_000..10_000_000 + count() as u64 * 10 / 4);
    assert_equal(Language::Rust, MANY_WITH_OUTPUTS, 11_000_000..11_000_000 + count().div_ceil(15) as u64);
}

/// Steps of an episode.
const STEPS: usize = 200;

/// States for each graph with leaves.
fn states_each() -> usize {
    std::env::var("TPG_RANDOM_STATES").map_or(500, |text| text.parse().expect("TPG_RANDOM_STATES is a number"))
}

/// The answers along observations, where each decision's last values are the next one's memory.
fn episode(graph: &Graph, observations: &[f64], mut answer: impl FnMut(&[f64]) -> Answer) -> Vec<Answer> {
    let (length, memory) = (graph.state_length(), graph.memory());
    let mut remembered: Vec<f64> = graph.outputs()[graph.outputs().len() - memory..].iter().map(|it| it.nan).collect();
    (observations.chunks_exact(length))
        .map(|observation| {
            let answer = answer(&[&observation[..length - memory], &remembered].concat());
            let Answer::Values(values) = &answer else { panic!("a policy with outputs answers with values") };
            remembered.copy_from_slice(&values[values.len() - memory..]);
            answer
        })
        .collect()
}

/// Compares every profile with the interpreter: on single states, and where a graph has memory along an episode.
fn assert_same_episodes(language: Language, seeds: std::ops::Range<u64>) {
    let (mut compared, mut steps, mut changes) = (0, 0, 0);
    let seeds: Vec<u64> = seeds.collect();
    for seeds in seeds.chunks(40) {
        let graphs: Vec<Graph> =
            seeds.iter().map(|&seed| sample::graph(&Shape::random_with_outputs(seed), seed)).collect();
        let form = |number: usize, profile: Profile| {
            let name = format!("p{number}_{}", profile.name().replace('-', "_"));
            Options { profile: Some(profile), ..Options::new(name.parse().expect("a prefix")) }
        };
        let policies: Vec<(&Graph, Options)> = (graphs.iter().enumerate())
            .flat_map(|(number, graph)| Profile::ALL.map(|profile| (graph, form(number, profile))))
            .collect();
        let workshop = Workshop::new().expect("a temporary folder");
        let batch = workshop.batch(&codes(language, &policies), None).expect("generated code compiles");
        for (place, (graph, options)) in policies.iter().enumerate() {
            let seed = seeds[place / Profile::ALL.len()];
            let mut process = batch.start(place, graph).expect("the program starts");
            let comparisons = verify::compare(graph, &mut [&mut process], states_each(), seed)
                .unwrap_or_else(|error| panic!("graph {seed}, {}: {error}", options.prefix));
            assert_eq!(comparisons[0].differences, 0, "graph {seed}, {}: {comparisons:?}", options.prefix);
            compared += comparisons[0].states;
            if graph.memory() == 0 {
                continue;
            }
            let observations = states::sample(graph, STEPS, seed);
            let expected = episode(graph, &observations, |state| interpret::answers(graph, state).remove(0));
            let found = episode(graph, &observations, |state| {
                let mut answers = Vec::new();
                process.answer(state, &mut answers).expect("an answer");
                answers.remove(0)
            });
            for (step, (found, expected)) in found.iter().zip(&expected).enumerate() {
                assert!(found.same_bits(expected), "graph {seed}, {}, step {step}: {found}", options.prefix);
            }
            steps += expected.len();
            changes += expected.windows(2).filter(|pair| pair[0] != pair[1]).count();
        }
    }
    let graphs = seeds.len();
    println!("{}: {graphs} graphs, {compared} states and {steps} steps of episodes in every profile", language.name());
    assert!(changes > steps / 4, "answers change along the episodes");
}

#[test]
fn c_lives_through_the_interpreters_episodes() {
    assert_same_episodes(Language::C, 12_000_000..12_000_000 + count().max(4) as u64);
}

#[test]
fn rust_lives_through_the_interpreters_episodes() {
    assert_same_episodes(Language::Rust, 13_000_000..13_000_000 + count().div_ceil(4) as u64);
}
