//! Damaged and forged states are refused at their place. The mutations are those with which a fuzzer once made training
//! panic, allocate half a gigabyte, or go on from a changed state.

use super::{VERSION, from_bytes, to_bytes};
use crate::evolution::config::{EvolutionConfig, StartConfig, StartKind};
use crate::evolution::generation::Goal;
use crate::evolution::presets::Preset;
use crate::evolution::run::{RunOptions, run};
use crate::evolution::state::State;
use crate::folder::{Trainer, checkpoint::look};
use serde_json::{Value, json};
use std::ops::ControlFlow;
use std::sync::OnceLock;
use tpg_engine::{Choices, EngineOptions, Environment, LocalThreads};
use tpg_graph::error::{InputError, Place};
use tpg_problems::Pendulum;
use tpg_problems::arm::shield::Shield;
use tpg_problems::arm::targets::Start;
use tpg_problems::arm::{self, ArmEnvironment};
use tpg_runtime::ops::Own;

type Swing = Choices<f32, Pendulum>;

fn swing() -> Swing {
    Choices::new(Pendulum, Some(3)).expect("three torques")
}

fn config() -> EvolutionConfig {
    let mut config = Preset::find("general").expect("a preset").config().expect("it is accepted");
    (config.tpg.nb_roots, config.tpg.init_nb_roots) = (12, 14);
    (config.demes.count, config.demes.migration_interval, config.demes.migrants) = (2, 2, 1);
    (config.learning.archive_size, config.learning.archiving_probability) = (6, 1.0);
    (config.learning.nb_iterations_per_policy_evaluation, config.learning.nb_generations) = (4, 4);
    config.learning.nb_program_constant = 2;
    (config.pool.size, config.pool.share) = (5, 0.5);
    (config.selection.racing_episodes, config.selection.validation_roots) = (0, 3);
    (config.selection.validation_episodes, config.selection.lexicase_survivors) = (4, 0);
    (config.curriculum.generations, config.curriculum.roughness) = (0, 1);
    config
}

/// Returns the content of the checkpoint of a real run.
fn whole() -> &'static Value {
    static CONTENT: OnceLock<Value> = OnceLock::new();
    CONTENT.get_or_init(|| content(&config(), &swing()))
}

fn content<E: Environment<f32>>(config: &EvolutionConfig, environment: &E) -> Value {
    content_within(config, environment, Goal::default())
}

