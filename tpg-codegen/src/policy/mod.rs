//! Networks in integers: `policy.q.json`, made from a trained actor's weights.
//!
//! The arithmetic is `tpg_arm::sac::fixed`'s, which this module calls: weights with a scale for each row, `i32`
//! accumulators that are proven not to overflow, one rounding rule. The [kind](Kind) says how many bits weights and
//! activations have:
//!
//! | kind | weights | hidden activations | features |
//! | --- | --- | --- | --- |
//! | `w8a16` | −128 to 127 | 0 to 32767 | multiples of 1/4096 |
//! | `w16a16` | −32768 to 32767 | 0 to 32767 | multiples of 1/4096 |
//! | `w8a8` | −127 to 127 | 0 to 127 | multiples of 1/32, −127 to 127 |
//!
//! The last layer of a `w8a8` network is `w8a16`: it is small, and its preferences would be coarse.

mod emit;
mod model;
mod quantise;

pub use emit::to_rust;
pub use model::{to_c, to_words};
pub use quantise::{FloatLayer, QuantiseError, quantise};

use serde::{Deserialize, Serialize};
use tpg_arm::JOINTS;
use tpg_arm::sac::fixed::{FEATURE_ONE, HIDDEN, LAST, PREFERENCE_ONE, Rescale, accumulate};
use tpg_arm::sac::packed::{Kind, LayerRows, Weights};
use tpg_arm::sac::{Actions, FEATURE_NAMES, Mask};
use tpg_graph::error::{InputError, Place};
use tpg_kernels::clip_to_i8;

/// The value of [`QuantisedPolicy::format`].
pub const FORMAT: &str = "tpg sac policy in integers";
/// Changes with every change to what a file means.
pub const VERSION: u32 = 1;
/// The rule by which accumulators are rescaled.
pub const ROUNDING: &str = "(acc * factor + 2^(shift - 1)) >> shift in 64 bits, then clipped";

/// A policy in integers: everything that decides its behaviour.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct QuantisedPolicy {
    /// [`FORMAT`].
    pub format: String,
    /// [`VERSION`].
    pub version: u32,
    /// SHA-256 of the weights it was made from, in hexadecimal.
    pub source_sha256: String,
    /// The features by name, in order.
    pub observation: Vec<String>,
    /// A feature of 1 as an integer.
    pub feature_one: u32,
    /// A preference of 1 as an integer.
    pub preference_one: u32,
    /// [`ROUNDING`].
    pub rounding: String,
    /// "fine" or "coarse".
    pub actions: String,
    /// "none" or "joint-limits".
    pub mask: String,
    /// Whether the arm may rest.
    pub may_rest: bool,
    /// The name of its [`Kind`]; left out of a file where it is `w8a16`.
    #[serde(default = "usual_kind", skip_serializing_if = "is_usual_kind")]
    pub kind: String,
    /// First to last; all but the last have a ReLU behind them.
    pub layers: Vec<QuantisedLayer>,
}

fn usual_kind() -> String {
    Kind::W8A16.name().to_owned()
}

fn is_usual_kind(kind: &str) -> bool {
    kind == Kind::W8A16.name()
}

/// The kind of one of `layers` layers: the last one's activations have 16 bits.
fn layer_kind(kind: Kind, index: usize, layers: usize) -> Kind {
    if kind == Kind::W8A8 && index + 1 == layers { Kind::W8A16 } else { kind }
}

/// One layer in integers.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct QuantisedLayer {
    /// Values in.
    pub inputs: usize,
    /// Values out.
    pub outputs: usize,
    /// Row-major, outputs × inputs.
    pub weights: Vec<i16>,
    /// In units of the accumulators.
    pub bias: Vec<i32>,
    /// What an accumulator is multiplied by, for each row.
    pub factor: Vec<i16>,
    /// By how many bits it is shifted then, for each row.
    pub shift: Vec<u8>,
}

