//! The contract between a problem and everything that trains or tries policies on it.

use crate::action::{Act, ActionSpace};
use crate::ending::{End, Ending, Measure, Preference, Step};
use crate::episodes::Episodes;
use crate::one_by_one::OneByOne;
use crate::random::{Purpose, Stream};
use crate::source_set::SourceSet;
use serde::{Serialize, de::DeserializeOwned};
use std::fmt::Debug;
use tpg_graph::SourceDocument;
use tpg_runtime::scalar::Scalar;

/// A problem that policies are trained on: evolution, soft actor-critic, evaluation and reports all use it through this
/// trait and know nothing else about it.
///
/// The rules must be deterministic: all chance lies in [`draw`](Self::draw). An episode's score is the sum of its rewards,
/// in the problem's own unit; higher is better.
///
/// ```
/// use tpg_engine::random::Stream;
/// use tpg_engine::{Act, ActionSpace, Environment, SourceSet, Step};
/// use tpg_graph::SourceDocument;
///
/// /// A cart on rails that is to stand still at 0: it is pushed to the left or to the right.
/// struct Cart;
///
/// impl Environment<f32> for Cart {
///     type Task = f32; // the starting position
///     type Episode = [f32; 2]; // position and velocity
///
///     fn sources(&self) -> Vec<SourceDocument> {
///         vec![SourceDocument { name: "cart".into(), length: 2, unit: "m, m/s".into(), ranges: vec![[-20.0, 20.0]; 2] }]
///     }
///     fn actions(&self) -> ActionSpace {
///         ActionSpace::discrete(["left", "right"])
///     }
///     fn time_limit(&self) -> u32 {
///         100
///     }
///     fn draw(&self, random: &mut Stream) -> f32 {
///         (4.0 * random.unit() - 2.0) as f32
///     }
///     fn start(&self, &position: &f32) -> [f32; 2] {
///         [position, 0.0]
///     }
///     fn observe(&self, cart: &mut [f32; 2], _wanted: SourceSet, state: &mut [f32]) {
///         state.copy_from_slice(cart);
///     }
///     fn step(&self, [position, velocity]: &mut [f32; 2], act: Act<'_, f32>) -> Step {
///         *velocity += if act.choice() == 0 { -0.1 } else { 0.1 };
///         *position += 0.1 * *velocity;
///         Step::reward(-f64::from(position.abs() + velocity.abs()))
///     }
/// }
/// # assert_eq!(Environment::<f32>::outcomes(&Cart), ["ended", "time limit"]);
/// ```
pub trait Environment<S: Scalar>: Sync {
    /// The drawn part of an episode: a start, a target. Drawn once, then given to every policy.
    type Task: Clone + Debug + PartialEq + Serialize + DeserializeOwned + Send + Sync;
    /// An episode under way.
    type Episode: Send;

    /// The data sources that a policy can read, in the order of the flat state; at most 64. An end of a range may be
    /// infinite where it is not known: it is then learned from visited states.
    fn sources(&self) -> Vec<SourceDocument>;

    /// The actions that a policy can take.
    fn actions(&self) -> ActionSpace;

    /// The most actions of an episode. The engine ends a longer one by [`timeout`](Self::timeout).
    fn time_limit(&self) -> u32;

    /// Draws a task.
    fn draw(&self, stream: &mut Stream) -> Self::Task;

    /// Starts an episode.
    fn start(&self, task: &Self::Task) -> Self::Episode;

    /// Writes the values of the wanted sources to their places in the flat state.
    ///
    /// The episode is mutable so that it can keep what it computed; what it shows must not depend on that.
    fn observe(&self, episode: &mut Self::Episode, wanted: SourceSet, state: &mut [S]);

    /// Takes one action; the step says what it earned, and how the episode ended if it did.
    fn step(&self, episode: &mut Self::Episode, act: Act<'_, S>) -> Step;

    /// The ways in which an episode can end, by [`End::outcome`].
    fn outcomes(&self) -> &'static [&'static str] {
        &["ended", "time limit"]
    }

    /// The end of an episode that has reached the [time limit](Self::time_limit); by default the last of the outcomes,
    /// neither success nor failure.
    fn timeout(&self, _episode: &Self::Episode) -> End {
        End { truncated: true, ..End::new(self.outcomes().len().saturating_sub(1) as u8) }
    }

    /// A quantity beside the score that is worth reporting at the end of an episode: [`End::measure`].
    fn measure(&self) -> Option<Measure> {
        None
    }

    /// The order of policies on this problem: by mean score unless it says otherwise.
    fn preference(&self) -> Preference {
        Preference::Score
    }

