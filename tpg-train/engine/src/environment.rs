//! What the engine asks of a problem.

use crate::episodes::{Episodes, OneByOne};
use crate::random::{Purpose, Stream};
use serde::{Serialize, de::DeserializeOwned};
use std::fmt::Debug;
use tpg_graph::{ActionDocument, SourceDocument};
use tpg_runtime::policy::ActionId;
use tpg_runtime::scalar::Scalar;

/// A problem that policies are trained on.
///
/// The rules must be deterministic: all chance lies in [`draw`](Self::draw). `examples/own_environment.rs` is a whole one.
pub trait Environment<S: Scalar>: Sync {
    /// What one episode asks: a start, a target. Drawn once, then given to every policy.
    type Task: Clone + Debug + PartialEq + Serialize + DeserializeOwned + Send + Sync;
    /// An episode under way.
    type Episode: Clone + Send;

    /// The data sources that programs read, in the order of the flat state; at most 64.
    fn sources(&self) -> Vec<SourceDocument>;

    /// What a policy can do.
    fn actions(&self) -> Vec<ActionDocument>;

    /// The ways in which an episode can end, by [`Ending::outcome`].
    fn outcomes(&self) -> &'static [&'static str];

    /// After this many actions an episode is over.
    fn time_limit(&self) -> u32;

    /// Draws a task.
    fn draw(&self, stream: &mut Stream) -> Self::Task;

    /// The same task in rougher steps, `factor` times as large; the default knows no rougher ones.
    ///
    /// A curriculum begins with them: episodes are shorter by about that factor.
    fn rougher(&self, task: Self::Task, _factor: u8) -> Self::Task {
        task
    }

    /// The tasks that choose between trained roots: the same for every run, and never among those that train.
    fn validation_tasks(&self, count: usize) -> Vec<Self::Task> {
        (0..count as u64).map(|index| self.draw(&mut Stream::new(0, 0, Purpose::Selection, index))).collect()
    }

    /// Starts an episode.
    fn start(&self, task: &Self::Task) -> Self::Episode;

    /// The values of the flat state that stay what they are from an episode's start to its end; none by default.
    ///
    /// What programs compute from them alone is computed once an episode.
    fn constants(&self) -> Vec<u16> {
        Vec::new()
    }

    /// Writes the values of the wanted sources to their places in the flat state.
    ///
    /// The episode is mutable so that it can keep what it computed; what it shows must not depend on that.
    fn observe(&self, episode: &mut Self::Episode, wanted: SourceSet, state: &mut [S]);

    /// Does one action; `Some` when it ended the episode.
    fn step(&self, episode: &mut Self::Episode, action: ActionId) -> Option<Ending>;

    /// Episodes side by side; the default takes one after the other.
    fn lanes(&self) -> Box<dyn Episodes<S, Self::Task> + '_>
    where
        Self: Sized,
    {
        Box::new(OneByOne::new(self))
    }

    /// A number that is equal at two moments of an episode exactly when everything but the time is equal there.
    ///
    /// Policies are memoryless, so from such a moment on everything repeats: the engine then ends the episode at its
    /// first repeat, by [`cycle`](Self::cycle). `None`, the default, where the problem does not want that.
    fn key(&self, _episode: &Self::Episode) -> Option<u64> {
        None
    }

    /// How the episode ends that came back to `key` at action number `actions`. `None`, the default: it goes on.
    fn cycle(&self, _episode: &Self::Episode, _key: u64, _actions: u32) -> Option<Ending> {
        None
    }
}

/// How an episode ended.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, serde::Deserialize)]
pub struct Ending {
    /// Place in [`Environment::outcomes`].
    pub outcome: u8,
    /// Whether the task was done.
    pub success: bool,
    /// What evolution maximises.
    pub score: f64,
    /// What was missing at the end, in the problem's unit: on the arm, mm from hand to target.
    pub error: f64,
    /// Actions done, the last one included.
    pub actions: u32,
}

/// Some of an environment's sources, by place.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct SourceSet(u64);

impl SourceSet {
    /// Every source.
    pub const ALL: Self = Self(u64::MAX);
    /// No source.
    pub const NONE: Self = Self(0);

    /// With the source at that place, too.
    #[must_use]
    pub fn with(self, place: usize) -> Self {
        Self(self.0 | 1 << place)
    }

    /// The sources that the given inputs of the flat state lie in.
    pub fn of_inputs(sources: &[SourceDocument], inputs: impl Iterator<Item = u16>) -> Self {
        assert!(sources.len() <= 64, "an environment has at most 64 sources");
        let mut ends = Vec::new();
        let mut end = 0;
        for source in sources {
            end += source.length;
            ends.push(end);
        }
        let bits = inputs.map(|input| 1u64 << ends.partition_point(|&end| end <= u32::from(input)));
        Self(bits.fold(0, |set, bit| set | bit))
    }

    /// Whether the source at that place is wanted.
    #[inline]
    pub fn contains(self, place: usize) -> bool {
        place < 64 && self.0 & (1 << place) != 0
    }
}

#[cfg(test)]
mod tests {
    use crate::SourceSet;
    use tpg_graph::SourceDocument;

    #[test]
    fn an_input_belongs_to_the_source_it_lies_in() {
        let source = |length: u32| SourceDocument {
            name: format!("s{length}"),
            length,
            unit: String::new(),
            ranges: vec![[0.0, 1.0]; length as usize],
        };
        let sources = [source(3), source(1), source(2)];
        let set = |inputs: &[u16]| {
            let set = SourceSet::of_inputs(&sources, inputs.iter().copied());
            [0, 1, 2].map(|place| set.contains(place))
        };
        assert_eq!(set(&[0]), [true, false, false]);
        assert_eq!(set(&[2, 3]), [true, true, false]);
        assert_eq!(set(&[4, 5]), [false, false, true]);
        assert_eq!(set(&[]), [false; 3]);
    }
}
