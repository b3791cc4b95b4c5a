//! Checkpoints of both trainers: what is accepted trains on.

use crate::accepted;
use std::fs;
use std::ops::ControlFlow;
use tempfile::TempDir;
use tpg_engine::{Choices, LocalThreads};
use tpg_problems::Pendulum;
use tpg_runtime::ops::Own;
use tpg_train::parts::Evolution;
use tpg_train::parts::Training;
use tpg_train::parts::sac;
use tpg_train::parts::tpg as checkpoint;
use tpg_train::parts::{RunFolder, Trainer};
use tpg_train::{Config as EvolutionConfig, Configuration as _, Goal, RunOptions, SacConfig, train as run};

/// The seed that the checkpoints must have.
pub const SEED: u64 = 1;

type Swing = Choices<f32, Pendulum>;

fn swing() -> Swing {
    Choices::new(Pendulum, Some(3)).expect("three torques")
}

fn evolution() -> EvolutionConfig {
    let mut config = EvolutionConfig::default();
    (config.tpg.nb_roots, config.tpg.init_nb_roots) = (12, 14);
    (config.demes.count, config.pool.share) = (2, 0.5);
    (config.learning.nb_iterations_per_policy_evaluation, config.learning.nb_generations) = (2, 4);
    (config.selection.racing_episodes, config.selection.validation_episodes) = (0, 4);
    config.start.share = 0.25;
    config
}

fn learning() -> SacConfig {
    let mut config = SacConfig::preset("general").expect("a preset");
    (config.actor.hidden, config.critic.hidden) = (vec![4], vec![5]);
    (config.learning.lanes, config.learning.random_decisions, config.learning.decisions_per_update) = (2, 8, 4);
    (config.learning.batch, config.learning.replay, config.learning.decisions) = (4, 20, 1000);
    config
}

/// The content of an evolution's checkpoint; what is accepted lives through a generation.
///
/// # Panics
/// If a state that was accepted cannot be written and read again.
pub fn tpg(data: &[u8]) {
    let (config, environment) = (evolution(), swing());
    let mut state = match checkpoint::from_bytes("fuzzed", data, &config, SEED, &environment) {
        Ok(state) => state,
        Err(error) => return drop(error.to_string()),
    };
    let evaluator = LocalThreads::<f32, Own, _>::new(&environment, 1).expect("a thread");
    let evolution = Evolution::new(&config, &environment, &evaluator, state.scales.clone(), Goal::default());
    if evolution.finished(&state) {
        return;
    }
    if evolution.advance(&mut state).is_ok() {
        let written = checkpoint::to_bytes("written", &config, &state).expect("plain data");
        checkpoint::from_bytes("written", &written, &config, SEED, &environment)
            .unwrap_or_else(|error| panic!("a generation later: {error}"));
    }
}

/// The content of a checkpoint of soft actor-critic; what is accepted trains on.
pub fn sac(data: &[u8]) {
    if let Some((mut training, _)) = accepted(sac::from_bytes("fuzzed", data, &Pendulum, &learning(), SEED)) {
        (0..6).for_each(|_| training.tick());
    }
}

/// A sealed checkpoint file in a folder, with its seal.
pub fn file(data: &[u8]) {
    for (trainer, version) in [(Trainer::Tpg, checkpoint::VERSION), (Trainer::Sac, sac::VERSION)] {
        let place = TempDir::new().expect("a temporary folder");
        fs::write(place.path().join("checkpoint"), data).expect("the folder can be written");
        let folder = RunFolder::open(place.path(), trainer, true).expect("a folder of its own");
        if let Some(Some(length)) = accepted(folder.load(version, |_, content| Ok(content.len()))) {
            assert!(length < data.len(), "a seal has a length");
        }
    }
}

/// Returns the contents of a real checkpoint of each trainer, and the sealed file of the first: seeds.
///
/// # Panics
/// If a run fails.
pub fn seeds() -> [Vec<u8>; 3] {
    let place = TempDir::new().expect("a temporary folder");
    let options = RunOptions { folder: place.path().to_owned(), ..RunOptions::default() };
    let (config, environment) = (evolution(), swing());
    let evaluator = LocalThreads::<f32, Own, _>::new(&environment, 1).expect("a thread");
    let stop_after_2 = |progress: &tpg_train::Progress<'_>| match progress.generations {
        2 => ControlFlow::Break(()),
        _ => ControlFlow::Continue(()),
    };
    run(&config, SEED, &environment, &evaluator, &options, stop_after_2).expect("a run");
    let folder = RunFolder::open(place.path(), Trainer::Tpg, true).expect("a run");
    let content = folder.load(checkpoint::VERSION, |_, content| Ok(content.to_vec())).expect("a whole one");
    let mut training = Training::new(&Pendulum, learning(), SEED).expect("an environment with outputs");
    (0..12).for_each(|_| training.tick());
    let sealed = fs::read(place.path().join("checkpoint")).expect("a checkpoint");
    [content.expect("a checkpoint"), sac::to_bytes(&training, &[]), sealed]
}
