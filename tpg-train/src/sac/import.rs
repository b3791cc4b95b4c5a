//! `tpg-train import`: actors that other trainers made.
//!
//! Known are the names of Stable-Baselines3 and of CleanRL. The whole export, in Python:
//!
//! | trainer | line |
//! | --- | --- |
//! | Stable-Baselines3 | `save_file({k: v.contiguous() for k, v in model.policy.actor.state_dict().items()}, "actor.safetensors")` |
//! | CleanRL | `save_file({k: v.contiguous() for k, v in actor.state_dict().items()}, "actor.safetensors")` |
//!
//! with `from safetensors.torch import save_file`. Such a file says neither what the network reads nor what its answers
//! mean, so the command line must; sizes that do not fit what it says are refused. Hidden layers have a ReLU behind them
//! (the default of both).

use super::config::{Actor, Decides, Inputs};
use super::replay::ACTIONS;
use super::tensors::{Tensor, Tensors};
use super::weights::{Provenance, to_tensors};
use clap::Args;
use std::path::{Path, PathBuf};
use tpg_arm::sac::{Actions, Mask};
use tpg_graph::error::{InputError, Place};
use tpg_nn::{Mlp, Shape, Spread};

/// No actor file is larger, bytes.
const LIMIT: u64 = 64 << 20;

/// Turn an actor of Stable-Baselines3 or CleanRL into a policy.safetensors.
#[derive(Clone, Debug, Args)]
pub struct ImportArgs {
    /// The other trainer's actor
    pub actor: PathBuf,
    /// The policy.safetensors to write
    #[arg(long, value_name = "FILE")]
    pub out: PathBuf,
    /// What the network reads: features, paper-fs or paper-rs
    #[arg(long, value_name = "NAME", value_parser = inputs)]
    pub inputs: Inputs,
    /// What its answers mean: fine or coarse
    #[arg(long, value_name = "NAME", value_parser = actions)]
    pub actions: Actions,
    /// What the policy refuses by itself: none or joint-limits
    #[arg(long, value_name = "NAME", default_value = "none", value_parser = mask)]
    pub mask: Mask,
    /// Let the arm rest where no answer reaches a threshold
    #[arg(long)]
    pub may_rest: bool,
}

fn inputs(name: &str) -> Result<Inputs, String> {
    match name {
        "features" => Ok(Inputs::Features),
        "paper-fs" => Ok(Inputs::PaperFs),
        "paper-rs" => Ok(Inputs::PaperRs),
        _ => Err("accepted: features, paper-fs, paper-rs".to_owned()),
    }
}

fn actions(name: &str) -> Result<Actions, String> {
    Actions::from_name(name).ok_or_else(|| "accepted: fine, coarse".to_owned())
}

fn mask(name: &str) -> Result<Mask, String> {
    Mask::from_name(name).ok_or_else(|| "accepted: none, joint-limits".to_owned())
}

/// Reads the actor, checks it, writes the policy.
///
/// # Errors
/// If the file is damaged, is neither trainer's, or does not fit what the arguments say.
pub fn import(args: &ImportArgs) -> Result<(), InputError> {
    let file = Tensors::read(&args.actor, LIMIT)?;
    let (network, trainer) = from_tensors(file, args.inputs).map_err(|(place, found, accepted)| {
        InputError::new(args.actor.display().to_string(), Place::Path(place), found, accepted)
    })?;
    let actor = Actor {
        inputs: args.inputs,
        hidden: network.shape().hidden.clone(),
        layer_norm: false,
        spread: Spread::LogSigma,
        actions: args.actions,
        mask: args.mask,
        may_rest: args.may_rest,
        decides: Decides::ByMean,
    };
    let provenance = Provenance {
        tool: format!("{trainer}, imported by tpg-train {}", env!("CARGO_PKG_VERSION")),
        config: String::new(),
        problem: String::new(),
        seed: 0,
        decisions: 0,
        validation_success: 0.0,
    };
    to_tensors(&network, &actor, provenance).write(Path::new(&args.out))
}

type Refusal = (String, String, String);

/// The names of a trainer's layers.
struct Names {
    trainer: &'static str,
    hidden: fn(usize) -> String,
    mean: &'static str,
    spread: &'static str,
}

