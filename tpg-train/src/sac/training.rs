//! The training loop: lanes decide, the buffer remembers, the agent learns, candidates are validated.
//!
//! One [`tick`](Training::tick) lets every lane decide once. Nothing depends on the clock or on who computes it: a
//! tick's random numbers are a function of the seed and of how many decisions came before.

use super::agent::{Agent, Experience, Rates, Report, Workspace};
use super::config::{Algorithm, Config};
use super::lanes::{End, Lanes};
use super::policy::ActorPolicy;
use super::replay::{ACTIONS, Batch, Replay, Transition};
use serde::{Deserialize, Serialize};
use tpg_arm::WIDOWX;
use tpg_engine::random::{Purpose, Stream};
use tpg_nn::{Gaussian, Mlp, Samples, Tape};
use tpg_problems::arm::targets::{Reach, Set, Start, Task, tasks};
use tpg_problems::arm::trial::Trial;

/// A training run under way.
#[derive(Debug)]
pub struct Training {
    pub(super) config: Config,
    pub(super) seed: u64,
    pub(super) agent: Agent<f32>,
    /// The actor that is validated and kept, where it is an average of the one that learns.
    pub(super) average: Option<Mlp<f32>>,
    pub(super) replay: Replay,
    pub(super) lanes: Lanes,
    pub(super) decisions: u64,
    pub(super) updates: u64,
    pub(super) best: Option<Best>,
    /// What each validation so far found.
    pub(super) curve: Vec<Point>,
    /// Of the updates since the last [`Training::take_progress`].
    pub(super) recent: Recent,
    space: Space,
}

/// The best candidate so far.
#[derive(Clone, Debug, PartialEq)]
pub struct Best {
    /// Its success on validation tasks.
    pub score: f64,
    /// The decisions it was trained for.
    pub decisions: u64,
    /// Its actor.
    pub actor: Mlp<f32>,
}

/// What a validation found on the problem that counts.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
pub struct Point {
    /// The fraction of successes.
    pub success: f64,
    /// The mean final distance, mm.
    pub distance_mm: f64,
}

/// Sums over updates and episodes, for the log.
#[derive(Clone, Copy, Debug, Default, PartialEq, Serialize, Deserialize)]
pub struct Recent {
    /// Updates.
    pub updates: u64,
    /// Sums of the updates' reports.
    pub sums: Report,
    /// Episodes that reached their target.
    pub reached: u64,
    /// Episodes that ended by an invalid step.
    pub invalid: u64,
    /// Episodes that were cut off.
    pub cut: u64,
    /// Steps done.
    pub steps: u64,
}

/// Memory for acting and learning, none of it a part of a run's state.
#[derive(Debug)]
struct Space {
    acting: Tape<f32>,
    samples: Samples<f32>,
    update: Workspace<f32>,
    batch: Batch,
    noise: Vec<f32>,
    next_noise: Vec<f32>,
    before: Vec<f32>,
}

impl Space {
    fn new(config: &Config, agent: &Agent<f32>) -> Self {
        let (inputs, lanes, batch) = (config.actor.inputs.count(), config.learning.lanes, config.learning.batch);
        Self {
            acting: Tape::new(agent.actor.network.shape(), lanes),
            samples: Samples::default(),
            update: agent.workspace(batch),
            batch: Batch::new(inputs, batch),
            noise: vec![0.0; ACTIONS * batch.max(lanes)],
            next_noise: vec![0.0; ACTIONS * batch],
            before: vec![0.0; inputs * lanes],
        }
    }
}

impl Training {
    /// A run from the start.
    pub fn new(config: Config, seed: u64) -> Self {
        let inputs = config.actor.inputs.count();
        let gaussian = Gaussian { actions: ACTIONS, spread: config.actor.spread };
        let agent = Agent::new(&config, gaussian, &mut Stream::new(seed, 0, Purpose::Weights, 0));
        let replay = Replay::new(inputs, config.learning.replay);
        let lanes = Lanes::new(&config, seed, Reach::sample(&WIDOWX, seed, Set::Training));
        Self::of_parts(config, seed, agent, replay, lanes)
    }

    pub(super) fn of_parts(config: Config, seed: u64, agent: Agent<f32>, replay: Replay, lanes: Lanes) -> Self {
        let space = Space::new(&config, &agent);
        let recent = Recent::default();
        let curve = Vec::new();
        let average = config.learning.average.map(|_| agent.actor.network.clone());
        Self { config, seed, agent, average, replay, lanes, decisions: 0, updates: 0, best: None, curve, recent, space }
    }

    /// What is trained.
    pub fn config(&self) -> &Config {
        &self.config
    }

    /// Decisions done, of all lanes together.
    pub fn decisions(&self) -> u64 {
        self.decisions
    }

    /// Updates done.
    pub fn updates(&self) -> u64 {
        self.updates
    }