/// Returns the content of the checkpoint of a run that ends early if it reaches a goal.
fn content_within<E: Environment<f32>>(config: &EvolutionConfig, environment: &E, goal: Goal) -> Value {
    let place = tempfile::tempdir().expect("a temporary folder");
    let options = RunOptions { folder: place.path().to_owned(), goal, ..RunOptions::default() };
    let evaluator = LocalThreads::<f32, Own, _>::new(environment, EngineOptions::default(), 1).expect("a thread");
    run(config, 1, environment, &evaluator, &options, |_| ControlFlow::Continue(())).expect("it runs");
    let json = |_: &str, content: &[u8]| Ok(serde_json::from_slice(content).expect("JSON"));
    look(place.path(), Trainer::Tpg, VERSION, json).expect("a checkpoint")
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
fn a_real_state_of_a_shielded_arm_is_accepted() {
    let mut config = config();
    config.language.literals = true;
    let (mut limits, mut small) = (arm::Config::default(), config);
    limits.shield = Shield::LimitsAndCollision;
    (small.learning.nb_iterations_per_policy_evaluation, small.learning.nb_generations) = (3, 2);
    (small.tpg.nb_roots, small.tpg.init_nb_roots) = (12, 12);
    let environment: ArmEnvironment<f32> = limits.environment(Start::Rs);
    let content = content(&small, &environment).to_string();
    let read = from_bytes("x", content.as_bytes(), &small, 1, &environment);
    assert!(read.is_ok(), "{:?}", read.err());
}

#[test]
fn a_state_with_an_index_of_nothing_is_refused_at_its_place() {
    let deme = "/state/demes/0";
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
        (format!("{genome}/next"), huge.clone(), "genome.next"),
        (format!("{genome}/next"), json!(3), "genome.teams."),
        (format!("{team}/edges"), json!([]), ".edges"),
        (format!("{team}/edges/0/program"), json!(999_999), ".edges[0].program"),
        (format!("{team}/edges/0/to"), json!({"Action": 3}), ".edges[0].to.Action"),
        (format!("{team}/edges/0/to"), json!({"Team": 999_999}), ".edges[0].to.Team"),
        (format!("{program}/lines"), json!([]), ".lines"),
        (format!("{program}/constants"), json!([]), ".constants"),
        (format!("{program}/lines/0/to"), json!(48), ".lines[0].to"),
        (format!("{program}/lines/0/instruction"), json!(config().instructions().len()), ".lines[0].instruction"),
        (format!("{program}/lines/0/operands/1/source"), json!(31), ".operands[1].source"),
        (format!("{program}/lines/0/operands/0/location"), json!(16_601), ".operands[0].location"),
        (format!("{record}/evaluations"), huge.clone(), ".evaluations"),
        ("/state/demes".to_owned(), json!([]), "state.demes"),
        ("/state/archive/size".to_owned(), json!(2_247_488), "state.archive.size"),
        ("/state/archive/recordings/0/state".to_owned(), json!([1.0]), "recordings[0].state"),
        ("/state/archive/recordings/0/program/0".to_owned(), json!(7), "recordings[0].program"),
        ("/state/pool".to_owned(), json!(vec![[0.0, 0.0]; 6]), "state.pool"),
        (format!("{policy}/registers"), json!(0), "best.policy.registers"),
        (format!("{policy}/registers"), json!(65_535), "best.policy.registers"),
        (format!("{policy}/teams"), json!([]), "best.policy.teams"),
        (format!("{policy}/teams/0/0/program"), json!(128), "teams[0][0].program"),
        (format!("{policy}/teams/0/0/to"), json!({"team": 0}), "teams[0][0].to.team"),
        (format!("{policy}/teams/0/0/to"), json!({"action": 3}), "teams[0][0].to.action"),
        (format!("{line}/to"), json!(32), "[0].to"),
        (format!("{line}/operands/0"), json!({"input": 4095}), "operands[0].input"),
        (format!("{line}/operands/0"), json!({"register": 99}), "operands[0].register"),
        ("/state/best/generation".to_owned(), json!(4), "best.generation"),
        ("/state/best/ranges".to_owned(), json!([[0.0, 1.0]]), "best.ranges"),
        ("/state/rows".to_owned(), json!([]), "state.rows"),
        ("/state/rows/1/generation".to_owned(), json!(5), "rows[1].generation"),
        ("/state/generation".to_owned(), json!(9_999_999), "state.generation"),
        ("/state/scales".to_owned(), json!([]), "state.scales"),
        ("/state/steps".to_owned(), huge.clone(), "state.steps"),
        ("/state/training_episodes".to_owned(), huge, "state.training_episodes"),
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
    let teams = "/state/demes/0/genome/teams";
    let ids: Vec<u64> = (whole().pointer(teams).and_then(Value::as_object).expect("teams").keys())
        .map(|id| id.parse().expect("a number"))
        .collect();
    let (low, high) = (ids.iter().min().expect("teams"), ids.iter().max().expect("teams"));
    for to in [low, high] {
        let mut content = whole().clone();
        *content.pointer_mut(&format!("{teams}/{low}/edges/0/to")).expect("an edge") = json!({"Team": to});
        let error = read(&content).expect_err("a cycle").to_string();
        assert!(error.contains("a team before"), "{error}");
    }
}

#[test]
fn a_damaged_search_for_a_linear_start_is_refused_at_its_place() {
    let mut config = config();
    config.language.literals = true;
    config.program.max_program_size = 6;
    config.start = StartConfig { kind: StartKind::Linear, generations: 3, ..StartConfig::default() };
    // Generation 2 is in the second half of the start, where one search goes on; generation 4 is behind it.
    for (generations, searches) in [(1, 3), (3, 1), (4, 1)] {
        config.learning.nb_generations = generations;
        let content = content(&config, &swing());
        let read = |content: &Value| -> Result<State<[f64; 2]>, InputError> {
            from_bytes("x", content.to_string().as_bytes(), &config, 1, &swing())
        };
        assert_eq!(read(&content).expect("a real one").searches.len(), searches);
        for (path, value, place) in [
            ("/state/searches", json!([]), "state.searches"),
            ("/state/searches/0/method/cma/mean", json!([0.0]), "state.searches[0].method.cma.mean"),
            ("/state/searches/0/method/cma/covariance", json!([1.0, 0.0]), "state.searches[0].method.cma.covariance"),
            ("/state/searches/0/method/cma/deviation", json!(-1.0), "state.searches[0].method.cma.deviation"),
            ("/state/searches/0/score", json!(1e300), "state.searches[0].score"),
        ] {
            let mut content = content.clone();
            *content.pointer_mut(path).unwrap_or_else(|| panic!("{path}")) = value;
            let error = read(&content).expect_err(path).to_string();
            assert!(error.contains(place), "{path}: {error}");
        }
    }
}

#[test]
fn damaged_milestones_of_a_start_that_is_limited_by_steps_are_refused() {
    let mut config = config();
    config.language.literals = true;
    config.program.max_program_size = 6;
    config.start = StartConfig { kind: StartKind::Linear, generations: 3, share: [0.2, 0.5], ..StartConfig::default() };
    config.learning.nb_generations = 4;
    let content = content(&config, &swing());
    let read = |content: &Value| -> Result<State<[f64; 2]>, InputError> {
        from_bytes("x", content.to_string().as_bytes(), &config, 1, &swing())
    };
    let milestones = read(&content).expect("a real one").milestones;
    assert_eq!(
        (milestones.chosen, milestones.ended),
        (Some(2), Some(3)),
        "generations decide: there is no limit of steps"
    );
    for (path, value, place) in [
        ("/state/milestones/chosen", json!(5), "state.milestones.chosen"),
        ("/state/milestones/ended", json!(1), "state.milestones.ended"),
        ("/state/milestones/peak/generations", json!(5), "state.milestones.peak.generations"),
        ("/state/milestones/peak/steps", json!(1u64 << 52), "state.milestones.peak.steps"),
        ("/state/milestones/further/generations", json!(5), "state.milestones.further.generations"),
        ("/state/best/error", json!(-1.0), "state.best.error"),
    ] {
        let mut content = content.clone();
        *content.pointer_mut(path).unwrap_or_else(|| panic!("{path}")) = value;
        let error = read(&content).expect_err(path).to_string();
        assert!(error.contains(place), "{path}: {error}");
    }
}

#[test]
fn a_damaged_search_that_has_begun_anew_is_refused() {
    let mut config = config();
    config.language.literals = true;
    config.program.max_program_size = 20;
    config.learning.nb_generations = 120;
    // Samples are equal, so some generation is the best of the ten after it.
    let share = [0.5, 1.0];
    config.start =
        StartConfig { kind: StartKind::Linear, generations: 2, share, deviation: 1e-6, ..StartConfig::default() };
    let written = |config: &EvolutionConfig| {
        content_within(config, &swing(), Goal { max_steps: Some(1 << 40), ..Goal::default() })
    };
    let content = written(&config);
    let read_with = |config: &EvolutionConfig, content: &Value| -> Result<State<[f64; 2]>, InputError> {
        from_bytes("x", content.to_string().as_bytes(), config, 1, &swing())
    };
    let read = |content: &Value| read_with(&config, content);
    let state = read(&content).expect("a real one");
    let begun = state.milestones.begun.expect("it has begun anew");
    assert!(state.stalled.is_some() && begun.searches > 1 && begun.steps > 0);
    let mut shorter = config.clone();
    shorter.learning.nb_generations = begun.generation;
    let state_then = read_with(&shorter, &written(&shorter)).expect("one between two searches");
    assert_eq!(state_then.milestones.begun, Some(begun));
    let turns = [StartKind::Linear, StartKind::Product];
    assert_eq!(state.searches[0].kind, turns[begun.searches as usize % 2], "sums and products in turns");
    for (path, value, place) in [
        ("/state/stalled", Value::Null, "state.stalled"),
        ("/state/stalled/score", json!(1e300), "state.stalled.score"),
        ("/state/stalled/method/cma/path", json!([0.0]), "state.stalled.method.cma.path"),
        ("/state/stalled/kind", json!("random"), "state.stalled.kind"),
        ("/state/searches/0/kind", json!("random"), "state.searches[0].kind"),
        ("/state/milestones/begun", Value::Null, "state.stalled"),
        ("/state/milestones/begun/generation", json!(121), "state.milestones.begun.generation"),
        ("/state/milestones/begun/steps", json!(1u64 << 52), "state.milestones.begun.steps"),
        ("/state/milestones/begun/searches", json!(121), "state.milestones.begun.searches"),
    ] {
        let mut content = content.clone();
        *content.pointer_mut(path).unwrap_or_else(|| panic!("{path}")) = value;
        let error = read(&content).expect_err(path).to_string();
        assert!(error.contains(place), "{path}: {error}");
    }
}

#[test]
fn a_damaged_random_search_is_refused() {
    let mut config = config();
    config.language.literals = true;
    config.program.max_program_size = 20;
    config.learning.nb_generations = 2;
    config.start = StartConfig {
        kind: StartKind::Linear,
        generations: 20,
        share: [0.5, 1.0],
        random: 0.5,
        ..StartConfig::default()
    };
    let content = content_within(&config, &swing(), Goal { max_steps: Some(1 << 40), ..Goal::default() });
    let read = |content: &Value| -> Result<State<[f64; 2]>, InputError> {
        from_bytes("x", content.to_string().as_bytes(), &config, 1, &swing())
    };
    assert_eq!(read(&content).expect("a real one").searches.len(), 1, "a random search is alone");
    let mut twice = content.clone();
    let searches = twice.pointer_mut("/state/searches").and_then(Value::as_array_mut).expect("searches");
    searches.push(searches[0].clone());
    assert!(read(&twice).expect_err("one of two").to_string().contains("state.searches: 2"));
    let mut product = content.clone();
    *product.pointer_mut("/state/searches/0/kind").expect("a kind") = json!("product");
    assert!(read(&product).expect_err("it looks for sums").to_string().contains("state.searches[0].kind"));
    for (path, value) in [("weights", json!([])), ("seen/means", json!([0.0])), ("seen/squares/0", json!(-1.0))] {
        let mut content = content.clone();
        let path = format!("/state/searches/0/method/random/{path}");
        *content.pointer_mut(&path).unwrap_or_else(|| panic!("{path}")) = value;
        let error = read(&content).expect_err(&path).to_string();
        assert!(error.contains("state.searches[0].method.random."), "{path}: {error}");
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
