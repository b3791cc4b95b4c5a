//! A trained actor as a policy of its environment.

use super::interface::Interface;
use std::cell::{RefCell, RefMut};
use tpg_engine::{Decision, Environment, EpisodeResult, Rollout};
use tpg_nn::{Mlp, Tape};

/// An actor, in `f32`: the same on every machine, and the same as in its training.
#[derive(Debug)]
pub(crate) struct NetworkPolicy<'a> {
    network: &'a Mlp,
    interface: Interface,
    tape: RefCell<Tape>,
}

impl<'a> NetworkPolicy<'a> {
    /// The policy of a network that decides by the mean of its actions.
    ///
    /// # Panics
    /// If the network's input or output is not the interface's.
    pub(crate) fn new(network: &'a Mlp, interface: Interface) -> Self {
        assert_eq!(network.shape().inputs, interface.inputs.len(), "an actor of other inputs");
        assert_eq!(network.shape().outputs, 2 * interface.outputs.len(), "an actor of other outputs");
        let tape = RefCell::new(Tape::new(network.shape(), 1));
        Self { network, interface, tape }
    }

    /// Lets it do a task; `each` sees the episode at its start and after every action.
    pub(crate) fn watch<E: Environment<f32>>(
        &self,
        environment: &E,
        task: &E::Task,
        each: impl FnMut(&E::Episode),
    ) -> EpisodeResult {
        Rollout::new(environment, task).watch(|state| Decision::Values(self.answer(state)), each)
    }

    /// The values for a flat state, decided by the mean.
    pub(crate) fn answer(&self, state: &[f32]) -> Vec<f32> {
        let tape = self.forward(state);
        let means = &tape.output()[..self.interface.outputs.len()];
        self.interface.values(means.iter().map(|&mean| libm::tanhf(mean)))
    }

    /// Returns the greatest activation of each hidden layer in some states.
    pub(crate) fn greatest_activations(&self, states: &[Vec<f32>]) -> Vec<f32> {
        let mut greatest = vec![0.0f32; self.network.shape().hidden.len()];
        for state in states {
            let tape = self.forward(state);
            for (layer, greatest) in greatest.iter_mut().enumerate() {
                *greatest = tape.activations(layer).iter().copied().fold(*greatest, f32::max);
            }
        }
        greatest
    }

    fn forward(&self, state: &[f32]) -> RefMut<'_, Tape> {
        let mut tape = self.tape.borrow_mut();
        tape.input_mut().copy_from_slice(state);
        self.interface.scale(tape.input_mut());
        self.network.forward(&mut tape);
        tape
    }
}
