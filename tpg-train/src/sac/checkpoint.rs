//! Checkpoints: all that a run needs to end in the same bytes as if it had never stopped.
//!
//! A safetensors file: networks, optimisers, replay buffer and best candidate as flat tensors, lanes and counters as
//! JSON. There is no random state: every stream is a function of the seed and the counters.

use super::agent::{Agent, Bootstrap, Learner};
use super::config::Config;
use super::lanes::Lanes;
use super::replay::{ACTIONS, Replay};
use super::tensors::{Tensor, Tensors};
use super::training::{Best, Point, Recent, Training};
use serde::{Deserialize, Serialize};
use std::path::Path;
use tpg_arm::{Pose, WIDOWX};
use tpg_engine::random::{Purpose, Stream};
use tpg_graph::error::{InputError, Place};
use tpg_nn::{Adam, Gaussian, Mlp, Shape};
use tpg_problems::arm::targets::{Reach, Set, Task};

const FORMAT: &str = "tpg-train sac checkpoint";
const VERSION: u32 = 3;
/// No checkpoint is larger, bytes: the largest replay buffer of the presets makes a sixth of it.
const LIMIT: u64 = 4 << 30;

/// Everything but the numbers of networks and buffer.
#[derive(Clone, Debug, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
struct State {
    format: String,
    version: u32,
    config: Config,
    seed: u64,
    decisions: u64,
    updates: u64,
    episodes: u64,
    replayed: u64,
    adam_steps: Vec<u64>,
    best: Option<(f64, u64)>,
    curve: Vec<Point>,
    recent: Recent,
    lanes: Vec<([i16; ACTIONS], [f64; 3], u32)>,
    failures: Vec<([i16; ACTIONS], [f64; 3])>,
    /// The rows of the log so far.
    log: Vec<serde_json::Value>,
}

/// Writes a checkpoint; the last good one stays until the new one is whole. `log` is kept for the run's log files.
///
/// # Errors
/// If it cannot be written.
pub fn save(path: &Path, training: &Training, log: &[serde_json::Value]) -> Result<(), InputError> {
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
        best: best.as_ref().map(|best| (best.score, best.decisions)),
        curve: curve.clone(),
        recent: *recent,
        lanes: lanes.lanes.iter().map(|lane| (lane.pose.0, lane.target, lane.steps)).collect(),
        failures: lanes.failures.places.iter().map(|task| (task.start.0, task.target)).collect(),
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

/// Reads a checkpoint and its log rows.
///
/// # Errors
/// If it cannot be read, is no checkpoint, or belongs to another configuration or seed.
pub fn load(path: &Path, config: &Config, seed: u64) -> Result<(Training, Vec<serde_json::Value>), InputError> {
    let tensors = Tensors::read(path, LIMIT)?;
    restore(tensors, config, seed).map_err(|(place, found, accepted)| {
        InputError::new(path.display().to_string(), Place::Path(place), found, accepted)
    })
}

type Refusal = (String, String, String);

fn restore(mut file: Tensors, config: &Config, seed: u64) -> Result<(Training, Vec<serde_json::Value>), Refusal> {
    let refuse = |place: &str, found: String, accepted: &str| (place.to_owned(), found, accepted.to_owned());
    let text = file.text.take().unwrap_or_default();
    let state: State = serde_json::from_str(&text)
        .map_err(|error| refuse("metadata.tpg", error.to_string(), "what this version of tpg-train wrote"))?;
    if state.format != FORMAT || state.version != VERSION {
        let found = format!("{:?}, version {}", state.format, state.version);
        return Err(refuse("metadata.tpg.format", found, &format!("{FORMAT:?}, version {VERSION}")));
    }
    if state.config != *config {
        let accepted = "the configuration that the run began with, or another --out";
        return Err(refuse("metadata.tpg.config", "another configuration".to_owned(), accepted));
    }
    if state.seed != seed {
        return Err(refuse("metadata.tpg.seed", state.seed.to_string(), &seed.to_string()));
    }
    let mut take = |name: &str, length: Option<usize>| -> Result<Vec<f32>, Refusal> {
        let tensor = file.tensors.remove(name);
        let values = tensor.ok_or_else(|| refuse(name, "nothing".to_owned(), "a tensor"))?.values;
        match length {
            Some(length) if length != values.len() => {
                Err(refuse(name, format!("{} numbers", values.len()), &format!("{length} numbers")))
            }
            _ => Ok(values),
        }
    };
    let gaussian = Gaussian { actions: ACTIONS, spread: config.actor.spread };
    // The weights drawn here are all overwritten: it is the shapes that count.
    let mut agent = Agent::new(config, gaussian, &mut Stream::new(seed, 0, Purpose::Weights, 0));
    let mut steps = state.adam_steps.iter().copied();
    let mut network = |name: &str, shape: &Shape| -> Result<Mlp<f32>, Refusal> {
        let parameters = take(name, Some(shape.parameters()))?;
        Ok(Mlp::from_parameters(shape.clone(), parameters).expect("as many parameters as the shape has"))
    };
    let few = || refuse("metadata.tpg.adam_steps", "too few".to_owned(), "one for each optimiser");
    {
        let Agent { actor, critics: [first, second], bootstrap, .. } = &mut agent;
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
            learner.network = network(name, &shape)?;
            let mean = network(&format!("{name}.adam.mean"), &shape)?.parameters().to_vec();
            let square = network(&format!("{name}.adam.square"), &shape)?.parameters().to_vec();
            let steps = steps.next().ok_or_else(few)?;
            learner.adam = Adam::from_state(steps, mean, square).expect("two vectors of one length");
        }
        for (name, follower) in followers {
            *follower = network(name, &follower.shape().clone())?;
        }
    }
    let actor = agent.actor.network.shape().clone();
    let average = config.learning.average.map(|_| network("average", &actor)).transpose()?;
    let best = match state.best {
        None => None,
        Some((score, decisions)) => Some(Best { score, decisions, actor: network("best", &actor)? }),
    };
    let temperature = take("temperature", Some(3))?;
    agent.log_alpha = temperature[0];
    let steps = steps.next().ok_or_else(few)?;
    agent.alpha_adam = Adam::from_state(steps, vec![temperature[1]], vec![temperature[2]]).expect("one number each");
    let inputs = config.actor.inputs.count();
    let replay = Replay::from_state(inputs, config.learning.replay, state.replayed, take("replay", None)?)
        .ok_or_else(|| refuse("replay", "another number of rows".to_owned(), "the rows that were replayed from"))?;
    let lanes: Vec<(Pose, [f64; 3], u32)> =
        state.lanes.iter().map(|&(pose, target, steps)| (Pose(pose), target, steps)).collect();
    if lanes.len() != config.learning.lanes {
        let accepted = config.learning.lanes.to_string();
        return Err(refuse("metadata.tpg.lanes", lanes.len().to_string(), &accepted));
    }
    let mut lanes = Lanes::resume(config, seed, Reach::sample(&WIDOWX, seed, Set::Training), state.episodes, &lanes);
    let failures = state.failures.into_iter().map(|(pose, target)| Task { start: Pose(pose), target });
    lanes.failures.places = failures.collect();
    let mut training = Training::of_parts(config.clone(), seed, agent, replay, lanes);
    training.average = average;
    training.decisions = state.decisions;
    training.updates = state.updates;
    training.best = best;
    training.curve = state.curve;
    training.recent = state.recent;
    Ok((training, state.log))
}

