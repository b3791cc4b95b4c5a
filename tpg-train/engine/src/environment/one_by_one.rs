//! Parallel episodes that are stepped one after another: the default of [`Environment::lanes`].

use super::Environment;
use crate::action::Acts;
use crate::episode_result::EpisodeResult;
use crate::episodes::Episodes;
use crate::error::EvaluationError;
use crate::rollout::Rollout;
use crate::source_set::{SourceSet, state_length};
use crate::view::View;
use tpg_runtime::scalar::Scalar;

/// Steps one episode after another.
pub struct OneByOne<'e, S: Scalar, E: Environment<S> + ?Sized> {
    environment: &'e E,
    lanes: Vec<Rollout<'e, S, E>>,
    keys: Vec<u64>,
    /// Number of values of the flat state.
    length: usize,
    /// The flat state of each lane.
    states: Vec<S>,
}

impl<'e, S: Scalar, E: Environment<S> + ?Sized> OneByOne<'e, S, E> {
    /// Creates an empty set of episodes.
    pub fn new(environment: &'e E) -> Self {
        let length = state_length(&environment.sources());
        Self { environment, lanes: Vec::new(), keys: Vec::new(), length, states: Vec::new() }
    }
}

impl<S: Scalar, E: Environment<S> + ?Sized> Episodes<S, E::Task> for OneByOne<'_, S, E> {
    fn begin(&mut self, lane: usize, task: &E::Task) -> Result<(), EvaluationError> {
        let new = Rollout::new(self.environment, task);
        let key = new.key();
        if lane == self.lanes.len() {
            self.lanes.push(new);
            self.keys.extend(key);
        } else {
            self.lanes[lane] = new;
            key.into_iter().for_each(|key| self.keys[lane] = key);
        }
        Ok(())
    }

    fn step(&mut self, acts: Acts<'_, S>, ended: &mut Vec<(usize, EpisodeResult)>) -> Result<(), EvaluationError> {
        for (place, (lane, act)) in self.lanes.iter_mut().zip(acts.iter()).enumerate() {
            ended.extend(lane.act(act).map(|ending| (place, ending)));
            lane.key().into_iter().for_each(|key| self.keys[place] = key);
        }
        Ok(())
    }

    fn keys(&self) -> &[u64] {
        &self.keys
    }

    fn cycle(&self, lane: usize, key: u64, actions: u32) -> Option<EpisodeResult> {
        self.environment.cycle(self.lanes[lane].episode(), key, actions)
    }

    fn observe(&mut self, wanted: SourceSet, view: &mut View<'_, S>) -> Result<(), EvaluationError> {
        let Self { environment, lanes, length, states, .. } = self;
        states.resize(lanes.len() * *length, S::ZERO);
        let inputs: Vec<u16> = (0..*length as u16).filter(|&input| view.column(input.into()).is_some()).collect();
        for (place, lane) in lanes.iter_mut().enumerate() {
            environment.observe_some(lane.episode_mut(), wanted, &inputs, &mut states[place * *length..][..*length]);
        }
        for input in inputs {
            if let Some(column) = view.column(input.into()) {
                let values = states.iter().skip(input.into()).step_by(*length);
                column.as_flattened_mut().iter_mut().zip(values).for_each(|(slot, value)| *slot = *value);
            }
        }
        Ok(())
    }

    fn close_up(&mut self, lane: usize) {
        self.lanes.swap_remove(lane);
        if !self.keys.is_empty() {
            self.keys.swap_remove(lane);
        }
    }
}
