//! Episodes side by side: what the lanes need of an environment, all at once.

use crate::columns::{BLOCK, Block};
use crate::environment::{Ending, Environment, SourceSet};
use tpg_runtime::policy::ActionId;
use tpg_runtime::scalar::Scalar;

/// Some episodes of an environment, one in each lane.
///
/// [`Environment::lanes`] makes them. By default each lane has an episode of its own and they take turns; an environment
/// for which that is too slow can do all lanes at once instead, with the same answers.
pub trait Episodes<S, Task> {
    /// Starts an episode: in a lane that there is already, or in the next one.
    fn begin(&mut self, lane: usize, task: &Task);

    /// Does one action in each lane; adds the lanes whose episode it ended, ascending.
    fn step(&mut self, actions: &[ActionId], ended: &mut Vec<(usize, Ending)>);

    /// [`Environment::key`] of each lane; empty where the problem has none.
    fn keys(&self) -> &[u64];

    /// [`Environment::cycle`] in a lane.
    fn cycle(&self, lane: usize, key: u64, actions: u32) -> Option<Ending>;

    /// Writes what each lane's policy sees.
    fn observe(&mut self, wanted: SourceSet, view: &mut View<'_, S>);

    /// The last lane's episode moves to `lane`, whose own is over.
    fn close_up(&mut self, lane: usize);
}

/// Where the values of the flat state go: a column for each that some program reads.
#[derive(Debug)]
pub struct View<'a, S> {
    pub(super) columns: &'a mut [Block<S>],
    pub(super) blocks: usize,
    /// For each value of the flat state, the place of its column; `u32::MAX` where nobody reads it.
    pub(super) places: &'a [u32],
}

impl<S> View<'_, S> {
    /// The column of a value of the flat state, in whole blocks of lanes; `None` where nobody reads it.
    #[inline]
    pub fn column(&mut self, input: usize) -> Option<&mut [[S; BLOCK]]> {
        let place = *self.places.get(input)? as usize;
        self.columns.get_mut(place * self.blocks..)?.get_mut(..self.blocks)
    }
}

/// One episode after the other.
pub struct OneByOne<'e, S, E: Environment<S>>
where
    S: Scalar,
{
    environment: &'e E,
    episodes: Vec<E::Episode>,
    keys: Vec<u64>,
    state: Vec<S>,
}

impl<'e, S: Scalar, E: Environment<S>> OneByOne<'e, S, E> {
    /// No episodes yet.
    pub fn new(environment: &'e E) -> Self {
        let length = environment.sources().iter().map(|source| source.length as usize).sum();
        Self { environment, episodes: Vec::new(), keys: Vec::new(), state: vec![S::ZERO; length] }
    }
}

impl<S: Scalar, E: Environment<S>> Episodes<S, E::Task> for OneByOne<'_, S, E> {
    fn begin(&mut self, lane: usize, task: &E::Task) {
        let episode = self.environment.start(task);
        let key = self.environment.key(&episode);
        if lane == self.episodes.len() {
            self.episodes.push(episode);
            self.keys.extend(key);
        } else {
            self.episodes[lane] = episode;
            key.into_iter().for_each(|key| self.keys[lane] = key);
        }
    }

    fn step(&mut self, actions: &[ActionId], ended: &mut Vec<(usize, Ending)>) {
        for (lane, (episode, &action)) in self.episodes.iter_mut().zip(actions).enumerate() {
            ended.extend(self.environment.step(episode, action).map(|ending| (lane, ending)));
            self.environment.key(episode).into_iter().for_each(|key| self.keys[lane] = key);
        }
    }

    fn keys(&self) -> &[u64] {
        &self.keys
    }

    fn cycle(&self, lane: usize, key: u64, actions: u32) -> Option<Ending> {
        self.environment.cycle(&self.episodes[lane], key, actions)
    }

    fn observe(&mut self, wanted: SourceSet, view: &mut View<'_, S>) {
        for (lane, episode) in self.episodes.iter_mut().enumerate() {
            self.environment.observe(episode, wanted, &mut self.state);
            for (input, &value) in self.state.iter().enumerate() {
                if let Some(column) = view.column(input) {
                    column[lane / BLOCK][lane % BLOCK] = value;
                }
            }
        }
    }

    fn close_up(&mut self, lane: usize) {
        self.episodes.swap_remove(lane);
        if !self.keys.is_empty() {
            self.keys.swap_remove(lane);
        }
    }
}
