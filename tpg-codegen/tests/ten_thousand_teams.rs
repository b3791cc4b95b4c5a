//! A graph of 10,000 teams, each leading to the next, passes through everything: nothing recurses along its walk, and the
//! text is one that a C compiler takes.

use crate::common::{SHAPES, emit_into, run, shaped};
use std::process::Command;
use tempfile::TempDir;
use tpg_codegen::emit::{Language, Profile};
use tpg_graph::Word;
use tpg_graph::sample::{self, Constants, Shape};
use tpg_graph::{Document, Graph, ScalarType};
use tpg_graph::{interpret, states};

fn teams() -> usize {
    tpg_testing::amount(1_000, 10_000)
}

#[test]
fn from_text_to_object_file() {
    // Without constants and divisions no bid is known beforehand: passes find little to leave out.
    let shape = Shape {
        teams: teams(),
        edges: 2..=4,
        lines: 6..=12,
        registers: 3,
        scalar: ScalarType::F32,
        instructions: ["add", "sub", "mul", "negate_if_less", "cos"]
            .iter()
            .copied()
            .filter_map(Word::from_name)
            .collect(),
        constants: Constants::None,
        chain: true,
        ..Shape::default()
    };
    let text = sample::graph(&shape, 1).to_json();
    let document: Document = serde_json::from_str(&text).expect("a document");
    let graph = Graph::from_document("large", document).expect("a valid graph");
    assert_eq!(graph.teams().len(), teams());
    let states = states::sample(&graph, 20, 1);
    assert_eq!(interpret::actions(&graph, &states).len(), 20);

    for shape in SHAPES {
        let folder = TempDir::new().expect("a temporary folder");
        let options = shaped("large", shape);
        let files = emit_into(folder.path(), &graph, Language::C, &options);
        let banner = files[0]
            .text
            .lines()
            .find_map(|line| line.strip_prefix(" * ")?.split_once(" teams ("))
            .expect("a banner")
            .0;
        let count: usize = banner.parse().expect("a number");
        assert!(count > teams() * 9 / 10, "{shape:?}: {count}");
        emit_into(folder.path(), &graph, Language::Rust, &options);
        // The constant-time code computes everything: what it is for is small.
        if shape.1 != Some(Profile::ConstantTime) {
            // Without optimising: what is asked is whether the compiler gets through.
            let mut command = Command::new("cc");
            command.current_dir(folder.path()).args(["-std=c99", "-O0", "-ffp-contract=off", "-c", "large.c"]);
            run(&mut command).unwrap_or_else(|message| panic!("{message}"));
        }
    }
}
