//! Checkpoints: all that a run needs to end in the same bytes as if it had never stopped.
//!
//! A safetensors file: networks, optimisers, replay buffer and best candidate as flat tensors, tasks and counters as JSON.
//! An episode under way is its task and the actions so far, which are done again. There is no random state: every stream is
//! a function of the seed and the counters.

use super::agent::{Agent, Bootstrap, Learner};
use super::config::Config;
use super::lanes::Lanes;
use super::replay::Replay;
use super::tensors::{Tensor, Tensors};
use super::training::{Best, Recent, Training, agent, interface};
use serde::{Deserialize, Serialize};
use std::path::Path;
use tpg_engine::{Environment, Summary};
use tpg_graph::error::{Finding, InputError};
use tpg_nn::{Adam, Mlp, Shape};

const FORMAT: &str = "tpg-train sac checkpoint";
const VERSION: u32 = 4;
/// No checkpoint is larger, bytes: the largest replay buffer of the presets makes a sixth of it.
const LIMIT: u64 = 4 << 30;

/// Everything but the numbers of networks, buffer and actions.
#[derive(Clone, Debug, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
struct State<Task> {
    format: String,
    version: u32,
    config: Config,
    seed: u64,
    decisions: u64,
    updates: u64,
    episodes: u64,
    replayed: u64,
    adam_steps: Vec<u64>,
    best: Option<(Summary, u64)>,
    curve: Vec<Summary>,
    recent: Recent,
    /// The task of each lane, and the number of values in its actions so far.
    lanes: Vec<(Task, usize)>,
    failures: Vec<Task>,
    /// The rows of the log so far.
    log: Vec<serde_json::Value>,
}

/// The part that tells whose checkpoint it is, for any problem.
#[derive(Deserialize)]
struct Header {
    format: String,
    version: u32,
    config: Config,
    seed: u64,
}

/// Writes a checkpoint; the last good one stays until the new one is whole. `log` is kept for the run's log files.
///
/// # Errors
/// If it cannot be written.
pub fn save<E: Environment<f32>>(
    path: &Path,
    training: &Training<'_, E>,
    log: &[serde_json::Value],
) -> Result<(), InputError> {
    let Training { config, seed, agent, average, replay, lanes, decisions, updates, best, curve, recent, .. } =
        training;
    let mut tensors = Tensors::default();
    let mut insert = |name: &str, values: &[f32]| {
        tensors.tensors.insert(name.to_owned(), Tensor::flat(values.to_vec()));
    };
    let mut adam_steps = Vec::new();
    for (name, learner) in learners(agent) {
        let (steps, mean, square) = learner.adam.state();
        insert(name, learner.network.parameters());
        insert(&format!("{name}.adam.mean"), mean);
        insert(&format!("{name}.adam.square"), square);
        adam_steps.push(steps);
    }
    for (name, network) in followers(agent) {
        insert(name, network.parameters());
    }
    if let Some(average) = average {
        insert("average", average.parameters());
    }
    let (steps, mean, square) = agent.alpha_adam.state();
    adam_steps.push(steps);
    insert("temperature", &[agent.log_alpha, mean[0], square[0]]);
    let (replayed, rows) = replay.state();
    insert("replay", rows);
    if let Some(best) = best {
        insert("best", best.actor.parameters());
    }
    let actions: Vec<f32> = lanes.lanes.iter().flat_map(|lane| &lane.actions).copied().collect();
    insert("actions", &actions);
    let state = State {
        format: FORMAT.to_owned(),
        version: VERSION,
        config: config.clone(),
        seed: *seed,
        decisions: *decisions,
        updates: *updates,
        episodes: lanes.episodes,
        replayed,
        adam_steps,
        best: best.as_ref().map(|best| (best.result, best.decisions)),
        curve: curve.clone(),
        recent: recent.clone(),
        lanes: lanes.lanes.iter().map(|lane| (lane.task.clone(), lane.actions.len())).collect(),
        failures: lanes.failures.places.clone(),
        log: log.to_vec(),
    };
    tensors.text = Some(serde_json::to_string(&state).expect("plain data"));
    tensors.write(path)
}

fn learners(agent: &Agent<f32>) -> Vec<(&'static str, &Learner<f32>)> {
    let [first, second] = &agent.critics;
    let mut all = vec![("actor", &agent.actor), ("critic.0", first), ("critic.1", second)];
    if let Bootstrap::Value { value, .. } = &agent.bootstrap {
        all.push(("value", value));
    }
    all
}

fn followers(agent: &Agent<f32>) -> Vec<(&'static str, &Mlp<f32>)> {
    match &agent.bootstrap {
        Bootstrap::SlowCritics([first, second]) => vec![("slow.0", first), ("slow.1", second)],
        Bootstrap::Value { slow, .. } => vec![("slow.0", slow)],
    }
}

