//! The soft actor-critic proper: an actor, two critics with slow copies, a temperature, and how one batch changes them
//! (Haarnoja et al. 2018, the second version with learned temperature).
//!
//! With γ already in the transitions' discounts, one [`update`](Agent::update) is, in this order:
//! 1. critics: (Q(s, a) − y)² with y = r + discount·(min Q̄(s′, a′) − α ln π(a′|s′)), a′ drawn from the actor;
//! 2. actor: α ln π(a|s) − min Q(s, a), a drawn from the actor, the critics just updated;
//! 3. temperature: −ln α·(ln π + target entropy), with the densities of 2;
//! 4. the slow copies follow by τ.

use crate::{Adam, Gaussian, Mlp, Samples, Shape, Tape};
use serde::{Deserialize, Serialize};

/// The step sizes and constants of an update.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Rates {
    /// Adam's step for actor and critics.
    pub learning: f64,
    /// Adam's step for ln α.
    pub temperature: f64,
    /// τ: the fraction by which the slow critics follow.
    pub follow: f64,
    /// The entropy that the temperature holds the actor to, nats.
    pub target_entropy: f64,
}

/// A batch for one update: one column per sample; `noise` is standard normal.
#[derive(Clone, Debug, Default)]
pub struct Experience {
    /// inputs × batch.
    pub states: Vec<f32>,
    /// actions × batch.
    pub actions: Vec<f32>,
    /// One a sample.
    pub rewards: Vec<f32>,
    /// One a sample.
    pub discounts: Vec<f32>,
    /// inputs × batch.
    pub next: Vec<f32>,
    /// actions × batch: for the actions in `next`.
    pub next_noise: Vec<f32>,
    /// actions × batch: for the actions in `states`.
    pub noise: Vec<f32>,
}

/// Figures of an update, averaged over its batch.
#[derive(Clone, Copy, Debug, Default, PartialEq, Serialize, Deserialize)]
pub struct UpdateFigures {
    /// Mean squared error of the two critics, summed.
    pub critic_loss: f64,
    /// α ln π − min Q.
    pub actor_loss: f64,
    /// −ln π.
    pub entropy: f64,
    /// α before the update.
    pub temperature: f64,
}

/// A parameter vector with its optimiser.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Learner {
    /// The network.
    pub network: Mlp,
    /// Its optimiser.
    pub adam: Adam,
}

impl Learner {
    fn new(network: Mlp) -> Self {
        let adam = Adam::new(network.parameters().len());
        Self { network, adam }
    }

    fn descend(&mut self, gradient: &[f32], rate: f64) {
        self.adam.step(self.network.parameters_mut(), gradient, rate);
    }
}

/// Everything that learns.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Agent {
    /// Outputs a [`Gaussian`] over actions.
    pub actor: Learner,
    /// Two estimates of the value of a state and an action.
    pub critics: [Learner; 2],
    /// Slow copies of the critics, the source of a next state's value.
    pub slow: [Mlp; 2],
    /// ln α.
    pub log_alpha: f32,
    /// The optimiser of ln α.
    pub alpha_adam: Adam,
    gaussian: Gaussian,
}

/// Scratch memory of an update, allocated once for one batch size.
#[derive(Clone, Debug)]
pub struct Workspace {
    actor: Tape,
    critics: [Tape; 2],
    gradient: Vec<f32>,
    by_q: [Vec<f32>; 2],
    /// By the critics' inputs, of which the actions are the last.
    by_input: [Vec<f32>; 2],
    by_actions: Vec<f32>,
    by_outputs: Vec<f32>,
    wanted: Vec<f32>,
    samples: Samples,
}

impl Agent {
    /// Creates an agent with random weights, drawn by `unit`, for states of that many inputs; `hidden` holds the units of each hidden
    /// layer of the actor and of the critics.
    pub fn random(
        inputs: usize,
        hidden: [&[usize]; 2],
        gaussian: Gaussian,
        log_alpha: f64,
        mut unit: impl FnMut() -> f64,
    ) -> Self {
        let shape = |inputs, hidden: &[usize], outputs| Shape { inputs, hidden: hidden.to_vec(), outputs };
        let actor = shape(inputs, hidden[0], 2 * gaussian.actions);
        let critic = shape(inputs + gaussian.actions, hidden[1], 1);
        let actor = Mlp::random(actor, &mut unit);
        let critics = [(); 2].map(|()| Mlp::random(critic.clone(), &mut unit));
        Self::new(actor, critics, gaussian, log_alpha)
    }

