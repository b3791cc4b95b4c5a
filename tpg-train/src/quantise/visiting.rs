//! An environment that keeps what its policies see.

use std::sync::{Mutex, PoisonError};
use tpg_engine::{Environment, SourceSet, forward};
use tpg_runtime::scalar::Scalar;

/// An environment that keeps some values of each state in which a policy decides.
pub(super) struct Visiting<E> {
    environment: E,
    /// The values' places in the flat state.
    places: Vec<u16>,
    /// The sources that hold them.
    wanted: SourceSet,
    states: Mutex<Vec<f64>>,
}

impl<E> Visiting<E> {
    pub(super) fn new<S: Scalar>(environment: E, places: Vec<u16>) -> Self
    where
        E: Environment<S>,
    {
        let wanted = SourceSet::of_inputs(&environment.sources(), places.iter().copied());
        Self { environment, places, wanted, states: Mutex::default() }
    }

    /// Returns the states so far, concatenated.
    pub(super) fn states(&self) -> Vec<f64> {
        self.states.lock().unwrap_or_else(PoisonError::into_inner).clone()
    }
}

impl<S: Scalar, E: Environment<S>> Environment<S> for Visiting<E> {
    type Task = E::Task;
    type Episode = E::Episode;

    forward!(this => this.environment;
        sources actions time_limit draw start step outcomes timeout measure preference accepts
        key cycle training task_from guarded moment distance);

    fn observe(&self, episode: &mut Self::Episode, _: SourceSet, state: &mut [S]) {
        self.environment.observe_some(episode, self.wanted, &self.places, state);
        let seen = self.places.iter().map(|&place| state[usize::from(place)].to_f64());
        self.states.lock().unwrap_or_else(PoisonError::into_inner).extend(seen);
    }
}