/// A run under way, and the rows of its log.
pub type Loaded<'e, E> = (Training<'e, E>, Vec<serde_json::Value>);

/// Reads a checkpoint.
///
/// # Errors
/// If it cannot be read, is no checkpoint, or belongs to another configuration or seed.
pub fn load<'e, E: Environment<f32>>(
    path: &Path,
    environment: &'e E,
    config: &Config,
    seed: u64,
) -> Result<Loaded<'e, E>, InputError> {
    let tensors = Tensors::read(path, LIMIT)?;
    restore(tensors, environment, config, seed).map_err(|finding| super::tensors::place(path, finding))
}

/// Takes tensors out of a checkpoint.
struct Numbers(Tensors);

impl Numbers {
    fn take(&mut self, name: &str, length: Option<usize>) -> Result<Vec<f32>, Finding> {
        let tensor = self.0.tensors.remove(name);
        let values = tensor.ok_or_else(|| Finding::new(name, "nothing", "a tensor"))?.values;
        match length {
            Some(length) if length != values.len() => {
                Err(Finding::new(name, format!("{} numbers", values.len()), format!("{length} numbers")))
            }
            _ => Ok(values),
        }
    }

    fn network(&mut self, name: &str, shape: &Shape) -> Result<Mlp<f32>, Finding> {
        let parameters = self.take(name, Some(shape.parameters()))?;
        Ok(Mlp::from_parameters(shape.clone(), parameters).expect("as many parameters as the shape has"))
    }

    /// Overwrites an agent's networks and optimisers.
    fn agent(&mut self, agent: &mut Agent<f32>, adam_steps: &[u64]) -> Result<(), Finding> {
        let mut steps = adam_steps.iter().copied();
        let few = || Finding::new("metadata.tpg.adam_steps", "too few", "one for each optimiser");
        let Agent { actor, critics: [first, second], bootstrap, .. } = agent;
        let mut learners = vec![("actor", actor), ("critic.0", first), ("critic.1", second)];
        let mut followers = Vec::new();
        match bootstrap {
            Bootstrap::SlowCritics([first, second]) => followers.extend([("slow.0", first), ("slow.1", second)]),
            Bootstrap::Value { value, slow } => {
                learners.push(("value", value));
                followers.push(("slow.0", slow));
            }
        }
        for (name, learner) in learners {
            let shape = learner.network.shape().clone();
            learner.network = self.network(name, &shape)?;
            let mean = self.network(&format!("{name}.adam.mean"), &shape)?.parameters().to_vec();
            let square = self.network(&format!("{name}.adam.square"), &shape)?.parameters().to_vec();
            let steps = steps.next().ok_or_else(few)?;
            learner.adam = Adam::from_state(steps, mean, square).expect("two vectors of one length");
        }
        for (name, follower) in followers {
            *follower = self.network(name, &follower.shape().clone())?;
        }
        let temperature = self.take("temperature", Some(3))?;
        let steps = steps.next().ok_or_else(few)?;
        agent.log_alpha = temperature[0];
        agent.alpha_adam =
            Adam::from_state(steps, vec![temperature[1]], vec![temperature[2]]).expect("one number each");
        Ok(())
    }
}

fn restore<'e, E: Environment<f32>>(
    mut file: Tensors,
    environment: &'e E,
    config: &Config,
    seed: u64,
) -> Result<Loaded<'e, E>, Finding> {
    let text = file.text.take().unwrap_or_default();
    check_header(&text, config, seed)?;
    let state: State<E::Task> = parse(&text)?;
    let mut numbers = Numbers(file);
    let interface = interface(environment, config)?;
    let (inputs, actions) = (interface.inputs.len(), interface.outputs.len());
    // The weights drawn here are all overwritten: only the shapes count.
    let mut agent = agent(config, &interface, seed);
    numbers.agent(&mut agent, &state.adam_steps)?;
    let actor = agent.actor.network.shape().clone();
    let average = config.learning.average.map(|_| numbers.network("average", &actor)).transpose()?;
    let best = match state.best {
        None => None,
        Some((result, decisions)) => Some(Best { result, decisions, actor: numbers.network("best", &actor)? }),
    };
    let rows = numbers.take("replay", None)?;
    let replay = Replay::from_state(inputs, actions, config.learning.replay, state.replayed, rows)
        .ok_or_else(|| Finding::new("replay", "another number of rows", "the rows that were replayed from"))?;
    if state.lanes.len() != config.learning.lanes {
        return Err(Finding::new("metadata.tpg.lanes", state.lanes.len(), config.learning.lanes.to_string()));
    }
    let mut lanes = Lanes::empty(environment, interface, config, seed);
    let done = numbers.take("actions", Some(state.lanes.iter().map(|(_, count)| count).sum()))?;
    let mut done = done.as_slice();
    for (task, count) in state.lanes {
        let (of_lane, rest) = done.split_at(count);
        lanes.resume(task, of_lane);
        done = rest;
    }
    lanes.episodes = state.episodes;
    lanes.failures.places = state.failures;
    let mut training = Training::of_parts(config.clone(), seed, agent, replay, lanes);
    training.average = average;
    training.decisions = state.decisions;
    training.updates = state.updates;
    training.best = best;
    training.curve = state.curve;
    training.recent = state.recent;
    Ok((training, state.log))
}

