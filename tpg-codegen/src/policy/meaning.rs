//! The meaning of a network's inputs and outputs.

use serde::{Deserialize, Serialize};
use std::fmt;
use tpg_graph::error::InputError;
use tpg_runtime::net::{OutputKind, Scaling, Squash, Value};

/// An input: the network sees (value − offset)·scale.
#[derive(Clone, Debug, PartialEq)]
pub struct Input {
    /// Its name.
    pub name: String,
    /// Subtracted first.
    pub offset: f32,
    /// Multiplied with then.
    pub scale: f32,
}

impl Input {
    /// An input that the network sees as it is.
    pub fn plain(name: &str) -> Self {
        Self { name: name.to_owned(), offset: 0.0, scale: 1.0 }
    }

    pub(super) fn is_plain(&self) -> bool {
        self.offset == 0.0 && self.scale == 1.0
    }
}

/// Writes the name, and what the network sees where that is not the input itself.
impl fmt::Display for Input {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let Self { name, offset, scale } = self;
        match self.is_plain() {
            true => f.write_str(name),
            false => write!(f, "{name}: the network sees (value - {offset}) * {scale}"),
        }
    }
}

/// The scales of inputs; none where the network sees all as they are.
pub(super) fn scales(inputs: &[Input]) -> Vec<Scaling> {
    if inputs.iter().all(Input::is_plain) {
        return Vec::new();
    }
    inputs.iter().map(|&Input { offset, scale, .. }| Scaling { offset, scale }).collect()
}

pub(super) fn check_inputs(file: &str, inputs: &[Input]) -> Result<(), InputError> {
    for (place, input) in inputs.iter().enumerate() {
        if !input.offset.is_finite() || !input.scale.is_finite() {
            let found = format!("{} and {}", input.offset, input.scale);
            return Err(InputError::new(file, format!("$.scales[{place}]"), found, "finite numbers"));
        }
        check_name(file, format!("$.observation[{place}]"), &input.name)?;
    }
    Ok(())
}

fn check_name(file: &str, path: String, name: &str) -> Result<(), InputError> {
    let harmless = |c: char| !c.is_control() && c != '*' && c != '/';
    if !name.is_empty() && name.chars().all(harmless) {
        return Ok(());
    }
    let accepted = "a name on one line, without * and /";
    Err(InputError::new(file, path, format!("{name:?}"), accepted))
}

/// The meaning of a network's outputs.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(rename_all = "lowercase")]
pub enum Output {
    /// A preference for each joint of the arm: thresholds make it a move.
    Preferences(Preferences),
    /// Values, each with a name and a range: actions of a box.
    Values(Vec<ValueOutput>),
    /// The greatest output is the action, of equals the first: the actions' names.
    Argmax(Vec<String>),
}

/// The decision behind preferences; its words are `tpg-arm`'s.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Preferences {
    /// "fine" or "coarse".
    pub actions: String,
    /// "none" or "joint-limits".
    pub mask: String,
    /// True if the arm may rest.
    pub may_rest: bool,
}

/// An output that becomes a value.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct ValueOutput {
    /// Its name.
    pub name: String,
    /// The lowest value.
    pub min: f32,
    /// The highest value.
    pub max: f32,
    /// "tanh" or "clamp".
    #[serde(with = "SquashName")]
    pub squash: Squash,
    /// Outputs are multiples of 2^−exponent.
    pub exponent: u8,
}

/// [`Squash`] as it is written.
#[derive(Serialize, Deserialize)]
#[serde(remote = "Squash", rename_all = "lowercase")]
enum SquashName {
    Tanh,
    Clamp,
}

impl ValueOutput {
    fn value(&self) -> Value {
        let &Self { min, max, squash, exponent, .. } = self;
        Value { min, max, squash, exponent }
    }
}

impl Preferences {
    /// The flags of a packed network, or the first word that is unknown.
    fn flags(&self) -> Result<u8, (&'static str, &str, &'static str)> {
        let fine = match self.actions.as_str() {
            "fine" => 4,
            "coarse" => 0,
            other => return Err(("actions", other, "fine or coarse")),
        };
        let mask = match self.mask.as_str() {
            "joint-limits" => 1,
            "none" => 0,
            other => return Err(("mask", other, "none or joint-limits")),
        };
        Ok(fine | mask | (u8::from(self.may_rest) << 1))
    }
}

impl Output {
    /// The number of outputs it names; `None` where it names none.
    pub(super) fn count(&self) -> Option<usize> {
        match self {
            Self::Preferences(_) => None,
            Self::Values(values) => Some(values.len()),
            Self::Argmax(names) => Some(names.len()),
        }
    }

    /// The names of the outputs that have one, values with their ranges.
    pub(super) fn described(&self) -> Vec<String> {
        match self {
            Self::Preferences(_) => Vec::new(),
            Self::Values(values) => {
                values.iter().map(|value| format!("{}: {} to {}", value.name, value.min, value.max)).collect()
            }
            Self::Argmax(names) => names.clone(),
        }
    }

    /// The values that outputs become.
    pub(super) fn values(&self) -> Vec<Value> {
        match self {
            Self::Values(values) => values.iter().map(ValueOutput::value).collect(),
            Self::Preferences(_) | Self::Argmax(_) => Vec::new(),
        }
    }

    /// The kind of answer of the packed network.
    pub(super) fn answer(&self) -> OutputKind {
        match self {
            Self::Preferences(preferences) => OutputKind::Preferences { flags: preferences.flags().unwrap_or(0) },
            Self::Values(_) => OutputKind::Values,
            Self::Argmax(_) => OutputKind::Argmax,
        }
    }

    pub(super) fn check(&self, file: &str) -> Result<(), InputError> {
        match self {
            Self::Preferences(preferences) => preferences.flags().map(drop).map_err(|(word, found, accepted)| {
                InputError::new(file, format!("$.output.preferences.{word}"), format!("{found:?}"), accepted)
            }),
            Self::Values(values) => values.iter().enumerate().try_for_each(|(place, value)| {
                let path = format!("$.output.values[{place}]");
                if !value.value().is_sound() {
                    let found = format!("{} to {}, exponent {}", value.min, value.max, value.exponent);
                    let accepted = "a finite range, and an exponent up to 11 behind tanh, up to 14 behind clamp";
                    return Err(InputError::new(file, path, found, accepted));
                }
                check_name(file, format!("{path}.name"), &value.name)
            }),
            Self::Argmax(names) => names
                .iter()
                .enumerate()
                .try_for_each(|(place, name)| check_name(file, format!("$.output.argmax[{place}]"), name)),
        }
    }
}