    /// Whether the run is over: it has its decisions, or its curve is flat.
    pub fn finished(&self) -> bool {
        self.decisions >= self.config.learning.decisions || self.flat()
    }

    /// Whether validations get no better: see [`Validation::flat_after`](super::config::Validation::flat_after).
    pub fn flat(&self) -> bool {
        flat(&self.curve, self.config.validation.flat_after)
    }

    /// The best candidate so far.
    pub fn best(&self) -> Option<&Best> {
        self.best.as_ref()
    }

    /// The sums since the last call.
    pub fn take_progress(&mut self) -> Recent {
        std::mem::take(&mut self.recent)
    }

    /// Lets every lane decide once, then does the updates that are due.
    pub fn tick(&mut self) {
        self.act();
        let learning = &self.config.learning;
        if self.decisions < learning.random_decisions {
            return;
        }
        let due = (self.decisions - learning.random_decisions) / learning.decisions_per_update;
        while self.updates < due {
            self.update();
        }
        if let Some(retry) = self.config.retry
            && self.decisions % retry.every < self.config.learning.lanes as u64
        {
            let policy = ActorPolicy::new(actor(&self.average, &self.agent), &self.config.actor);
            self.lanes.look_for_failures(&policy, &retry, self.decisions);
        }
    }

    fn act(&mut self) {
        let Self { config, seed, agent, replay, lanes, space, .. } = self;
        let inputs = config.actor.inputs;
        let width = inputs.count();
        let columns = space.acting.input_mut().chunks_exact_mut(width);
        columns.enumerate().for_each(|(lane, column)| lanes.observe(lane, inputs, column));
        space.before.copy_from_slice(space.acting.input_mut());
        let mut random = Stream::new(*seed, self.decisions, Purpose::Exploration, 0);
        let count = config.learning.lanes;
        let exploring = self.decisions < config.learning.random_decisions;
        if exploring {
            space.samples.actions.clear();
            space.samples.actions.extend((0..ACTIONS * count).map(|_| (2.0 * random.unit() - 1.0) as f32));
        } else {
            agent.actor.network.forward(&mut space.acting);
            let noise = &mut space.noise[..ACTIONS * count];
            random.normals(noise);
            agent.gaussian().sample(space.acting.output(), noise, &mut space.samples);
        }
        let mut next = vec![0.0; width];
        for lane in 0..count {
            let action: [f32; ACTIONS] = std::array::from_fn(|joint| space.samples.actions[lane * ACTIONS + joint]);
            let consequence = lanes.act(lane, action.map(libm::atanhf));
            lanes.observe(lane, inputs, &mut next);
            let goes_on = !matches!(consequence.end, Some(End::Reached | End::Invalid));
            let discount = libm::powf(config.learning.discount as f32, consequence.steps as f32);
            replay.push(Transition {
                state: &space.before[lane * width..][..width],
                action,
                reward: consequence.reward,
                discount: if goes_on { discount } else { 0.0 },
                next: &next,
            });
            self.recent.steps += u64::from(consequence.steps);
            match consequence.end {
                Some(End::Reached) => self.recent.reached += 1,
                Some(End::Invalid) => self.recent.invalid += 1,
                Some(End::Cut) => self.recent.cut += 1,
                None => continue,
            }
            lanes.renew(lane);
        }
        self.decisions += count as u64;
    }

    fn update(&mut self) {
        let learning = &self.config.learning;
        let space = &mut self.space;
        self.replay.draw(&mut Stream::new(self.seed, self.updates, Purpose::Replay, 0), &mut space.batch);
        let mut random = Stream::new(self.seed, self.updates, Purpose::Update, 0);
        let noise = &mut space.noise[..ACTIONS * learning.batch];
        random.normals(&mut space.next_noise);
        random.normals(noise);
        if learning.algorithm == Algorithm::ValueNetwork {
            // The artifact draws one number for a whole batch (`networks.cpp`, `rsample`).
            for noise in [&mut space.next_noise[..], noise] {
                noise.fill(noise[0]);
            }
        }
        let experience = Experience {
            states: &space.batch.states,
            actions: &space.batch.actions,
            rewards: &space.batch.rewards,
            discounts: &space.batch.discounts,
            next: &space.batch.next,
            next_noise: &space.next_noise,
            noise,
        };
        let done = (self.decisions as f64 / learning.decisions as f64).min(1.0);
        let rates = Rates {
            learning: learning.rate * (1.0 + (learning.final_rate - 1.0) * done),
            temperature: learning.temperature_rate,
            follow: learning.follow,
            target_entropy: learning.target_entropy,
        };
        let report = self.agent.update(&mut space.update, experience, &rates);
        self.updates += 1;
        if let (Some(average), Some(rate)) = (&mut self.average, learning.average) {
            average.follow(&self.agent.actor.network, rate as f32);
        }
        self.recent.add(report);
    }

