//! The training loop: lanes decide, the buffer remembers, the agent learns, candidates are validated.
//!
//! One [`tick`](Training::tick) lets every lane decide once. Nothing depends on the clock or on who computes it: a
//! tick's random numbers are a function of the seed and of how many decisions came before.

use super::config::{Learning, SacConfig};
use super::contract::{Contract, NetworkOrigin};
use super::failures::look;
use super::interface::Interface;
use super::lanes::TrainingLanes;
use super::network::Network;
use super::policy::NetworkPolicy;
use super::replay::Replay;
use serde::{Deserialize, Serialize};
use std::ops::ControlFlow;
use tpg_engine::random::{Purpose, Stream};
use tpg_engine::{Environment, Preference, Summary, TaskSet, tasks};
use tpg_graph::error::Finding;
use tpg_nn::{Agent, Gaussian, Mlp, Rates, Samples, Tape, UpdateFigures, Workspace};

/// A running training.
pub(crate) struct Training<'e, E: Environment<f32>> {
    pub(super) config: SacConfig,
    pub(super) seed: u64,
    pub(super) agent: Agent,
    /// The actor that is validated and kept, if it is an average of the learning one.
    pub(super) average: Option<Mlp>,
    pub(super) replay: Replay,
    pub(super) lanes: TrainingLanes<'e, E>,
    pub(super) decisions: u64,
    pub(super) updates: u64,
    pub(super) best: Option<BestActor>,
    /// The result of the newest validation.
    pub(super) last: Option<Summary>,
    /// Sums since the last row of the log.
    pub(super) recent: Recent,
    /// Scratch memory for acting and learning; not part of a run's state.
    acting: Tape,
    samples: Samples,
    workspace: Workspace,
}

/// The best candidate so far.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub(crate) struct BestActor {
    /// Its result on the validation tasks.
    pub result: Summary,
    /// The decisions it was trained for.
    pub decisions: u64,
    /// Its actor.
    pub actor: Mlp,
}

/// Sums over updates, for the log.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize)]
pub(crate) struct Recent {
    /// Updates.
    pub updates: u64,
    /// Sums of the updates' reports.
    pub sums: UpdateFigures,
}

impl<'e, E: Environment<f32>> Training<'e, E> {
    /// Starts a run.
    ///
    /// # Errors
    /// If the environment's actions are not outputs, or it does not have what the configuration asks for.
    pub(crate) fn new(environment: &'e E, config: SacConfig, seed: u64) -> Result<Self, Finding> {
        let interface = interface(environment, &config)?;
        let (inputs, actions) = (interface.inputs.len(), interface.outputs.len());
        let agent = agent(&config, &interface, seed);
        let replay = Replay::new(inputs, actions, config.learning.replay);
        let lanes = TrainingLanes::new(environment, interface, &config, seed);
        let acting = Tape::new(agent.actor.network.shape(), config.learning.lanes);
        let (samples, workspace) = (Samples::default(), agent.workspace(config.learning.batch));
        let recent = Recent::default();
        let average = config.learning.average.map(|_| agent.actor.network.clone());
        let (decisions, updates, best, last) = (0, 0, None, None);
        Ok(Self {
            config,
            seed,
            agent,
            average,
            replay,
            lanes,
            decisions,
            updates,
            best,
            last,
            recent,
            acting,
            samples,
            workspace,
        })
    }

    /// Returns the contract of a candidate; `name` is the configuration's, `problem` that of the problem.
    pub(super) fn contract(&self, best: &BestActor, name: &str, problem: &str) -> Contract {
        let provenance = NetworkOrigin {
            tool: concat!("tpg-train ", env!("CARGO_PKG_VERSION")).to_owned(),
            config: name.to_owned(),
            problem: problem.to_owned(),
            seed: self.seed,
            decisions: best.decisions,
            validation: Some(best.result),
        };
        Contract::new(self.config.problem.clone(), &self.lanes.interface, self.config.actor.clone(), provenance)
    }

