//! Parallel episodes behind tasks of another type.

use crate::action::Acts;
use crate::episode_result::EpisodeResult;
use crate::episodes::Episodes;
use crate::error::EvaluationError;
use crate::source_set::SourceSet;
use crate::view::View;

/// Parallel episodes of an environment that is wrapped by another one, whose tasks hold its own.
pub struct Mapped<'e, S, Outer, Inner> {
    episodes: Box<dyn Episodes<S, Inner> + 'e>,
    task: fn(&Outer) -> &Inner,
}

impl<'e, S, Outer, Inner> Mapped<'e, S, Outer, Inner> {
    /// Wraps parallel episodes; `task` returns the task within another.
    pub fn new(episodes: Box<dyn Episodes<S, Inner> + 'e>, task: fn(&Outer) -> &Inner) -> Self {
        Self { episodes, task }
    }
}

impl<S, Outer, Inner> Episodes<S, Outer> for Mapped<'_, S, Outer, Inner> {
    fn begin(&mut self, lane: usize, task: &Outer) -> Result<(), EvaluationError> {
        self.episodes.begin(lane, (self.task)(task))
    }
    fn step(&mut self, acts: Acts<'_, S>, ended: &mut Vec<(usize, EpisodeResult)>) -> Result<(), EvaluationError> {
        self.episodes.step(acts, ended)
    }
    fn keys(&self) -> &[u64] {
        self.episodes.keys()
    }
    fn cycle(&self, lane: usize, key: u64, actions: u32) -> Option<EpisodeResult> {
        self.episodes.cycle(lane, key, actions)
    }
    fn observe(&mut self, wanted: SourceSet, view: &mut View<'_, S>) -> Result<(), EvaluationError> {
        self.episodes.observe(wanted, view)
    }
    fn close_up(&mut self, lane: usize) {
        self.episodes.close_up(lane);
    }
}