    /// Creates an agent from given networks, with new optimisers and slow copies equal to the critics.
    pub fn new(actor: Mlp, critics: [Mlp; 2], gaussian: Gaussian, log_alpha: f64) -> Self {
        let (slow, critics) = (critics.clone(), critics.map(Learner::new));
        let (actor, log_alpha, alpha_adam) = (Learner::new(actor), log_alpha as f32, Adam::new(1));
        Self { actor, critics, slow, log_alpha, alpha_adam, gaussian }
    }

    /// Allocates scratch memory for updates with `batch` samples.
    pub fn workspace(&self, batch: usize) -> Workspace {
        let (actor, critic) = (self.actor.network.shape(), self.critics[0].network.shape());
        let (zeros, actions) = (|rows: usize| vec![0.0; rows * batch], self.gaussian.actions);
        let widest = self.actor.network.parameters().len().max(self.critics[0].network.parameters().len());
        Workspace {
            actor: Tape::new(actor, batch),
            critics: [Tape::new(critic, batch), Tape::new(critic, batch)],
            gradient: vec![0.0; widest],
            by_q: [zeros(1), zeros(1)],
            by_input: [zeros(actions), zeros(actions)],
            by_actions: zeros(actions),
            by_outputs: zeros(2 * actions),
            wanted: zeros(1),
            samples: Samples::default(),
        }
    }

    /// Learns from one batch.
    ///
    /// # Panics
    /// If the batch has another size than the workspace.
    pub fn update(&mut self, space: &mut Workspace, batch: &Experience, rates: &Rates) -> UpdateFigures {
        let alpha = libm::expf(self.log_alpha);
        self.bootstrap_from_critics(space, batch, alpha);
        let critic_loss = self.update_critics(space, batch, rates.learning);
        self.actor_answers(space, &batch.states);
        let actor_loss = self.update_actor(space, batch, alpha, rates.learning);
        let mean_density = mean(&space.samples.log_densities);
        let mut log_alpha = [self.log_alpha];
        self.alpha_adam.step(&mut log_alpha, &[-mean_density - rates.target_entropy as f32], rates.temperature);
        [self.log_alpha] = log_alpha;
        for (slow, critic) in self.slow.iter_mut().zip(&self.critics) {
            slow.follow(&critic.network, rates.follow as f32);
        }
        UpdateFigures { critic_loss, actor_loss, entropy: f64::from(-mean_density), temperature: alpha.into() }
    }

    fn actor_answers(&self, space: &mut Workspace, states: &[f32]) {
        space.actor.input_mut().copy_from_slice(states);
        self.actor.network.forward(&mut space.actor);
    }

    /// Draws an action for each state from the actor's output, and evaluates it with both critics.
    fn judge_own_actions(&self, space: &mut Workspace, states: &[f32], noise: &[f32]) {
        self.gaussian.sample(space.actor.output(), noise, &mut space.samples);
        let [first, second] = &mut space.critics;
        join(first.input_mut(), states, &space.samples.actions, self.gaussian.actions);
        second.input_mut().copy_from_slice(first.input_mut());
        for (critic, tape) in self.critics.iter().zip(&mut space.critics) {
            critic.network.forward(tape);
        }
    }

    /// Computes the critics' targets from their slow copies.
    fn bootstrap_from_critics(&self, space: &mut Workspace, batch: &Experience, alpha: f32) {
        self.actor_answers(space, &batch.next);
        self.gaussian.sample(space.actor.output(), &batch.next_noise, &mut space.samples);
        // One tape for both, so that it stays near the processor.
        let [tape, _] = &mut space.critics;
        join(tape.input_mut(), &batch.next, &space.samples.actions, self.gaussian.actions);
        for (slow, by_q) in self.slow.iter().zip(&mut space.by_q) {
            slow.forward(tape);
            by_q.copy_from_slice(tape.output());
        }
        let [first, second] = &space.by_q;
        let values = first.iter().zip(second).zip(&space.samples.log_densities);
        let returns = batch.rewards.iter().zip(&batch.discounts);
        for ((wanted, ((&first, &second), &density)), (&reward, &discount)) in
            space.wanted.iter_mut().zip(values).zip(returns)
        {
            *wanted = reward + discount * (least(first, second) - alpha * density);
        }
    }