    /// The policy as it stands.
    pub fn policy(&self) -> ActorPolicy<'_> {
        ActorPolicy::new(actor(&self.average, &self.agent), &self.config.actor)
    }

    /// Puts the actor as it stands to the validation tasks, and keeps it if it is the best so far. Where the rate falls,
    /// the last actor of a run is kept whatever its score: its rate is almost nothing, and the best of many noisy scores
    /// is mostly lucky (measured: chosen at 99.6 %, it did 98.5 % on fresh tasks, the last one 98.7 %).
    pub fn validate(&mut self, validation: &ValidationTasks) -> Vec<Trial> {
        let trials = validation.run(&self.policy());
        let weighted = |value: fn(&Trial) -> f64| -> f64 {
            trials.iter().zip(&validation.weights).map(|(trial, weight)| value(trial) * weight).sum()
        };
        let (score, distance_mm) = (weighted(|trial| trial.success_rate), weighted(|trial| trial.mean_distance_mm));
        self.curve.push(Point { success: score, distance_mm });
        let learning = &self.config.learning;
        let settled = self.decisions >= learning.decisions && learning.final_rate < 1.0;
        if settled || self.best.as_ref().is_none_or(|best| score >= best.score) {
            let actor = actor(&self.average, &self.agent).clone();
            self.best = Some(Best { score, decisions: self.decisions, actor });
        }
        trials
    }
}

/// The actor as it stands: the average, where there is one.
fn actor<'a>(average: &'a Option<Mlp<f32>>, agent: &'a Agent<f32>) -> &'a Mlp<f32> {
    average.as_ref().unwrap_or(&agent.actor.network)
}

/// Whether the last `window` points are no better than the `window` before them, neither in success nor in distance.
fn flat(curve: &[Point], window: usize) -> bool {
    let Some(first) = curve.len().checked_sub(2 * window) else { return false };
    let mean = |points: &[Point], value: fn(&Point) -> f64| points.iter().map(value).sum::<f64>() / window as f64;
    let (before, last) = curve[first..].split_at(window);
    let [success, distance] = [|point: &Point| point.success, |point: &Point| point.distance_mm];
    window > 0 && mean(last, success) <= mean(before, success) && mean(last, distance) >= mean(before, distance)
}

impl Recent {
    fn add(&mut self, report: Report) {
        self.updates += 1;
        self.sums.critic_loss += report.critic_loss;
        self.sums.actor_loss += report.actor_loss;
        self.sums.entropy += report.entropy;
        self.sums.temperature += report.temperature;
    }

    /// The means of the updates' reports.
    pub fn means(&self) -> Report {
        let count = self.updates.max(1) as f64;
        let Report { critic_loss, actor_loss, entropy, temperature } = self.sums;
        Report {
            critic_loss: critic_loss / count,
            actor_loss: actor_loss / count,
            entropy: entropy / count,
            temperature: temperature / count,
        }
    }
}

/// The validation tasks of a run: for each problem, and how much its success weighs.
#[derive(Clone, Debug)]
pub struct ValidationTasks {
    problems: Vec<(Start, Vec<Task>)>,
    weights: Vec<f64>,
}

impl ValidationTasks {
    /// For a run that shall do well on `problem`: the other start is watched, too, but does not choose.
    pub fn new(seed: u64, problem: Start, episodes: usize) -> Self {
        let starts = [Start::Fs, Start::Rs];
        let problems = starts.map(|start| (start, tasks(&WIDOWX, seed, Set::Validation, start, episodes)));
        Self { problems: problems.into(), weights: starts.map(|start| f64::from(u8::from(start == problem))).into() }
    }

    /// Runs a policy on all of them.
    pub fn run(&self, policy: &ActorPolicy<'_>) -> Vec<Trial> {
        let trial = |(start, tasks): &(Start, Vec<Task>)| policy.trial(*start, tasks);
        self.problems.iter().map(trial).collect()
    }
}

#[cfg(test)]
mod tests {
    use super::{Point, flat};

    fn curve(points: &[(f64, f64)]) -> Vec<Point> {
        points.iter().map(|&(success, distance_mm)| Point { success, distance_mm }).collect()
    }

    #[test]
    fn a_curve_is_flat_when_neither_success_nor_distance_gets_better() {
        let rising = curve(&[(0.1, 90.0), (0.2, 80.0), (0.3, 80.0), (0.3, 80.0)]);
        assert!(!flat(&rising, 2) && !flat(&rising[..3], 2) && !flat(&[], 2));
        let nearer = curve(&[(0.0, 90.0), (0.0, 80.0), (0.0, 80.0), (0.0, 70.0)]);
        assert!(!flat(&nearer, 2), "no success yet, but nearer");
        let still = curve(&[(0.1, 9.0), (0.4, 40.0), (0.3, 30.0), (0.2, 40.0), (0.4, 31.0)]);
        assert!(flat(&still, 2));
        assert!(!flat(&still, 0), "never, when it is turned off");
    }
}
