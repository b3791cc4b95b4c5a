//! `policy.safetensors`: a trained actor with its contract.
//!
//! Tensors, in PyTorch's orientation (a `Linear`'s weight is outputs × inputs): `hidden.0.weight`, `hidden.0.bias`,
//! with LayerNorm `hidden.0.norm.weight` and `hidden.0.norm.bias`, and so on for each hidden layer; `mean.weight`,
//! `mean.bias`, and `spread.weight`, `spread.bias`, which only training needs. The metadata's one key `tpg` holds the
//! [`Contract`] as JSON: what goes in, in which order, and what comes out.

use super::config::{Actor, Inputs};
use super::replay::ACTIONS;
use super::tensors::{Tensor, Tensors};
use serde::{Deserialize, Serialize};
use std::path::Path;
use tpg_arm::sac::FEATURE_NAMES;
use tpg_graph::error::{InputError, Place};
use tpg_nn::{Mlp, Shape};

/// The value of [`Contract::format`].
pub const FORMAT: &str = "tpg sac policy";
/// Changes with every change to what a file means.
pub const VERSION: u32 = 1;
/// No policy file is larger, bytes.
const LIMIT: u64 = 64 << 20;

/// What a policy file says about its network.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Contract {
    /// [`FORMAT`].
    pub format: String,
    /// [`VERSION`].
    pub version: u32,
    /// The inputs by name, in order.
    pub observation: Vec<String>,
    /// What the outputs are: the mean of each joint's preference before the tanh.
    pub output: Vec<String>,
    /// Network, actions and mask.
    pub actor: Actor,
    /// Where the policy comes from.
    pub provenance: Provenance,
}

/// Where a policy comes from.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Provenance {
    /// Tool and version.
    pub tool: String,
    /// The configuration's name.
    pub config: String,
    /// The problem it was chosen on.
    pub problem: String,
    /// The seed.
    pub seed: u64,
    /// Decisions it was trained for.
    pub decisions: u64,
    /// Its success on the validation tasks it was chosen by.
    pub validation_success: f64,
}

impl Inputs {
    /// The names of the inputs, in order.
    pub fn names(self) -> Vec<String> {
        let axes = |what: &str| ["x", "y", "z"].map(|axis| format!("{what}_{axis}"));
        let joints = ["base", "shoulder", "elbow", "wrist"].map(str::to_owned);
        let paper = |parts: [&str; 3]| parts.into_iter().flat_map(axes).chain(joints).collect();
        match self {
            Self::Features => FEATURE_NAMES.map(str::to_owned).into(),
            Self::PaperFs => paper(["target", "difference", "hand"]),
            Self::PaperRs => paper(["target", "hand", "difference"]),
        }
    }
}

const OUTPUT: [&str; ACTIONS] = ["base", "shoulder", "elbow", "wrist"];

/// An actor as a file.
pub fn to_tensors(network: &Mlp<f32>, actor: &Actor, provenance: Provenance) -> Tensors {
    let contract = Contract {
        format: FORMAT.to_owned(),
        version: VERSION,
        observation: actor.inputs.names(),
        output: OUTPUT.map(str::to_owned).into(),
        actor: actor.clone(),
        provenance,
    };
    let mut tensors =
        Tensors { text: Some(serde_json::to_string(&contract).expect("plain data")), ..Tensors::default() };
    let mut insert = |name: String, shape: Vec<usize>, values: Vec<f32>| {
        tensors.tensors.insert(name, Tensor { shape, values });
    };
    let hidden = actor.hidden.len();
    let mut inputs = network.shape().inputs;
    for (index, (weights, bias)) in network.weights().into_iter().enumerate() {
        if index < hidden {
            let units = bias.len();
            insert(format!("hidden.{index}.weight"), vec![units, inputs], weights);
            insert(format!("hidden.{index}.bias"), vec![units], bias);
            if let Some((gain, shift)) = network.norm(index) {
                insert(format!("hidden.{index}.norm.weight"), vec![units], gain.to_vec());
                insert(format!("hidden.{index}.norm.bias"), vec![units], shift.to_vec());
            }
            inputs = units;
        } else {
            let (means, spreads) = weights.split_at(ACTIONS * inputs);
            let (mean_bias, spread_bias) = bias.split_at(ACTIONS);
            insert("mean.weight".to_owned(), vec![ACTIONS, inputs], means.to_vec());
            insert("mean.bias".to_owned(), vec![ACTIONS], mean_bias.to_vec());
            insert("spread.weight".to_owned(), vec![ACTIONS, inputs], spreads.to_vec());
            insert("spread.bias".to_owned(), vec![ACTIONS], spread_bias.to_vec());
        }
    }
    tensors
}

