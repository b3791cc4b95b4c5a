//! The arm among balls as an [`Environment`].

use super::BODY;
use super::config::DodgeConfig;
use super::draw::{Generator, LIMIT, SEED, TRIES, scenes};
use super::episode::{self, Episode, OUTCOMES};
use super::scene::Scene;
use crate::arm::drawing;
use crate::arm::targets::Set;
use tpg_arm::dodge::{Behaviour, DodgeSource, Dodger};
use tpg_engine::random::Stream;
use tpg_engine::{Act, ActionSpace, End, Environment, Measure, Preference, SourceSet, Step, TaskSet, Training};
use tpg_graph::SourceDocument;
use tpg_runtime::scalar::Scalar;

/// Reward of a success, a hit and the end of the time.
const REWARDS: [f64; 3] = [10.0, -20.0, -15.0];
/// Reward of every step that a success leaves.
const UNUSED: f64 = 0.005;
/// Cost of every millimetre from the target at the end of a failure.
const FAR: f64 = 0.05;

/// The environment.
#[derive(Clone, Debug)]
pub struct Dodge {
    config: DodgeConfig,
}

/// A running episode: the rules' part, and what the controller remembers.
#[derive(Clone, Debug)]
pub struct DodgeEpisode {
    episode: Episode,
    dodger: Dodger,
}

impl Dodge {
    /// Creates the environment; the settings have been checked.
    pub fn new(config: &DodgeConfig) -> Self {
        Self { config: config.clone() }
    }
}

impl<S: Scalar> Environment<S> for Dodge {
    type Task = Scene;
    type Episode = DodgeEpisode;

    fn sources(&self) -> Vec<SourceDocument> {
        DodgeSource::ALL.into_iter().map(document).collect()
    }

    fn actions(&self) -> ActionSpace {
        ActionSpace::discrete(Behaviour::ALL.map(Behaviour::name))
    }

    fn outcomes(&self) -> &'static [&'static str] {
        &OUTCOMES
    }

    fn measure(&self) -> Option<Measure> {
        Some(crate::arm::problem::DISTANCE)
    }

    fn preference(&self) -> Preference {
        Preference::Score
    }

    fn time_limit(&self) -> u32 {
        LIMIT
    }

    fn draw(&self, stream: &mut Stream) -> Scene {
        Generator::new(&self.config, SEED, Set::Training).draw(stream, TRIES).scene
    }

    fn training(&self) -> Option<&dyn Training<Scene>> {
        Some(self)
    }

    fn moment(&self, running: &DodgeEpisode) -> Vec<f64> {
        let episode = &running.episode;
        let balls = episode.balls().iter().map(|ball| [ball.at[0], ball.at[1], ball.at[2], ball.radius]);
        let mut moment = drawing::moment(episode.pose(), episode.target().map(f64::from));
        moment.extend(balls.flatten().map(f64::from));
        moment
    }

    fn accepts(&self, scene: &Scene) -> bool {
        let is_on_the_arm = |pose: &[i16; 4]| pose.iter().zip(&BODY.arm.ranges).all(|(&t, range)| range.contains(t));
        !scene.goals.is_empty() && scene.goals.iter().chain([&scene.start]).all(is_on_the_arm)
    }

    fn start(&self, scene: &Scene) -> DodgeEpisode {
        let episode = Episode::new(scene);
        let dodger = Dodger::new(self.config.settings(), &episode.view());
        DodgeEpisode { episode, dodger }
    }

    fn observe(&self, running: &mut DodgeEpisode, _wanted: SourceSet, state: &mut [S]) {
        let values = running.dodger.observe(&running.episode.view());
        state.iter_mut().zip(values).for_each(|(slot, value)| *slot = S::from_f64(f64::from(value)));
    }

    fn step(&self, running: &mut DodgeEpisode, act: Act<'_, S>) -> Step {
        let behaviour = Behaviour::ALL[act.choice()];
        let wanted = running.dodger.act(&running.episode.view(), behaviour);
        let Some(end) = running.episode.step(wanted, self.config.tolerance) else {
            return Step::reward(0.0);
        };
        let distance = f64::from(running.episode.distance());
        let left = f64::from(LIMIT - running.episode.steps());
        let success = end == episode::End::Reached;
        let reward = REWARDS[end as usize] + if success { UNUSED * left } else { -FAR * distance };
        Step::reward(reward).ending(End { success: Some(success), measure: distance, ..End::new(end as u8) })
    }

    fn distance(&self, running: &DodgeEpisode) -> Option<f64> {
        Some(running.episode.distance().into())
    }
}

impl Training<Scene> for Dodge {
    fn tasks(&self, set: TaskSet, _seed: u64, count: usize) -> Option<Vec<Scene>> {
        let certified =
            (set == TaskSet::Validation).then(|| scenes(&self.config, SEED, Set::Validation, count, TRIES))?;
        Some(certified.into_iter().map(|certified| certified.scene).collect())
    }
}

fn document(source: DodgeSource) -> SourceDocument {
    let ranges = source.ranges().iter().map(|&[low, high]| [low.into(), high.into()]).collect::<Vec<[f64; 2]>>();
    SourceDocument::new(source.name(), source.unit(), ranges)
}
