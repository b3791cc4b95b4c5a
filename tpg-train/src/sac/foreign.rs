//! Actors of other trainers: Stable-Baselines3 and CleanRL.
//!
//! Hidden layers have a ReLU behind them, the default of both. Both squash a Gaussian by tanh, and stretch it to the range
//! of the actions.

use super::tensors::Tensors;
use tpg_engine::Output;
use tpg_graph::error::Finding;
use tpg_nn::Mlp;

/// The names of a trainer's layers.
struct ForeignNames {
    trainer: &'static str,
    hidden: fn(usize) -> String,
    mean: &'static str,
    spread: &'static str,
}

const TRAINERS: [ForeignNames; 2] = [
    ForeignNames {
        trainer: "Stable-Baselines3",
        // A Sequential of Linear and ReLU by turns.
        hidden: |layer| format!("latent_pi.{}", 2 * layer),
        mean: "mu",
        spread: "log_std",
    },
    ForeignNames {
        trainer: "CleanRL",
        hidden: |layer| format!("fc{}", layer + 1),
        mean: "fc_mean",
        spread: "fc_logstd",
    },
];

/// The network of another trainer's file, and the trainer's name.
///
/// # Errors
/// If the file is neither trainer's, or does not fit that many inputs and these outputs.
pub fn from_tensors(mut file: Tensors, inputs: usize, outputs: &[Output]) -> Result<(Mlp, &'static str), Finding> {
    let known = |names: &&ForeignNames| file.tensors.contains_key(&format!("{}.weight", names.mean));
    let Some(names) = TRAINERS.iter().find(known) else {
        let found = file.tensors.keys().cloned().collect::<Vec<_>>().join(" ");
        let accepted = "an actor of Stable-Baselines3 (mu.weight, ...) or CleanRL (fc_mean.weight, ...)";
        return Err(Finding::new("", format!("tensors {found}"), accepted));
    };
    let mut count = 0;
    while count < 8 && file.tensors.contains_key(&format!("{}.weight", (names.hidden)(count))) {
        count += 1;
    }
    let hidden = (0..count).map(|layer| ((names.hidden)(layer), None)).collect();
    let network = file.take_network((inputs, outputs.len()), hidden, [names.mean, names.spread])?;
    type Stretch = fn(&Output) -> f64;
    let stretch: [(&str, Stretch); 2] = [
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
    file.refuse_rest(&format!("only the tensors of an actor of {}", names.trainer))?;
    Ok((network, names.trainer))
}