impl QuantisedLayer {
    /// The outputs, clipped to `low` from below and to `high` from above.
    pub fn forward(&self, inputs: &[i16], low: i16, high: i16) -> Vec<i16> {
        let rows = self.weights.chunks_exact(self.inputs).zip(&self.bias).zip(self.factor.iter().zip(&self.shift));
        rows.map(|((weights, &bias), (&factor, &shift))| {
            Rescale { factor, shift }.apply(accumulate(bias, weights, inputs), low).min(high)
        })
        .collect()
    }

    /// How each row's accumulators become outputs.
    pub fn rescales(&self) -> Vec<Rescale> {
        self.factor.iter().zip(&self.shift).map(|(&factor, &shift)| Rescale { factor, shift }).collect()
    }

    fn bytes(&self, kind: Kind) -> usize {
        let of_a_weight = if kind == Kind::W16A16 { 2 } else { 1 };
        of_a_weight * self.weights.len() + 4 * self.bias.len() + 2 * self.factor.len() + self.shift.len()
    }
}

impl QuantisedPolicy {
    /// A policy of layers; `check`ed.
    ///
    /// # Errors
    /// If the layers do not fit each other or an accumulator could overflow.
    pub fn new(
        source_sha256: String,
        actions: Actions,
        mask: Mask,
        may_rest: bool,
        kind: Kind,
        layers: Vec<QuantisedLayer>,
    ) -> Result<Self, InputError> {
        let policy = Self {
            format: FORMAT.to_owned(),
            version: VERSION,
            source_sha256,
            observation: FEATURE_NAMES.map(str::to_owned).into(),
            feature_one: FEATURE_ONE as u32,
            preference_one: PREFERENCE_ONE as u32,
            rounding: ROUNDING.to_owned(),
            actions: actions.name().to_owned(),
            mask: mask.name().to_owned(),
            may_rest,
            kind: kind.name().to_owned(),
            layers,
        };
        policy.check("<quantised>")?;
        Ok(policy)
    }

    /// Reads and checks a `policy.q.json`.
    ///
    /// # Errors
    /// If it is no such file, or one that could overflow.
    pub fn from_json(file: &str, text: &str) -> Result<Self, InputError> {
        let mut reader = serde_json::Deserializer::from_str(text);
        let policy: Self = serde_path_to_error::deserialize(&mut reader).map_err(|error| {
            let place = Place::Path(format!("$.{}", error.path()));
            InputError::new(file, place, error.inner().to_string(), "a policy.q.json")
        })?;
        policy.check(file)?;
        Ok(policy)
    }

    /// The file's text: the same for the same policy.
    pub fn to_json(&self) -> String {
        serde_json::to_string(self).expect("plain data") + "\n"
    }

