//! One episode of any environment, action by action.

use crate::action::Act;
use crate::environment::Environment;
use crate::episode_result::{End, EpisodeResult, Step};
use crate::source_set::{SourceSet, state_length};
use tpg_graph::interpret::Answer;
use tpg_runtime::policy::ActionId;
use tpg_runtime::scalar::Scalar;

/// A policy's decision, owned: see [`Act`].
#[derive(Clone, Debug, PartialEq)]
pub enum Decision<S> {
    /// One of the named actions.
    Choice(ActionId),
    /// A value for each output.
    Values(Vec<S>),
}

impl<S> Decision<S> {
    /// Borrows the decision as an environment takes it.
    pub fn act(&self) -> Act<'_, S> {
        match self {
            Self::Choice(action) => Act::Choice(*action),
            Self::Values(values) => Act::Values(values),
        }
    }
}

impl<S: Scalar> From<Answer> for Decision<S> {
    fn from(answer: Answer) -> Self {
        match answer {
            Answer::Action(action) => Self::Choice(action),
            Answer::Values(values) => Self::Values(values.into_iter().map(S::from_f64).collect()),
        }
    }
}

impl Decision<f32> {
    /// Returns the same decision in another scalar type.
    pub fn widened<S: Scalar>(self) -> Decision<S> {
        match self {
            Self::Choice(action) => Decision::Choice(action),
            Self::Values(values) => {
                Decision::Values(values.into_iter().map(|value| S::from_f64(f64::from(value))).collect())
            }
        }
    }
}

/// A running episode with its score.
#[derive(Debug)]
pub struct Rollout<'e, S: Scalar, E: Environment<S> + ?Sized> {
    environment: &'e E,
    episode: E::Episode,
    /// The flat state; empty before it is first observed.
    state: Vec<S>,
    score: f64,
    actions: u32,
    /// The reward of the last action.
    reward: Option<f64>,
}

impl<'e, S: Scalar, E: Environment<S> + ?Sized> Rollout<'e, S, E> {
    /// Starts an episode.
    pub fn new(environment: &'e E, task: &E::Task) -> Self {
        let episode = environment.start(task);
        Self { environment, episode, state: Vec::new(), score: 0.0, actions: 0, reward: None }
    }

    /// Returns the flat state with the wanted sources observed now.
    pub fn observe(&mut self, wanted: SourceSet) -> &[S] {
        if self.state.is_empty() {
            self.state.resize(state_length(&self.environment.sources()), S::ZERO);
        }
        self.environment.observe(&mut self.episode, wanted, &mut self.state);
        &self.state
    }

    /// Takes an action; at the time limit the step has an end.
    pub fn step(&mut self, act: Act<'_, S>) -> Step {
        let step = self.environment.step(&mut self.episode, act);
        self.score += step.reward;
        self.actions += 1;
        self.reward = Some(step.reward);
        let timeout = || self.environment.timeout(&self.episode);
        let end = step.end.or_else(|| (self.actions >= self.environment.time_limit()).then(timeout));
        Step { end, ..step }
    }

    /// Takes an action; returns the ending if the episode ended.
    pub fn act(&mut self, act: Act<'_, S>) -> Option<EpisodeResult> {
        let Step { reward: final_reward, end, .. } = self.step(act);
        let (End { outcome, success, measure, .. }, score, actions) = (end?, self.score, self.actions);
        Some(EpisodeResult { outcome, success, score, final_reward, measure, actions })
    }

    /// Lets a policy act until the end.
    pub fn run(self, decide: impl FnMut(&[S]) -> Decision<S>) -> EpisodeResult {
        self.watch(decide, |_| ())
    }

    /// Lets a policy act until the end; `each` sees the episode at its start and after every action.
    pub fn watch(
        mut self,
        mut decide: impl FnMut(&[S]) -> Decision<S>,
        mut each: impl FnMut(&E::Episode),
    ) -> EpisodeResult {
        each(&self.episode);
        loop {
            let decision = decide(self.observe(SourceSet::ALL));
            let ending = self.act(decision.act());
            each(&self.episode);
            if let Some(ending) = ending {
                return ending;
            }
        }
    }

    /// Returns the [distance](Environment::distance) to the goal, or the last reward with its sign changed; infinity
    /// where that is unknown before the first action.
    pub fn distance(&self) -> S {
        let by_reward = || self.reward.map_or(f64::INFINITY, |reward| -reward);
        S::from_f64(self.environment.distance(&self.episode).unwrap_or_else(by_reward))
    }

    /// Returns the [key](Environment::key) of this moment, if the environment has keys.
    pub fn key(&self) -> Option<u64> {
        self.environment.key(&self.episode)
    }

    /// Returns the ending of an episode that comes back to a key for ever: see [`Environment::cycle`].
    pub fn cycle(&self, key: u64) -> Option<EpisodeResult> {
        self.environment.cycle(&self.episode, key, self.actions)
    }

    /// Returns the environment.
    pub fn environment(&self) -> &'e E {
        self.environment
    }

    /// Returns the episode.
    pub fn episode(&self) -> &E::Episode {
        &self.episode
    }

    /// Returns the episode, mutable for [`Environment::observe`].
    pub fn episode_mut(&mut self) -> &mut E::Episode {
        &mut self.episode
    }
}
