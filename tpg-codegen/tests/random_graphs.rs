//! Random graphs, compiled in every profile and language: the interpreter's action for every state, in range and out of it.
//!
//! The graphs hold ties, shared and empty programs, constants of every kind; the states hold NaN, infinities, denormals.
//! `TPG_RANDOM_GRAPHS` says how many graphs (in Rust, a quarter of them: its compiler takes longer).

use tpg_codegen::emit::{Language, Options, Profile};
use tpg_codegen::graph::Graph;
use tpg_codegen::passes;
use tpg_codegen::passes::interval::Assumption;
use tpg_codegen::sample::{self, Shape};
use tpg_codegen::verify::{self, Workshop};

/// Graphs in one program.
const BATCH: usize = 60;
/// States for each graph.
const STATES: usize = 2000;

fn count() -> usize {
    std::env::var("TPG_RANDOM_GRAPHS").map_or(120, |text| text.parse().expect("TPG_RANDOM_GRAPHS is a number"))
}

fn assert_equal(language: Language, seeds: std::ops::Range<u64>) {
    let seeds: Vec<u64> = seeds.collect();
    for seeds in seeds.chunks(BATCH) {
        let graphs: Vec<Graph> = seeds.iter().map(|&seed| sample::graph(&Shape::random(seed), seed)).collect();
        let policies: Vec<(&Graph, Options)> = (graphs.iter().zip(0..))
            .flat_map(|(graph, number)| Profile::ALL.map(|profile| (graph, number, profile)))
            .map(|(graph, number, profile): (&Graph, usize, Profile)| {
                let prefix = format!("p{number}_{}", profile.name().replace('-', "_"));
                let options = Options::new(prefix.parse().expect("a prefix"));
                (graph, Options { profile: Some(profile), ..options })
            })
            .collect();
        let workshop = Workshop::new().expect("a temporary folder");
        let batch = workshop.batch(language, &policies).expect("generated code compiles");
        for (place, (graph, options)) in policies.iter().enumerate() {
            let mut process = batch.start(place, graph).expect("the program starts");
            let seed = seeds[place / Profile::ALL.len()];
            let comparisons = verify::compare(graph, &mut [&mut process], STATES, seed).expect("it runs");
            let [comparison] = &comparisons[..] else { panic!("one engine, one comparison") };
            assert_eq!(comparison.states, STATES);
            assert_eq!(comparison.differences, 0, "graph {seed}, {}: {comparison:?}", options.prefix);
        }
    }
}

#[test]
fn c_in_every_profile_acts_like_the_interpreter() {
    assert_equal(Language::C, 0..count() as u64);
}

#[test]
fn rust_in_every_profile_acts_like_the_interpreter() {
    assert_equal(Language::Rust, 1_000_000..1_000_000 + count() as u64 / 4);
}

#[test]
fn the_passes_find_something_in_them() {
    let mut total = passes::Removed::default();
    for seed in 0..200 {
        let graph = sample::graph(&Shape::random(seed), seed);
        let (_, removed) = passes::optimise(&graph, Assumption::Nothing);
        total.operations += removed.operations;
        total.duplicate_bids += removed.duplicate_bids;
        total.hopeless_bids += removed.hopeless_bids;
        total.teams_without_choice += removed.teams_without_choice;
        total.unreachable_teams += removed.unreachable_teams;
    }
    let passes::Removed { operations, duplicate_bids, hopeless_bids, teams_without_choice, unreachable_teams, .. } =
        total;
    let found = [operations, duplicate_bids, hopeless_bids, teams_without_choice, unreachable_teams];
    assert!(found.iter().all(|&count| count > 0), "every pass has work in random graphs: {total:?}");
}