    /// Moves both critics towards `space.wanted`.
    fn update_critics(&mut self, space: &mut Workspace, batch: &Experience, rate: f64) -> f64 {
        let scale = (2.0 / space.wanted.len() as f64) as f32;
        let mut loss = 0.0;
        // One tape for both, so that it stays near the processor.
        let ([tape, _], [by_q, _]) = (&mut space.critics, &mut space.by_q);
        join(tape.input_mut(), &batch.states, &batch.actions, self.gaussian.actions);
        for critic in &mut self.critics {
            critic.network.forward(tape);
            let mut squares = 0.0;
            for ((by_q, &q), &wanted) in by_q.iter_mut().zip(tape.output()).zip(&space.wanted) {
                squares += (q - wanted) * (q - wanted);
                *by_q = scale * (q - wanted);
            }
            loss += f64::from(squares) / space.wanted.len() as f64;
            let gradient = &mut space.gradient[..critic.network.parameters().len()];
            critic.network.backward(tape, by_q, Some(gradient), None);
            critic.descend(gradient, rate);
        }
        loss
    }

    /// Updates the actor, which has already been run on the states.
    fn update_actor(&mut self, space: &mut Workspace, batch: &Experience, alpha: f32, rate: f64) -> f64 {
        self.judge_own_actions(space, &batch.states, &batch.noise);
        let size = space.wanted.len();
        let share = 1.0 / size as f32;
        let mut loss = 0.0;
        for sample in 0..size {
            let [first, second] = space.critics.each_ref().map(|tape| tape.output()[sample]);
            loss += alpha * space.samples.log_densities[sample] - least(first, second);
            // The loss depends on the smaller estimate only.
            let (by_first, by_second) = if second < first { (0.0, -share) } else { (-share, 0.0) };
            space.by_q[0][sample] = by_first;
            space.by_q[1][sample] = by_second;
        }
        let critics = self.critics.iter().zip(&mut space.critics);
        for ((critic, tape), (by_q, by_input)) in critics.zip(space.by_q.iter().zip(&mut space.by_input)) {
            critic.network.backward(tape, by_q, None, Some(by_input));
        }
        let [first, second] = &space.by_input;
        for ((by_action, &first), &second) in space.by_actions.iter_mut().zip(first).zip(second) {
            *by_action = first + second;
        }
        let (noise, by_outputs) = (&batch.noise, &mut space.by_outputs);
        self.gaussian.backward(&space.samples, noise, &space.by_actions, alpha * share, by_outputs);
        let gradient = &mut space.gradient[..self.actor.network.parameters().len()];
        self.actor.network.backward(&mut space.actor, by_outputs, Some(gradient), None);
        self.actor.descend(gradient, rate);
        f64::from(loss * share)
    }

    /// Returns the distribution that the actor's outputs parameterise.
    pub fn gaussian(&self) -> Gaussian {
        self.gaussian
    }
}

/// Stacks columns of states on columns of actions: a critic's input.
fn join(input: &mut [f32], states: &[f32], actions: &[f32], components: usize) {
    let inputs = states.len() * components / actions.len();
    let parts = states.chunks_exact(inputs).zip(actions.chunks_exact(components));
    for (column, (state, action)) in input.chunks_exact_mut(inputs + components).zip(parts) {
        column[..inputs].copy_from_slice(state);
        column[inputs..].copy_from_slice(action);
    }
}

fn least(a: f32, b: f32) -> f32 {
    if b < a { b } else { a }
}

fn mean(values: &[f32]) -> f32 {
    values.iter().fold(0.0, |sum, &value| sum + value) / values.len() as f32
}
