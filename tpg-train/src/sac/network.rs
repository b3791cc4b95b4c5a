//! A policy file of either kind, ready to act.

use super::contract::Contract;
use super::integers::{decided, quantised};
use super::interface::input_names;
use super::policy::NetworkPolicy;
use super::weights;
use crate::folder::frame::checksum;
use std::path::Path;
use tpg_codegen::policy::{Output, QuantisedPolicy};
use tpg_engine::{ActionSpace, Decision, Environment};
use tpg_graph::SourceDocument;
use tpg_graph::error::{InputError, Place};
use tpg_graph::files::read_text;
use tpg_nn::Mlp;
use tpg_runtime::net::Kind;

/// A trained network: `policy.safetensors` or `policy.q.json`.
#[derive(Clone, Debug)]
pub enum Network {
    /// In floating point.
    Float(Box<(Mlp, Contract)>),
    /// In integers.
    Fixed(Box<QuantisedPolicy>),
}

/// A network's decision for a flat state.
pub type Decide<'n> = Box<dyn Fn(&[f32]) -> Decision<f32> + 'n>;

impl Network {
    /// Reads either file: JSON is the one in integers.
    ///
    /// # Errors
    /// If it is neither.
    pub fn read(path: &Path) -> Result<Self, InputError> {
        if path.extension().is_none_or(|extension| extension != "json") {
            return Ok(Self::Float(Box::new(weights::read(path)?)));
        }
        let text = read_text(path, "a policy.q.json")?;
        Ok(Self::Fixed(Box::new(QuantisedPolicy::from_json(&path.display().to_string(), &text)?)))
    }

    /// Puts a network into integers, calibrated on the states that it visits on training tasks of `seed`. See `tpg-train quantise` for
    /// networks that were trained on a built-in problem.
    ///
    /// # Errors
    /// If it is in integers, or has numbers that do not fit.
    pub fn quantised(
        &self,
        environment: &impl Environment<f32>,
        kind: Kind,
        seed: u64,
    ) -> Result<QuantisedPolicy, InputError> {
        let Self::Float(actor) = self else {
            return Err(InputError::new("<network>", Place::Whole, "a network in integers", "one in floating point"));
        };
        let actor = (&actor.0, &actor.1);
        let hash = checksum(weights::to_tensors(actor.0, actor.1).to_bytes());
        quantised("<network>", actor, None, environment, hash, kind, seed)
    }

    /// Returns the number of inputs, and the units of each hidden layer.
    pub(crate) fn widths(&self) -> Vec<usize> {
        match self {
            Self::Float(actor) => [&[actor.0.shape().inputs], &actor.0.shape().hidden[..]].concat(),
            Self::Fixed(policy) => policy.layers.iter().map(|layer| layer.inputs).collect(),
        }
    }

    /// Returns the settings of the problem that the network was trained on, as far as its file says them.
    pub fn settings(&self) -> toml::Table {
        match self {
            Self::Float(actor) => actor.1.problem.clone(),
            Self::Fixed(policy) => match &policy.output {
                Output::Preferences(preferences) => toml::Table::try_from(preferences).unwrap_or_default(),
                _ => toml::Table::new(),
            },
        }
    }

    /// Returns the network's decision as a function of the flat state, by the mean of its actions.
    pub fn deciding(&self) -> Decide<'_> {
        match self {
            Self::Float(actor) => {
                let policy = NetworkPolicy::new(&actor.0, actor.1.interface());
                Box::new(move |state| Decision::Values(policy.answer(state)))
            }
            Self::Fixed(policy) => Box::new(|state| decided(policy, state)),
        }
    }

    /// Compares inputs and outputs with those of a problem, by name; `file` is what an error names.
    ///
    /// # Errors
    /// If the network reads or answers something else.
    pub fn fit(&self, file: &str, sources: &[SourceDocument], actions: &ActionSpace) -> Result<(), InputError> {
        let refuse = |found: String, accepted: String| Err(InputError::new(file, Place::Whole, found, accepted));
        let wanted = input_names(sources);
        let inputs: Vec<&str> = match self {
            Self::Float(actor) => actor.1.inputs.iter().map(|input| input.name.as_str()).collect(),
            Self::Fixed(policy) => policy.inputs.iter().map(|input| input.name.as_str()).collect(),
        };
        if inputs != wanted {
            return refuse(format!("the inputs {}", inputs.join(" ")), wanted.join(" "));
        }
        let (answer, outputs) = match self {
            Self::Float(actor) => ("values", actor.1.outputs.iter().map(|output| output.name.as_str()).collect()),
            Self::Fixed(policy) => match &policy.output {
                Output::Values(values) => ("values", values.iter().map(|value| value.name.as_str()).collect()),
                Output::Argmax(names) => ("argmax", names.iter().map(String::as_str).collect()),
                Output::Preferences(_) => {
                    let count = policy.layers.last().map_or(0, |layer| layer.outputs);
                    ("values", actions.names().take(count).collect())
                }
            },
        };
        let accepted = if actions.outputs().is_empty() { "argmax" } else { "values" };
        let wanted: Vec<&str> = actions.names().collect();
        if (answer, &outputs) != (accepted, &wanted) {
            let (found, wanted) = (outputs.join(" "), wanted.join(" "));
            return refuse(format!("the outputs {found} ({answer})"), format!("{wanted} ({accepted})"));
        }
        Ok(())
    }
}