/// Reads a policy file.
///
/// # Errors
/// If it is damaged, says another contract than this version's, lacks a tensor, has one too many or of another shape,
/// or holds a number that is not finite.
pub fn read(path: &Path) -> Result<(Mlp<f32>, Contract), InputError> {
    let tensors = Tensors::read(path, LIMIT)?;
    from_tensors(tensors).map_err(|(place, found, accepted)| {
        InputError::new(path.display().to_string(), Place::Path(place), found, accepted)
    })
}

type Refusal = (String, String, String);

fn from_tensors(mut file: Tensors) -> Result<(Mlp<f32>, Contract), Refusal> {
    let refuse = |place: &str, found: String, accepted: &str| (place.to_owned(), found, accepted.to_owned());
    let text = file.text.as_ref().ok_or_else(|| {
        refuse(
            "metadata.tpg",
            "nothing".to_owned(),
            "the contract that `tpg-train sac` writes; `import` adds it to files of others",
        )
    })?;
    let contract: Contract = serde_json::from_str(text).map_err(|error| {
        refuse("metadata.tpg", error.to_string(), "the contract that this version of tpg-train writes")
    })?;
    if contract.format != FORMAT || contract.version != VERSION {
        let found = format!("{:?}, version {}", contract.format, contract.version);
        return Err(refuse("metadata.tpg.format", found, &format!("{FORMAT:?}, version {VERSION}")));
    }
    let names = contract.actor.inputs.names();
    if contract.observation != names {
        let found = format!("{} inputs: {}", contract.observation.len(), contract.observation.join(" "));
        let accepted = format!("{} inputs in this order: {}", names.len(), names.join(" "));
        return Err(refuse("metadata.tpg.observation", found, &accepted));
    }
    if contract.output != OUTPUT {
        return Err(refuse("metadata.tpg.output", contract.output.join(" "), &OUTPUT.join(" ")));
    }
    if contract.actor.hidden.len() > 8 || contract.actor.hidden.iter().any(|width| !(1..=4096).contains(width)) {
        let found = format!("{:?}", contract.actor.hidden);
        return Err(refuse("metadata.tpg.actor.hidden", found, "up to 8 layers of 1 to 4096 units"));
    }
    let shape = Shape {
        inputs: names.len(),
        hidden: contract.actor.hidden.clone(),
        outputs: 2 * ACTIONS,
        norm: contract.actor.layer_norm,
    };
    let mut take = |name: String, shape: &[usize]| -> Result<Vec<f32>, Refusal> {
        let Some(tensor) = file.tensors.remove(&name) else {
            return Err(refuse(&name, "nothing".to_owned(), &format!("a tensor of shape {shape:?}")));
        };
        if tensor.shape != shape {
            return Err(refuse(&name, format!("shape {:?}", tensor.shape), &format!("shape {shape:?}")));
        }
        match tensor.values.iter().position(|value| !value.is_finite()) {
            Some(at) => Err(refuse(&name, format!("{} at place {at}", tensor.values[at]), "finite numbers")),
            None => Ok(tensor.values),
        }
    };
    let mut inputs = shape.inputs;
    let mut rest: Vec<Vec<f32>> = Vec::new();
    let mut all = Vec::new();
    for (index, &units) in shape.hidden.iter().enumerate() {
        all.push((take(format!("hidden.{index}.weight"), &[units, inputs])?, inputs));
        rest.push(take(format!("hidden.{index}.bias"), &[units])?);
        if shape.norm {
            let gain = take(format!("hidden.{index}.norm.weight"), &[units])?;
            let shift = take(format!("hidden.{index}.norm.bias"), &[units])?;
            rest.last_mut().expect("just pushed").extend(gain.into_iter().chain(shift));
        }
        inputs = units;
    }
    let mut heads = take("mean.weight".to_owned(), &[ACTIONS, inputs])?;
    heads.extend(take("spread.weight".to_owned(), &[ACTIONS, inputs])?);
    let mut bias = take("mean.bias".to_owned(), &[ACTIONS])?;
    bias.extend(take("spread.bias".to_owned(), &[ACTIONS])?);
    all.push((heads, inputs));
    rest.push(bias);
    // Each layer's weights, turned to column-major, then what follows them.
    let mut flat = Vec::with_capacity(shape.parameters());
    for ((weights, inputs), rest) in all.into_iter().zip(rest) {
        let outputs = weights.len() / inputs;
        flat.extend((0..inputs).flat_map(|i| (0..outputs).map(move |o| (i, o))).map(|(i, o)| weights[o * inputs + i]));
        flat.extend(rest);
    }
    if let Some(unknown) = file.tensors.keys().next() {
        return Err(refuse(unknown, "a tensor of that name".to_owned(), "only the tensors of the contract's network"));
    }
    let network = Mlp::from_parameters(shape, flat).expect("every tensor has its shape");
    Ok((network, contract))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::sac::config::Config;
    use tpg_engine::random::{Purpose, Stream};

    fn example(preset: &str) -> (Mlp<f32>, Tensors) {
        let actor = Config::preset(preset).expect("a preset").actor;
        let shape = Shape {
            inputs: actor.inputs.count(),
            hidden: actor.hidden.clone(),
            outputs: 2 * ACTIONS,
            norm: actor.layer_norm,
        };
        let mut random = Stream::new(1, 0, Purpose::Test, 30);
        let mut network = Mlp::random(shape, || random.unit());
        for (index, parameter) in network.parameters_mut().iter_mut().enumerate() {
            *parameter += index as f32 * 1e-6;
        }
        let provenance = Provenance {
            tool: "test".to_owned(),
            config: preset.to_owned(),
            problem: "fs".to_owned(),
            seed: 1,
            decisions: 2,
            validation_success: 0.5,
        };
        let tensors = to_tensors(&network, &actor, provenance);
        (network, tensors)
    }

    #[test]
    fn a_network_comes_back_as_it_was() {
        for preset in ["best-fs", "paper-rs"] {
            let (network, tensors) = example(preset);
            let (read, contract) = from_tensors(tensors).expect("a good file");
            assert_eq!(read, network);
            assert_eq!(contract.provenance.config, preset);
        }
    }

    #[test]
    fn a_foreign_or_damaged_file_is_refused_at_its_place() {
        let place = |change: &dyn Fn(&mut Tensors)| {
            let (_, mut tensors) = example("best-fs");
            change(&mut tensors);
            from_tensors(tensors).map(|_| ()).map_err(|(place, ..)| place)
        };
        fn of<'a>(tensors: &'a mut Tensors, name: &str) -> &'a mut Tensor {
            tensors.tensors.get_mut(name).expect("a tensor of the example")
        }
        let text = |from: &'static str, to: &'static str| {
            move |tensors: &mut Tensors| {
                let text = tensors.text.take().expect("a contract");
                assert!(text.contains(from), "{from} in {text}");
                tensors.text = Some(text.replacen(from, to, 1));
            }
        };
        assert_eq!(place(&|_| ()), Ok(()));
        for (change, expected) in [
            (&(|t: &mut Tensors| t.text = None) as &dyn Fn(&mut Tensors), "metadata.tpg"),
            (&text("\"version\":1", "\"version\":9"), "metadata.tpg.format"),
            (&text("\"shoulder\"", "\"knee\""), "metadata.tpg.observation"),
            (&text("\"hidden\":[64", "\"hidden\":[640000000"), "metadata.tpg.actor.hidden"),
            (&|t| drop(t.tensors.remove("mean.bias")), "mean.bias"),
            (&|t| of(t, "hidden.1.weight").shape = vec![32, 128], "hidden.1.weight"),
            (&|t| of(t, "hidden.0.bias").values[3] = f32::NAN, "hidden.0.bias"),
            (&|t| drop(t.tensors.insert("extra".to_owned(), Tensor::flat(vec![1.0]))), "extra"),
        ] {
            assert_eq!(place(change), Err(expected.to_owned()));
        }
    }
}
