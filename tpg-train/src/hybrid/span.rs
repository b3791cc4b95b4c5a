//! A number of actions in a hybrid's settings.

use serde::{Deserialize, Serialize};
use tpg_runtime::switch::NEVER;

/// A number of actions from 1, or never.
///
/// ```
/// use tpg_train::Span;
///
/// assert_eq!("100".parse(), Ok(Span(100)));
/// assert_eq!("never".parse(), Ok(Span::NEVER));
/// assert!("0".parse::<Span>().is_err());
/// ```
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Span(pub u32);

impl Span {
    /// The number of actions that no episode reaches.
    pub const NEVER: Self = Self(NEVER);
}

impl Default for Span {
    fn default() -> Self {
        Self::NEVER
    }
}

impl std::fmt::Display for Span {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        if *self == Self::NEVER { f.write_str("never") } else { write!(f, "{}", self.0) }
    }
}

impl std::str::FromStr for Span {
    type Err = String;

    fn from_str(text: &str) -> Result<Self, String> {
        match text.parse() {
            _ if text == "never" => Ok(Self::NEVER),
            Ok(actions) if (1..NEVER).contains(&actions) => Ok(Self(actions)),
            _ => Err(format!("{text:?}: neither a number of actions from 1 nor \"never\"")),
        }
    }
}

impl Serialize for Span {
    fn serialize<S: serde::Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        if *self == Self::NEVER { serializer.serialize_str("never") } else { serializer.serialize_u32(self.0) }
    }
}

impl<'de> Deserialize<'de> for Span {
    fn deserialize<D: serde::Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        #[derive(Deserialize)]
        #[serde(untagged)]
        enum Either {
            Actions(u32),
            Word(String),
        }
        let text = match Either::deserialize(deserializer)? {
            Either::Actions(actions) => actions.to_string(),
            Either::Word(word) => word,
        };
        text.parse().map_err(serde::de::Error::custom)
    }
}
