//! The content of a checkpoint: all that a run needs to end in the same bytes as if it had never stopped.
//!
//! Postcard's bytes: settings, tasks and counters as one JSON text, then networks, optimisers, replay buffer and best candidate.
//! A running episode is stored as its task and its actions so far, which are repeated. There is no random state: every stream is
//! a function of the seed and the counters.

use super::config::SacConfig;
use super::interface::Input;
use super::replay::Replay;
use super::training::{BestActor, Recent, Training};
use crate::run_args::place;
use serde::{Deserialize, Serialize};
use tpg_engine::{Environment, Summary};
use tpg_graph::error::{Finding, InputError};
use tpg_nn::{Agent, Mlp};

/// Trainer and version, which is incremented with every change to the content or meaning of checkpoints.
pub(super) const FORM: &str = "tpg-train sac, checkpoint version 10";

/// Everything except the numbers: networks, replay buffer, actions.
#[derive(Clone, Debug, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
struct CheckpointState<Task> {
    config: SacConfig,
    seed: u64,
    decisions: u64,
    updates: u64,
    episodes: u64,
    last: Option<Summary>,
    recent: Recent,
    /// The task of each lane.
    lanes: Vec<Task>,
    failures: Vec<Task>,
    /// The inputs, which a run may have measured.
    inputs: Vec<Input>,
    /// The rows of the log so far.
    log: Vec<serde_json::Value>,
}

/// The JSON text of a [`CheckpointState`], the numbers, the actions of each lane so far.
type Content = (String, Agent, Option<Mlp>, Option<BestActor>, Replay, Vec<Vec<f32>>);

/// Returns the content of a checkpoint. `log` is kept for the run's log files.
///
/// # Panics
/// If a task of the environment cannot be written as JSON.
pub(super) fn to_bytes<E: Environment<f32>>(training: &Training<'_, E>, log: &[serde_json::Value]) -> Vec<u8> {
    let Training { config, seed, agent, average, replay, lanes, decisions, updates, best, last, recent, .. } = training;
    let state = CheckpointState {
        config: config.clone(),
        seed: *seed,
        decisions: *decisions,
        updates: *updates,
        episodes: lanes.episodes,
        last: *last,
        recent: recent.clone(),
        lanes: lanes.lanes.iter().map(|lane| lane.task.clone()).collect(),
        failures: lanes.failures.clone(),
        inputs: lanes.interface.inputs.clone(),
        log: log.to_vec(),
    };
    let text = serde_json::to_string(&state).expect("plain data");
    let actions: Vec<&[f32]> = lanes.lanes.iter().map(|lane| lane.actions.as_slice()).collect();
    postcard::to_stdvec(&(text, agent, average, best, replay, actions)).expect("plain data")
}

/// A run under way, and the rows of its log.
pub(super) type Loaded<'e, E> = (Training<'e, E>, Vec<serde_json::Value>);

/// Reads the content of a checkpoint; `file` is named in errors.
///
/// # Errors
/// If it is not a checkpoint, or belongs to another configuration or seed.
pub(super) fn from_bytes<'e, E: Environment<f32>>(
    file: &str,
    content: &[u8],
    environment: &'e E,
    config: &SacConfig,
    seed: u64,
) -> Result<Loaded<'e, E>, InputError> {
    let damaged = |error| Finding::new("", error, "a checkpoint written by this version of tpg-train");
    (postcard::from_bytes(content).map_err(damaged))
        .and_then(|content| restore(content, environment, config, seed))
        .map_err(|finding| place(file.as_ref(), finding))
}

