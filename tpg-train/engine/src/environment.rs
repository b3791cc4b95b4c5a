//! The contract between a problem and everything that trains or evaluates policies on it.

mod one_by_one;

pub use one_by_one::OneByOne;

use crate::action::{Act, ActionSpace};
use crate::episode_result::{End, EpisodeResult, Measure, Preference, Step};
use crate::episodes::Episodes;
use crate::extensions::{Guarded, Training};
use crate::random::Stream;
use crate::source_set::SourceSet;
use serde::{Serialize, de::DeserializeOwned};
use std::fmt::Debug;
use tpg_graph::SourceDocument;
use tpg_runtime::scalar::Scalar;

/// A problem that policies are trained on. Evolution, soft actor-critic, evaluation and reports use it only through
/// this trait.
///
/// The rules must be deterministic: all randomness comes from [`draw`](Self::draw). An episode's score is the sum of
/// its rewards, in the problem's own unit; higher is better.
///
/// ```
/// use tpg_engine::random::Stream;
/// use tpg_engine::{Act, ActionSpace, Environment, SourceSet, Step};
/// use tpg_graph::SourceDocument;
///
/// /// A cart on rails that should come to rest at 0: it is pushed to the left or to the right.
/// struct Cart;
///
/// impl Environment<f32> for Cart {
///     type Task = f32; // the starting position
///     type Episode = [f32; 2]; // position and velocity
///
///     fn sources(&self) -> Vec<SourceDocument> {
///         vec![SourceDocument::new("cart", "m, m/s", vec![[-20.0, 20.0]; 2])]
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
    /// The random part of an episode, such as a start or a target. Drawn once, then given to every policy.
    type Task: Clone + Debug + PartialEq + Serialize + DeserializeOwned + Send + Sync + 'static;
    /// A running episode.
    type Episode: Send + 'static;

    /// Returns the data sources that a policy can read, in the order of the flat state; at most 64. An unknown end of a
    /// range may be infinite; it is then estimated from visited states.
    fn sources(&self) -> Vec<SourceDocument>;

    /// Returns the actions that a policy can take.
    fn actions(&self) -> ActionSpace;

    /// Returns the maximum number of actions in an episode. The engine ends a longer one with
    /// [`timeout`](Self::timeout).
    fn time_limit(&self) -> u32;

    /// Draws a task.
    fn draw(&self, stream: &mut Stream) -> Self::Task;

    /// Starts an episode.
    fn start(&self, task: &Self::Task) -> Self::Episode;

    /// Writes the values of the wanted sources to their places in the flat state.
    ///
    /// The episode is mutable so that it can cache results; the observed values must not depend on that.
    fn observe(&self, episode: &mut Self::Episode, wanted: SourceSet, state: &mut [S]);

    /// Writes the wanted values alone, given by their places in the flat state; by default all of the wanted sources.
    fn observe_some(&self, episode: &mut Self::Episode, wanted: SourceSet, _inputs: &[u16], state: &mut [S]) {
        self.observe(episode, wanted, state);
    }

    /// Takes one action. The returned step states the reward and, if the episode ended, how.
    fn step(&self, episode: &mut Self::Episode, act: Act<'_, S>) -> Step;

    /// Returns the names of the ways in which an episode can end, indexed by [`End::outcome`].
    fn outcomes(&self) -> &'static [&'static str] {
        &["ended", "time limit"]
    }

    /// Returns the end of an episode that has reached the [time limit](Self::time_limit); by default the last of the
    /// outcomes, neither success nor failure.
    fn timeout(&self, _episode: &Self::Episode) -> End {
        End { truncated: true, ..End::new(self.outcomes().len().saturating_sub(1) as u8) }
    }

    /// Returns the quantity reported at the end of an episode in addition to the score: [`End::measure`].
    fn measure(&self) -> Option<Measure> {
        None
    }

    /// Returns the criterion by which policies are ranked on this problem; by default the mean score.
    fn preference(&self) -> Preference {
        Preference::Score
    }

    /// Returns true if an episode can start from a task. Tasks read from a checkpoint are checked with it; those that
    /// [`draw`](Self::draw) returns are always possible. By default every task is.
    fn accepts(&self, _task: &Self::Task) -> bool {
        true
    }

    /// Creates parallel episodes; the default steps them one after another.
    fn lanes(&self) -> Box<dyn Episodes<S, Self::Task> + '_> {
        Box::new(OneByOne::new(self))
    }

    /// Returns a number that is equal at two moments of an episode exactly if everything except the time is equal.
    ///
    /// Graphs are memoryless, so from a repeated moment on everything repeats: the engine then ends the episode at its
    /// first repeat with [`cycle`](Self::cycle). `None`, the default, disables this.
    fn key(&self, _episode: &Self::Episode) -> Option<u64> {
        None
    }

    /// Returns the ending of an episode that came back to `key` at action number `actions`. `None`, the default: it
    /// goes on.
    fn cycle(&self, _episode: &Self::Episode, _key: u64, _actions: u32) -> Option<EpisodeResult> {
        None
    }

    /// Returns the tasks that this environment has beside the drawn ones; `None` by default.
    fn training(&self) -> Option<&dyn Training<Self::Task>> {
        None
    }

    /// Returns a task that begins where an episode is now, so that training can restart where a policy failed; `None` by default.
    fn task_from(&self, _episode: &Self::Episode) -> Option<Self::Task> {
        None
    }

    /// Returns the guard of this environment; `None` by default.
    fn guarded(&self) -> Option<&dyn Guarded<S, Self::Episode>> {
        None
    }

    /// Returns what a picture needs to know of a moment of an episode; nothing by default.
    fn moment(&self, _episode: &Self::Episode) -> Vec<f64> {
        Vec::new()
    }

    /// Returns the distance to the goal, in a unit of the problem's own; less is better. A hybrid hands over to its
    /// network when the distance grows, or no longer falls. `None`, the default: the reward of the last action, with its
    /// sign changed, takes its place.
    fn distance(&self, _episode: &Self::Episode) -> Option<f64> {
        None
    }
}

impl<S: Scalar, E: Environment<S> + ?Sized> Environment<S> for &E {
    type Task = E::Task;
    type Episode = E::Episode;

    crate::forward!(this => (**this);
        sources actions time_limit draw start observe observe_some step outcomes timeout measure preference accepts
        lanes key cycle training task_from guarded moment distance);
}
