//! A trained actor as a policy of the arm.

use super::config::{Actor, Inputs};
use super::lanes::{ARM, Discretiser};
use super::nn::{Mlp, Tape};
use super::replay::ACTIONS;
use std::cell::RefCell;
use tpg_runtime::arm::Move;
use tpg_runtime::frame::Frame;
use tpg_runtime::observation::Observation;
use tpg_runtime::policy::Policy;

/// An actor's mean action, in `f32`: the same on every machine, and the same as in its training.
#[derive(Debug)]
pub struct ActorPolicy<'a> {
    network: &'a Mlp<f32>,
    inputs: Inputs,
    discretiser: Discretiser,
    tape: RefCell<Tape<f32>>,
}

impl<'a> ActorPolicy<'a> {
    /// The policy of a network that was trained under that configuration.
    ///
    /// # Panics
    /// If the network's input or output is not the configuration's.
    pub fn new(network: &'a Mlp<f32>, actor: &Actor) -> Self {
        assert_eq!(network.shape().inputs, actor.inputs.count(), "an actor of other inputs");
        assert!(network.shape().outputs >= ACTIONS, "an actor of other outputs");
        let tape = RefCell::new(Tape::new(network.shape(), 1));
        Self { network, inputs: actor.inputs, discretiser: Discretiser::new(actor), tape }
    }

    /// The means before the tanh.
    pub fn preferences(&self, frame: &Frame<'_, f32>) -> [f32; ACTIONS] {
        let mut tape = self.tape.borrow_mut();
        self.inputs.observe(frame, tape.input_mut());
        self.network.forward(&mut tape);
        std::array::from_fn(|joint| tape.output()[joint])
    }
}

impl Policy for ActorPolicy<'_> {
    type State = Observation<f32>;
    type Action = Move;

    fn decide(&self, seen: &Observation<f32>) -> Move {
        self.discretiser.decide(self.preferences(&Frame::of(&ARM, seen)), seen.pose)
    }
}