    /// True when the run has its decisions.
    pub(crate) fn finished(&self) -> bool {
        self.decisions >= self.config.learning.decisions
    }

    /// Lets every lane decide once, as [`tick`](Self::tick); returns true if a validation is due.
    pub(super) fn tick_to_validation(&mut self) -> bool {
        let every = self.config.validation.every;
        let before = self.decisions / every;
        self.tick();
        self.decisions / every > before
    }

    /// Lets every lane decide once, then does the updates that are due.
    pub(crate) fn tick(&mut self) {
        let began = self.decisions;
        self.act();
        let learning = &self.config.learning;
        if self.decisions < learning.random_decisions {
            return;
        }
        if learning.measured_inputs && began < learning.random_decisions {
            self.measure_inputs();
        }
        let learning = &self.config.learning;
        let due = (self.decisions - learning.random_decisions) / learning.decisions_per_update;
        while self.updates < due {
            self.update();
        }
        if let Some(retry) = self.config.retry
            && self.decisions % retry.every < self.config.learning.lanes as u64
        {
            let mut failures = std::mem::take(&mut self.lanes.failures);
            look(&mut failures, &self.policy(), self.lanes.environment, &retry, self.seed, self.decisions);
            self.lanes.failures = failures;
        }
    }

    /// Scales inputs by what was seen so far, and the states that are remembered with them.
    fn measure_inputs(&mut self) {
        let before = self.lanes.interface.inputs.clone();
        self.lanes.interface.measure(&self.replay.moments());
        self.replay.map_states(|state| {
            for (value, input) in state.iter_mut().zip(&before) {
                *value = *value / input.scale + input.offset;
            }
            self.lanes.interface.scale(state);
        });
    }

    fn act(&mut self) {
        let Self { config, seed, agent, replay, lanes, acting, samples, .. } = self;
        let (width, actions) = (agent.actor.network.shape().inputs, agent.gaussian().actions);
        let columns = acting.input_mut().chunks_exact_mut(width);
        columns.enumerate().for_each(|(lane, column)| lanes.observe(lane, column));
        let before = acting.input_mut().to_vec();
        let count = config.learning.lanes;
        let mut random = Stream::new(*seed, self.decisions, Purpose::Exploration, 0);
        if self.decisions < config.learning.random_decisions {
            samples.actions = (0..actions * count).map(|_| (2.0 * random.unit() - 1.0) as f32).collect();
        } else {
            agent.actor.network.forward(acting);
            let mut noise = vec![0.0; actions * count];
            random.normals(&mut noise);
            agent.gaussian().sample(acting.output(), &noise, samples);
        }
        let mut next = vec![0.0; width];
        for (lane, action) in samples.actions.chunks_exact(actions).enumerate() {
            let step = lanes.act(lane, action);
            lanes.observe(lane, &mut next);
            let goes_on = step.end.is_none_or(|end| end.truncated);
            let discount = libm::powf(config.learning.discount as f32, step.repeats as f32);
            let discount = if goes_on { discount } else { 0.0 };
            replay.push(&before[lane * width..][..width], action, [step.reward as f32, discount], &next);
            if step.end.is_some() {
                lanes.renew(lane);
            }
        }
        self.decisions += count as u64;
    }

    fn update(&mut self) {
        let learning = &self.config.learning;
        let actions = self.agent.gaussian().actions;
        let mut batch = self.replay.draw(&mut Stream::new(self.seed, self.updates, Purpose::Replay, 0), learning.batch);
        let mut random = Stream::new(self.seed, self.updates, Purpose::Update, 0);
        for noise in [&mut batch.next_noise, &mut batch.noise] {
            noise.resize(actions * learning.batch, 0.0);
            random.normals(noise);
        }
        let done = (self.decisions as f64 / learning.decisions as f64).min(1.0);
        let target_entropy = target_entropy(learning, actions, done);
        let rates = Rates {
            learning: learning.rate * (1.0 + (learning.final_rate - 1.0) * done),
            temperature: learning.temperature_rate,
            follow: learning.follow,
            target_entropy,
        };
        let report = self.agent.update(&mut self.workspace, &batch, &rates);
        self.updates += 1;
        if let (Some(average), Some(rate)) = (&mut self.average, learning.average) {
            average.follow(&self.agent.actor.network, rate as f32);
        }
        self.recent.add(report);
    }

