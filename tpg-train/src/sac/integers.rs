//! A trained actor in integers, and how well it does beside floating point.

use super::contract::Contract;
use super::episode::play;
use super::policy::NetworkPolicy;
use serde::Serialize;
use std::fmt;
use tpg_codegen::policy::{FloatLayer, FloatNetwork, FloatOutput, FloatValue, Input, QuantisedPolicy};
use tpg_engine::random::{Purpose, Stream};
use tpg_engine::{Environment, Summary};
use tpg_graph::error::{InputError, Place};
use tpg_nn::Mlp;
use tpg_runtime::net::{Kind, Squash};

/// Calibration episodes: training tasks, never validation or test tasks.
const CALIBRATION: u64 = 100;
/// Test episodes of a comparison.
const EPISODES: u64 = 1000;

/// The layers of an actor that decide: its last layer without the spreads, which only training needs.
pub fn deciding_layers(network: &Mlp<f32>, actions: usize) -> Vec<FloatLayer> {
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

/// Puts an actor into integers, calibrated on the states that it visits on training tasks of `seed`.
///
/// # Errors
/// If it has LayerNorm, or numbers that do not fit; `file` is what the error names.
pub fn quantise(
    file: &str,
    (network, contract): (&Mlp<f32>, &Contract),
    environment: &impl Environment<f32>,
    source_sha256: String,
    kind: Kind,
    seed: u64,
) -> Result<QuantisedPolicy, InputError> {
    let refuse = |found: String, accepted: &str| InputError::new(file, Place::Whole, found, accepted);
    if contract.actor.layer_norm {
        return Err(refuse("layer_norm = true".to_owned(), "a network without LayerNorm"));
    }
    let values = contract.outputs.iter().map(|output| FloatValue {
        name: output.name.clone(),
        min: output.min as f32,
        max: output.max as f32,
        squash: Squash::Tanh,
    });
    let inputs = contract.inputs.iter();
    let float = FloatNetwork {
        inputs: inputs.map(|of| Input { name: of.name.clone(), offset: of.offset, scale: of.scale }).collect(),
        layers: deciding_layers(network, contract.outputs.len()),
        output: FloatOutput::Values(values.collect()),
    };
    let policy = NetworkPolicy::new(network, contract.interface(), &contract.actor);
    let mut states = Vec::new();
    for index in 0..CALIBRATION {
        let task = environment.draw(&mut Stream::new(seed, index, Purpose::Reset, 0));
        let answer = |state: &[f32], values: &mut Vec<f32>| {
            states.push(state.to_vec());
            policy.answer(state, values);
        };
        play(environment, &task, answer, |_episode| ());
    }
    float
        .quantise(&states, kind, source_sha256)
        .map_err(|error| refuse(error.to_string(), "a network whose numbers fit"))
}

/// An actor in integers beside the same in floating point, on test episodes.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct Comparison {
    /// The widths of weights and activations.
    pub kind: String,
    /// Bytes of its constants.
    pub bytes: usize,
    /// Multiplications of a weight that one decision costs.
    pub multiplications: usize,
    /// How far outputs differ; absent on the arm.
    #[serde(flatten, skip_serializing_if = "Option::is_none")]
    pub differences: Option<Differences>,
    /// In floating point.
    pub float: Summary,
    /// In integers.
    pub fixed: Summary,
}

/// Differences of outputs, at the states that the policy in floating point visits.
#[derive(Clone, Copy, Debug, PartialEq, Serialize)]
pub struct Differences {
    /// The mean difference of an output, as a fraction of half its range.
    pub mean_difference: f64,
    /// The maximum of these differences.
    pub greatest_difference: f64,
}

impl Comparison {
    /// The comparison of an actor and its integers on the test episodes of `seed`.
    pub fn new(
        (network, contract): (&Mlp<f32>, &Contract),
        fixed: &QuantisedPolicy,
        environment: &impl Environment<f32>,
        seed: u64,
    ) -> Self {
        let interface = contract.interface();
        let float = NetworkPolicy::new(network, contract.interface(), &contract.actor);
        let (mut endings, mut count, mut sum, mut greatest) = ([Vec::new(), Vec::new()], 0usize, 0.0, 0.0f64);
        for index in 0..EPISODES {
            let task = environment.draw(&mut Stream::new(seed, 0, Purpose::Evaluation, index));
            let compared = |state: &[f32], values: &mut Vec<f32>| {
                float.answer(state, values);
                for ((a, b), of) in values.iter().zip(fixed.values(state)).zip(&interface.outputs) {
                    let difference = f64::from((a - b).abs()) / (0.5 * (of.max - of.min));
                    (count, sum, greatest) = (count + 1, sum + difference, greatest.max(difference));
                }
            };
            endings[0].push(play(environment, &task, compared, |_episode| ()));
            let alone = |state: &[f32], values: &mut Vec<f32>| *values = fixed.values(state);
            endings[1].push(play(environment, &task, alone, |_episode| ()));
        }
        Self {
            kind: fixed.kind.clone(),
            bytes: fixed.bytes(),
            multiplications: fixed.multiplications(),
            differences: Some(Differences {
                mean_difference: sum / count.max(1) as f64,
                greatest_difference: greatest,
            }),
            float: Summary::of(&endings[0]),
            fixed: Summary::of(&endings[1]),
        }
    }
}

impl fmt::Display for Comparison {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let Self { float, fixed, .. } = self;
        let (float_score, fixed_score, episodes) = (float.score, fixed.score, float.episodes);
        write!(
            f,
            "mean score {float_score:.2} in floating point, {fixed_score:.2} in integers, on {episodes} episodes"
        )?;
        if let Some((float, fixed)) = float.success.zip(fixed.success) {
            write!(f, "; success {:.1} % and {:.1} %", 100.0 * float, 100.0 * fixed)?;
        }
        let Some(Differences { mean_difference, greatest_difference }) = self.differences else { return Ok(()) };
        write!(
            f,
            "; outputs differ by {:.2} % of half their range in the mean, {:.1} % at most",
            100.0 * mean_difference,
            100.0 * greatest_difference
        )
    }
}
