//! Learning to choose among named actions: soft actor-critic with a value for each action (Christodoulou 2019, 1910.07207).
//!
//! The actor's first outputs are preferences, π their softmax; its others are unused. A critic answers Q(s, i) for every action i at
//! once, so that means over actions are sums and need no draw. An action in a batch has one component for each name, 1 for the one taken.
//!
//! One update is, in this order:
//! 1. critics: (Q(s, a) − y)² with y = r + discount·Σ π(i|s′)·(min Q̄(s′, i) − α ln π(i|s′));
//! 2. actor: Σ π(i|s)·(α ln π(i|s) − min Q(s, i)), the critics just updated;
//! 3. temperature: −ln α·(target entropy − entropy), the entropy that of 2;
//! 4. the slow copies follow by τ.

use super::agent::{Agent, Bootstrap, Experience, Rates, UpdateFigures, Workspace, least};
use tpg_nn::{Mlp, Real, Tape, softmax, softmax_backward};

/// The share of the greatest possible entropy, that of an actor without preferences, to which the temperature holds an actor
/// where the configuration does not say it.
const USUAL_ENTROPY: f64 = 0.3;

/// Returns the usual target entropy among that many actions.
pub(super) fn usual_entropy(actions: usize) -> f64 {
    USUAL_ENTROPY * libm::log(actions as f64)
}

/// Scratch memory of an update: π and ln π of each sample, one column a sample.
#[derive(Clone, Debug)]
pub(super) struct Choices<T> {
    probabilities: Vec<T>,
    logarithms: Vec<T>,
    q: Vec<T>,
}

impl<T: Real> Choices<T> {
    /// Allocates for that many actions and samples.
    pub(super) fn new(actions: usize, batch: usize) -> Self {
        let zeros = |count: usize| vec![T::zero(); count];
        Self { probabilities: zeros(actions * batch), logarithms: zeros(actions * batch), q: zeros(actions) }
    }

    /// Lets the actor answer states.
    fn decide(&mut self, actor: &Mlp<T>, tape: &mut Tape<T>, states: &[T], actions: usize) {
        tape.input_mut().copy_from_slice(states);
        actor.forward(tape);
        let columns = tape.output().chunks_exact(2 * actions);
        let answers = self.probabilities.chunks_exact_mut(actions).zip(self.logarithms.chunks_exact_mut(actions));
        for (output, (probabilities, logarithms)) in columns.zip(answers) {
            softmax(&output[..actions], probabilities, logarithms);
        }
    }
}

impl<T: Real> Agent<T> {
    pub(super) fn update_choosing(
        &mut self,
        space: &mut Workspace<T>,
        batch: Experience<'_, T>,
        rates: &Rates,
    ) -> UpdateFigures {
        let alpha = self.log_alpha.exponential();
        self.expect_from_critics(space, batch, alpha);
        let critic_loss = self.update_critics_of_choices(space, batch, rates.learning);
        let (actor_loss, entropy) = self.update_choice(space, batch, alpha, rates.learning);
        self.settle(T::of(entropy), rates);
        UpdateFigures { critic_loss, actor_loss, entropy, temperature: alpha.wide() }
    }

    /// Computes the critics' targets from their slow copies.
    fn expect_from_critics(&self, space: &mut Workspace<T>, batch: Experience<'_, T>, alpha: T) {
        let Bootstrap::SlowCritics(slow) = &self.bootstrap else { return };
        let actions = self.gaussian().actions;
        space.choices.decide(&self.actor.network, &mut space.actor, batch.next, actions);
        let [tape, _] = &mut space.critics;
        tape.input_mut().copy_from_slice(batch.next);
        for (slow, by_q) in slow.iter().zip(&mut space.by_q) {
            slow.forward(tape);
            by_q.copy_from_slice(tape.output());
        }
        let [first, second] = &space.by_q;
        for (sample, wanted) in space.wanted.iter_mut().enumerate() {
            let mut value = T::zero();
            for at in sample * actions..(sample + 1) * actions {
                let q = least(first[at], second[at]);
                value += space.choices.probabilities[at] * (q - alpha * space.choices.logarithms[at]);
            }
            *wanted = batch.rewards[sample] + batch.discounts[sample] * value;
        }
    }

    /// Moves both critics' value of the action taken towards `space.wanted`.
    fn update_critics_of_choices(&mut self, space: &mut Workspace<T>, batch: Experience<'_, T>, rate: f64) -> f64 {
        let actions = self.gaussian().actions;
        let scale = T::of(2.0 / space.wanted.len() as f64);
        let mut loss = 0.0;
        let ([tape, _], [by_q, _]) = (&mut space.critics, &mut space.by_q);
        tape.input_mut().copy_from_slice(batch.states);
        for critic in &mut self.critics {
            critic.network.forward(tape);
            let mut squares = T::zero();
            for (at, (by_q, (&q, &taken))) in by_q.iter_mut().zip(tape.output().iter().zip(batch.actions)).enumerate() {
                let error = if taken > T::zero() { q - space.wanted[at / actions] } else { T::zero() };
                squares += error * error;
                *by_q = scale * error;
            }
            loss += squares.wide() / space.wanted.len() as f64;
            let gradient = &mut space.gradient[..critic.network.parameters().len()];
            critic.network.backward(tape, by_q, Some(gradient), None);
            critic.descend(gradient, rate);
        }
        loss
    }