    /// Returns the current actor: the average, if there is one.
    fn actor(&self) -> &Mlp {
        self.average.as_ref().unwrap_or(&self.agent.actor.network)
    }

    /// Returns the current policy.
    pub(crate) fn policy(&self) -> NetworkPolicy<'_> {
        NetworkPolicy::new(self.actor(), self.lanes.interface.clone())
    }

    /// Lets the actor as it stands try the validation tasks, and keeps it if it is the best so far. Where the rate falls,
    /// the last actor of a run is kept whatever its result: its rate is almost nothing, and the best of many noisy results
    /// is mostly lucky (measured on the arm: chosen at 99.6 %, it did 98.5 % on fresh tasks, the last one 98.7 %).
    pub(crate) fn validate(&mut self, tasks: &[E::Task]) -> Summary {
        let environment = self.lanes.environment;
        let policy = self.policy();
        let endings: Vec<_> = tasks.iter().map(|task| policy.watch(environment, task, |_| ())).collect();
        let result = Summary::new(&endings);
        self.last = Some(result);
        let learning = &self.config.learning;
        let settled = self.decisions >= learning.decisions && learning.final_rate < 1.0;
        let as_good = |best: &BestActor| result.compare(&best.result, environment.preference()).is_ge();
        if settled || self.best.as_ref().is_none_or(as_good) {
            self.best = Some(BestActor { result, decisions: self.decisions, actor: self.actor().clone() });
        }
        result
    }
}

/// Trains a network on an environment of your own, and returns it with its result on the validation tasks. `watch` is called after
/// every decision of all lanes; if it returns `Break`, the training ends. `name` is the configuration's in the network's file.
///
/// ```
/// use std::ops::ControlFlow;
/// use tpg_problems::Pendulum;
/// use tpg_train::{Configuration as _, SacConfig, train_network};
///
/// let mut config = SacConfig::preset("general")?;
/// (config.learning.decisions, config.learning.random_decisions) = (300, 100);
/// config.validation.episodes = 2;
/// let (_network, result) = train_network(&Pendulum, config, "short", 1, || ControlFlow::Continue(()))?;
/// assert_eq!(result.episodes, 2);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
///
/// # Errors
/// If the environment's actions are not outputs, or the training ended before a validation.
pub fn train_network<E: Environment<f32>>(
    environment: &E,
    config: SacConfig,
    name: &str,
    seed: u64,
    mut watch: impl FnMut() -> ControlFlow<()>,
) -> Result<(Network, Summary), Finding> {
    let mut training = Training::new(environment, config, seed)?;
    let validation = tasks(environment, TaskSet::Validation, 0, training.config.validation.episodes);
    while !training.finished() {
        if training.tick_to_validation() || training.finished() {
            training.validate(&validation);
        }
        if watch().is_break() {
            break;
        }
    }
    let early = || Finding::new("learning.decisions", training.decisions, "enough for a validation");
    let best = training.best.as_ref().ok_or_else(early)?;
    let network = Network::Float(Box::new((best.actor.clone(), training.contract(best, name, ""))));
    Ok((network, best.result))
}

/// Returns the target entropy when a fraction of the run is `done`.
fn target_entropy(learning: &Learning, actions: usize, done: f64) -> f64 {
    let target = learning.target_entropy.unwrap_or(-(actions as f64));
    match learning.exploring_entropy {
        Some(each) => target + (actions as f64 * each - target) * (1.0 - done),
        _ => target,
    }
}