fn parse<T: serde::de::DeserializeOwned>(text: &str) -> Result<T, Finding> {
    serde_json::from_str(text)
        .map_err(|error| Finding::new("metadata.tpg", error, "the text that this version of tpg-train writes"))
}

/// Refuses the checkpoint of another version, configuration or seed.
fn check_header(text: &str, config: &Config, seed: u64) -> Result<(), Finding> {
    let header: Header = parse(text)?;
    if header.format != FORMAT || header.version != VERSION {
        let found = format!("{:?}, version {}", header.format, header.version);
        return Err(Finding::new("metadata.tpg.format", found, format!("{FORMAT:?}, version {VERSION}")));
    }
    if header.config != *config {
        let accepted = "the configuration that the run began with, or another --out";
        return Err(Finding::new("metadata.tpg.config", "another configuration", accepted));
    }
    if header.seed != seed {
        return Err(Finding::new("metadata.tpg.seed", header.seed, seed.to_string()));
    }
    Ok(())
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::sac::presets;
    use tpg_problems::Pendulum;
    use tpg_problems::arm::motors::{self, Motors};
    use tpg_problems::arm::targets::Start;

    fn small(preset: &str) -> Config {
        let mut config = presets::config(presets::find(preset).expect("a preset")).expect("it is accepted");
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

    fn motors(preset: &str) -> Motors {
        let settings: motors::Config = match preset {
            "paper-fs" => motors::Config {
                inputs: motors::Inputs::PaperFs,
                stuck_ends: false,
                repeat_most: 1,
                ..motors::Config::default()
            },
            _ => motors::Config::default(),
        };
        Motors::new(Start::Rs, settings, 9)
    }

    fn check_resumed<E: Environment<f32>>(environment: &E, config: &Config) {
        let folder = tempfile::tempdir().expect("a temporary folder");
        let path = folder.path().join("checkpoint.safetensors");
        let new = || Training::new(environment, config.clone(), 9).expect("an environment with outputs");
        let (mut undisturbed, mut stopped) = (new(), new());
        (0..100).for_each(|_| stopped.tick());
        save(&path, &stopped, &[serde_json::json!({"row": 1})]).expect("the folder can be written");
        let (mut resumed, log) = load(&path, environment, config, 9).expect("a good checkpoint");
        assert_eq!(log, [serde_json::json!({"row": 1})]);
        for training in [&mut undisturbed, &mut resumed] {
            while !training.finished() {
                training.tick();
            }
        }
        let bytes = |training: &Training<'_, E>| {
            let path = folder.path().join("end");
            save(&path, training, &[]).expect("the folder can be written");
            std::fs::read(path).expect("it was just written")
        };
        assert!(undisturbed.updates() > 40);
        assert_eq!(undisturbed.lanes.failures.places.len(), config.retry.map_or(0, |retry| retry.remembered));
        assert!(bytes(&undisturbed) == bytes(&resumed), "the checkpoints at the end differ");
    }

    #[test]
    fn a_stopped_run_ends_in_the_bytes_of_an_undisturbed_one() {
        for preset in ["best-rs", "paper-fs"] {
            check_resumed(&motors(preset), &small(preset));
        }
        check_resumed(&Pendulum, &small("general"));
    }

    #[test]
    fn a_checkpoint_of_another_seed_or_configuration_is_refused() {
        let config = small("general");
        let folder = tempfile::tempdir().expect("a temporary folder");
        let path = folder.path().join("checkpoint.safetensors");
        let mut training = Training::new(&Pendulum, config.clone(), 9).expect("a torque");
        training.tick();
        save(&path, &training, &[]).expect("the folder can be written");
        let refusal = |config: &Config, seed: u64| match load(&path, &Pendulum, config, seed) {
            Ok(_) => panic!("it is read"),
            Err(error) => error.to_string(),
        };
        assert!(refusal(&config, 10).contains("seed"));
        let mut other = config.clone();
        other.learning.rate = 0.5;
        assert!(refusal(&other, 9).contains("config"));
        let bytes = std::fs::read(&path).expect("it was just written");
        std::fs::write(&path, &bytes[..bytes.len() / 2]).expect("the folder can be written");
        assert!(refusal(&config, 9).contains("safetensors"));
    }
}
