//! A graph of 10,000 teams, each leading to the next, passes through everything: nothing recurses along its walk, and the
//! text is one that a C compiler takes.

mod common;

use common::{emit_into, options, run};
use std::process::Command;
use tempfile::TempDir;
use tpg_codegen::emit::{self, Language, Style};
use tpg_codegen::graph::{Document, Graph, ScalarType};
use tpg_codegen::ir::Module;
use tpg_codegen::sample::{self, Shape};
use tpg_codegen::{interpret, states};

const TEAMS: usize = 10_000;

#[test]
fn from_text_to_object_file() {
    let shape =
        Shape { teams: TEAMS, edges: 2..=4, lines: 0..=10, scalar: ScalarType::F32, chain: true, ..Shape::default() };
    let text = sample::graph(&shape, 1).to_json();
    let document: Document = serde_json::from_str(&text).expect("a document");
    let graph = Graph::from_document("large", document).expect("a valid graph");
    assert_eq!(graph.teams().len(), TEAMS);
    let states = states::sample(&graph, 20, 1);
    assert_eq!(interpret::actions(&graph, &states).len(), 20);

    let folder = TempDir::new().expect("a temporary folder");
    // The style that keeps every team: passes would leave few of a random graph.
    let options = options("large", Style::Gegelati);
    assert_eq!(Module::lower(&graph).depth, TEAMS, "the longest walk is all teams");
    assert!(!emit::emit(&graph, Language::Rust, &options).is_empty());
    emit_into(folder.path(), &graph, Language::C, &options);
    let mut command = Command::new("cc");
    // Optimising takes half as long again; what is asked here is whether the compiler gets through.
    command.current_dir(folder.path()).args(["-std=c99", "-O0", "-ffp-contract=off", "-c", "large.c"]);
    run(&mut command).unwrap_or_else(|message| panic!("{message}"));
}
