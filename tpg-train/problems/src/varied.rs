//! Problems made harder, or more like a real machine: other constants, late actions, noisy or missing sensors.

use crate::eights::{ByEight, number};
use crate::physics::Constants;
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};
use std::collections::{BTreeMap, BTreeSet, VecDeque};
use tpg_engine::random::{Purpose, Stream};
use tpg_engine::{Act, End, Environment, Episodes, Mapped, OneByOne, SourceSet, Step};
use tpg_graph::SourceDocument;
use tpg_graph::error::Finding;
use tpg_runtime::scalar::Scalar;

/// The section `[problem.disturbance]` of a configuration: whatever stands between a policy and the problem.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize, JsonSchema)]
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
    fn check(&self, sources: &[SourceDocument]) -> Result<(), Finding> {
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
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields, default)]
#[schemars(bound = "C: JsonSchema + Default + Serialize")]
pub struct VariedSettings<C> {
    /// The constants of the rules.
    pub physics: C,
    /// Delays, noise and hidden sources.
    pub disturbance: Disturbance,
}

impl<C: Constants> VariedSettings<C> {
    /// Puts an environment under these settings.
    pub(crate) fn around<E>(&self, environment: E) -> Varied<E, C> {
        Varied::new(environment, self.physics.clone(), self.disturbance.clone())
    }
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
    /// Puts `environment` under constants and disturbances.
    pub fn new(environment: E, constants: C, disturbance: Disturbance) -> Self {
        let is_standard = constants == C::default() && disturbance == Disturbance::default();
        Self { environment, constants, disturbance, is_standard }
    }

