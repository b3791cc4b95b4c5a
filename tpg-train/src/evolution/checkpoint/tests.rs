//! Damaged and forged states are refused at their place. The mutations are those with which a fuzzer once made training
//! panic, allocate half a gigabyte, or go on from a changed state.

use super::{VERSION, from_bytes, to_bytes};
use crate::evolution::config::EvolutionConfig;
use crate::evolution::run::{Progress, RunOptions, train};
use crate::evolution::state::State;
use crate::folder::{RunFolder, Trainer};
use serde_json::{Value, json};
use std::ops::ControlFlow;
use std::sync::OnceLock;
use tpg_engine::{Choices, Environment, LocalThreads};
use tpg_graph::error::{InputError, Place};
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
    (config.tpg.nb_roots, config.tpg.init_nb_roots) = (12, 14);
    config.demes.count = 2;
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
    let folder = RunFolder::open(place.path(), Trainer::Tpg, true).expect("a run");
    folder.load(VERSION, json).expect("a whole one").expect("a checkpoint")
}

fn read(content: &Value) -> Result<State<[f64; 2]>, InputError> {
    from_bytes("x", content.to_string().as_bytes(), &config(), 1, &swing())
}

/// Returns the first key of an object, in its order.
fn first(object: &Value) -> String {
    object.as_object().and_then(|object| object.keys().next()).expect("an object with keys").clone()
}

#[test]
fn a_real_state_is_accepted_and_written_as_it_was_read() {
    let state = read(whole()).expect("a real one");
    assert!(!state.pool.is_empty() && state.best.is_some(), "a state that has every part");
    let again = to_bytes("x", &config(), &state).expect("plain data");
    assert_eq!(serde_json::from_slice::<Value>(&again).expect("JSON"), *whole());
}

#[test]
fn a_real_state_of_an_arm_is_accepted() {
    let mut config = config();
    config.language.literals = true;
    let mut small = config;
    (small.learning.nb_iterations_per_policy_evaluation, small.learning.nb_generations) = (3, 2);
    (small.tpg.nb_roots, small.tpg.init_nb_roots) = (12, 12);
    let environment: ArmEnvironment<f32> = arm::Config::default().environment(Start::Rs);
    let content = content(&small, &environment).to_string();
    let read = from_bytes("x", content.as_bytes(), &small, 1, &environment);
    assert!(read.is_ok(), "{:?}", read.err());
}

#[test]
fn a_state_with_an_index_of_nothing_is_refused_at_its_place() {
    let deme = "/state/population/demes/0";
    let genome = format!("{deme}/genome");
    let at = |path: &str| whole().pointer(path).unwrap_or_else(|| panic!("{path}"));
    let team = format!("{genome}/teams/{}", first(at(&format!("{genome}/teams"))));
    let program = format!("{genome}/programs/{}", first(at(&format!("{genome}/programs"))));
    let record = format!("{deme}/records/{}", first(at(&format!("{deme}/records"))));
    let policy = "/state/best/policy";
    let programs = at(&format!("{policy}/programs")).as_array().expect("a list");
    // Lines without effect are not kept, so that a program may have none.
    let written = programs.iter().position(|lines| *lines != json!([])).expect("a program with lines");
    let line = format!("{policy}/programs/{written}/0");
    let huge = json!(u64::MAX);
    for (path, value, place) in [
        (format!("{genome}/next"), huge.clone(), "population.demes[0]"),
        (format!("{genome}/next"), json!(3), "population.demes[0]"),
        (format!("{team}/edges"), json!([]), "population.demes[0]"),
        (format!("{team}/edges/0/program"), json!(999_999), "population.demes[0]"),
        (format!("{team}/edges/0/to"), json!({"Action": 3}), "population.demes[0]"),
        (format!("{team}/edges/0/to"), json!({"Team": 999_999}), "population.demes[0]"),
        (format!("{program}/lines"), json!([]), "population.demes[0]"),
        (format!("{program}/lines/0/to"), json!(48), "population.demes[0]"),
        (format!("{program}/lines/0/instruction"), json!(config().instructions().len()), "population.demes[0]"),
        (format!("{program}/lines/0/operands/1/source"), json!(31), "population.demes[0]"),
        (format!("{program}/lines/0/operands/0/location"), json!(16_601), "population.demes[0]"),
        (format!("{record}/evaluations"), huge.clone(), "population.demes[0]"),
        ("/state/population/demes".to_owned(), json!([]), "state.population.demes"),
        (format!("{policy}/registers"), json!(0), "best.policy.registers"),
        (format!("{policy}/registers"), json!(65_535), "best.policy.registers"),
        (format!("{policy}/teams"), json!([]), "best.policy.teams"),
        (format!("{policy}/teams/0/0/program"), json!(128), "teams[0][0].program"),
        (format!("{policy}/teams/0/0/to"), json!({"team": 0}), "teams[0][0].to.team"),
        (format!("{policy}/teams/0/0/to"), json!({"action": 3}), "teams[0][0].to.action"),
        (format!("{line}/to"), json!(32), "[0].to"),
        (format!("{line}/operands/0"), json!({"input": 4095}), "operands[0].input"),
        (format!("{line}/operands/0"), json!({"register": 99}), "operands[0].register"),
        ("/state/best/ranges".to_owned(), json!([[0.0, 1.0]]), "best.ranges"),
        ("/state/rows".to_owned(), json!([]), "state.rows"),
        ("/state/generation".to_owned(), json!(9_999_999_999_u64), "state.generation"),
        ("/state/scales".to_owned(), json!([]), "state.scales"),
        ("/state/steps".to_owned(), huge.clone(), "state.steps"),
        ("/state/episode_steps".to_owned(), huge, "state.episode_steps"),
    ] {
        let mut content = whole().clone();
        *content.pointer_mut(&path).unwrap_or_else(|| panic!("{path}")) = value;
        let error = read(&content).expect_err(&path);
        let Place::Path(key) = &error.place else { panic!("{path}: {error}") };
        assert!(key.starts_with("state.") && key.contains(place), "{path}: {error}");
    }
}

