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
use tpg_arm::sac::{Actions, FEATURE_NAMES, Mask, features};
use tpg_arm::{JOINTS, Move, WIDOWX};
use tpg_codegen::policy::{FloatLayer, Input, Output, Preferences, QuantisedPolicy, quantise};
use tpg_graph::error::{InputError, Place};
use tpg_nn::{Mlp, Tape};
use tpg_problems::arm::targets::{Set, Start, tasks};
use tpg_runtime::net::Kind;
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
    let preferences = Preferences {
        actions: actor.actions.name().to_owned(),
        mask: actor.mask.name().to_owned(),
        may_rest: actor.may_rest,
    };
    let inputs = FEATURE_NAMES.map(Input::plain).into();
    QuantisedPolicy::new(source_sha256, inputs, Output::Preferences(preferences), kind, layers)
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
    /// If it is not a network of the arm's features with a preference for each joint.
    pub fn new(policy: QuantisedPolicy) -> Result<Self, InputError> {
        let refuse =
            |found: String, accepted: &str| Err(InputError::new("policy.q.json", Place::Whole, found, accepted));
        let names: Vec<&str> = policy.inputs.iter().map(|input| input.name.as_str()).collect();
        if names != FEATURE_NAMES {
            return refuse(format!("the inputs {}", names.join(" ")), &FEATURE_NAMES.join(" "));
        }
        let outputs = policy.layers.last().map_or(0, |layer| layer.outputs);
        let Output::Preferences(preferences) = &policy.output else {
            return refuse("a network of another problem".to_owned(), "preferences of the arm's joints");
        };
        let known = Actions::from_name(&preferences.actions).zip(Mask::from_name(&preferences.mask));
        let Some((actions, mask)) = known.filter(|_| outputs == JOINTS) else {
            let accepted = format!("{JOINTS} preferences, actions and mask that exist");
            return refuse(format!("{outputs} outputs, {preferences:?}"), &accepted);
        };
        let decision = FixedDecision::new(actions, mask, preferences.may_rest);
        Ok(Self { policy, decision })
    }
}

impl Policy for FixedActor {
    type State = Observation<f32>;
    type Action = Move;

    fn decide(&self, seen: &Observation<f32>) -> Move {
        let features = quantise_features(&features(&Frame::of(&ARM, seen)));
        let outputs = self.policy.outputs(&features);
        let preferences = std::array::from_fn(|joint| outputs.get(joint).copied().unwrap_or(0));
        self.decision.decide(preferences, seen.pose, &ARM.ranges)
    }
}
