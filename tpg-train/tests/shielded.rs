//! A graph trained under a shield is an ordinary graph: its compiled code decides like the interpreter.

use std::fs;
use std::path::Path;
use std::process::Command;
use tpg_arm::observation::Source;
use tpg_codegen::emit::{Language, Options, Prefix, Profile};
use tpg_codegen::verify::{self, Workshop};
use tpg_graph::Graph;
use tpg_graph::engine::Engine;
use tpg_problems::Problem;
use tpg_train::{Config as EvolutionConfig, Configuration as _};

/// Three generations of a few roots on the arm.
fn config() -> EvolutionConfig {
    let mut config = EvolutionConfig::preset("best-rs").expect("a preset");
    let shielded = "[problem]\nname = \"rs\"\nshield = \"limits-and-collision\"\n";
    config.problem = Problem::from_toml("shielded", shielded).expect("a problem").to_table();
    (config.tpg.nb_roots, config.tpg.init_nb_roots) = (24, 40);
    (config.learning.nb_iterations_per_policy_evaluation, config.learning.nb_generations) = (6, 3);
    config.learning.ratio_deleted_roots = 0.7;
    (config.selection.lexicase_survivors, config.selection.racing_episodes) = (3, 0);
    config.selection.validation_episodes = 20;
    (config.pool.share, config.curriculum.generations) = (0.0, 0);
    config
}

fn train(config: &Path, folder: &Path, threads: &str) -> String {
    let mut command = Command::new(env!("CARGO_BIN_EXE_tpg-train"));
    let command = command.args(["tpg", "--threads", threads, "--config"]).arg(config).arg("--out").arg(folder);
    let output = command.output().expect("the program starts");
    assert!(output.status.success(), "{}", String::from_utf8_lossy(&output.stderr));
    fs::read_to_string(folder.join("graph.json")).expect("training leaves a graph")
}

#[test]
fn a_graph_trained_under_a_shield_compiles_to_the_same_decisions() {
    let folder = tempfile::tempdir().expect("a temporary folder");
    let path = folder.path().join("config.toml");
    fs::write(&path, config().to_toml()).expect("it can be written");
    let text = train(&path, &folder.path().join("one"), "1");
    assert!(text == train(&path, &folder.path().join("two"), "2"), "another number of threads, another graph");

    let graph = Graph::from_json("graph.json", &text).expect("a good one");
    let shield = Source::ShieldCollision.name();
    assert!(graph.sources().iter().any(|source| source.name == shield), "no {shield} in its sources");
    if !tpg_testing::tool("cc", "gcc", "a shielded graph, compiled") {
        return;
    }
    let workshop = Workshop::new().expect("a temporary folder");
    for profile in [Profile::Fast, Profile::Small, Profile::ConstantTime] {
        for language in [Language::C, Language::Rust] {
            let prefix: Prefix = "shielded".parse().expect("a name");
            let options = Options { profile: Some(profile), ..Options::new(prefix) };
            let mut program = workshop.run(language, &graph, &options).expect("generated code compiles");
            let compared = verify::compare(&graph, &mut [&mut program as &mut dyn Engine], 20_000, 1);
            for comparison in compared.expect("the program answers") {
                assert_eq!(comparison.differences, 0, "{}: {:?}", comparison.engine, comparison.first);
            }
        }
    }
}
