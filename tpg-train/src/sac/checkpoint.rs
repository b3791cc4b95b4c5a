//! The content of a checkpoint: all that a run needs to end in the same bytes as if it had never stopped.
//!
//! Postcard's bytes: settings, tasks and counters as one JSON text, then networks, optimisers, replay buffer and best candidate
//! as vectors of numbers. A running episode is stored as its task and its actions so far, which are repeated. There is no random
//! state: every stream is a function of the seed and the counters.

use super::config::SacConfig;
use super::interface::Input;
use super::lanes::Lanes;
use super::replay::Replay;
use super::tensors::place;
use super::training::{Best, Recent, Training, agent, interface};
use serde::{Deserialize, Serialize};
use tpg_engine::{Environment, Summary};
use tpg_graph::error::{Finding, InputError};
use tpg_nn::Mlp;

/// Incremented with every change to the content or meaning of checkpoints.
pub const VERSION: u32 = 8;
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
    replayed: u64,
    adam_steps: Vec<u64>,
    best: Option<(Summary, u64)>,
    last: Option<Summary>,
    recent: Recent,
    /// The task of each lane, and the number of values in its actions so far.
    lanes: Vec<(Task, usize)>,
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

/// The JSON text of a [`CheckpointState`]; the vectors of the agent, the average and the best actor, the rows of the replay buffer, the actions.
type Content = (String, Vec<Vec<f32>>, Option<Vec<f32>>, Option<Vec<f32>>, Vec<f32>, Vec<f32>);

/// Returns the content of a checkpoint. `log` is kept for the run's log files.
///
/// # Panics
/// If a task of the environment cannot be written as JSON.
pub fn to_bytes<E: Environment<f32>>(training: &Training<'_, E>, log: &[serde_json::Value]) -> Vec<u8> {
    let Training { config, seed, agent, average, replay, lanes, decisions, updates, best, last, recent, .. } = training;
    let mut agent = agent.clone();
    let (adam_steps, agent) = agent.state_mut();
    let (replayed, rows) = replay.state();
    let actions: Vec<f32> = lanes.lanes.iter().flat_map(|lane| &lane.actions).copied().collect();
    let state = CheckpointState {
        config: config.clone(),
        seed: *seed,
        decisions: *decisions,
        updates: *updates,
        episodes: lanes.episodes,
        replayed,
        adam_steps: adam_steps.into_iter().map(|steps| *steps).collect(),
        best: best.as_ref().map(|best| (best.result, best.decisions)),
        last: *last,
        recent: recent.clone(),
        lanes: lanes.lanes.iter().map(|lane| (lane.task.clone(), lane.actions.len())).collect(),
        failures: lanes.failures.places.clone(),
        inputs: lanes.interface().inputs.clone(),
        log: log.to_vec(),
    };
    let text = serde_json::to_string(&state).expect("plain data");
    let (average, best) = (average.as_ref().map(Mlp::parameters), best.as_ref().map(|best| best.actor.parameters()));
    postcard::to_stdvec(&(text, agent, average, best, rows, actions)).expect("plain data")
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

/// Overwrites numbers with as many others.
fn overwrite(name: &str, numbers: &mut [f32], read: Option<&Vec<f32>>) -> Result<(), Finding> {
    let found = read.map_or(0, Vec::len);
    let read = read.filter(|read| read.len() == numbers.len());
    let other = || Finding::new(name, format!("{found} numbers"), format!("{} numbers", numbers.len()));
    numbers.copy_from_slice(read.ok_or_else(other)?);
    Ok(())
}

fn restore<'e, E: Environment<f32>>(
    (text, vectors, average, best, rows, done): Content,
    environment: &'e E,
    config: &SacConfig,
    seed: u64,
) -> Result<Loaded<'e, E>, Finding> {
    check_header(&text, config, seed)?;
    let state: CheckpointState<E::Task> = parse(&text)?;
    let interface = interface(environment, config)?;
    let (inputs, actions) = (interface.inputs.len(), interface.outputs.len());
    state.check(config, environment, actions)?;
    check_inputs(&state.inputs, &interface.inputs)?;
    // The weights drawn here are all overwritten: only the shapes count.
    let mut agent = agent(config, &interface, seed);
    let (counts, numbers) = agent.state_mut();
    if (state.adam_steps.len(), vectors.len()) != (counts.len(), numbers.len()) {
        return Err(Finding::new("agent", vectors.len(), format!("{} vectors of numbers", numbers.len())));
    }
    counts.into_iter().zip(state.adam_steps).for_each(|(count, steps)| *count = steps);
    numbers.into_iter().zip(&vectors).try_for_each(|(numbers, read)| overwrite("agent", numbers, Some(read)))?;
    let network = |name: &str, read: Option<Vec<f32>>| {
        let mut network = agent.actor.network.clone();
        overwrite(name, network.parameters_mut(), read.as_ref()).map(|()| network)
    };
    let average = config.learning.average.map(|_| network("average", average)).transpose()?;
    let candidate = |(result, decisions)| Ok::<_, Finding>(Best { result, decisions, actor: network("best", best)? });
    let best = state.best.map(candidate).transpose()?;
    let replay = Replay::from_state(inputs, actions, config.learning.replay, state.replayed, rows)
        .ok_or_else(|| Finding::new("replay", "another number of rows", "the rows that were replayed from"))?;
    if done.len() != state.lanes.iter().map(|(_, count)| count).sum::<usize>() {
        return Err(Finding::new("actions", done.len(), "those of the lanes"));
    }
    let mut lanes = Lanes::empty(environment, interface, config, seed);
    let mut done = done.as_slice();
    for (place, (task, count)) in state.lanes.into_iter().enumerate() {
        let (of_lane, rest) = done.split_at(count);
        if let Some(action) = of_lane.iter().find(|action| !(-1.0..=1.0).contains(*action)) {
            return Err(Finding::new("actions", action, "-1 to 1"));
        }
        if !lanes.resume(task, of_lane) {
            let key = format!("lanes[{place}]");
            return Err(Finding::new(key, "actions after the end of the episode", "an episode under way"));
        }
        done = rest;
    }
    lanes.episodes = state.episodes;
    lanes.failures.places = state.failures;
    lanes.set_inputs(state.inputs);
    let mut training = Training::of_parts(config.clone(), seed, agent, replay, lanes);
    training.average = average;
    training.decisions = state.decisions;
    training.updates = state.updates;
    training.best = best;
    training.last = state.last;
    training.recent = state.recent;
    Ok((training, state.log))
}

