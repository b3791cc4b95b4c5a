//! `policy.safetensors`: a trained actor with its contract.
//!
//! Tensors, in PyTorch's orientation (a `Linear`'s weight is outputs × inputs): `hidden.0.weight`, `hidden.0.bias`,
//! and so on for each hidden layer; `mean.weight`,
//! `mean.bias`, and `spread.weight`, `spread.bias`, which only training needs. The metadata's one key `tpg` holds the
//! contract as JSON.

use super::contract::Contract;
use super::tensors::{Tensor, Tensors};
use crate::run_args::place;
use std::path::Path;
use tpg_graph::error::{Finding, InputError};
use tpg_nn::Mlp;

/// No policy file is larger, bytes.
pub const LIMIT: u64 = 64 << 20;

/// An actor as a file.
pub fn to_tensors(network: &Mlp, contract: &Contract) -> Tensors {
    let text = Some(serde_json::to_string(contract).expect("plain data"));
    let mut tensors = Tensors { text, ..Tensors::default() };
    let mut insert = |name: String, shape: Vec<usize>, values: Vec<f32>| {
        tensors.tensors.insert(name, Tensor { shape, values });
    };
    let mut inputs = network.shape().inputs;
    for (index, (weights, bias)) in network.weights().into_iter().enumerate() {
        let heads = match index < contract.actor.hidden.len() {
            true => vec![format!("hidden.{index}")],
            false => ["mean", "spread"].map(str::to_owned).into(),
        };
        let units = bias.len() / heads.len();
        let parts = weights.chunks_exact(units * inputs).zip(bias.chunks_exact(units));
        for (head, (weights, bias)) in heads.iter().zip(parts) {
            insert(format!("{head}.weight"), vec![units, inputs], weights.to_vec());
            insert(format!("{head}.bias"), vec![units], bias.to_vec());
        }
        inputs = bias.len();
    }
    tensors
}

/// Reads a policy file.
///
/// # Errors
/// If it is damaged, has another version's contract, a missing, additional or misshapen tensor, or a number that is not
/// finite.
pub fn read(path: &Path) -> Result<(Mlp, Contract), InputError> {
    from_tensors(Tensors::read(path, LIMIT)?).map_err(|finding| place(path, finding))
}

/// Returns the actor of a file.
///
/// # Errors
/// As [`read`].
pub fn from_tensors(mut file: Tensors) -> Result<(Mlp, Contract), Finding> {
    let contract = Contract::from_text(file.text.as_deref())?;
    let hidden = contract.actor.hidden.iter().enumerate();
    let hidden = hidden.map(|(layer, &units)| (format!("hidden.{layer}"), Some(units))).collect();
    let sizes = (contract.inputs.len(), contract.outputs.len());
    let network = file.take_network(sizes, hidden, ["mean", "spread"])?;
    file.refuse_rest("only the tensors of the contract's network")?;
    Ok((network, contract))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::configuration::Configuration as _;
    use crate::sac::config::SacConfig;
    use crate::sac::contract::NetworkOrigin;
    use crate::sac::interface::Interface;
    use tpg_engine::random::{Purpose, Stream};
    use tpg_nn::Shape;
    use tpg_problems::{Pendulum, Problem, ProblemName};

    fn example() -> (Mlp, Tensors) {
        let config = SacConfig::preset("general").expect("a preset");
        let actor = crate::sac::config::Actor { hidden: vec![6, 5], ..config.actor };
        let shape = Shape { inputs: 3, hidden: actor.hidden.clone(), outputs: 2 };
        let mut random = Stream::new(1, 0, Purpose::Test, 30);
        let mut network = Mlp::random(shape, || random.unit());
        for (index, parameter) in network.parameters_mut().iter_mut().enumerate() {
            *parameter += index as f32 * 1e-6;
        }
        let problem = Problem::new(ProblemName::Pendulum).to_table();
        let interface = Interface::new(&Pendulum, true).expect("a torque");
        let provenance = NetworkOrigin { config: "test".to_owned(), ..NetworkOrigin::default() };
        let tensors = to_tensors(&network, &Contract::new(problem, &interface, actor, provenance));
        (network, tensors)
    }

    #[test]
    fn a_network_comes_back_as_it_was() {
        let (network, tensors) = example();
        let (read, contract) = from_tensors(tensors).expect("a good file");
        assert_eq!(read, network);
        assert_eq!(contract.provenance.config, "test");
        assert_eq!(contract.interface(), Interface::new(&Pendulum, true).expect("a torque"));
    }

    #[test]
    fn a_foreign_or_damaged_file_is_refused_at_its_place() {
        let place = |change: &dyn Fn(&mut Tensors)| {
            let (_, mut tensors) = example();
            change(&mut tensors);
            from_tensors(tensors).map(|_| ()).map_err(|finding| finding.key)
        };
        fn tensor<'a>(tensors: &'a mut Tensors, name: &str) -> &'a mut Tensor {
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
            (&text("\"version\":2", "\"version\":9"), "metadata.tpg.version"),
            (&text("\"min\":-2.0", "\"min\":2.0"), "metadata.tpg.outputs"),
            (&text("\"hidden\":[6", "\"hidden\":[640000000"), "metadata.tpg.actor.hidden"),
            (&|t| drop(t.tensors.remove("mean.bias")), "mean.bias"),
            (&|t| tensor(t, "hidden.1.weight").shape = vec![6, 5], "hidden.1.weight"),
            (&|t| tensor(t, "hidden.0.bias").values[3] = f32::NAN, "hidden.0.bias"),
            (&|t| drop(t.tensors.insert("extra".to_owned(), Tensor::flat(vec![1.0]))), "extra"),
        ] {
            assert_eq!(place(change), Err(expected.to_owned()));
        }
    }
}
