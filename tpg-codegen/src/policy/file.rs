//! `policy.q.json`: version 1 for networks of the arm's preferences, version 2 for every other network.

use super::meaning::{self, Input, Output, Preferences};
use super::network::{QuantisedLayer, QuantisedPolicy, ROUNDING};
use serde::{Deserialize, Serialize};
use tpg_graph::error::InputError;
use tpg_runtime::net::{INPUT_ONE, Kind, PREFERENCE_ONE};

/// The value of `format` in version 1.
const PREFERENCES: &str = "tpg sac policy in integers";
/// The value of `format` in version 2.
const NETWORK: &str = "tpg network in integers";

/// The file as it is written.
#[derive(Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
struct Written {
    format: String,
    version: u32,
    source_sha256: String,
    /// The inputs' names, in order.
    observation: Vec<String>,
    /// Offset and scale of each input; left out where all are 0 and 1.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    scales: Option<Vec<[f32; 2]>>,
    /// An input of 1 as an integer.
    feature_one: u32,
    /// A preference of 1 as an integer; version 1.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    preference_one: Option<u32>,
    rounding: String,
    /// Version 1.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    actions: Option<String>,
    /// Version 1.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    mask: Option<String>,
    /// Version 1.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    may_rest: Option<bool>,
    /// Version 2.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    output: Option<Output>,
    /// Left out where it is `w8a16`.
    #[serde(default = "default_kind", skip_serializing_if = "is_default_kind")]
    kind: String,
    layers: Vec<QuantisedLayer>,
}

fn default_kind() -> String {
    Kind::W8A16.name().to_owned()
}

fn is_default_kind(kind: &str) -> bool {
    kind == Kind::W8A16.name()
}

impl QuantisedPolicy {
    /// Reads and checks a `policy.q.json`.
    ///
    /// # Errors
    /// If it is no such file, or one that could overflow.
    pub fn from_json(file: &str, text: &str) -> Result<Self, InputError> {
        let mut reader = serde_json::Deserializer::from_str(text);
        let written: Written = serde_path_to_error::deserialize(&mut reader).map_err(|error| {
            InputError::new(file, format!("$.{}", error.path()), error.inner().to_string(), "a policy.q.json")
        })?;
        let policy = written.read(file)?;
        policy.check(file)?;
        Ok(policy)
    }

    /// The file's text: the same for the same policy.
    pub fn to_json(&self) -> String {
        serde_json::to_string(&Written::new(self)).expect("plain data with finite numbers") + "\n"
    }
}

impl Written {
    fn new(policy: &QuantisedPolicy) -> Self {
        let scales = meaning::scales(&policy.inputs);
        let (preferences, output) = match &policy.output {
            Output::Preferences(preferences) => (Some(preferences.clone()), None),
            other => (None, Some(other.clone())),
        };
        let (format, version) = if preferences.is_some() { (PREFERENCES, 1) } else { (NETWORK, 2) };
        Self {
            format: format.to_owned(),
            version,
            source_sha256: policy.source_sha256.clone(),
            observation: policy.inputs.iter().map(|input| input.name.clone()).collect(),
            scales: (!scales.is_empty()).then(|| scales.iter().map(|scale| [scale.offset, scale.scale]).collect()),
            feature_one: INPUT_ONE as u32,
            preference_one: preferences.as_ref().map(|_| PREFERENCE_ONE as u32),
            rounding: ROUNDING.to_owned(),
            actions: preferences.as_ref().map(|preferences| preferences.actions.clone()),
            mask: preferences.as_ref().map(|preferences| preferences.mask.clone()),
            may_rest: preferences.map(|preferences| preferences.may_rest),
            output,
            kind: policy.kind.clone(),
            layers: policy.layers.clone(),
        }
    }

    fn read(self, file: &str) -> Result<QuantisedPolicy, InputError> {
        let refuse = |path: &str, found: String, accepted: &str| Err(InputError::new(file, path, found, accepted));
        let format = (self.format.as_str(), self.version);
        if format != (PREFERENCES, 1) && format != (NETWORK, 2) {
            let accepted = format!("{PREFERENCES:?}, version 1; {NETWORK:?}, version 2");
            return refuse("$.format", format!("{:?}, version {}", self.format, self.version), &accepted);
        }
        let (found, accepted) = ((self.feature_one, self.rounding.as_str()), (INPUT_ONE as u32, ROUNDING));
        if found != accepted {
            return refuse("$.feature_one", format!("{found:?}"), &format!("{accepted:?}"));
        }
        let scales = self.scales.unwrap_or_else(|| vec![[0.0, 1.0]; self.observation.len()]);
        if scales.len() != self.observation.len() {
            return refuse("$.scales", scales.len().to_string(), "offset and scale of each input");
        }
        let output = match (self.output, self.actions, self.mask, self.may_rest, self.preference_one) {
            (Some(output), None, None, None, None) if self.version == 2 => output,
            (None, Some(actions), Some(mask), Some(may_rest), Some(one)) if self.version == 1 => {
                if one != PREFERENCE_ONE as u32 {
                    return refuse("$.preference_one", one.to_string(), &PREFERENCE_ONE.to_string());
                }
                Output::Preferences(Preferences { actions, mask, may_rest })
            }
            _ => {
                let accepted = "actions, mask, may_rest and preference_one in version 1; output in version 2";
                return refuse("$", "another description of the outputs".to_owned(), accepted);
            }
        };
        let input = |(name, [offset, scale]): (String, [f32; 2])| Input { name, offset, scale };
        Ok(QuantisedPolicy {
            source_sha256: self.source_sha256,
            inputs: self.observation.into_iter().zip(scales).map(input).collect(),
            output,
            kind: self.kind,
            layers: self.layers,
        })
    }
}
