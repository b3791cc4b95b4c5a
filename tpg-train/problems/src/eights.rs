//! Episodes that are stepped eight at a time, in a form that compilers turn into vectors.

use fearless_simd::{Level, dispatch};
use tpg_engine::{Act, Acts, End, Environment, EpisodeResult, Episodes, EvaluationError, SourceSet, Step, View};
use tpg_runtime::policy::ActionId;
use tpg_runtime::scalar::Scalar;

/// A problem whose episodes are `N` numbers each, and whose steps are the same operations for all of them and for policies in any
/// numbers.
pub trait ByEight<const N: usize>: Sized {
    /// The constants of the rules.
    type Physics: Copy + Send + Sync + 'static;
    /// Those of the problem itself.
    const STANDARD: Self::Physics;
    /// Places of the observed values among the numbers.
    const OBSERVED: &[usize];
    /// True if observations are rounded to `f32`, as Gymnasium's are.
    const ROUNDS: bool;
    /// The named action that does least; until a late action arrives, it is taken. With an output, 0 is.
    const REST: u16 = 0;

    /// Takes one action in each of `L` episodes: the number of an action, or the value of the output. Writes the rewards, and
    /// which episodes have come to their outcome 0. Must be `#[inline(always)]`.
    fn step_many<const L: usize>(
        physics: &Self::Physics,
        numbers: &mut [[f64; L]; N],
        acts: &[f64; L],
        rewards: &mut [f64; L],
        ended: &mut [bool; L],
    );

    /// Takes an [action](number) in one episode under some constants.
    #[inline]
    fn step_under(physics: &Self::Physics, episode: &mut [f64; N], act: f64) -> Step {
        let (mut numbers, mut rewards, mut ended) = (episode.map(|number| [number]), [0.0], [false]);
        Self::step_many(physics, &mut numbers, &[act], &mut rewards, &mut ended);
        *episode = numbers.map(|[number]| number);
        let step = Step::reward(rewards[0]);
        if ended[0] { step.ending(End::new(0)) } else { step }
    }

    /// Writes what is observed of an episode.
    fn observe_one<S: Scalar>(episode: &[f64; N], state: &mut [S]) {
        state.iter_mut().zip(Self::OBSERVED).for_each(|(slot, &place)| *slot = observed::<S, Self, N>(episode[place]));
    }
}

/// Returns the number of an action, or the value of the output.
pub fn number<S: Scalar>(act: Act<'_, S>) -> f64 {
    match act {
        Act::Choice(ActionId(action)) => f64::from(action),
        Act::Values(values) => values[0].to_f64(),
    }
}

/// Implements the methods of an [`Environment`] that follow from [`ByEight`].
macro_rules! by_eight {
    ($numbers:literal) => {
        fn observe(&self, episode: &mut Self::Episode, _wanted: tpg_engine::SourceSet, state: &mut [S]) {
            <Self as $crate::eights::ByEight<$numbers>>::observe_one(episode, state);
        }

        fn step(&self, episode: &mut Self::Episode, act: tpg_engine::Act<'_, S>) -> tpg_engine::Step {
            <Self as $crate::eights::ByEight<$numbers>>::step_under(
                &Self::STANDARD,
                episode,
                $crate::eights::number(act),
            )
        }

        fn lanes(&self) -> Box<dyn tpg_engine::Episodes<S, Self::Task> + '_> {
            Box::new($crate::eights::Eights::new::<S>(self))
        }
    };
}
pub(crate) use by_eight;

#[inline(always)]
fn observed<S: Scalar, E: ByEight<N>, const N: usize>(value: f64) -> S {
    S::from_f64(if E::ROUNDS { f64::from(value as f32) } else { value })
}

/// The lanes of a problem: with the results of [`OneByOne`](tpg_engine::OneByOne), bit for bit.
pub(crate) struct Eights<'e, E, const N: usize> {
    environment: &'e E,
    limit: u32,
    eights: Vec<Eight<N>>,
    /// The action of each lane, as [`ByEight::step_many`] gets it.
    acts: Vec<f64>,
    lanes: usize,
    level: Level,
}

/// Eight episodes; behind the last lane, whatever was there before, which is stepped and never read.
struct Eight<const N: usize> {
    numbers: [[f64; 8]; N],
    scores: [f64; 8],
    rewards: [f64; 8],
    actions: [u32; 8],
    ended: [bool; 8],
}

/// One of them: its numbers, its score, its newest reward and the number of its actions.
type One<const N: usize> = ([f64; N], f64, f64, u32);

impl<const N: usize> Eight<N> {
    fn new() -> Self {
        Self { numbers: [[0.0; 8]; N], scores: [0.0; 8], rewards: [0.0; 8], actions: [0; 8], ended: [false; 8] }
    }

    fn get(&self, lane: usize) -> One<N> {
        (self.numbers.map(|eight| eight[lane]), self.scores[lane], self.rewards[lane], self.actions[lane])
    }

    fn set(&mut self, lane: usize, (numbers, score, reward, actions): One<N>) {
        self.numbers.iter_mut().zip(numbers).for_each(|(eight, number)| eight[lane] = number);
        (self.scores[lane], self.rewards[lane], self.actions[lane]) = (score, reward, actions);
    }