    /// Checks constants and disturbances.
    pub(crate) fn check(&self) -> Result<(), Finding>
    where
        E: Environment<f64>,
    {
        self.constants.check()?;
        self.disturbance.check(&self.environment.sources())
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

impl<T> VariedTask<T> {
    /// Returns the bare environment's task.
    fn start(&self) -> &T {
        let (Self::Standard(start) | Self::Varied { start, .. }) = self;
        start
    }
}

/// A running episode.
#[derive(Clone, Debug)]
pub struct VariedEpisode<S, P, Episode> {
    bare: Episode,
    /// None under standard constants without disturbances.
    variation: Option<Box<Variation<S, P>>>,
}

/// The constants and the noise of one episode.
#[derive(Clone, Debug)]
struct Variation<S, P> {
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

impl<S, E, C, const N: usize> Environment<S> for Varied<E, C>
where
    S: Scalar,
    E: ByEight<N> + Environment<S, Episode = [f64; N]>,
    C: Constants<Physics = E::Physics>,
{
    type Task = VariedTask<E::Task>;
    type Episode = VariedEpisode<S, E::Physics, E::Episode>;

    tpg_engine::forward!(this => this.environment; actions time_limit outcomes measure preference);

    fn sources(&self) -> Vec<SourceDocument> {
        let mut sources = self.environment.sources();
        sources.retain(|source| !self.disturbance.hidden.contains(&source.name));
        sources
    }

    fn timeout(&self, running: &Self::Episode) -> End {
        self.environment.timeout(&running.bare)
    }

    fn draw(&self, stream: &mut Stream) -> Self::Task {
        let start = self.environment.draw(stream);
        if self.is_standard { VariedTask::Standard(start) } else { VariedTask::Varied { start, seed: stream.bits() } }
    }

    fn start(&self, task: &Self::Task) -> Self::Episode {
        let (start, seed) = match task {
            VariedTask::Standard(start) if self.is_standard => {
                return VariedEpisode { bare: self.environment.start(start), variation: None };
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
            physics: self.constants.draw(&mut stream),
            stream,
            deviations: sources.iter().map(deviation).collect(),
            noise: vec![0.0; sources.len()],
            visible: (0..sources.len()).filter(is_visible).collect(),
            late: vec![rest; self.disturbance.delay.into()].into(),
            state: vec![S::ZERO; sources.len()],
        };
        variation.draw_noise();
        VariedEpisode { bare: self.environment.start(start), variation: Some(Box::new(variation)) }
    }

    fn observe(&self, running: &mut Self::Episode, wanted: SourceSet, state: &mut [S]) {
        let Some(variation) = &mut running.variation else {
            return self.environment.observe(&mut running.bare, wanted, state);
        };
        self.environment.observe(&mut running.bare, SourceSet::ALL, &mut variation.state);
        for (slot, &place) in state.iter_mut().zip(&variation.visible) {
            *slot = S::from_f64(variation.state[place].to_f64() + variation.noise[place]);
        }
    }

    fn step(&self, running: &mut Self::Episode, act: Act<'_, S>) -> Step {
        let Some(variation) = &mut running.variation else { return self.environment.step(&mut running.bare, act) };
        variation.draw_noise();
        variation.late.push_back(number(act));
        let act = variation.late.pop_front().expect("an action that was just added");
        E::step_under(&variation.physics, &mut running.bare, act)
    }

    fn distance(&self, running: &Self::Episode) -> Option<f64> {
        self.environment.distance(&running.bare)
    }

    fn lanes(&self) -> Box<dyn Episodes<S, Self::Task> + '_> {
        if !self.is_standard {
            return Box::new(OneByOne::new(self));
        }
        Box::new(Mapped::new(self.environment.lanes(), VariedTask::start))
    }
}

#[cfg(test)]
mod tests {
    use super::{Disturbance, Varied, VariedTask};
    use crate::amount::Amount;
    use crate::{Acrobot, CartPole, MountainCar, MountainCarContinuous, Pendulum};
    use crate::{acrobot, cartpole, mountain_car, mountain_car_continuous, pendulum};
    use tpg_engine::random::{Purpose, Stream};
    use tpg_engine::{Act, ActionSpace, Environment, SourceSet};
    use tpg_runtime::policy::ActionId;

    /// Returns what is observed and earned in the first steps of some episodes, under random actions.
    fn course<E: Environment<f64>>(environment: &E) -> Vec<u64> {
        let mut seen = Vec::new();
        for index in 0..20 {
            let mut stream = Stream::new(1, 0, Purpose::Test, index);
            let mut episode = environment.start(&environment.draw(&mut stream));
            let mut state = vec![0.0; environment.sources().len()];
            let mut choices = Stream::new(2, 0, Purpose::Test, index);
            for _ in 0..50 {
                environment.observe(&mut episode, SourceSet::ALL, &mut state);
                seen.extend(state.iter().map(|value| value.to_bits()));
                let step = match environment.actions() {
                    ActionSpace::Discrete(actions) => {
                        let action = ActionId(choices.below(actions.len()) as u16);
                        environment.step(&mut episode, Act::Choice(action))
                    }
                    _ => environment.step(&mut episode, Act::Values(&[2.0 * choices.unit() - 1.0])),
                };
                seen.push(step.reward.to_bits());
                if step.end.is_some() {
                    break;
                }
            }
        }
        seen
    }

    fn none() -> Disturbance {
        Disturbance::default()
    }

    #[test]
    fn under_standard_constants_every_bit_is_the_bare_problems() {
        assert_eq!(course(&Varied::new(CartPole, cartpole::Amounts::default(), none())), course(&CartPole));
        assert_eq!(course(&Varied::new(Acrobot, acrobot::Amounts::default(), none())), course(&Acrobot));
        assert_eq!(course(&Varied::new(MountainCar, mountain_car::Amounts::default(), none())), course(&MountainCar));
        assert_eq!(course(&Varied::new(Pendulum, pendulum::Amounts::default(), none())), course(&Pendulum));
        let car = Varied::new(MountainCarContinuous, mountain_car_continuous::Amounts::default(), none());
        assert_eq!(course(&car), course(&MountainCarContinuous));
    }

    #[test]
    fn constants_are_drawn_for_each_episode_and_a_task_keeps_them() {
        let mass = Amount::Between([0.5, 2.0]);
        let varied = Varied::new(Pendulum, pendulum::Amounts { mass, ..Default::default() }, none());
        let after = |task: &VariedTask<[f64; 2]>| {
            let mut running = Environment::<f64>::start(&varied, task);
            Environment::<f64>::step(&varied, &mut running, Act::Values(&[2.0]));
            let mut state = [0.0; 3];
            varied.observe(&mut running, SourceSet::ALL, &mut state);
            state
        };
        let task = |seed| VariedTask::Varied { start: [0.5, 0.0], seed };
        assert_eq!(after(&task(1)), after(&task(1)));
        assert_ne!(after(&task(1)), after(&task(2)));
        let drawn = Environment::<f64>::draw(&varied, &mut Stream::new(1, 0, Purpose::Test, 0));
        assert!(matches!(drawn, VariedTask::Varied { .. }));
    }

    #[test]
    fn a_late_action_takes_effect_after_the_delay() {
        let late = Varied::new(MountainCar, mountain_car::Amounts::default(), Disturbance { delay: 2, ..none() });
        let mut running = Environment::<f64>::start(&late, &VariedTask::Standard([-0.5, 0.0]));
        let mut bare = [-0.5, 0.0];
        // Two steps at rest, then what was decided two steps before.
        for (decided, taken) in [(2, 1), (0, 1), (1, 2), (1, 0)] {
            Environment::<f64>::step(&late, &mut running, Act::Choice(ActionId(decided)));
            Environment::<f64>::step(&MountainCar, &mut bare, Act::Choice(ActionId(taken)));
            assert_eq!(running.bare, bare);
        }
    }

    #[test]
    fn noise_is_the_same_however_often_it_is_looked_at_and_hidden_sources_are_missing() {
        let disturbance = Disturbance {
            hidden: ["sin_theta".to_owned()].into(),
            noise: [("omega".to_owned(), 0.5)].into(),
            ..none()
        };
        let varied = Varied::new(Pendulum, pendulum::Amounts::default(), disturbance);
        let names: Vec<String> = Environment::<f64>::sources(&varied).into_iter().map(|source| source.name).collect();
        assert_eq!(names, ["cos_theta", "omega"]);
        let mut errors = Vec::new();
        for seed in 0..2000 {
            let mut running = Environment::<f64>::start(&varied, &VariedTask::Varied { start: [0.0, 1.0], seed });
            let (mut first, mut second) = ([0.0; 2], [0.0; 2]);
            varied.observe(&mut running, SourceSet::ALL, &mut first);
            varied.observe(&mut running, SourceSet::ALL, &mut second);
            assert_eq!(first, second);
            assert_eq!(first[0], 1.0, "no noise where none is asked for");
            errors.push(first[1] - 1.0);
        }
        let variance = errors.iter().map(|error| error * error).sum::<f64>() / errors.len() as f64;
        assert!((variance - 0.25).abs() < 0.03, "{variance}");
    }
}
