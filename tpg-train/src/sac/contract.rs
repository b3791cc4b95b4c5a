//! The contract of a policy file: its inputs, its outputs, and where it comes from.

use super::config::{Actor, check_widths};
use super::interface::{Input, Interface};
use serde::{Deserialize, Serialize};
use serde_json::Value;
use tpg_engine::{Output, Summary};
use tpg_graph::error::Finding;

/// The value of [`Contract::format`].
pub(crate) const FORMAT: &str = "tpg sac policy";
/// Changes with every change to what a file means.
pub(crate) const VERSION: u32 = 2;

/// The contract of a policy file.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Contract {
    /// [`FORMAT`].
    pub format: String,
    /// [`VERSION`].
    pub version: u32,
    /// The problem's settings, as the problem wrote them; empty where a program brought its own environment.
    pub problem: toml::Table,
    /// The network's inputs, in order.
    pub inputs: Vec<Input>,
    /// The outputs, in order: a component of the action, tanh of a mean, is the fraction of half the range.
    pub outputs: Vec<Output>,
    /// The network.
    pub actor: Actor,
    /// The origin of the policy.
    pub provenance: NetworkOrigin,
}

/// The origin of a policy.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct NetworkOrigin {
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
    /// Its result on the validation tasks that chose it; none for a policy that was imported.
    pub validation: Option<Summary>,
}

impl Contract {
    /// The contract of an actor.
    pub fn new(problem: toml::Table, interface: &Interface, actor: Actor, provenance: NetworkOrigin) -> Self {
        Self {
            format: FORMAT.to_owned(),
            version: VERSION,
            problem,
            inputs: interface.inputs.clone(),
            outputs: interface.outputs.clone(),
            actor,
            provenance,
        }
    }

    /// The network's inputs and outputs.
    pub fn interface(&self) -> Interface {
        Interface { inputs: self.inputs.clone(), outputs: self.outputs.clone() }
    }

    /// Reads the text of a policy file.
    ///
    /// # Errors
    /// If there is none, it has another version, or says what no network can be.
    pub(super) fn from_text(text: Option<&str>) -> Result<Self, Finding> {
        #[derive(Deserialize)]
        struct ContractHeader {
            format: String,
            version: u32,
        }
        let accepted = "the contract that `tpg-train sac` writes; `import` adds it to files of others";
        let text = text.ok_or_else(|| Finding::new("metadata.tpg", "nothing", accepted))?;
        let header: ContractHeader =
            serde_json::from_str(text).map_err(|error| Finding::new("metadata.tpg", error, accepted))?;
        if header.format != FORMAT || header.version != VERSION {
            let found = format!("{:?}, version {}", header.format, header.version);
            return Err(Finding::new("metadata.tpg.version", found, format!("{FORMAT:?}, version {VERSION}")));
        }
        let contract = serde_json::from_str(text).map(without_retired).and_then(serde_json::from_value::<Self>);
        let contract = contract.map_err(|error| Finding::new("metadata.tpg", error, accepted))?;
        contract.check()?;
        Ok(contract)
    }

    fn check(&self) -> Result<(), Finding> {
        check_widths("metadata.tpg.actor.hidden", &self.actor.hidden)?;
        if let Some(input) = self.inputs.iter().find(|input| !input.offset.is_finite() || !input.scale.is_finite()) {
            return Err(Finding::new("metadata.tpg.inputs", format!("{input:?}"), "finite numbers"));
        }
        let sound = |output: &&Output| output.min.is_finite() && output.max.is_finite() && output.min < output.max;
        match self.outputs.iter().find(|output| !sound(output)) {
            Some(output) => {
                Err(Finding::new("metadata.tpg.outputs", format!("{output:?}"), "a lowest below a highest"))
            }
            None if self.outputs.is_empty() || self.inputs.is_empty() => {
                Err(Finding::new("metadata.tpg.inputs", "a network without inputs or outputs", "one or more of each"))
            }
            None => Ok(()),
        }
    }
}

/// Settings that earlier versions wrote: place, name, and the one value that is left of each.
const RETIRED: [(&str, &str, &str); 8] = [
    ("/problem", "inputs", "\"features\""),
    ("/problem", "invalid_ends", "true"),
    ("/problem", "step", "3"),
    ("/problem", "stuck_ends", "true"),
    ("/problem/reward", "remaining_distance", "0.0"),
    ("/problem/reward", "scale", "1.0"),
    ("/actor", "layer_norm", "false"),
    ("/actor", "spread", "\"log-sigma\""),
];

fn without_retired(mut contract: Value) -> Value {
    for (place, name, left) in RETIRED {
        let section = contract.pointer_mut(place).and_then(Value::as_object_mut);
        if let Some(section) = section.filter(|it| it.get(name) == left.parse().ok().as_ref()) {
            section.remove(name);
        }
    }
    contract
}
