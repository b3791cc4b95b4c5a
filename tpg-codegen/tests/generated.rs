//! The text of generated code: what it looks like, that rustfmt leaves it, that it depends on nothing else.

use crate::common::{COMBINATIONS, emit_into, fixture, options, run, shaped};
use std::process::Command;
use tempfile::TempDir;
use tpg_codegen::emit::{self, Language, Profile, Style};
use tpg_codegen::report::explain;
use tpg_graph::sample::{self, Shape};
use tpg_graph::{Document, Graph, MathsProvider, ScalarType};

fn text(graph: &Graph, language: Language, style: Style, file: &str) -> String {
    let files = emit::emit(graph, language, &options("arm", style));
    files.into_iter().find(|emitted| emitted.name == file).expect("the file is emitted").text
}

#[test]
fn the_c_of_every_instruction() {
    let graph = fixture(ScalarType::F32, MathsProvider::System);
    insta::assert_snapshot!("arm.h", text(&graph, Language::C, Style::Pure, "arm.h"));
    insta::assert_snapshot!("arm.c", text(&graph, Language::C, Style::Pure, "arm.c"));
}

#[test]
fn the_gegelati_header_of_every_instruction() {
    let graph = fixture(ScalarType::F64, MathsProvider::System);
    insta::assert_snapshot!("arm.gegelati.h", text(&graph, Language::C, Style::Gegelati, "arm.h"));
}

#[test]
fn the_rust_of_every_instruction() {
    let graph = fixture(ScalarType::F32, MathsProvider::Own);
    insta::assert_snapshot!("arm.rs", text(&graph, Language::Rust, Style::Pure, "arm.rs"));
}

#[test]
fn an_action_that_asks_is_named_where_code_is_read() {
    let mut document = sample::graph(&Shape::default(), 7).to_document();
    (document.actions[1].name, document.actions[1].ask) = ("help".to_owned(), Some("network".to_owned()));
    let graph = Graph::from_document("asking", document.clone()).expect("a valid graph");
    let header = text(&graph, Language::C, Style::Pure, "arm.h");
    assert!(header.contains("\n    ARM_HELP = 1, /* help (asks network) */\n"), "{header}");
    assert!(header.contains("\n#define ARM_ASKS_NETWORK ARM_HELP\n"), "{header}");
    let rust = text(&graph, Language::Rust, Style::Pure, "arm.rs");
    assert!(rust.contains("/// - 1: help (asks network)\n"), "{rust}");
    assert!(rust.contains("    pub const ASKS_NETWORK: ActionId = ActionId(1);\n"), "{rust}");
    assert!(explain(&graph, &options("arm", Style::Pure)).contains("-> help (asks network)"));
    // Nothing else of the code knows of it.
    document.actions[1].ask = None;
    let alone = Graph::from_document("alone", document).expect("a valid graph");
    let body =
        |graph: &Graph| text(graph, Language::C, Style::Pure, "arm.c").split_once("*/").expect("a banner").1.to_owned();
    assert_eq!(body(&graph), body(&alone));
}

/// The fixture with this many actions and, in front of its root, this many more teams, each leading to the next.
fn stretched(teams: u32, actions: u32) -> Graph {
    let mut document: Document = fixture(ScalarType::F64, MathsProvider::Own).to_document();
    let action = document.actions[0].clone();
    let first = document.actions.len() as u32;
    document.actions.extend((first..actions).map(|id| {
        let mut action = action.clone();
        (action.id, action.name) = (id, format!("action {id} "));
        action
    }));
    let root = document.root.expect("a root");
    for new in 0..teams {
        let mut team = document.teams[0].clone();
        team.id = 1000 + new;
        let mut program = document.programs[0].clone();
        program.id = team.id;
        document.programs.push(program);
        team.edges[0].program = team.id;
        team.edges[0].action = None;
        team.edges[0].team = Some(if new == 0 { root } else { team.id - 1 });
        document.root = Some(team.id);
        document.teams.push(team);
    }
    Graph::from_document("stretched", document).expect("a valid graph")
}

#[test]
fn rustfmt_changes_nothing() {
    if !tpg_testing::tool("rustfmt", "rustup component add rustfmt", "the layout of generated Rust") {
        return;
    }
    let folder = TempDir::new().expect("a temporary folder");
    let mut files = Vec::new();
    let mut add = |graph: &Graph, prefix: &str| {
        for (profile, short) in Profile::ALL.into_iter().zip(["f", "b", "s", "c"]) {
            let options = shaped(&format!("{prefix}_{short}"), (Style::Pure, Some(profile)));
            let emitted = emit_into(folder.path(), graph, Language::Rust, &options);
            files.extend(emitted.into_iter().map(|file| file.name));
        }
    };
    for (scalar, maths) in COMBINATIONS {
        add(&fixture(scalar, maths), &format!("arm_{}_{}", scalar.name(), maths.name()));
    }
    for seed in 1..=30 {
        add(&sample::graph(&Shape::random(seed), seed), &format!("random{seed}"));
        add(&sample::graph(&Shape::random_with_outputs(seed), seed), &format!("outputs{seed}"));
    }
    // One to eleven outputs, so that a line holds some and not others; eleven values of memory are more than a line.
    for outputs in 1..12 {
        let shape = Shape { teams: 2, outputs, memory: 12 - outputs, ..Shape::random(u64::from(outputs)) };
        add(&sample::graph(&shape, u64::from(outputs)), &format!("values{outputs}"));
    }
    add(&Graph::from_json("eye.json", include_str!("fixtures/eye.json")).expect("a graph"), "eye");
    // Around the lengths where arrays get a line more.
    for teams in (0..60).chain([97, 98, 99, 500]) {
        add(&stretched(teams, 4 + teams % 7), &format!("stretched{teams}"));
    }
    // No configuration lies above a temporary folder: rustfmt's own defaults hold.
    let mut command = Command::new("rustfmt");
    command.current_dir(folder.path()).args(["--edition=2024", "--check"]).args(files);
    run(&mut command).unwrap_or_else(|message| panic!("{message}"));
}

#[test]
fn the_same_graph_and_options_give_the_same_bytes() {
    for (scalar, maths) in COMBINATIONS {
        let graph = fixture(scalar, maths);
        // Read again from its own text: another allocation, another hash seed, another order of building.
        let document = serde_json::from_str(&graph.to_json()).expect("its own text");
        let again = Graph::from_document("again", document).expect("its own text");
        for language in [Language::C, Language::Rust] {
            for profile in Profile::ALL {
                let options = shaped("arm", (Style::Pure, Some(profile)));
                assert_eq!(emit::emit(&graph, language, &options), emit::emit(&again, language, &options));
            }
        }
    }
}
