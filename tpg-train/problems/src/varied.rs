//! Problems made harder, or more like a real machine: other constants, late actions, noisy or missing sensors.

use crate::physics::Constants;
use serde::{Deserialize, Serialize};
use std::collections::{BTreeMap, BTreeSet, VecDeque};
use tpg_engine::random::{Purpose, Stream};
use tpg_engine::{Act, ActionSpace, End, Environment, Measure, Preference, SourceSet, Step};
use tpg_graph::SourceDocument;
use tpg_graph::error::Finding;
use tpg_runtime::policy::ActionId;
use tpg_runtime::scalar::Scalar;

/// An environment whose rules have constants. Its sources have one value each, and it has named actions or one output.
pub trait Adjustable<S: Scalar>: Environment<S> {
    /// The constants.
    type Physics: Copy + Send + Sync;

    /// The named action that does least; until a late action arrives, it is taken. With an output, 0 is.
    const REST: u16;

    /// Takes one action, as [`Environment::step`] does with the standard constants.
    fn step_under(&self, physics: &Self::Physics, episode: &mut Self::Episode, act: Act<'_, S>) -> Step;
}

/// The section `[problem.disturbance]` of a configuration: whatever stands between a policy and the problem.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields, default)]
pub struct Disturbance {
    /// Number of steps from a decision until it takes effect, 0 to 100.
    pub delay: u16,
    /// Names of the sources that a policy cannot read.
    pub hidden: BTreeSet<String>,
    /// Standard deviation of the noise of a source, by its name, in the source's own unit.
    pub noise: BTreeMap<String, f64>,
}

impl Disturbance {
    /// Checks the settings for a problem with these sources.
    ///
    /// # Errors
    /// A value out of range, an unknown source, or no source left.
    pub fn check(&self, sources: &[SourceDocument]) -> Result<(), Finding> {
        Finding::range("problem.disturbance.delay", self.delay, 0, 100)?;
        let known = || sources.iter().map(|source| source.name.as_str()).collect::<Vec<_>>();
        let one_of = || format!("one of {}", known().join(", "));
        if let Some(name) = self.hidden.iter().find(|name| !known().contains(&name.as_str())) {
            return Err(Finding::new("problem.disturbance.hidden", format!("{name:?}"), one_of()));
        }
        if self.hidden.len() == sources.len() {
            return Err(Finding::new("problem.disturbance.hidden", "every source", "at least one source left"));
        }
        for (name, &deviation) in &self.noise {
            if !known().contains(&name.as_str()) {
                return Err(Finding::new("problem.disturbance.noise", format!("{name:?}"), one_of()));
            }
            Finding::range(&format!("problem.disturbance.noise.{name}"), deviation, 0.0, 1e6)?;
        }
        Ok(())
    }
}

/// The section `[problem]` of a configuration for a problem without settings of its own.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields, default)]
pub struct Settings<C> {
    /// The constants of the rules.
    pub physics: C,
    /// Delays, noise and hidden sources.
    pub disturbance: Disturbance,
}

/// An environment under given constants and disturbances. With the standard ones, every number is the bare environment's.
///
/// ```
/// use tpg_engine::Environment;
/// use tpg_problems::varied::{Disturbance, Varied};
/// use tpg_problems::{Pendulum, pendulum};
///
/// // A pendulum of unknown mass without a sensor of its velocity.
/// let physics = pendulum::Amounts { mass: tpg_problems::amount::Amount::Between([0.8, 1.2]), ..Default::default() };
/// let disturbance = Disturbance { hidden: ["omega".to_owned()].into(), ..Disturbance::default() };
/// let blind = Varied::new(Pendulum, physics, disturbance);
/// assert_eq!(Environment::<f32>::sources(&blind).len(), 2);
/// ```
#[derive(Clone, Debug)]
pub struct Varied<E, C> {
    environment: E,
    constants: C,
    disturbance: Disturbance,
    is_standard: bool,
}

impl<E, C: Constants> Varied<E, C> {
    /// Puts `environment` under constants and disturbances, which have been checked.
    pub fn new(environment: E, constants: C, disturbance: Disturbance) -> Self {
        let is_standard = constants == C::default() && disturbance == Disturbance::default();
        Self { environment, constants, disturbance, is_standard }
    }
}

/// A task: that of the bare environment, with the seed of everything that varies in the episode.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(untagged)]
pub enum VariedTask<T> {
    /// Under standard constants without disturbances.
    Standard(T),
    /// Under others.
    Varied {
        /// The bare environment's task.
        start: T,
        /// Seed of constants and noise.
        seed: u64,
    },
}

/// A running episode.
#[derive(Clone, Debug)]
pub struct Trial<S, P, Episode> {
    bare: Episode,
    /// None under standard constants without disturbances.
    variation: Option<Box<Variation<S, P>>>,
}

/// The constants and the noise of one episode.
#[derive(Clone, Debug)]
struct Variation<S, P> {
    seed: u64,
    physics: P,
    stream: Stream,
    /// Standard deviation of the noise of each source of the bare environment.
    deviations: Vec<f64>,
    /// The noise of each source until the next action.
    noise: Vec<f64>,
    /// The sources that a policy can read, by place.
    visible: Vec<usize>,
    /// Decisions that have not taken effect: numbers of actions, or values of the output.
    late: VecDeque<f64>,
    /// The bare environment's observation.
    state: Vec<S>,
}

impl<S: Scalar, P> Variation<S, P> {
    fn draw_noise(&mut self) {
        for (noise, deviation) in self.noise.iter_mut().zip(&self.deviations).filter(|(_, deviation)| **deviation > 0.0)
        {
            *noise = deviation * self.stream.normal();
        }
    }
}

impl<S: Scalar, E: Adjustable<S>, C: Constants<Physics = E::Physics>> Environment<S> for Varied<E, C> {
    type Task = VariedTask<E::Task>;
    type Episode = Trial<S, E::Physics, E::Episode>;

