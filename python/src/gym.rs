//! A Gymnasium environment as an [`Environment`], for trainers that step it themselves.

use crate::driver::Driver;
use crate::space::{Space, seed_of};
use pyo3::prelude::*;
use std::sync::{Arc, Mutex, MutexGuard, PoisonError};
use tpg_engine::random::Stream;
use tpg_engine::{Act, ActionSpace, End, Environment, SourceSet, Step};
use tpg_graph::SourceDocument;

/// Drivers that no episode uses.
type Idle = Arc<Mutex<Vec<Py<Driver>>>>;

/// An environment with outputs, one for each episode that is under way at a time.
pub(crate) struct Gym {
    space: Space,
    /// Makes a driver with an environment of its own.
    make: Py<PyAny>,
    idle: Idle,
    /// The first error: the contract of environments knows no errors.
    failed: Mutex<Option<PyErr>>,
}

/// A running episode.
pub(crate) struct Episode {
    driver: Option<Py<Driver>>,
    idle: Idle,
    seed: u64,
    step: u32,
    state: Vec<f64>,
}

impl Drop for Episode {
    fn drop(&mut self) {
        lock(&self.idle).extend(self.driver.take());
    }
}

fn lock<T>(mutex: &Mutex<T>) -> MutexGuard<'_, T> {
    mutex.lock().unwrap_or_else(PoisonError::into_inner)
}

impl Gym {
    /// Describes an environment; `make` makes a driver for another one.
    pub(crate) fn new(space: Space, make: Py<PyAny>) -> Self {
        Self { space, make, idle: Idle::default(), failed: Mutex::new(None) }
    }

    /// Takes what went wrong.
    pub(crate) fn failed(&self) -> Option<PyErr> {
        lock(&self.failed).take()
    }

    fn driver(&self, py: Python<'_>) -> PyResult<Py<Driver>> {
        if let Some(driver) = lock(&self.idle).pop() {
            return Ok(driver);
        }
        Ok(self.make.bind(py).call0()?.cast::<Driver>()?.clone().unbind())
    }

    /// Keeps an error, and goes on with what stands for the result.
    fn kept<T>(&self, result: PyResult<T>) -> Option<T> {
        let error = match result {
            Ok(value) => return Some(value),
            Err(error) => error,
        };
        lock(&self.failed).get_or_insert(error);
        None
    }
}

impl Environment<f32> for Gym {
    /// The seed of `reset`.
    type Task = u64;
    type Episode = Episode;

    fn sources(&self) -> Vec<SourceDocument> {
        self.space.sources.clone()
    }
    fn actions(&self) -> ActionSpace {
        self.space.actions.clone()
    }
    fn time_limit(&self) -> u32 {
        self.space.limit
    }
    fn draw(&self, stream: &mut Stream) -> u64 {
        seed_of(stream)
    }

    fn start(&self, &seed: &u64) -> Episode {
        let mut state = Vec::new();
        let driver = Python::attach(|py| {
            let begun = self.driver(py).and_then(|driver| {
                driver.get().begin(py, seed, &mut state)?;
                Ok(driver)
            });
            self.kept(begun)
        });
        state.resize(self.space.length(), 0.0);
        Episode { driver, idle: Arc::clone(&self.idle), seed, step: 0, state }
    }

    fn observe(&self, episode: &mut Episode, _wanted: SourceSet, state: &mut [f32]) {
        state.iter_mut().zip(&episode.state).for_each(|(slot, &value)| *slot = value as f32);
    }

    fn step(&self, episode: &mut Episode, act: Act<'_, f32>) -> Step {
        episode.step += 1;
        let Episode { driver, seed, step, state, .. } = episode;
        let taken = Python::attach(|py| {
            let driver = driver.as_ref()?.get();
            let action = driver.values(py, act.values().iter().map(|&value| value.into()).collect());
            let at = || format!("seed {seed}, step {step}");
            self.kept(action.and_then(|action| driver.advance(action, state, at)))
        });
        taken.unwrap_or(Step::reward(0.0).ending(End::new(0)))
    }
}
