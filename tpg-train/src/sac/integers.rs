//! A trained actor in integers.

use super::contract::Contract;
use super::policy::NetworkPolicy;
use tpg_codegen::policy::{
    FloatLayer, FloatNetwork, FloatOutput, FloatValue, Input, Output, Preferences, QuantiseError, QuantisedPolicy,
    quantise as quantise_layers,
};
use tpg_engine::{Decision, Environment, Rollout, TaskSet, tasks};
use tpg_graph::error::{InputError, Place};
use tpg_nn::Mlp;
use tpg_runtime::net::{Kind, PREFERENCE_ONE, Squash};
use tpg_runtime::policy::ActionId;

/// Calibration episodes: training tasks, never validation or test tasks.
const CALIBRATION: usize = 100;

/// The layers of an actor that decide: its last layer without the spreads, which only training needs.
pub(crate) fn deciding_layers(network: &Mlp, actions: usize) -> Vec<FloatLayer> {
    let mut inputs = network.shape().inputs;
    let mut layers = Vec::new();
    for (mut weights, mut bias) in network.weights() {
        if layers.len() == network.shape().hidden.len() {
            weights.truncate(actions * inputs);
            bias.truncate(actions);
        }
        let outputs = bias.len();
        layers.push(FloatLayer { inputs, weights, bias });
        inputs = outputs;
    }
    layers
}

/// Puts an actor into integers, calibrated on the states that it visits on training tasks of `seed`. `preferences` is the meaning
/// of its outputs, if they are not values.
///
/// # Errors
/// If it has numbers that do not fit; `file` is what the error names.
pub(crate) fn quantised(
    file: &str,
    (network, contract): (&Mlp, &Contract),
    preferences: Option<Preferences>,
    environment: &impl Environment<f32>,
    source_sha256: String,
    kind: Kind,
    seed: u64,
) -> Result<QuantisedPolicy, InputError> {
    let refuse = |found: String, accepted: &str| InputError::new(file, Place::Whole, found, accepted);
    let layers = deciding_layers(network, contract.outputs.len());
    let inputs = contract.inputs.iter();
    let inputs: Vec<Input> =
        inputs.map(|item| Input { name: item.name.clone(), offset: item.offset, scale: item.scale }).collect();
    let policy = NetworkPolicy::new(network, contract.interface());
    let mut states = Vec::new();
    for task in tasks(environment, TaskSet::Calibration, seed, CALIBRATION) {
        Rollout::new(environment, &task).run(|state| {
            states.push(state.to_vec());
            Decision::Values(policy.answer(state))
        });
    }
    let refused = |error: QuantiseError| refuse(error.to_string(), "a network whose numbers fit");
    if let Some(preferences) = preferences {
        let layers = quantise_layers(&layers, &policy.greatest_activations(&states), kind).map_err(refused)?;
        return QuantisedPolicy::new(source_sha256, inputs, Output::Preferences(preferences), kind, layers);
    }
    let values = contract.outputs.iter().map(|output| FloatValue {
        name: output.name.clone(),
        min: output.min as f32,
        max: output.max as f32,
        squash: Squash::Tanh,
    });
    let float = FloatNetwork { inputs, layers, output: FloatOutput::Values(values.collect()) };
    float.quantise(&states, kind, source_sha256).map_err(refused)
}

/// The decision of a network in integers for a flat state.
pub(crate) fn decided(policy: &QuantisedPolicy, state: &[f32]) -> Decision<f32> {
    match policy.output {
        Output::Argmax(_) => Decision::Choice(ActionId(policy.choose(state) as u16)),
        Output::Values(_) => Decision::Values(policy.values(state)),
        Output::Preferences(_) => {
            let value = |output: i32| libm::tanhf(output as f32 / PREFERENCE_ONE);
            Decision::Values(policy.outputs(&policy.integers(state)).into_iter().map(value).collect())
        }
    }
}