#[cfg(test)]
mod tests {
    use super::*;

    fn small(preset: &str) -> Config {
        let mut config = Config::preset(preset).expect("a preset");
        config.actor.hidden = vec![12, 10];
        config.critic.hidden = vec![14, 9];
        config.learning.lanes = 4;
        config.learning.random_decisions = 100;
        config.learning.batch = 16;
        config.learning.replay = 300; // less than there will be transitions: the ring must turn
        config.learning.decisions = 1000;
        if let Some(retry) = &mut config.retry {
            (retry.every, retry.random_starts, retry.fixed_starts, retry.remembered) = (150, 12, 4, 30);
        }
        config
    }

    #[test]
    fn a_stopped_run_ends_in_the_bytes_of_an_undisturbed_one() {
        for preset in ["best-rs", "paper-fs"] {
            let config = small(preset);
            let folder = tempfile::tempdir().expect("a temporary folder");
            let path = folder.path().join("checkpoint.safetensors");
            let mut undisturbed = Training::new(config.clone(), 9);
            let mut stopped = Training::new(config.clone(), 9);
            (0..100).for_each(|_| stopped.tick());
            save(&path, &stopped, &[serde_json::json!({"row": 1})]).expect("the folder can be written");
            let (mut resumed, log) = load(&path, &config, 9).expect("a good checkpoint");
            assert_eq!(log, [serde_json::json!({"row": 1})]);
            for training in [&mut undisturbed, &mut resumed] {
                while !training.finished() {
                    training.tick();
                }
            }
            let bytes = |training: &Training| {
                let path = folder.path().join("end");
                save(&path, training, &[]).expect("the folder can be written");
                std::fs::read(path).expect("it was just written")
            };
            assert!(undisturbed.updates() > 40);
            assert_eq!(undisturbed.lanes.failures.places.len(), config.retry.map_or(0, |retry| retry.remembered));
            assert!(bytes(&undisturbed) == bytes(&resumed), "{preset}: the checkpoints at the end differ");
        }
    }

    #[test]
    fn another_seed_gives_another_run_and_is_refused_for_a_checkpoint() {
        let config = small("best-rs");
        let folder = tempfile::tempdir().expect("a temporary folder");
        let path = folder.path().join("checkpoint.safetensors");
        let mut training = Training::new(config.clone(), 9);
        training.tick();
        save(&path, &training, &[]).expect("the folder can be written");
        let error = load(&path, &config, 10).expect_err("another seed");
        assert!(error.to_string().contains("seed"), "{error}");
        let mut other = config.clone();
        other.learning.rate = 1.0;
        assert!(load(&path, &other, 9).expect_err("another configuration").to_string().contains("config"));
        let bytes = std::fs::read(&path).expect("it was just written");
        std::fs::write(&path, &bytes[..bytes.len() / 2]).expect("the folder can be written");
        assert!(load(&path, &config, 9).is_err());
    }
}