    /// Takes one action in each of the first `L` episodes: few take less time than all.
    #[inline(always)]
    fn step_first<E: ByEight<N>, const L: usize>(&mut self, acts: &[f64; 8]) {
        let (mut numbers, mut first) = ([[0.0; L]; N], [0.0; L]);
        first.copy_from_slice(&acts[..L]);
        for (to, from) in numbers.iter_mut().zip(&self.numbers) {
            to.copy_from_slice(&from[..L]);
        }
        let (mut rewards, mut ended) = ([0.0; L], [false; L]);
        E::step_many(&E::STANDARD, &mut numbers, &first, &mut rewards, &mut ended);
        for (to, from) in self.numbers.iter_mut().zip(&numbers) {
            to[..L].copy_from_slice(from);
        }
        self.ended[..L].copy_from_slice(&ended);
        self.rewards[..L].copy_from_slice(&rewards);
        self.scores.iter_mut().zip(rewards).for_each(|(score, reward)| *score += reward);
        self.actions[..L].iter_mut().for_each(|actions| *actions += 1);
    }
}

impl<'e, E, const N: usize> Eights<'e, E, N> {
    /// Creates an empty set of episodes.
    pub(crate) fn new<S: Scalar>(environment: &'e E) -> Self
    where
        E: Environment<S>,
    {
        Self {
            environment,
            limit: environment.time_limit(),
            eights: Vec::new(),
            acts: Vec::new(),
            lanes: 0,
            level: Level::new(),
        }
    }

    /// Returns how a lane's episode has ended, if it has.
    fn ending<S: Scalar>(&self, lane: usize) -> Option<EpisodeResult>
    where
        E: ByEight<N> + Environment<S, Episode = [f64; N]>,
    {
        let Eight { ended, actions, .. } = &self.eights[lane / 8];
        if !ended[lane % 8] && actions[lane % 8] < self.limit {
            return None;
        }
        let (numbers, score, final_reward, actions) = self.eights[lane / 8].get(lane % 8);
        let End { outcome, success, measure, .. } =
            if ended[lane % 8] { End::new(0) } else { self.environment.timeout(&numbers) };
        Some(EpisodeResult { outcome, success, score, final_reward, measure, actions })
    }
}

/// Takes an action in each lane.
#[inline(always)]
fn step_all<E: ByEight<N>, const N: usize>(eights: &mut [Eight<N>], acts: &[f64]) {
    for (acts, eight) in acts.chunks(8).zip(eights) {
        let mut numbers = [0.0; 8];
        numbers.iter_mut().zip(acts).for_each(|(to, act)| *to = *act);
        match acts.len() {
            1 => eight.step_first::<E, 1>(&numbers),
            2 => eight.step_first::<E, 2>(&numbers),
            3 | 4 => eight.step_first::<E, 4>(&numbers),
            _ => eight.step_first::<E, 8>(&numbers),
        }
    }
}

impl<S: Scalar, E, const N: usize> Episodes<S, E::Task> for Eights<'_, E, N>
where
    E: ByEight<N> + Environment<S, Episode = [f64; N]>,
{
    fn begin(&mut self, lane: usize, task: &E::Task) -> Result<(), EvaluationError> {
        self.lanes = self.lanes.max(lane + 1);
        self.eights.resize_with(self.lanes.div_ceil(8), Eight::new);
        self.eights[lane / 8].set(lane % 8, (self.environment.start(task), 0.0, 0.0, 0));
        Ok(())
    }

    fn step(&mut self, acts: Acts<'_, S>, ended: &mut Vec<(usize, EpisodeResult)>) -> Result<(), EvaluationError> {
        self.acts.clear();
        match acts {
            Acts::Choices(actions) => self.acts.extend(actions[..self.lanes].iter().map(|action| f64::from(action.0))),
            Acts::Values { values, .. } => self.acts.extend(values[..self.lanes].iter().map(|value| value.to_f64())),
        }
        dispatch!(self.level, _ => step_all::<E, N>(&mut self.eights, &self.acts));
        ended.extend((0..self.lanes).filter_map(|lane| Some((lane, self.ending::<S>(lane)?))));
        Ok(())
    }

    fn observe(&mut self, _wanted: SourceSet, view: &mut View<'_, S>) -> Result<(), EvaluationError> {
        for (input, &place) in E::OBSERVED.iter().enumerate() {
            let Some(column) = view.column(input) else { continue };
            for (slots, eight) in column.as_flattened_mut().chunks_exact_mut(8).zip(&self.eights) {
                for (slot, &value) in slots.iter_mut().zip(&eight.numbers[place]) {
                    *slot = observed::<S, E, N>(value);
                }
            }
        }
        Ok(())
    }

    fn close_up(&mut self, lane: usize) {
        self.lanes -= 1;
        let last = self.eights[self.lanes / 8].get(self.lanes % 8);
        self.eights[lane / 8].set(lane % 8, last);
        self.eights.truncate(self.lanes.div_ceil(8));
    }
}
