//! Checks that the committed code is what the generator produces today and that it acts like the graph.

use std::fs;
use std::path::{Path, PathBuf};
use tpg_codegen::emit::{self, Language, Options, Prefix, Profile};
use tpg_generated::widowx_fs::WidowxFs;
use tpg_generated::widowx_fs_fast::WidowxFsFast;
use tpg_generated::widowx_rs::WidowxRs;
use tpg_generated::widowx_rs_fast::WidowxRsFast;
use tpg_graph::Graph;
use tpg_graph::{interpret, states};
use tpg_runtime::policy::{ActionId, Policy};

fn folder(name: &str) -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join(name)
}

/// Returns the folders with a `graph.json` next to this crate's manifest.
fn policies() -> Vec<PathBuf> {
    let mut folders: Vec<PathBuf> = fs::read_dir(folder("."))
        .expect("the crate's folder")
        .map(|entry| entry.expect("an entry").path())
        .filter(|path| path.join("graph.json").is_file())
        .collect();
    folders.sort();
    assert!(!folders.is_empty());
    folders
}

fn graph(folder: &Path) -> Graph {
    let path = folder.join("graph.json");
    let text = fs::read_to_string(&path).expect("readable");
    Graph::from_json(&path.display().to_string(), &text).unwrap_or_else(|error| panic!("{error}"))
}

#[test]
fn graphs_are_in_canonical_form() {
    for folder in policies() {
        let text = fs::read_to_string(folder.join("graph.json")).expect("readable");
        assert!(
            graph(&folder).to_json() == text,
            "{}: `tpg-codegen convert` it",
            folder.display()
        );
    }
}

#[test]
fn generated_code_is_fresh() {
    for folder in policies() {
        let prefix = Prefix::of_file(&folder.join("graph.json"));
        let fast: Prefix = format!("{}_fast", prefix.lower()).parse().expect("a name");
        let fast = Options {
            profile: Some(Profile::Fast),
            ..Options::new(fast)
        };
        let options = Options::new(prefix);
        for (language, options) in [
            (Language::C, &options),
            (Language::Rust, &options),
            (Language::Rust, &fast),
        ] {
            for file in emit::emit(&graph(&folder), language, options) {
                let path = folder.join(&file.name);
                let found = fs::read_to_string(&path).unwrap_or_default();
                assert!(
                    found == file.text,
                    "{}: regenerate as PROVENANCE.md says",
                    path.display()
                );
            }
        }
    }
}

/// Compares the Rust code of this crate, built by cargo like any other, with the interpreter.
fn acts_like<P, const N: usize>(policy: P, graph: &Graph)
where
    P: Policy<State = [f32; N], Action = ActionId>,
{
    let states = states::sample(graph, 20_000, 7);
    let expected = interpret::actions(graph, &states);
    for (state, expected) in states.chunks_exact(N).zip(expected) {
        let state: [f32; N] = std::array::from_fn(|index| state[index] as f32);
        assert_eq!(policy.decide(&state), expected, "{state:?}");
    }
}

#[test]
fn compiled_policies_act_like_their_graphs() {
    acts_like(WidowxFs, &graph(&folder("widowx-fs")));
    acts_like(WidowxFsFast, &graph(&folder("widowx-fs")));
    acts_like(WidowxRs, &graph(&folder("widowx-rs")));
    acts_like(WidowxRsFast, &graph(&folder("widowx-rs")));
}