const TRAINERS: [Names; 2] = [
    Names {
        trainer: "Stable-Baselines3",
        // A Sequential of Linear and ReLU by turns.
        hidden: |layer| format!("latent_pi.{}", 2 * layer),
        mean: "mu",
        spread: "log_std",
    },
    Names { trainer: "CleanRL", hidden: |layer| format!("fc{}", layer + 1), mean: "fc_mean", spread: "fc_logstd" },
];

/// The network of another trainer's file, and the trainer's name.
///
/// # Errors
/// As [`import`]: place, what was found, what is accepted.
pub fn from_tensors(mut file: Tensors, inputs: Inputs) -> Result<(Mlp<f32>, &'static str), Refusal> {
    let known = |names: &&Names| file.tensors.contains_key(&format!("{}.weight", names.mean));
    let Some(names) = TRAINERS.iter().find(known) else {
        let found = file.tensors.keys().cloned().collect::<Vec<_>>().join(" ");
        let accepted = "an actor of Stable-Baselines3 (mu.weight, ...) or CleanRL (fc_mean.weight, ...)";
        return Err((String::new(), format!("tensors {found}"), accepted.to_owned()));
    };
    let mut hidden = Vec::new();
    let mut flat = Vec::new();
    let mut width = inputs.count();
    while file.tensors.contains_key(&format!("{}.weight", (names.hidden)(hidden.len()))) && hidden.len() < 8 {
        let layer = take_layer(&mut file, &(names.hidden)(hidden.len()), width, None)?;
        let units = layer.1.len();
        append(&mut flat, &layer, width);
        hidden.push(units);
        width = units;
    }
    let mut head = take_layer(&mut file, names.mean, width, Some(ACTIONS))?;
    let (weights, bias) = take_layer(&mut file, names.spread, width, Some(ACTIONS))?;
    head.0.extend(weights);
    head.1.extend(bias);
    append(&mut flat, &head, width);
    for (name, value) in [("action_scale", 1.0), ("action_bias", 0.0)] {
        let Some(tensor) = file.tensors.remove(name) else { continue };
        if tensor.values.iter().any(|&found| found != value) {
            return Err((name.to_owned(), format!("{:?}", tensor.values), format!("{value}: actions within −1..1")));
        }
    }
    if let Some(unknown) = file.tensors.keys().next() {
        let accepted = format!("only the tensors of an actor of {}", names.trainer);
        return Err((unknown.clone(), "a tensor of that name".to_owned(), accepted));
    }
    let shape = Shape { inputs: inputs.count(), hidden, outputs: 2 * ACTIONS, norm: false };
    let network = Mlp::from_parameters(shape, flat).expect("every layer fits the one before");
    Ok((network, names.trainer))
}

type Layer = (Vec<f32>, Vec<f32>);

/// Weights (row-major) and bias of a layer whose input is `inputs` wide.
fn take_layer(file: &mut Tensors, name: &str, inputs: usize, outputs: Option<usize>) -> Result<Layer, Refusal> {
    let mut take = |part: &str| -> Result<(String, Tensor), Refusal> {
        let name = format!("{name}.{part}");
        let tensor = file.tensors.remove(&name);
        let tensor = tensor.ok_or_else(|| (name.clone(), "nothing".to_owned(), "a tensor".to_owned()))?;
        match tensor.values.iter().find(|value| !value.is_finite()) {
            Some(value) => Err((name, value.to_string(), "finite numbers".to_owned())),
            None => Ok((name, tensor)),
        }
    };
    let (weight_name, weight) = take("weight")?;
    let (bias_name, bias) = take("bias")?;
    let units = outputs.unwrap_or(bias.values.len());
    if weight.shape != [units, inputs] || !(1..=4096).contains(&units) {
        let accepted = format!("{units} × {inputs}, from 1 to 4096 units");
        return Err((weight_name, format!("shape {:?}", weight.shape), accepted));
    }
    if bias.shape != [units] {
        return Err((bias_name, format!("shape {:?}", bias.shape), format!("{units} numbers")));
    }
    Ok((weight.values, bias.values))
}

/// Appends a layer as the flat parameters have it: weights column-major, then bias.
fn append(flat: &mut Vec<f32>, (weights, bias): &Layer, inputs: usize) {
    let units = bias.len();
    flat.extend((0..inputs).flat_map(|i| (0..units).map(move |o| (i, o))).map(|(i, o)| weights[o * inputs + i]));
    flat.extend(bias);
}
