//! Actors of other trainers: Stable-Baselines3 and CleanRL.
//!
//! Hidden layers have a ReLU behind them, the default of both. Both squash a Gaussian by tanh, and stretch it to the range
//! of the actions.

use super::tensors::{Tensor, Tensors};
use tpg_engine::Output;
use tpg_graph::error::Finding;
use tpg_nn::{Mlp, Shape};

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
/// If the file is neither trainer's, or does not fit that many inputs and these outputs.
pub fn from_tensors(mut file: Tensors, inputs: usize, outputs: &[Output]) -> Result<(Mlp<f32>, &'static str), Finding> {
    let known = |names: &&Names| file.tensors.contains_key(&format!("{}.weight", names.mean));
    let Some(names) = TRAINERS.iter().find(known) else {
        let found = file.tensors.keys().cloned().collect::<Vec<_>>().join(" ");
        let accepted = "an actor of Stable-Baselines3 (mu.weight, ...) or CleanRL (fc_mean.weight, ...)";
        return Err(Finding::new("", format!("tensors {found}"), accepted));
    };
    let mut hidden = Vec::new();
    let mut flat = Vec::new();
    let mut width = inputs;
    while file.tensors.contains_key(&format!("{}.weight", (names.hidden)(hidden.len()))) && hidden.len() < 8 {
        let layer = take_layer(&mut file, &(names.hidden)(hidden.len()), width, None)?;
        let units = layer.1.len();
        append(&mut flat, &layer, width);
        hidden.push(units);
        width = units;
    }
    let mut head = take_layer(&mut file, names.mean, width, Some(outputs.len()))?;
    let (weights, bias) = take_layer(&mut file, names.spread, width, Some(outputs.len()))?;
    head.0.extend(weights);
    head.1.extend(bias);
    append(&mut flat, &head, width);
    type Of = fn(&Output) -> f64;
    let stretch: [(&str, Of); 2] = [
        ("action_scale", |number| 0.5 * (number.max - number.min)),
        ("action_bias", |number| 0.5 * (number.max + number.min)),
    ];
    for (name, number) in stretch {
        let Some(tensor) = file.tensors.remove(name) else { continue };
        let expected: Vec<f32> = outputs.iter().map(|output| number(output) as f32).collect();
        // One number stands for all.
        let fits = tensor.values == expected
            || tensor.values.len() == 1 && expected.iter().all(|value| *value == tensor.values[0]);
        if !fits {
            return Err(Finding::new(
                name,
                format!("{:?}", tensor.values),
                format!("{expected:?}: the outputs' range"),
            ));
        }
    }
    if let Some(unknown) = file.tensors.keys().next() {
        let accepted = format!("only the tensors of an actor of {}", names.trainer);
        return Err(Finding::new(unknown, "a tensor of that name", accepted));
    }
    let shape = Shape { inputs, hidden, outputs: 2 * outputs.len(), norm: false };
    let network = Mlp::from_parameters(shape, flat).expect("every layer fits the one before");
    Ok((network, names.trainer))
}

type Layer = (Vec<f32>, Vec<f32>);

/// Weights (row-major) and bias of a layer whose input is `inputs` wide.
fn take_layer(file: &mut Tensors, name: &str, inputs: usize, outputs: Option<usize>) -> Result<Layer, Finding> {
    let mut take = |part: &str| -> Result<(String, Tensor), Finding> {
        let name = format!("{name}.{part}");
        let tensor = file.tensors.remove(&name);
        let tensor = tensor.ok_or_else(|| Finding::new(&name, "nothing", "a tensor"))?;
        match tensor.values.iter().find(|value| !value.is_finite()) {
            Some(value) => Err(Finding::new(name, value, "finite numbers")),
            None => Ok((name, tensor)),
        }
    };
    let (weight_name, weight) = take("weight")?;
    let (bias_name, bias) = take("bias")?;
    let units = outputs.unwrap_or(bias.values.len());
    if weight.shape != [units, inputs] || !(1..=4096).contains(&units) {
        let accepted = format!("{units} × {inputs}, from 1 to 4096 units");
        return Err(Finding::new(weight_name, format!("shape {:?}", weight.shape), accepted));
    }
    if bias.shape != [units] {
        return Err(Finding::new(bias_name, format!("shape {:?}", bias.shape), format!("{units} numbers")));
    }
    Ok((weight.values, bias.values))
}

/// Appends a layer as the flat parameters have it: weights column-major, then bias.
fn append(flat: &mut Vec<f32>, (weights, bias): &Layer, inputs: usize) {
    let units = bias.len();
    flat.extend((0..inputs).flat_map(|i| (0..units).map(move |o| (i, o))).map(|(i, o)| weights[o * inputs + i]));
    flat.extend(bias);
}
