//! Parallel episodes behind tasks of another type.

use crate::action::Acts;
use crate::episode_result::EpisodeResult;
use crate::episodes::Episodes;
use crate::error::EvaluationError;
use crate::source_set::SourceSet;
use crate::view::View;

/// Parallel episodes of an environment that is wrapped by another one, whose tasks hold its own, and whose named actions may
/// stand for values.
pub struct Mapped<'e, S, Outer, Inner> {
    episodes: Box<dyn Episodes<S, Inner> + 'e>,
    task: fn(&Outer) -> &Inner,
    /// The values of each named action; none where actions are the same.
    levels: &'e [Vec<S>],
    /// Those of the lanes' actions, lane after lane.
    values: Vec<S>,
}

impl<'e, S, Outer, Inner> Mapped<'e, S, Outer, Inner> {
    /// Wraps parallel episodes; `task` returns the task within another.
    pub fn new(episodes: Box<dyn Episodes<S, Inner> + 'e>, task: fn(&Outer) -> &Inner) -> Self {
        Self { episodes, task, levels: &[], values: Vec::new() }
    }

    /// Gives each named action its values.
    pub(crate) fn with_levels(self, levels: &'e [Vec<S>]) -> Self {
        Self { levels, ..self }
    }
}

impl<S: Copy, Outer, Inner> Episodes<S, Outer> for Mapped<'_, S, Outer, Inner> {
    fn begin(&mut self, lane: usize, task: &Outer) -> Result<(), EvaluationError> {
        self.episodes.begin(lane, (self.task)(task))
    }
    fn step(&mut self, acts: Acts<'_, S>, ended: &mut Vec<(usize, EpisodeResult)>) -> Result<(), EvaluationError> {
        let (Acts::Choices(actions), Some(first)) = (acts, self.levels.first()) else {
            return self.episodes.step(acts, ended);
        };
        let values = actions.iter().map(|action| &self.levels[usize::from(action.0)]);
        self.values.clear();
        match first.len() {
            1 => self.values.extend(values.map(|values| values[0])),
            _ => self.values.extend(values.flatten()),
        }
        self.episodes.step(Acts::Values { values: &self.values, outputs: first.len() }, ended)
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
