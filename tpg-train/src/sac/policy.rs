//! A trained actor as a policy of its environment.

use super::config::{Actor, Decides};
use super::episode::play;
use super::interface::Interface;
use std::cell::RefCell;
use tpg_engine::random::{Purpose, Stream};
use tpg_engine::{Ending, Environment};
use tpg_nn::{Gaussian, Mlp, Samples, Tape};

/// An actor, in `f32`: the same on every machine, and the same as in its training.
#[derive(Debug)]
pub(crate) struct NetworkPolicy<'a> {
    network: &'a Mlp<f32>,
    interface: Interface,
    gaussian: Gaussian,
    decides: Decides,
    tape: RefCell<Tape<f32>>,
}

impl<'a> NetworkPolicy<'a> {
    /// The policy of a network that was trained under that configuration.
    ///
    /// # Panics
    /// If the network's input or output is not the interface's.
    pub(crate) fn new(network: &'a Mlp<f32>, interface: Interface, actor: &Actor) -> Self {
        let gaussian = Gaussian { actions: interface.outputs.len(), spread: actor.spread };
        assert_eq!(network.shape().inputs, interface.inputs.len(), "an actor of other inputs");
        assert_eq!(network.shape().outputs, 2 * gaussian.actions, "an actor of other outputs");
        let tape = RefCell::new(Tape::new(network.shape(), 1));
        Self { network, interface, gaussian, decides: actor.decides, tape }
    }

    /// One episode of each task.
    pub(crate) fn endings<E: Environment<f32>>(&self, environment: &E, tasks: &[E::Task]) -> Vec<Ending> {
        tasks.iter().enumerate().map(|(place, task)| self.watch(environment, place, task, |_episode| ())).collect()
    }

    /// The episode at that place of a list, decided as the actor does outside of training; `each` sees it at its start and
    /// after every action.
    pub(crate) fn watch<E: Environment<f32>>(
        &self,
        environment: &E,
        place: usize,
        task: &E::Task,
        each: impl FnMut(&E::Episode),
    ) -> Ending {
        let mut random = Stream::new(0, place as u64, Purpose::Draws, 0);
        play(environment, task, |state, values| self.values(state, &mut random, values), each)
    }

    /// Returns true if it decides by the mean of its actions.
    pub(crate) fn decides_by_mean(&self) -> bool {
        self.decides.is_by_mean()
    }

    /// Computes the means of the actions before the tanh.
    pub(crate) fn means(&self, state: &[f32], means: &mut [f32]) {
        let mut tape = self.tape.borrow_mut();
        self.forward(state, &mut tape);
        means.copy_from_slice(&tape.output()[..self.gaussian.actions]);
    }

    /// The values for a flat state, decided by the mean.
    pub(crate) fn answer(&self, state: &[f32], values: &mut Vec<f32>) {
        let mut tape = self.tape.borrow_mut();
        self.forward(state, &mut tape);
        let means = &tape.output()[..self.gaussian.actions];
        let action: Vec<f32> = means.iter().map(|&mean| libm::tanhf(mean)).collect();
        self.interface.values(&action, values);
    }

    /// The values for a flat state, decided as the actor does outside of training.
    pub(crate) fn values(&self, state: &[f32], random: &mut Stream, values: &mut Vec<f32>) {
        if self.decides.is_by_mean() {
            return self.answer(state, values);
        }
        let mut tape = self.tape.borrow_mut();
        self.forward(state, &mut tape);
        let (mut noise, mut samples) = (vec![0.0; self.gaussian.actions], Samples::default());
        random.normals(&mut noise);
        self.gaussian.sample(tape.output(), &noise, &mut samples);
        self.interface.values(&samples.actions, values);
    }

    fn forward(&self, state: &[f32], tape: &mut Tape<f32>) {
        tape.input_mut().copy_from_slice(state);
        self.interface.scale(tape.input_mut());
        self.network.forward(tape);
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::sac::presets;
    use tpg_nn::Shape;
    use tpg_problems::Pendulum;

    #[test]
    fn a_policy_that_draws_draws_the_same_again_and_not_its_mean() {
        let interface = Interface::new(&Pendulum, true).expect("a torque");
        let mut actor = presets::config(presets::find("general").expect("a preset")).expect("it is accepted").actor;
        let mut random = Stream::new(3, 0, Purpose::Test, 0);
        let shape = Shape { inputs: 3, hidden: vec![8], outputs: 2, norm: false };
        let network = Mlp::random(shape, || random.unit());
        let tasks = tpg_engine::tasks::<f32, _>(&Pendulum, tpg_engine::TaskSet::Validation, 0, 3);
        let endings = |actor: &Actor| NetworkPolicy::new(&network, interface.clone(), actor).endings(&Pendulum, &tasks);
        let by_mean = endings(&actor);
        actor.decides = Decides::ByDraw;
        assert_eq!(endings(&actor), endings(&actor));
        assert_ne!(endings(&actor), by_mean);
    }
}