    /// Updates the actor; returns its loss and its entropy.
    fn update_choice(&mut self, space: &mut Workspace<T>, batch: Experience<'_, T>, alpha: T, rate: f64) -> (f64, f64) {
        let actions = self.gaussian().actions;
        let size = space.wanted.len();
        let share = T::one() / T::of(size as f64);
        space.choices.decide(&self.actor.network, &mut space.actor, batch.states, actions);
        for (critic, tape) in self.critics.iter().zip(&mut space.critics) {
            tape.input_mut().copy_from_slice(batch.states);
            critic.network.forward(tape);
        }
        let [first, second] = space.critics.each_ref().map(|tape| tape.output().chunks_exact(actions));
        let choices = &mut space.choices;
        let policy = choices.probabilities.chunks_exact(actions).zip(choices.logarithms.chunks_exact(actions));
        let columns = space.by_outputs.chunks_exact_mut(2 * actions);
        let (mut loss, mut entropy) = (T::zero(), T::zero());
        for ((column, policy), (first, second)) in columns.zip(policy).zip(first.zip(second)) {
            for (q, (&first, &second)) in choices.q.iter_mut().zip(first.iter().zip(second)) {
                *q = least(first, second);
            }
            let (by_preferences, unused) = column.split_at_mut(actions);
            unused.fill(T::zero());
            loss += softmax_backward(policy, &choices.q, alpha, share, by_preferences);
            let (probabilities, logarithms) = policy;
            entropy = probabilities.iter().zip(logarithms).fold(entropy, |sum, (&p, &log)| sum - p * log);
        }
        let gradient = &mut space.gradient[..self.actor.network.parameters().len()];
        self.actor.network.backward(&mut space.actor, &space.by_outputs, Some(gradient), None);
        self.actor.descend(gradient, rate);
        ((loss * share).wide(), (entropy * share).wide())
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::sac::presets;
    use tpg_engine::random::{Purpose, Stream};
    use tpg_nn::Gaussian;

    const ACTIONS: usize = 5;
    const BATCH: usize = 32;

    /// A walk over two states: the action of the state's number pays 1 and ends the walk, action 2 leads to the other state and pays
    /// nothing, all others end it with nothing. In state 1 the right action pays 3, so that in state 0 waiting is best.
    fn after(state: usize, action: usize) -> (f64, f64) {
        match action {
            2 => (0.0, 0.9),
            action if action == state => ([1.0, 3.0][state], 0.0),
            _ => (0.0, 0.0),
        }
    }

    fn one_hot(place: usize, count: usize) -> impl Iterator<Item = f64> {
        (0..count).map(move |index| f64::from(u8::from(index == place)))
    }

    #[test]
    fn it_learns_which_action_pays_and_which_one_pays_later() {
        let mut config = presets::config(presets::find("general").expect("a preset")).expect("it is accepted");
        (config.actor.hidden, config.critic.hidden) = (vec![16], vec![16]);
        let gaussian = Gaussian { actions: ACTIONS, spread: config.actor.spread };
        let mut random = Stream::new(1, 0, Purpose::Test, 24);
        let mut agent = Agent::<f64>::new(&config, 2, gaussian, true, &mut random);
        let mut space = agent.workspace(BATCH);
        let target_entropy = usual_entropy(ACTIONS);
        let rates = Rates { learning: 5e-3, temperature: 5e-3, follow: 0.05, target_entropy };
        let mut last = UpdateFigures::default();
        for _ in 0..3000 {
            let drawn: Vec<_> = (0..BATCH).map(|_| (random.below(2), random.below(ACTIONS))).collect();
            let of = |state: usize| one_hot(state, 2);
            let states: Vec<f64> = drawn.iter().flat_map(|&(state, _)| of(state)).collect();
            let next: Vec<f64> = drawn.iter().flat_map(|&(state, _)| of(1 - state)).collect();
            let actions: Vec<f64> = drawn.iter().flat_map(|&(_, action)| one_hot(action, ACTIONS)).collect();
            let (rewards, discounts): (Vec<f64>, Vec<f64>) =
                drawn.iter().map(|&(state, action)| after(state, action)).unzip();
            let batch = Experience {
                states: &states,
                actions: &actions,
                rewards: &rewards,
                discounts: &discounts,
                next: &next,
                next_noise: &[],
                noise: &[],
            };
            last = agent.update(&mut space, batch, &rates);
        }
        let states: Vec<f64> = (0..BATCH).flat_map(|sample| one_hot(sample % 2, 2)).collect();
        space.choices.decide(&agent.actor.network, &mut space.actor, &states, ACTIONS);
        let policy = |state: usize| &space.choices.probabilities[state * ACTIONS..][..ACTIONS];
        assert!(policy(0)[2] > 0.5 && policy(1)[1] > 0.5, "{:?} {:?}", policy(0), policy(1));
        assert!((last.entropy - target_entropy).abs() < 0.15, "{last:?}");
        assert!(last.critic_loss < 0.05, "{last:?}");
    }

    #[test]
    fn an_actor_without_preferences_takes_every_action_equally_often() {
        let (mut random, mut action) = (Stream::new(2, 0, Purpose::Test, 25), Vec::new());
        let mut counts = [0; 4];
        for _ in 0..4000 {
            crate::sac::policy::draw_choice(&[3.0, 3.0, 3.0, -1000.0], &mut random, &mut action);
            assert_eq!(action.iter().sum::<f32>(), 1.0);
            counts[action.iter().position(|&taken| taken == 1.0).expect("one is taken")] += 1;
        }
        assert!(counts[..3].iter().all(|&count| (1200..1470).contains(&count)) && counts[3] == 0, "{counts:?}");
    }
}
