//! A trained actor in integers: calibration, and the policy that the trainer evaluates.

use super::config::{Actor, Inputs};
use super::lanes::ARM;
use super::policy::ActorPolicy;
use super::replay::ACTIONS;
use tpg_arm::cycle::Brent;
use tpg_arm::episode::Episode;
use tpg_arm::frame::Frame;
use tpg_arm::observation::Observation;
use tpg_arm::sac::fixed::{FixedDecision, quantise as quantise_features};
use tpg_arm::sac::packed::Kind;
use tpg_arm::sac::{Actions, Mask, features};
use tpg_arm::{Move, WIDOWX};
use tpg_codegen::policy::{FloatLayer, QuantisedPolicy, quantise};
use tpg_graph::error::{InputError, Place};
use tpg_nn::{Mlp, Tape};
use tpg_problems::arm::targets::{Set, Start, tasks};
use tpg_runtime::policy::Policy;

/// Calibration episodes of each start: training tasks, never validation or test tasks.
const EPISODES: usize = 100;

/// Puts an actor into integers, calibrated on the states that it meets in training tasks of that seed.
///
/// # Errors
/// If it has other inputs than the features, LayerNorm, or numbers that do not fit.
pub fn quantise_actor(
    file: &str,
    network: &Mlp<f32>,
    actor: &Actor,
    source_sha256: String,
    kind: Kind,
    seed: u64,
) -> Result<QuantisedPolicy, InputError> {
    let refuse = |found: String, accepted: &str| InputError::new(file, Place::Whole, found, accepted);
    if actor.inputs != Inputs::Features || actor.layer_norm {
        let found = format!("inputs {:?}, layer_norm {}", actor.inputs, actor.layer_norm);
        return Err(refuse(found, "the inputs \"features\" without LayerNorm"));
    }
    let mut inputs = network.shape().inputs;
    let mut layers = Vec::new();
    for (mut weights, mut bias) in network.weights() {
        if layers.len() == actor.hidden.len() {
            // The second half, the spreads, is training's alone.
            weights.truncate(ACTIONS * inputs);
            bias.truncate(ACTIONS);
        }
        let outputs = bias.len();
        layers.push(FloatLayer { inputs, weights, bias });
        inputs = outputs;
    }
    let layers = quantise(&layers, &greatest_activations(network, actor, seed), kind)
        .map_err(|error| refuse(error.to_string(), "a network whose numbers fit"))?;
    QuantisedPolicy::new(source_sha256, actor.actions, actor.mask, actor.may_rest, kind, layers)
}

/// The greatest activation behind each hidden layer, over the calibration episodes.
fn greatest_activations(network: &Mlp<f32>, actor: &Actor, seed: u64) -> Vec<f32> {
    let policy = ActorPolicy::new(network, actor);
    let mut tape = Tape::new(network.shape(), 1);
    let mut greatest = vec![0.0f32; actor.hidden.len()];
    for start in [Start::Fs, Start::Rs] {
        for task in tasks(&WIDOWX, seed, Set::Training, start, EPISODES) {
            let mut episode = Episode::new(&ARM, task.problem(start), Brent::new());
            loop {
                let seen = *episode.observation();
                actor.inputs.observe(&Frame::of(&ARM, &seen), tape.input_mut());
                network.forward(&mut tape);
                for (layer, greatest) in greatest.iter_mut().enumerate() {
                    *greatest = tape.activations(layer).iter().copied().fold(*greatest, f32::max);
                }
                if episode.advance(policy.decide(&seen)).is_some() {
                    break;
                }
            }
        }
    }
    greatest
}

/// A policy in integers behind the features.
#[derive(Debug)]
pub struct FixedActor {
    policy: QuantisedPolicy,
    decision: FixedDecision,
}

impl FixedActor {
    /// Of a checked policy.
    ///
    /// # Errors
    /// None in practice: a checked policy names actions and mask that exist.
    pub fn new(policy: QuantisedPolicy) -> Result<Self, InputError> {
        let known = Actions::from_name(&policy.actions).zip(Mask::from_name(&policy.mask));
        let (actions, mask) = known.ok_or_else(|| {
            InputError::new("policy.q.json", Place::Whole, policy.actions.clone(), "actions and mask that exist")
        })?;
        let decision = FixedDecision::new(actions, mask, policy.may_rest);
        Ok(Self { policy, decision })
    }
}

impl Policy for FixedActor {
    type State = Observation<f32>;
    type Action = Move;

    fn decide(&self, seen: &Observation<f32>) -> Move {
        let features = quantise_features(&features(&Frame::of(&ARM, seen)));
        self.decision.decide(self.policy.preferences(&features), seen.pose, &ARM.ranges)
    }
}