#[test]
fn a_team_that_leads_to_itself_or_to_a_later_one_is_refused() {
    let teams = "/state/population/demes/0/genome/teams";
    let ids: Vec<u64> = (whole().pointer(teams).and_then(Value::as_object).expect("teams").keys())
        .map(|id| id.parse().expect("a number"))
        .collect();
    let (low, high) = (ids.iter().min().expect("teams"), ids.iter().max().expect("teams"));
    for to in [low, high] {
        let mut content = whole().clone();
        *content.pointer_mut(&format!("{teams}/{low}/edges/0/to")).expect("an edge") = json!({"Team": to});
        let error = read(&content).expect_err("a cycle").to_string();
        assert!(error.contains("population.demes[0]"), "{error}");
    }
}

#[test]
fn a_damaged_search_is_refused_at_its_place() {
    let mut config = config();
    (config.start.share, config.start.random, config.learning.nb_generations) = (1.0, 0.5, 12);
    config.pool.share = 0.0;
    // The random search has half of the run at most.
    let content = content_after(9, &config, &swing());
    let read = |content: &Value| -> Result<State<[f64; 2]>, InputError> {
        from_bytes("x", content.to_string().as_bytes(), &config, 1, &swing())
    };
    assert!(read(&content).expect("a real one").stalled.is_some());
    for (path, value, place) in [
        ("/state/search/method/cma/mean", json!([0.0]), "state.search"),
        ("/state/search/method/cma/variances", json!([1.0, 0.0]), "state.search"),
        ("/state/search/method/cma/deviation", json!(-1.0), "state.search"),
        ("/state/search/kind", json!("product"), "state.search"),
        ("/state/stalled/method/random/weights", json!([0.0]), "state.search"),
        ("/state/stalled/kind", json!("product"), "state.search"),
        ("/state/budget/begun", json!(99), "state.budget"),
        ("/state/budget/searches", json!(99), "state.budget"),
    ] {
        let mut content = content.clone();
        *content.pointer_mut(path).unwrap_or_else(|| panic!("{path}")) = value;
        let error = read(&content).expect_err(path).to_string();
        assert!(error.contains(place), "{path}: {error}");
    }
}

#[test]
fn text_that_is_no_checkpoint_is_refused() {
    for text in ["", "{}", "[]", "null", "{\"config\":\"\",\"state\":{}}", "\u{0}\u{ff}"] {
        let refused = from_bytes("x", text.as_bytes(), &config(), 1, &swing()).expect_err(text);
        assert!(refused.found.starts_with("not a checkpoint"), "{refused}");
    }
    let mut content = whole().clone();
    *content.pointer_mut("/config").expect("a configuration") = json!("[tpg");
    assert!(read(&content).expect_err("no configuration").found.contains("another configuration"));
}
