//! A state is read as it was written, on the environment and with the configuration that it belongs to.

use super::{FORM, from_bytes, to_bytes};
use crate::evolution::config::EvolutionConfig;
use crate::evolution::run::{Progress, RunOptions, train};
use crate::evolution::state::State;
use crate::folder::RunFolder;
use serde_json::{Value, json};
use std::ops::ControlFlow;
use std::sync::OnceLock;
use tpg_engine::{Choices, Environment, LocalThreads};
use tpg_graph::error::InputError;
use tpg_problems::Pendulum;
use tpg_problems::arm::targets::Start;
use tpg_problems::arm::{self, ArmEnvironment};
use tpg_runtime::ops::Own;

type Swing = Choices<f32, Pendulum>;

fn swing() -> Swing {
    Choices::new(Pendulum, Some(3)).expect("three torques")
}

fn config() -> EvolutionConfig {
    let mut config = EvolutionConfig::default();
    (config.tpg.nb_roots, config.tpg.init_nb_roots) = (24, 28);
    (config.learning.nb_iterations_per_policy_evaluation, config.learning.nb_generations) = (4, 4);
    (config.pool.share, config.start.share) = (0.5, 0.0);
    (config.selection.racing_episodes, config.selection.validation_episodes) = (0, 4);
    config
}

/// Returns the content of the checkpoint of a real run.
fn whole() -> &'static Value {
    static CONTENT: OnceLock<Value> = OnceLock::new();
    CONTENT.get_or_init(|| content(&config(), &swing()))
}

fn content<E: Environment<f32>>(config: &EvolutionConfig, environment: &E) -> Value {
    content_after(u64::MAX, config, environment)
}

/// Returns the content of the checkpoint of a run that is stopped after so many generations.
fn content_after<E: Environment<f32>>(generations: u64, config: &EvolutionConfig, environment: &E) -> Value {
    let place = tempfile::tempdir().expect("a temporary folder");
    let options = RunOptions { folder: place.path().to_owned(), ..RunOptions::default() };
    let evaluator = LocalThreads::<f32, Own, _>::new(environment, 1).expect("a thread");
    let watch = |progress: &Progress<'_>| match progress.generations >= generations {
        true => ControlFlow::Break(()),
        false => ControlFlow::Continue(()),
    };
    train(config, 1, environment, &evaluator, &options, watch).expect("it runs");
    let json = |_: &str, content: &[u8]| Ok(serde_json::from_slice(content).expect("JSON"));
    let folder = RunFolder::open(place.path(), true).expect("a run");
    folder.load(FORM, json).expect("a whole one").expect("a checkpoint")
}

fn read(content: &Value) -> Result<State<[f64; 2]>, InputError> {
    from_bytes("x", content.to_string().as_bytes(), &config(), 1, &swing())
}

#[test]
fn a_real_state_is_accepted_and_written_as_it_was_read() {
    let state = read(whole()).expect("a real one");
    assert!(!state.pool.is_empty() && state.best.is_some(), "a state that has every part");
    let again = to_bytes("x", &config(), &state, &swing()).expect("plain data");
    assert_eq!(serde_json::from_slice::<Value>(&again).expect("JSON"), *whole());
}

#[test]
fn a_real_state_of_an_arm_is_accepted() {
    let mut config = config();
    config.language.literals = true;
    let mut small = config;
    (small.learning.nb_iterations_per_policy_evaluation, small.learning.nb_generations) = (3, 2);
    (small.tpg.nb_roots, small.tpg.init_nb_roots) = (12, 12);
    let environment: ArmEnvironment<f32> = arm::ArmConfig::default().environment(Start::Rs);
    let content = content(&small, &environment).to_string();
    let read = from_bytes("x", content.as_bytes(), &small, 1, &environment);
    assert!(read.is_ok(), "{:?}", read.err());
}

#[test]
fn text_that_is_no_checkpoint_is_refused() {
    for text in ["", "{}", "[]", "null", "{\"config\":\"\",\"names\":[],\"state\":{}}", "\u{0}\u{ff}"] {
        let refused = from_bytes("x", text.as_bytes(), &config(), 1, &swing()).expect_err(text);
        assert!(refused.found.starts_with("not a checkpoint"), "{refused}");
    }
    let mut content = whole().clone();
    *content.pointer_mut("/config").expect("a configuration") = json!("[tpg");
    assert!(read(&content).expect_err("no configuration").found.contains("another configuration"));
}

#[test]
fn a_state_of_another_environment_is_refused() {
    let five: Swing = Choices::new(Pendulum, Some(5)).expect("five torques");
    let refused = from_bytes("x", whole().to_string().as_bytes(), &config(), 1, &five).expect_err("other actions");
    assert!(refused.found.starts_with("a checkpoint of an environment with "), "{refused}");
}
