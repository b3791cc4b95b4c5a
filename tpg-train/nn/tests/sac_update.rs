//! Compares two complete updates of the soft actor-critic with numbers computed by PyTorch.

use serde::Deserialize;
use tpg_nn::{Agent, Experience, Gaussian, Mlp, Rates, Shape};

#[derive(Deserialize)]
struct Fixture {
    inputs: usize,
    batch: usize,
    actor_hidden: Vec<usize>,
    critic_hidden: Vec<usize>,
    rate: f64,
    temperature_rate: f64,
    follow: f64,
    target_entropy: f64,
    before: Parameters,
    updates: Vec<Update>,
}

#[derive(Deserialize)]
struct Parameters {
    actor: Vec<f64>,
    critics: [Vec<f64>; 2],
    slow: [Vec<f64>; 2],
    log_alpha: f64,
}

#[derive(Deserialize)]
struct Update {
    states: Vec<f64>,
    actions: Vec<f64>,
    rewards: Vec<f64>,
    discounts: Vec<f64>,
    next: Vec<f64>,
    next_noise: Vec<f64>,
    noise: Vec<f64>,
    critic_loss: f64,
    actor_loss: f64,
    entropy: f64,
    after: Parameters,
}

const ACTIONS: usize = 4;

fn fixture() -> Fixture {
    serde_json::from_str(include_str!("fixtures/sac-update/update.json")).expect("the fixture is JSON")
}

/// Returns the largest difference of two lists, relative to the larger of 1 and the second's magnitude.
fn difference(ours: &[f32], theirs: &[f64]) -> f64 {
    assert_eq!(ours.len(), theirs.len());
    let relative = |(ours, theirs): (&f32, &f64)| (f64::from(*ours) - theirs).abs() / (1.0 + theirs.abs());
    ours.iter().zip(theirs).map(relative).fold(0.0, f64::max)
}

#[test]
fn two_updates_are_near_pytorchs() {
    let fixture = fixture();
    let narrow = |values: &[f64]| -> Vec<f32> { values.iter().map(|&value| value as f32).collect() };
    let network = |inputs, hidden: &[usize], outputs, parameters: &[f64]| {
        let shape = Shape { inputs, hidden: hidden.to_vec(), outputs };
        Mlp::from_parameters(shape, narrow(parameters)).expect("the fixture fits its shape")
    };
    let actor = network(fixture.inputs, &fixture.actor_hidden, 2 * ACTIONS, &fixture.before.actor);
    let critics = (fixture.before.critics.each_ref())
        .map(|critic| network(fixture.inputs + ACTIONS, &fixture.critic_hidden, 1, critic));
    let gaussian = Gaussian { actions: ACTIONS };
    let mut agent = Agent::new(actor, critics, gaussian, fixture.before.log_alpha);
    let mut space = agent.workspace(fixture.batch);
    let rates = Rates {
        learning: fixture.rate,
        temperature: fixture.temperature_rate,
        follow: fixture.follow,
        target_entropy: fixture.target_entropy,
    };
    for (number, update) in fixture.updates.iter().enumerate() {
        let lists = [
            &update.states,
            &update.actions,
            &update.rewards,
            &update.discounts,
            &update.next,
            &update.next_noise,
            &update.noise,
        ]
        .map(|list| narrow(list));
        let [states, actions, rewards, discounts, next, next_noise, noise] = lists;
        let experience = Experience { states, actions, rewards, discounts, next, next_noise, noise };
        let report = agent.update(&mut space, &experience, &rates);
        let after = &update.after;
        let pairs = [
            ("actor", difference(agent.actor.network.parameters(), &after.actor)),
            ("critic 0", difference(agent.critics[0].network.parameters(), &after.critics[0])),
            ("critic 1", difference(agent.critics[1].network.parameters(), &after.critics[1])),
            ("slow 0", difference(agent.slow[0].parameters(), &after.slow[0])),
            ("slow 1", difference(agent.slow[1].parameters(), &after.slow[1])),
            ("temperature", difference(&[agent.log_alpha], &[after.log_alpha])),
            ("critic loss", difference(&[report.critic_loss as f32], &[update.critic_loss])),
            ("actor loss", difference(&[report.actor_loss as f32], &[update.actor_loss])),
            ("entropy", difference(&[report.entropy as f32], &[update.entropy])),
        ];
        for (what, difference) in pairs {
            assert!(difference < 1e-4, "update {number}, {what}: off by {difference}");
        }
    }
}
