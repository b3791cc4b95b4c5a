//! Generated C by tcc, which takes C99 to the letter and optimises nothing. `cargo xtask compilers` compares many compilers
//! at every level.

use std::process::Command;
use tpg_codegen::emit::{self, Language, Options, Profile};
use tpg_codegen::verify::{self, Workshop};
use tpg_graph::Graph;
use tpg_graph::sample::{self, Shape};

const STATES: usize = 600;

fn options(number: usize, profile: Profile) -> Options {
    let name = profile.name().replace('-', "_");
    let prefix = format!("p{number}_{name}").parse().expect("a prefix");
    Options { profile: Some(profile), ..Options::new(prefix) }
}

/// The first graphs, up to one of each scalar with minus infinity among the constants of its tables.
fn graphs() -> Vec<Graph> {
    let mut wanted = vec!["= -INFINITY;", "= -(double)INFINITY;"];
    let mut graphs = Vec::new();
    for seed in 0..500 {
        let graph = sample::graph(&Shape::random(seed), seed);
        let text: String =
            emit::emit(&graph, Language::C, &options(0, Profile::Small)).into_iter().map(|file| file.text).collect();
        let before = wanted.len();
        wanted.retain(|constant| !text.contains(&format!("] {constant}")));
        if graphs.len() < 10 || wanted.len() < before {
            graphs.push(graph);
        }
        if wanted.is_empty() {
            return graphs;
        }
    }
    panic!("no graph has a constant minus infinity");
}

#[test]
fn tcc_compiles_every_profile_and_it_acts_like_the_interpreter() {
    let graphs = graphs();
    if !tpg_testing::tool("tcc", "tcc", "generated C by tcc") {
        return;
    }
    let policies: Vec<(&Graph, Options)> = (graphs.iter().enumerate())
        .flat_map(|(number, graph)| Profile::ALL.map(|profile| (graph, options(number, profile))))
        .collect();
    let workshop = Workshop::new().expect("a temporary folder");
    let tcc = |folder: &std::path::Path| {
        let mut command = Command::new("tcc");
        command.current_dir(folder).arg("-std=c99");
        command
    };
    let batch = workshop.batch_by(Language::C, &policies, Some(&tcc)).expect("tcc takes generated C");
    for (place, (graph, options)) in policies.iter().enumerate() {
        let mut process = batch.start(place, graph).expect("the program starts");
        let comparisons = verify::compare(graph, &mut [&mut process], STATES, 1).expect("it runs");
        assert_eq!(comparisons[0].differences, 0, "{}: {:?}", options.prefix, comparisons[0]);
    }
}
