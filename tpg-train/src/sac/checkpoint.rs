//! The content of a checkpoint: all that a run needs to end in the same bytes as if it had never stopped.
//!
//! The bytes of a safetensors file: networks, optimisers, replay buffer and best candidate as flat tensors, tasks and
//! counters as JSON. A running episode is stored as its task and its actions so far, which are repeated. There is no random
//! state: every stream is a function of the seed and the counters.

use super::config::SacConfig;
use super::interface::Input;
use super::lanes::Lanes;
use super::replay::Replay;
use super::tensors::{Tensor, Tensors, place};
use super::training::{Best, Recent, Training, agent, interface};
use serde::{Deserialize, Serialize};
use tpg_engine::{Environment, Summary};
use tpg_graph::error::{Finding, InputError};
use tpg_nn::{Adam, Agent, Mlp, Shape};

/// Incremented with every change to the content or meaning of checkpoints.
pub const VERSION: u32 = 8;
/// No run counts further: sums of two such counts do not overflow, and `f64` holds them exactly.
const MOST: u64 = 1 << 53;

/// Everything except the tensors: networks, replay buffer, actions.
#[derive(Clone, Debug, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
struct State<Task> {
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
struct Header {
    config: SacConfig,
    seed: u64,
}

/// Returns the content of a checkpoint. `log` is kept for the run's log files.
///
/// # Panics
/// If a task of the environment cannot be written as JSON.
pub fn to_bytes<E: Environment<f32>>(training: &Training<'_, E>, log: &[serde_json::Value]) -> Vec<u8> {
    let Training { config, seed, agent, average, replay, lanes, decisions, updates, best, last, recent, .. } = training;
    let mut tensors = Tensors::default();
    let mut insert = |name: &str, values: &[f32]| {
        tensors.tensors.insert(name.to_owned(), Tensor::flat(values.to_vec()));
    };
    let mut adam_steps = Vec::new();
    for (name, learner) in LEARNERS.into_iter().zip([&agent.actor].into_iter().chain(&agent.critics)) {
        let (steps, mean, square) = learner.adam.state();
        insert(name, learner.network.parameters());
        insert(&format!("{name}.adam.mean"), mean);
        insert(&format!("{name}.adam.square"), square);
        adam_steps.push(steps);
    }
    for (name, network) in ["slow.0", "slow.1"].into_iter().zip(&agent.slow) {
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
        config: config.clone(),
        seed: *seed,
        decisions: *decisions,
        updates: *updates,
        episodes: lanes.episodes,
        replayed,
        adam_steps,
        best: best.as_ref().map(|best| (best.result, best.decisions)),
        last: *last,
        recent: recent.clone(),
        lanes: lanes.lanes.iter().map(|lane| (lane.task.clone(), lane.actions.len())).collect(),
        failures: lanes.failures.places.clone(),
        inputs: lanes.interface().inputs.clone(),
        log: log.to_vec(),
    };
    tensors.text = Some(serde_json::to_string(&state).expect("plain data"));
    tensors.to_bytes()
}

/// The names of what learns: the actor, then the critics.
const LEARNERS: [&str; 3] = ["actor", "critic.0", "critic.1"];

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
    Tensors::from_bytes(content)
        .and_then(|tensors| restore(tensors, environment, config, seed))
        .map_err(|finding| place(file.as_ref(), finding))
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
        let Agent { actor, critics, slow, .. } = agent;
        for (name, learner) in LEARNERS.into_iter().zip([actor].into_iter().chain(critics)) {
            let shape = learner.network.shape().clone();
            learner.network = self.network(name, &shape)?;
            let mean = self.take(&format!("{name}.adam.mean"), Some(shape.parameters()))?;
            let square = self.take(&format!("{name}.adam.square"), Some(shape.parameters()))?;
            let steps = steps.next().ok_or_else(few)?;
            learner.adam = Adam::from_state(steps, mean, square).expect("two vectors of one length");
        }
        for (name, follower) in ["slow.0", "slow.1"].into_iter().zip(slow) {
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
    config: &SacConfig,
    seed: u64,
) -> Result<Loaded<'e, E>, Finding> {
    let text = file.text.take().unwrap_or_default();
    check_header(&text, config, seed)?;
    let state: State<E::Task> = parse(&text)?;
    let interface = interface(environment, config)?;
    let (inputs, actions) = (interface.inputs.len(), interface.outputs.len());
    state.check(config, environment, actions).map_err(|finding| finding.within("metadata.tpg"))?;
    check_inputs(&state.inputs, &interface.inputs).map_err(|finding| finding.within("metadata.tpg"))?;
    let mut numbers = Numbers(file);
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
    let mut lanes = Lanes::empty(environment, interface, config, seed);
    let done = numbers.take("actions", Some(state.lanes.iter().map(|(_, count)| count).sum()))?;
    let mut done = done.as_slice();
    for (place, (task, count)) in state.lanes.into_iter().enumerate() {
        let (of_lane, rest) = done.split_at(count);
        if let Some(action) = of_lane.iter().find(|action| !(-1.0..=1.0).contains(*action)) {
            return Err(Finding::new("actions", action, "-1 to 1"));
        }
        if !lanes.resume(task, of_lane) {
            let key = format!("metadata.tpg.lanes[{place}]");
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
        .map_err(|error| Finding::new("metadata.tpg", error, "the text that this version of tpg-train writes"))
}

impl<Task> State<Task> {
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
    let header: Header = parse(text)?;
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
        assert!(undisturbed.updates() > 40);
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
        assert!(refusal(&whole[..whole.len() / 2], &config, 9).contains("safetensors"));
    }
}