    fn check(&self, file: &str) -> Result<(), InputError> {
        let refuse = |path: String, found: String, accepted: String| {
            Err(InputError::new(file, Place::Path(path), found, accepted))
        };
        if self.format != FORMAT || self.version != VERSION {
            let found = format!("{:?}, version {}", self.format, self.version);
            return refuse("$.format".to_owned(), found, format!("{FORMAT:?}, version {VERSION}"));
        }
        if self.observation != FEATURE_NAMES {
            let found = self.observation.join(" ");
            return refuse("$.observation".to_owned(), found, FEATURE_NAMES.join(" "));
        }
        let scales = (self.feature_one, self.preference_one, self.rounding.as_str());
        let accepted = (FEATURE_ONE as u32, PREFERENCE_ONE as u32, ROUNDING);
        if scales != accepted {
            return refuse("$.feature_one".to_owned(), format!("{scales:?}"), format!("{accepted:?}"));
        }
        if Actions::from_name(&self.actions).is_none() || Mask::from_name(&self.mask).is_none() {
            let found = format!("{:?}, {:?}", self.actions, self.mask);
            return refuse("$.actions".to_owned(), found, "fine or coarse, none or joint-limits".to_owned());
        }
        let Some(kind) = Kind::from_name(&self.kind) else {
            let accepted = Kind::ALL.map(Kind::name).join(", ");
            return refuse("$.kind".to_owned(), format!("{:?}", self.kind), accepted);
        };
        let mut inputs = FEATURE_NAMES.len();
        for (index, layer) in self.layers.iter().enumerate() {
            let path = |field: &str| format!("$.layers[{index}].{field}");
            let sizes = [layer.inputs, layer.outputs * layer.inputs, layer.outputs, layer.outputs, layer.outputs];
            let lengths = [inputs, layer.weights.len(), layer.bias.len(), layer.factor.len(), layer.shift.len()];
            if sizes != lengths || layer.inputs == 0 || layer.outputs == 0 {
                return refuse(
                    path("inputs"),
                    format!("{sizes:?}"),
                    format!("the sizes of what is there, {lengths:?}"),
                );
            }
            let kind = layer_kind(kind, index, self.layers.len());
            let (least, greatest) = kind.weights();
            if let Some(weight) = layer.weights.iter().find(|weight| !(least..=greatest).contains(weight)) {
                return refuse(path("weights"), weight.to_string(), format!("{least} to {greatest}, as {}", self.kind));
            }
            let rescale = layer.rescales();
            let weights = Weights::I16(&layer.weights);
            let rows = LayerRows { inputs: layer.inputs, kind, weights, bias: &layer.bias, rescale: &rescale };
            for row in 0..layer.outputs {
                let worst = rows.worst_accumulator(row);
                if worst > i64::from(i32::MAX) {
                    let found = format!("row {row} can reach {worst}");
                    return refuse(path("weights"), found, format!("accumulators up to {}", i32::MAX));
                }
                if layer.factor[row] < 0 || !(1..=47).contains(&layer.shift[row]) {
                    let found = format!("row {row}: {} and {}", layer.factor[row], layer.shift[row]);
                    return refuse(path("shift"), found, "a factor from 0 and a shift of 1 to 47".to_owned());
                }
            }
            inputs = layer.outputs;
        }
        if self.layers.is_empty() || inputs != JOINTS {
            return refuse("$.layers".to_owned(), format!("{inputs} outputs"), format!("{JOINTS} outputs"));
        }
        Ok(())
    }

    /// How many bits weights and activations have.
    pub fn kind(&self) -> Kind {
        Kind::from_name(&self.kind).unwrap_or(Kind::W8A16)
    }

    /// The same of each layer.
    pub fn layer_kinds(&self) -> Vec<Kind> {
        (0..self.layers.len()).map(|index| layer_kind(self.kind(), index, self.layers.len())).collect()
    }

    /// The preferences, in multiples of 1/2048, for features in multiples of 1/4096.
    pub fn preferences(&self, features: &[i16]) -> [i32; JOINTS] {
        let kinds = self.layer_kinds();
        let mut values = features.to_vec();
        if kinds.first() == Some(&Kind::W8A8) {
            values.iter_mut().for_each(|value| *value = clip_to_i8(*value));
        }
        for (index, layer) in self.layers.iter().enumerate() {
            let (low, high) = match kinds.get(index + 1) {
                Some(next) => (HIDDEN, next.activation()),
                None => (LAST, i16::MAX),
            };
            values = layer.forward(&values, low, high);
        }
        std::array::from_fn(|joint| values.get(joint).copied().map_or(0, i32::from))
    }

    /// Bytes of its constants on a target.
    pub fn bytes(&self) -> usize {
        self.layers.iter().zip(self.layer_kinds()).map(|(layer, kind)| layer.bytes(kind)).sum()
    }

    /// Multiplications of a weight that one decision costs.
    pub fn multiplications(&self) -> usize {
        self.layers.iter().map(|layer| layer.weights.len()).sum()
    }
}