    /// The same task in rougher steps, `factor` times as large; the default knows no rougher ones.
    ///
    /// A curriculum begins with them: episodes are shorter by about that factor.
    fn rougher(&self, task: Self::Task, _factor: u8) -> Self::Task {
        task
    }

    /// The tasks that choose between trained policies: the same for every run, and never among those that train.
    fn validation_tasks(&self, count: usize) -> Vec<Self::Task> {
        (0..count as u64).map(|index| self.draw(&mut Stream::new(0, 0, Purpose::Selection, index))).collect()
    }

    /// Fresh tasks that show where a policy under training fails, under the rules that it is judged by: by default drawn as
    /// those that train.
    fn trial_tasks(&self, stream: &mut Stream, count: usize) -> Vec<Self::Task> {
        (0..count).map(|_| self.draw(stream)).collect()
    }

    /// A task that begins where an episode is now; `None`, the default, where the problem has no such task.
    ///
    /// With it, training can begin again where a policy failed.
    fn task_from(&self, _episode: &Self::Episode) -> Option<Self::Task> {
        None
    }

    /// The values of the flat state that stay the same from an episode's start to its end; none by default.
    ///
    /// Values that programs compute from them alone are computed once an episode.
    fn constants(&self) -> Vec<u16> {
        Vec::new()
    }

    /// The place of a source, the last one, that holds upper bounds for the bids of the first actions, in their order;
    /// programs cannot read it. `None`, the default, where bids are free.
    fn bid_bounds(&self) -> Option<usize> {
        None
    }

    /// Episodes side by side; the default steps one after the other.
    fn lanes(&self) -> Box<dyn Episodes<S, Self::Task> + '_>
    where
        Self: Sized,
    {
        Box::new(OneByOne::new(self))
    }

    /// A number that is equal at two moments of an episode exactly when everything but the time is equal there.
    ///
    /// Graphs are memoryless, so from such a moment on everything repeats: the engine then ends the episode at its
    /// first repeat, by [`cycle`](Self::cycle). `None`, the default, where the problem does not want that.
    fn key(&self, _episode: &Self::Episode) -> Option<u64> {
        None
    }

    /// The ending of an episode that came back to `key` at action number `actions`. `None`, the default: it goes on.
    fn cycle(&self, _episode: &Self::Episode, _key: u64, _actions: u32) -> Option<Ending> {
        None
    }
}

impl<S: Scalar, E: Environment<S>> Environment<S> for &E {
    type Task = E::Task;
    type Episode = E::Episode;

    fn sources(&self) -> Vec<SourceDocument> {
        E::sources(self)
    }
    fn actions(&self) -> ActionSpace {
        E::actions(self)
    }
    fn time_limit(&self) -> u32 {
        E::time_limit(self)
    }
    fn draw(&self, stream: &mut Stream) -> Self::Task {
        E::draw(self, stream)
    }
    fn start(&self, task: &Self::Task) -> Self::Episode {
        E::start(self, task)
    }
    fn observe(&self, episode: &mut Self::Episode, wanted: SourceSet, state: &mut [S]) {
        E::observe(self, episode, wanted, state);
    }
    fn step(&self, episode: &mut Self::Episode, act: Act<'_, S>) -> Step {
        E::step(self, episode, act)
    }
    fn outcomes(&self) -> &'static [&'static str] {
        E::outcomes(self)
    }
    fn timeout(&self, episode: &Self::Episode) -> End {
        E::timeout(self, episode)
    }
    fn measure(&self) -> Option<Measure> {
        E::measure(self)
    }
    fn preference(&self) -> Preference {
        E::preference(self)
    }
    fn rougher(&self, task: Self::Task, factor: u8) -> Self::Task {
        E::rougher(self, task, factor)
    }
    fn validation_tasks(&self, count: usize) -> Vec<Self::Task> {
        E::validation_tasks(self, count)
    }
    fn trial_tasks(&self, stream: &mut Stream, count: usize) -> Vec<Self::Task> {
        E::trial_tasks(self, stream, count)
    }
    fn task_from(&self, episode: &Self::Episode) -> Option<Self::Task> {
        E::task_from(self, episode)
    }
    fn constants(&self) -> Vec<u16> {
        E::constants(self)
    }
    fn bid_bounds(&self) -> Option<usize> {
        E::bid_bounds(self)
    }
    fn lanes(&self) -> Box<dyn Episodes<S, Self::Task> + '_> {
        E::lanes(self)
    }
    fn key(&self, episode: &Self::Episode) -> Option<u64> {
        E::key(self, episode)
    }
    fn cycle(&self, episode: &Self::Episode, key: u64, actions: u32) -> Option<Ending> {
        E::cycle(self, episode, key, actions)
    }
}
