//! Effects: numbers that an action carries for its problem.

use schemars::JsonSchema;
use serde::{Deserialize, Serialize, Serializer};

/// A named list of numbers that an action carries. The problem defines their meaning, such as changes of motor
/// positions or a torque; the graph does not interpret them.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Effect {
    /// Name by which a problem recognises the effect.
    pub name: String,
    /// Finite numbers; equally many for every action of a graph that has an effect.
    #[serde(serialize_with = "numbers")]
    pub values: Vec<f64>,
}

impl Effect {
    /// The name of the effect that `graph.json` writes as `"move": [3, 0, 0, 0]`.
    pub const MOVE: &str = "move";

    /// Creates an effect.
    ///
    /// ```
    /// use tpg_graph::Effect;
    ///
    /// let raise = Effect::new("move", [0.0, 3.0, 0.0, 0.0]);
    /// assert_eq!((raise.name.as_str(), raise.values.len()), ("move", 4));
    /// ```
    pub fn new(name: impl Into<String>, values: impl Into<Vec<f64>>) -> Self {
        Self { name: name.into(), values: values.into() }
    }
}

/// An action as written in `graph.json`.
#[derive(Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub(super) struct WrittenAction {
    /// Index in the list, from 0.
    id: u32,
    /// Name of the action.
    name: String,
    /// Shorthand for the effect "move", such as changes of motor positions.
    #[serde(rename = "move", default, skip_serializing_if = "Option::is_none", serialize_with = "moves")]
    moves: Option<Vec<f64>>,
    /// Any other effect; at most one of `move` and `effect` is given.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    effect: Option<Effect>,
    /// The action is to let another policy decide this step: its name, such as "network". No other action asks it, and an
    /// action that asks has no effect.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    #[schemars(regex(pattern = r"^[a-z][a-z0-9_]*$"))]
    ask: Option<String>,
}

fn moves<S: Serializer>(values: &Option<Vec<f64>>, serializer: S) -> Result<S::Ok, S::Error> {
    numbers(values.as_deref().unwrap_or_default(), serializer)
}

/// Whole numbers are written without a fraction.
fn numbers<S: Serializer>(values: &[f64], serializer: S) -> Result<S::Ok, S::Error> {
    serializer.collect_seq(values.iter().map(|&value| EffectNumber(value)))
}

struct EffectNumber(f64);

impl Serialize for EffectNumber {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        // Compared by bits because −0 differs from 0.
        match self.0 as i32 {
            whole if f64::from(whole).to_bits() == self.0.to_bits() => serializer.serialize_i32(whole),
            _ => serializer.serialize_f64(self.0),
        }
    }
}

impl From<super::document::ActionDocument> for WrittenAction {
    fn from(action: super::document::ActionDocument) -> Self {
        let super::document::ActionDocument { id, name, effect, ask } = action;
        match effect {
            Some(effect) if effect.name == Effect::MOVE => {
                Self { id, name, moves: Some(effect.values), effect: None, ask }
            }
            effect => Self { id, name, moves: None, effect, ask },
        }
    }
}

impl TryFrom<WrittenAction> for super::document::ActionDocument {
    type Error = &'static str;

    fn try_from(written: WrittenAction) -> Result<Self, &'static str> {
        let WrittenAction { id, name, moves, effect, ask } = written;
        let effect = match (moves, effect) {
            (Some(_), Some(_)) => return Err("both \"move\" and \"effect\""),
            (Some(values), None) => Some(Effect::new(Effect::MOVE, values)),
            (None, effect) => effect,
        };
        Ok(Self { id, name, effect, ask })
    }
}
