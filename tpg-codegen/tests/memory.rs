//! Policies with memory: their code. `random_graphs` runs them over whole episodes.

use tpg_codegen::emit::{self, Language, Options, Profile};
use tpg_codegen::report::explain;
use tpg_graph::Graph;

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
