//! The content of a checkpoint: all that a run needs to end in the same bytes as if it had never stopped.
//!
//! Postcard's bytes: settings, tasks and counters as one JSON text, then networks, optimisers, replay buffer and best candidate.
//! A running episode is stored as its task and its actions so far, which are repeated. There is no random state: every stream is
//! a function of the seed and the counters.

use super::config::SacConfig;
use super::interface::Input;
use super::replay::Replay;
use super::tensors::place;
use super::training::{BestActor, Recent, Training};
use serde::{Deserialize, Serialize};
use tpg_engine::{Environment, Summary};
use tpg_graph::error::{Finding, InputError};
use tpg_nn::{Agent, Mlp};

/// Incremented with every change to the content or meaning of checkpoints.
pub const VERSION: u32 = 9;
/// No run counts further: sums of two such counts do not overflow, and `f64` holds them exactly.
const MOST: u64 = 1 << 53;

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

/// The part that identifies a run, for any problem.
#[derive(Deserialize)]
struct CheckpointHeader {
    config: SacConfig,
    seed: u64,
}

/// The JSON text of a [`CheckpointState`], the numbers, the actions of each lane so far.
type Content = (String, Agent, Option<Mlp>, Option<BestActor>, Replay, Vec<Vec<f32>>);

/// Returns the content of a checkpoint. `log` is kept for the run's log files.
///
/// # Panics
/// If a task of the environment cannot be written as JSON.
pub fn to_bytes<E: Environment<f32>>(training: &Training<'_, E>, log: &[serde_json::Value]) -> Vec<u8> {
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
        failures: lanes.failures.places.clone(),
        inputs: lanes.interface().inputs.clone(),
        log: log.to_vec(),
    };
    let text = serde_json::to_string(&state).expect("plain data");
    let actions: Vec<&[f32]> = lanes.lanes.iter().map(|lane| lane.actions.as_slice()).collect();
    postcard::to_stdvec(&(text, agent, average, best, replay, actions)).expect("plain data")
}

/// A run under way, and the rows of its log.
pub type Loaded<'e, E> = (Training<'e, E>, Vec<serde_json::Value>);

/// Reads the content of a checkpoint and checks it; `file` is named in errors.
///
/// # Errors
/// If it is not a checkpoint, belongs to another configuration or seed, or is not a state that a run on this environment
/// can be in.
pub fn from_bytes<'e, E: Environment<f32>>(
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
    check_header(&text, config, seed)?;
    let state: CheckpointState<E::Task> = parse(&text)?;
    state.check(environment, replay.added)?;
    // What is drawn here is all overwritten: only the shapes count.
    let mut training = Training::new(environment, config.clone(), seed)?;
    let networks = || average.iter().chain(best.iter().map(|best| &best.actor));
    let is_whole = training.agent.is_like(&agent)
        && training.average.is_some() == average.is_some()
        && networks().all(|network| network.is_like(&agent.actor.network))
        && training.replay.is_like(&replay)
        && [state.lanes.len(), actions.len()] == [config.learning.lanes; 2]
        && names(&state.inputs).eq(names(&training.interface().inputs));
    if !is_whole {
        let found = "networks, inputs, lanes or a replay buffer of another size";
        return Err(Finding::new("", found, "those of the configuration"));
    }
    training.lanes.lanes.clear();
    for (place, (task, actions)) in state.lanes.into_iter().zip(&actions).enumerate() {
        if !training.lanes.resume(task, actions) {
            let key = format!("lanes[{place}]");
            return Err(Finding::new(key, "actions after the end of the episode", "an episode under way"));
        }
    }
    training.lanes.episodes = state.episodes;
    training.lanes.failures.places = state.failures;
    training.lanes.set_inputs(state.inputs);
    (training.agent, training.average, training.best, training.replay) = (agent, average, best, replay);
    (training.decisions, training.updates) = (state.decisions, state.updates);
    (training.last, training.recent) = (state.last, state.recent);
    Ok((training, state.log))
}

fn names(inputs: &[Input]) -> impl Iterator<Item = &str> {
    inputs.iter().map(|input| input.name.as_str())
}

fn parse<T: serde::de::DeserializeOwned>(text: &str) -> Result<T, Finding> {
    serde_json::from_str(text)
        .map_err(|error| Finding::new("", error, "the text that this version of tpg-train writes"))
}

impl<Task: std::fmt::Debug> CheckpointState<Task> {
    /// Checks what would panic later: counts that overflow, tasks of another problem.
    fn check<E: Environment<f32, Task = Task>>(&self, environment: &E, replayed: u64) -> Result<(), Finding> {
        let Recent { updates, steps, ends, .. } = &self.recent;
        let counts = [self.decisions, self.updates, self.episodes, replayed, *updates, *steps];
        counts.iter().chain(ends).try_for_each(|&count| Finding::range("a count", count, 0, MOST))?;
        match self.lanes.iter().chain(&self.failures).find(|task| !environment.accepts(task)) {
            Some(task) => Err(Finding::new("lanes or failures", format!("{task:?}"), "tasks of the problem")),
            None => Ok(()),
        }
    }
}

/// Refuses the checkpoint of another configuration or seed.
fn check_header(text: &str, config: &SacConfig, seed: u64) -> Result<(), Finding> {
    let header: CheckpointHeader = parse(text)?;
    if header.config != *config {
        let accepted = "the configuration that the run began with, or another --out";
        return Err(Finding::new("config", "another configuration", accepted));
    }
    if header.seed != seed {
        return Err(Finding::new("seed", header.seed, seed.to_string()));
    }
    Ok(())
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
        assert_eq!(undisturbed.lanes.failures.places.len(), config.retry.map_or(0, |retry| retry.remembered));
        assert!(to_bytes(&undisturbed, &[]) == to_bytes(&resumed, &[]), "the checkpoints at the end differ");
    }

    #[test]
    fn a_stopped_run_ends_in_the_bytes_of_an_undisturbed_one() {
        check_resumed(&Motors::new(Start::Rs, motors::Config::default(), 9), &small("best-rs"));
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