fn restore<'e, E: Environment<f32>>(
    (text, agent, average, best, replay, actions): Content,
    environment: &'e E,
    config: &SacConfig,
    seed: u64,
) -> Result<Loaded<'e, E>, Finding> {
    let state: CheckpointState<E::Task> = serde_json::from_str(&text)
        .map_err(|error| Finding::new("", error, "the text that this version of tpg-train writes"))?;
    if state.config != *config {
        let accepted = "the configuration that the run began with, or another --out";
        return Err(Finding::new("config", "another configuration", accepted));
    }
    if state.seed != seed {
        return Err(Finding::new("seed", state.seed, seed.to_string()));
    }
    // What is drawn here is all overwritten.
    let mut training = Training::new(environment, config.clone(), seed)?;
    training.lanes.lanes.clear();
    state.lanes.into_iter().zip(&actions).for_each(|(task, actions)| training.lanes.resume(task, actions));
    training.lanes.episodes = state.episodes;
    training.lanes.failures = state.failures;
    training.lanes.interface.inputs = state.inputs;
    (training.agent, training.average, training.best, training.replay) = (agent, average, best, replay);
    (training.decisions, training.updates) = (state.decisions, state.updates);
    (training.last, training.recent) = (state.last, state.recent);
    Ok((training, state.log))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::configuration::Configuration as _;
    use tpg_problems::Pendulum;
    use tpg_problems::arm::motors::{self, Motors};
    use tpg_problems::arm::targets::Start;

    fn small(preset: &str) -> SacConfig {
        let mut config = SacConfig::preset(preset).expect("a preset");
        config.actor.hidden = vec![12, 10];
        config.critic.hidden = vec![14, 9];
        config.learning.lanes = 4;
        config.learning.random_decisions = 100;
        config.learning.decisions_per_update = 16;
        config.learning.batch = 16;
        config.learning.replay = 300; // less than there will be transitions: the ring must turn
        config.learning.decisions = 1000;
        if let Some(retry) = &mut config.retry {
            (retry.every, retry.episodes, retry.remembered) = (150, 16, 30);
        }
        config
    }

    fn check_resumed<E: Environment<f32>>(environment: &E, config: &SacConfig) {
        let new = || Training::new(environment, config.clone(), 9).expect("an environment with outputs");
        let (mut undisturbed, mut stopped) = (new(), new());
        (0..100).for_each(|_| stopped.tick());
        let content = to_bytes(&stopped, &[serde_json::json!({"row": 1})]);
        let (mut resumed, log) = from_bytes("x", &content, environment, config, 9).expect("a good checkpoint");
        assert_eq!(log, [serde_json::json!({"row": 1})]);
        for training in [&mut undisturbed, &mut resumed] {
            while !training.finished() {
                training.tick();
            }
        }
        assert!(undisturbed.updates > 40);
        assert_eq!(undisturbed.lanes.failures.len(), config.retry.map_or(0, |retry| retry.remembered));
        assert!(to_bytes(&undisturbed, &[]) == to_bytes(&resumed, &[]), "the checkpoints at the end differ");
    }

    #[test]
    fn a_stopped_run_ends_in_the_bytes_of_an_undisturbed_one() {
        check_resumed(&Motors::new(Start::Rs, motors::MotorsConfig::default(), 9), &small("best-rs"));
        check_resumed(&Pendulum, &small("general"));
        let mut measured = small("general");
        measured.learning.measured_inputs = true;
        check_resumed(&Pendulum, &measured);
    }

    #[test]
    fn a_checkpoint_of_another_seed_or_configuration_is_refused() {
        let config = small("general");
        let mut training = Training::new(&Pendulum, config.clone(), 9).expect("a torque");
        training.tick();
        let whole = to_bytes(&training, &[]);
        let refusal =
            |content: &[u8], config: &SacConfig, seed: u64| match from_bytes("x", content, &Pendulum, config, seed) {
                Ok(_) => panic!("it is read"),
                Err(error) => error.to_string(),
            };
        assert!(refusal(&whole, &config, 10).contains("seed"));
        let mut other = config.clone();
        other.learning.rate = 0.5;
        assert!(refusal(&whole, &other, 9).contains("config"));
        assert!(refusal(&whole[..whole.len() / 2], &config, 9).contains("a checkpoint written by this version"));
    }
}