fn parse<T: serde::de::DeserializeOwned>(text: &str) -> Result<T, Finding> {
    serde_json::from_str(text)
        .map_err(|error| Finding::new("", error, "the text that this version of tpg-train writes"))
}

impl<Task> CheckpointState<Task> {
    /// Checks what would panic later: counts that overflow, another number of lanes, tasks of another problem.
    fn check<E: Environment<f32, Task = Task>>(
        &self,
        config: &SacConfig,
        environment: &E,
        outputs: usize,
    ) -> Result<(), Finding> {
        for (key, count) in [
            ("decisions", self.decisions),
            ("updates", self.updates),
            ("episodes", self.episodes),
            ("recent.updates", self.recent.updates),
            ("recent.steps", self.recent.steps),
        ] {
            Finding::range(key, count, 0, MOST)?;
        }
        let counts = self.adam_steps.iter().chain(&self.recent.ends);
        counts.clone().try_for_each(|&count| Finding::range("adam_steps or recent.ends", count, 0, MOST))?;
        if self.lanes.len() != config.learning.lanes {
            return Err(Finding::new("lanes", self.lanes.len(), config.learning.lanes.to_string()));
        }
        let limit = environment.time_limit() as usize;
        for (place, (task, count)) in self.lanes.iter().enumerate() {
            check_task(environment, &format!("lanes[{place}][0]"), task)?;
            if count.checked_rem(outputs) != Some(0) || *count > limit.saturating_mul(outputs) {
                let accepted = format!("{outputs} for each action, at most {limit} actions");
                return Err(Finding::new(format!("lanes[{place}][1]"), count, accepted));
            }
        }
        (self.failures.iter().enumerate())
            .try_for_each(|(place, task)| check_task(environment, &format!("failures[{place}]"), task))
    }
}

fn check_task<E: Environment<f32>>(environment: &E, key: &str, task: &E::Task) -> Result<(), Finding> {
    if environment.accepts(task) {
        return Ok(());
    }
    Err(Finding::new(key, format!("{task:?}"), "a task of the problem"))
}

/// Refuses other inputs than the environment's, and scales that are no numbers.
fn check_inputs(found: &[Input], accepted: &[Input]) -> Result<(), Finding> {
    let same = |(found, accepted): (&Input, &Input)| {
        found.name == accepted.name && found.offset.is_finite() && found.scale.is_finite() && found.scale > 0.0
    };
    if found.len() == accepted.len() && found.iter().zip(accepted).all(same) {
        return Ok(());
    }
    let accepted = accepted.iter().map(|input| input.name.as_str()).collect::<Vec<_>>().join(" ");
    Err(Finding::new("inputs", format!("{found:?}"), format!("{accepted}, each with a finite offset and scale")))
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