/// Returns the interface that a configuration asks for.
pub(super) fn interface(environment: &impl Environment<f32>, config: &SacConfig) -> Result<Interface, Finding> {
    if config.retry.is_some() && environment.preference() != Preference::Success {
        return Err(Finding::new(
            "retry",
            "episodes that begin where one failed",
            "none: this problem knows no failure",
        ));
    }
    Interface::new(environment, config.actor.scaled_inputs)
}

/// Creates the agent with the run's initial weights.
pub(super) fn agent(config: &SacConfig, interface: &Interface, seed: u64) -> Agent {
    let gaussian = Gaussian { actions: interface.outputs.len() };
    let mut random = Stream::new(seed, 0, Purpose::Weights, 0);
    let hidden = [&config.actor.hidden[..], &config.critic.hidden];
    let log_alpha = config.learning.log_temperature;
    Agent::random(interface.inputs.len(), hidden, gaussian, log_alpha, || random.unit())
}

impl Recent {
    fn add(&mut self, report: UpdateFigures) {
        self.updates += 1;
        self.sums.critic_loss += report.critic_loss;
        self.sums.actor_loss += report.actor_loss;
        self.sums.entropy += report.entropy;
        self.sums.temperature += report.temperature;
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::configuration::Configuration as _;
    use tpg_problems::Pendulum;

    fn long() -> SacConfig {
        let mut config = SacConfig::preset("long").expect("a preset");
        config.learning.random_decisions = 500;
        config
    }

    #[test]
    fn the_target_entropy_falls() {
        let learning = long().learning;
        let values = [0.0, 0.5, 1.0].map(|done| target_entropy(&learning, 2, done));
        assert_eq!(values, [0.0, -1.0, -2.0]);
        assert_eq!(target_entropy(&Learning { exploring_entropy: None, ..learning }, 2, 0.0), -2.0);
    }

    #[test]
    fn inputs_are_measured_once_after_the_random_decisions() {
        let mut training = Training::new(&Pendulum, long(), 3).expect("a torque");
        let declared = training.lanes.interface.clone();
        while training.decisions < 498 {
            training.tick();
        }
        let mut seen = training.replay.clone();
        assert_eq!(training.lanes.interface, declared);
        training.tick();
        let measured = training.lanes.interface.clone();
        for moments in training.replay.moments() {
            assert!(moments.mean.abs() < 1e-4 && (moments.deviation() - 1.0).abs() < 1e-4, "{moments:?}");
        }
        // The states themselves are the same, by the policy's own scale.
        let (mut before, mut after) = (Vec::new(), Vec::new());
        seen.map_states(|state| {
            let raw: Vec<f32> =
                (declared.inputs.iter().zip(&*state)).map(|(input, &x)| x / input.scale + input.offset).collect();
            state.copy_from_slice(&raw);
            measured.scale(state);
            before.extend_from_slice(state);
        });
        training.replay.map_states(|state| after.extend_from_slice(state));
        assert!(before.iter().zip(&after).all(|(a, b)| (a - b).abs() < 1e-5));
        (0..200).for_each(|_| training.tick());
        assert_eq!(training.lanes.interface, measured);
    }

    #[test]
    fn a_few_thousand_decisions_swing_the_pendulum_up() {
        let config = SacConfig::preset("general").expect("a preset");
        let mut training = Training::new(&Pendulum, config, 1).expect("a torque");
        let tasks = tasks::<f32, _>(&Pendulum, TaskSet::Validation, 0, 50);
        let decisions = tpg_testing::amount(5000, 8000);
        let mut score = || -> [f64; 2] {
            let before: Summary = training.validate(&tasks);
            while training.decisions < decisions {
                training.tick();
            }
            [before.score, training.validate(&tasks).score]
        };
        let [before, after] = score();
        assert!(before < -900.0 && after > -400.0, "{before} before, {after} after");
    }
}