    fn sources(&self) -> Vec<SourceDocument> {
        let mut sources = self.environment.sources();
        sources.retain(|source| !self.disturbance.hidden.contains(&source.name));
        sources
    }

    fn actions(&self) -> ActionSpace {
        self.environment.actions()
    }

    fn time_limit(&self) -> u32 {
        self.environment.time_limit()
    }

    fn outcomes(&self) -> &'static [&'static str] {
        self.environment.outcomes()
    }

    fn timeout(&self, trial: &Self::Episode) -> End {
        self.environment.timeout(&trial.bare)
    }

    fn measure(&self) -> Option<Measure> {
        self.environment.measure()
    }

    fn preference(&self) -> Preference {
        self.environment.preference()
    }

    fn draw(&self, stream: &mut Stream) -> Self::Task {
        let start = self.environment.draw(stream);
        if self.is_standard { VariedTask::Standard(start) } else { VariedTask::Varied { start, seed: stream.bits() } }
    }

    fn start(&self, task: &Self::Task) -> Self::Episode {
        let (start, seed) = match task {
            VariedTask::Standard(start) if self.is_standard => {
                return Trial { bare: self.environment.start(start), variation: None };
            }
            VariedTask::Standard(start) => (start, 0),
            VariedTask::Varied { start, seed } => (start, *seed),
        };
        let mut stream = Stream::new(seed, 0, Purpose::Variation, 0);
        let sources = self.environment.sources();
        let deviation = |source: &SourceDocument| self.disturbance.noise.get(&source.name).copied().unwrap_or(0.0);
        let is_visible = |&place: &usize| !self.disturbance.hidden.contains(&sources[place].name);
        let rest = if self.environment.actions().outputs().is_empty() { f64::from(E::REST) } else { 0.0 };
        let mut variation = Variation {
            seed,
            physics: self.constants.draw(&mut stream),
            stream,
            deviations: sources.iter().map(deviation).collect(),
            noise: vec![0.0; sources.len()],
            visible: (0..sources.len()).filter(is_visible).collect(),
            late: vec![rest; self.disturbance.delay.into()].into(),
            state: vec![S::ZERO; sources.len()],
        };
        variation.draw_noise();
        Trial { bare: self.environment.start(start), variation: Some(Box::new(variation)) }
    }

    fn observe(&self, trial: &mut Self::Episode, wanted: SourceSet, state: &mut [S]) {
        let Some(variation) = &mut trial.variation else {
            return self.environment.observe(&mut trial.bare, wanted, state);
        };
        self.environment.observe(&mut trial.bare, SourceSet::ALL, &mut variation.state);
        for (slot, &place) in state.iter_mut().zip(&variation.visible) {
            *slot = S::from_f64(variation.state[place].to_f64() + variation.noise[place]);
        }
    }

    fn step(&self, trial: &mut Self::Episode, act: Act<'_, S>) -> Step {
        let Some(variation) = &mut trial.variation else { return self.environment.step(&mut trial.bare, act) };
        variation.draw_noise();
        let physics = variation.physics;
        match act {
            Act::Choice(ActionId(action)) => {
                variation.late.push_back(action.into());
                let action = variation.late.pop_front().map_or(action, |action| action as u16);
                self.environment.step_under(&physics, &mut trial.bare, Act::Choice(ActionId(action)))
            }
            Act::Values(&[value]) => {
                variation.late.push_back(value.to_f64());
                let value = variation.late.pop_front().map_or(value, S::from_f64);
                self.environment.step_under(&physics, &mut trial.bare, Act::Values(&[value]))
            }
            Act::Values(_) | Act::Choices(_) => self.environment.step_under(&physics, &mut trial.bare, act),
        }
    }

    fn task_from(&self, trial: &Self::Episode) -> Option<Self::Task> {
        let start = self.environment.task_from(&trial.bare)?;
        Some(match &trial.variation {
            None => VariedTask::Standard(start),
            Some(variation) => VariedTask::Varied { start, seed: variation.seed },
        })
    }

    fn distance(&self, trial: &Self::Episode) -> Option<f64> {
        self.environment.distance(&trial.bare)
    }
}
