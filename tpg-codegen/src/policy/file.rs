//! `policy.q.json`.

use super::meaning::{self, Input, Output};
use super::network::{QuantisedLayer, QuantisedPolicy, ROUNDING};
use serde::{Deserialize, Serialize};
use tpg_graph::error::InputError;
use tpg_runtime::net::{INPUT_ONE, Kind};

/// The values of `format` and `version`.
const FORMAT: (&str, u32) = ("tpg network in integers", 2);

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
    rounding: String,
    output: Output,
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
        Self {
            format: FORMAT.0.to_owned(),
            version: FORMAT.1,
            source_sha256: policy.source_sha256.clone(),
            observation: policy.inputs.iter().map(|input| input.name.clone()).collect(),
            scales: (!scales.is_empty()).then(|| scales.iter().map(|scale| [scale.offset, scale.scale]).collect()),
            feature_one: INPUT_ONE as u32,
            rounding: ROUNDING.to_owned(),
            output: policy.output.clone(),
            kind: policy.kind.clone(),
            layers: policy.layers.clone(),
        }
    }

    fn read(self, file: &str) -> Result<QuantisedPolicy, InputError> {
        let refuse = |path: &str, found: String, accepted: &str| Err(InputError::new(file, path, found, accepted));
        let format = (self.format.as_str(), self.version);
        if format != FORMAT {
            return refuse("$.format", format!("{format:?}"), &format!("{FORMAT:?}"));
        }
        let (found, accepted) = ((self.feature_one, self.rounding.as_str()), (INPUT_ONE as u32, ROUNDING));
        if found != accepted {
            return refuse("$.feature_one", format!("{found:?}"), &format!("{accepted:?}"));
        }
        let scales = self.scales.unwrap_or_else(|| vec![[0.0, 1.0]; self.observation.len()]);
        if scales.len() != self.observation.len() {
            return refuse("$.scales", scales.len().to_string(), "offset and scale of each input");
        }
        let input = |(name, [offset, scale]): (String, [f32; 2])| Input { name, offset, scale };
        Ok(QuantisedPolicy {
            source_sha256: self.source_sha256,
            inputs: self.observation.into_iter().zip(scales).map(input).collect(),
            output: self.output,
            kind: self.kind,
            layers: self.layers,
        })
    }
}
