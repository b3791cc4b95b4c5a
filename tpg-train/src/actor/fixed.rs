//! An actor of the arm in integers: calibration, and the policy that the trainer evaluates.

use super::file::FloatActor;
use crate::sac::integers::deciding_layers;
use tpg_arm::cycle::Brent;
use tpg_arm::episode::Episode;
use tpg_arm::frame::Frame;
use tpg_arm::observation::Observation;
use tpg_arm::sac::fixed::{FixedDecision, quantise as quantise_features};
use tpg_arm::sac::{Actions, FEATURE_NAMES, Mask, features};
use tpg_arm::{Arm, JOINTS, Move};
use tpg_codegen::policy::{Input, Output, Preferences, QuantisedPolicy, quantise};
use tpg_graph::error::{InputError, Place};
use tpg_nn::Tape;
use tpg_problems::arm::motors::Inputs;
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
    float: &FloatActor,
    source_sha256: String,
    kind: Kind,
    seed: u64,
) -> Result<QuantisedPolicy, InputError> {
    let refuse = |found: String, accepted: &str| InputError::new(file, Place::Whole, found, accepted);
    let FloatActor { network, motors, actor } = float;
    if motors.inputs != Inputs::Features || actor.layer_norm {
        let found = format!("inputs {:?}, layer_norm {}", motors.inputs, actor.layer_norm);
        return Err(refuse(found, "the inputs \"features\" without LayerNorm"));
    }
    let layers = quantise(&deciding_layers(network, JOINTS), &greatest_activations(float, seed), kind)
        .map_err(|error| refuse(error.to_string(), "a network whose numbers fit"))?;
    let preferences = Preferences {
        actions: motors.actions.name().to_owned(),
        mask: motors.mask.name().to_owned(),
        may_rest: motors.may_rest,
    };
    let inputs = FEATURE_NAMES.map(Input::plain).into();
    QuantisedPolicy::new(source_sha256, inputs, Output::Preferences(preferences), kind, layers)
}

/// The greatest activation behind each hidden layer, over the calibration episodes.
fn greatest_activations(float: &FloatActor, seed: u64) -> Vec<f32> {
    let (policy, arm) = (float.policy(), float.motors.arm());
    let single = arm.to_f32();
    let mut tape = Tape::new(float.network.shape(), 1);
    let mut greatest = vec![0.0f32; float.actor.hidden.len()];
    for start in [Start::Fs, Start::Rs] {
        for task in tasks(&arm, seed, Set::Training, start, EPISODES) {
            let mut episode = Episode::new(&single, float.motors.tests(start).reach(&task), Brent::new());
            loop {
                let seen = *episode.observation();
                float.motors.inputs.observe(&Frame::of(&single, &seen), tape.input_mut());
                float.network.forward(&mut tape);
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

/// A network in integers behind the features.
#[derive(Debug)]
pub struct FixedActor {
    policy: QuantisedPolicy,
    decision: FixedDecision,
    description: Arm<f64>,
    /// In the precision that it runs in.
    arm: Arm<f32>,
}

impl FixedActor {
    /// The actor of a checked policy, on an arm.
    ///
    /// # Errors
    /// If it is not a network of the arm's features with a preference for each joint.
    pub fn new(policy: QuantisedPolicy, arm: &Arm<f64>) -> Result<Self, InputError> {
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
        Ok(Self { policy, decision, description: *arm, arm: arm.to_f32() })
    }

    /// Returns the arm that it drives.
    pub fn arm(&self) -> &Arm<f64> {
        &self.description
    }
}

impl Policy for FixedActor {
    type State = Observation<f32>;
    type Action = Move;

    fn decide(&self, seen: &Observation<f32>) -> Move {
        let features = quantise_features(&features(&Frame::of(&self.arm, seen)));
        let outputs = self.policy.outputs(&features);
        let preferences = std::array::from_fn(|joint| outputs.get(joint).copied().unwrap_or(0));
        self.decision.decide(preferences, seen.pose, &self.arm.ranges)
    }
}
