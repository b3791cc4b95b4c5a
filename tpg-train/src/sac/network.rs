//! A policy file of either kind, ready to act.

use super::contract::Contract;
use super::episode::play;
use super::interface::Interface;
use super::policy::NetworkPolicy;
use super::weights;
use crate::files::read_text;
use std::path::Path;
use tpg_codegen::policy::{Output, QuantisedPolicy};
use tpg_engine::{Ending, Environment};
use tpg_graph::error::{InputError, Place};
use tpg_nn::Mlp;

/// A trained network: `policy.safetensors` or `policy.q.json`.
#[derive(Clone, Debug)]
pub enum Network {
    /// In floating point.
    Float(Box<(Mlp<f32>, Contract)>),
    /// In integers.
    Fixed(Box<QuantisedPolicy>),
}

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

    /// The problem's settings, where the file says them.
    pub fn problem(&self) -> Option<&toml::Table> {
        match self {
            Self::Float(actor) => Some(&actor.1.problem).filter(|table| !table.is_empty()),
            Self::Fixed(_) => None,
        }
    }

    /// One episode of each task; `file` is what an error names.
    ///
    /// # Errors
    /// If the network reads or answers something else than the environment has.
    pub fn endings<E: Environment<f32>>(
        &self,
        file: &str,
        environment: &E,
        tasks: &[E::Task],
    ) -> Result<Vec<Ending>, InputError> {
        self.check(file, environment)?;
        Ok(match self {
            Self::Float(actor) => {
                let interface = actor.1.interface();
                NetworkPolicy::new(&actor.0, &interface, &actor.1.actor).endings(environment, tasks)
            }
            Self::Fixed(policy) => {
                let answer = |state: &[f32], values: &mut Vec<f32>| *values = policy.values(state);
                tasks.iter().map(|task| play(environment, task, answer, |_episode| ())).collect()
            }
        })
    }

    /// Compares inputs and outputs with the environment's, by name.
    fn check(&self, file: &str, environment: &impl Environment<f32>) -> Result<(), InputError> {
        let refuse = |found: String, accepted: String| Err(InputError::new(file, Place::Whole, found, accepted));
        let expected = match Interface::new(environment, false) {
            Ok(interface) => interface,
            Err(finding) => return refuse(format!("a network for {}", finding.found), finding.accepted),
        };
        let (inputs, outputs): (Vec<&str>, Vec<&str>) = match self {
            Self::Float(actor) => (
                actor.1.inputs.iter().map(|input| input.name.as_str()).collect(),
                actor.1.outputs.iter().map(|output| output.name.as_str()).collect(),
            ),
            Self::Fixed(policy) => {
                (policy.inputs.iter().map(|input| input.name.as_str()).collect(), names(&policy.output))
            }
        };
        let wanted: Vec<&str> = expected.inputs.iter().map(|input| input.name.as_str()).collect();
        if inputs != wanted {
            return refuse(format!("the inputs {}", inputs.join(" ")), wanted.join(" "));
        }
        let wanted: Vec<&str> = expected.outputs.iter().map(|output| output.name.as_str()).collect();
        if outputs != wanted {
            return refuse(format!("the outputs {}", outputs.join(" ")), wanted.join(" "));
        }
        Ok(())
    }
}

/// The names of the values that a network in integers answers; none where it answers otherwise.
fn names(output: &Output) -> Vec<&str> {
    match output {
        Output::Values(values) => values.iter().map(|value| value.name.as_str()).collect(),
        Output::Preferences(_) | Output::Argmax(_) => Vec::new(),
    }
}
