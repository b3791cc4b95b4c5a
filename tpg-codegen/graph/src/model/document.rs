//! `graph.json` as written: plain data, not yet validated.

use super::counts::Counts;
use super::effect::{Effect, WrittenAction};
use crate::image::ImageSource;
use crate::word::Word;
use schemars::JsonSchema;
use serde::de::{Deserializer, Visitor};
use serde::{Deserialize, Serialize};
use std::collections::BTreeMap;
use std::fmt;

/// The value of [`Document::format`].
pub const FORMAT: &str = "tpg-graph";

/// The versions of the format that this tool reads. Version 2 adds outputs, counts and images; a graph without them is written as version 1.
pub const VERSIONS: [u32; 2] = [1, 2];

/// A tangled program graph with everything that determines its behaviour.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
#[schemars(title = "graph.json", extend("oneOf" = [
    {"required": ["actions", "root", "teams"], "properties": {"outputs": false, "leaves": false, "memory": false}},
    {"required": ["outputs", "leaves"], "properties": {"actions": false, "version": {"const": 2}}},
]))]
pub struct Document {
    /// Always "tpg-graph".
    #[schemars(extend("const" = FORMAT))]
    pub format: String,
    /// 1, or 2 for a policy with outputs, counts or images.
    #[schemars(extend("enum" = VERSIONS))]
    pub version: u32,
    /// The type programs compute in.
    pub scalar: ScalarType,
    /// Provider of sin, cos, tan, ln and exp.
    pub maths: MathsProvider,
    /// Number of registers of a program. All are zero when it starts; register 0 holds its bid when it ends.
    #[schemars(range(min = 1, max = 256))]
    pub registers: u32,
    /// The values that programs can read, in the order of the state.
    #[schemars(length(min = 1))]
    pub sources: Vec<SourceDocument>,
    /// The instructions that programs may use.
    #[schemars(length(min = 1), extend("items" = {"type": "string", "enum": instruction_names()}))]
    pub instructions: Vec<String>,
    /// The actions of the policy; the id of an action is its index in this list. Empty for a policy with outputs.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub actions: Vec<ActionDocument>,
    /// Version 2: the values that the policy answers, in order, instead of actions.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub outputs: Vec<OutputDocument>,
    /// Version 2: the values that leaves compute for the next decision, in order. Programs read them like sources of one
    /// value, `name[0]`.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub memory: Vec<MemoryDocument>,
    /// The id of the team where the walk starts: the only team without incoming edges. Absent if there are no teams.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub root: Option<u32>,
    /// The teams. A policy with outputs and a single leaf needs none.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub teams: Vec<TeamDocument>,
    /// Version 2: the leaves, where a walk ends in a policy with outputs.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub leaves: Vec<LeafDocument>,
    /// The programs.
    #[schemars(length(min = 1))]
    pub programs: Vec<ProgramDocument>,
    /// Origin of the graph. It does not affect behaviour.
    #[serde(default)]
    pub provenance: Provenance,
}

/// A floating-point type.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash, Serialize, Deserialize, JsonSchema, clap::ValueEnum)]
#[serde(rename_all = "lowercase")]
pub enum ScalarType {
    /// 32 bits.
    F32,
    /// 64 bits.
    #[default]
    F64,
}

impl ScalarType {
    /// Returns `f32` or `f64`.
    pub const fn name(self) -> &'static str {
        match self {
            Self::F32 => "f32",
            Self::F64 => "f64",
        }
    }

    /// Rounds `value` to the nearest value of this type, returned as an `f64`.
    pub fn round(self, value: f64) -> f64 {
        match self {
            Self::F32 => f64::from(value as f32),
            Self::F64 => value,
        }
    }
}

/// A provider of sin, cos, tan, ln and exp.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "lowercase")]
pub enum MathsProvider {
    /// This project's loop-free kernels, which give the same bits on every platform.
    Own,
    /// The platform's libm.
    #[default]
    System,
}

impl MathsProvider {
    /// Returns `own` or `system`.
    pub const fn name(self) -> &'static str {
        match self {
            Self::Own => "own",
            Self::System => "system",
        }
    }
}

/// A data source: a named, contiguous group of values.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct SourceDocument {
    /// An identifier: a lower-case letter, then lower-case letters, digits and underscores.
    #[schemars(regex(pattern = r"^[a-z][a-z0-9_]*$"))]
    pub name: String,
    /// Number of values.
    #[schemars(range(min = 1))]
    pub length: u32,
    /// Unit of the values, for human readers.
    pub unit: String,
    /// Lowest and highest value of each, both finite; of counts, whole numbers.
    pub ranges: Vec<[f64; 2]>,
    /// Version 2: the integers that the values come in, one for each; programs then see counts. Empty where they see the values
    /// themselves.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub counts: Vec<Counts>,
    /// Version 2: the image that the values are computed from. The caller gives the image instead of the values.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub image: Option<ImageSource>,
}

impl SourceDocument {
    /// Creates a source with a value for each range.
    ///
    /// ```
    /// use tpg_graph::SourceDocument;
    ///
    /// let angle = SourceDocument::new("angle", "rad", vec![[-3.2, 3.2]]);
    /// assert_eq!((angle.length, angle.counts.len()), (1, 0));
    /// ```
    pub fn new(name: impl Into<String>, unit: impl Into<String>, ranges: Vec<[f64; 2]>) -> Self {
        let (name, unit, length) = (name.into(), unit.into(), ranges.len() as u32);
        Self { name, length, unit, ranges, counts: Vec::new(), image: None }
    }
}

/// An action.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(try_from = "WrittenAction", into = "WrittenAction")]
pub struct ActionDocument {
    /// Index in the list, from 0.
    pub id: u32,
    /// Name of the action.
    pub name: String,
    /// Numbers that the action carries for its problem.
    pub effect: Option<Effect>,
    /// Name of another policy that decides this step: the action is to ask it.
    pub ask: Option<String>,
}

/// A value that a policy answers: the result of a leaf's program, limited to a range.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct OutputDocument {
    /// An identifier: a lower-case letter, then lower-case letters, digits and underscores.
    #[schemars(regex(pattern = r"^[a-z][a-z0-9_]*$"))]
    pub name: String,
    /// Unit of the value, for human readers.
    pub unit: String,
    /// Lowest value.
    pub min: f64,
    /// Highest value.
    pub max: f64,
    /// The value in place of NaN, from `min` to `max`.
    pub nan: f64,
    /// The integers that it is; `min`, `max` and `nan` are then counts.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub counts: Option<Counts>,
}

/// A value that a leaf computes for the next decision.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct MemoryDocument {
    /// An identifier that no source and no output has: a lower-case letter, then lower-case letters, digits and underscores.
    #[schemars(regex(pattern = r"^[a-z][a-z0-9_]*$"))]
    pub name: String,
    /// Lowest value.
    pub min: f64,
    /// Highest value.
    pub max: f64,
    /// The value at the first decision, and in place of NaN; from `min` to `max`.
    pub initial: f64,
}

/// A leaf: the programs that compute the outputs and the next values of the memory.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct LeafDocument {
    /// A number that no other leaf has.
    pub id: u32,
    /// The id of the program of each output, in the order of the outputs. Leaves and outputs may share programs.
    #[schemars(length(min = 1))]
    pub programs: Vec<u32>,
    /// The id of the program of each value of the memory, in its order.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub memory: Vec<u32>,
}

/// A team.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct TeamDocument {
    /// A number that no other team has.
    pub id: u32,
    /// The bidders. The highest bid wins, and among equal bids the last; NaN counts as −∞.
    #[schemars(length(min = 1))]
    pub edges: Vec<EdgeDocument>,
}

/// An edge of a team: a program and the destination it bids for.
#[derive(Clone, Debug, Default, PartialEq, Eq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
#[schemars(extend("oneOf" = [{"required": ["team"]}, {"required": ["action"]}, {"required": ["leaf"]}]))]
pub struct EdgeDocument {
    /// The id of the bidding program.
    pub program: u32,
    /// The id of the team that the edge leads to; exactly one of `team`, `action` and `leaf` is given.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub team: Option<u32>,
    /// The id of the action that the edge leads to.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub action: Option<u32>,
    /// The id of the leaf that the edge leads to.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub leaf: Option<u32>,
}

/// A program.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct ProgramDocument {
    /// A number that no other program has.
    pub id: u32,
    /// Its lines, in order.
    pub lines: Vec<LineDocument>,
}

/// A line: `to = op(args)`; `multiply_add` is `to = to + args[0] * args[1]`, two roundings.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct LineDocument {
    /// Destination register.
    pub to: u32,
    /// An instruction of the declared set.
    #[schemars(extend("enum" = instruction_names()))]
    pub op: String,
    /// Operands, as many as the instruction takes.
    #[schemars(length(min = 1, max = 2))]
    pub args: Vec<OperandDocument>,
}

fn instruction_names() -> [&'static str; Word::ALL.len()] {
    Word::ALL.map(Word::name)
}

/// An operand: a number, a register `r3`, or a value of a source `target[0]`.
#[derive(Clone, Debug, PartialEq, Serialize, JsonSchema)]
#[serde(untagged)]
pub enum OperandDocument {
    /// A constant.
    Constant(f64),
    /// A register or a value of a source.
    Place(#[schemars(regex(pattern = r"^(r[0-9]+|[a-z][a-z0-9_]*\[[0-9]+\])$"))] String),
}

/// Written by hand because the derived implementation reports any other value only as "did not match any variant".
impl<'de> Deserialize<'de> for OperandDocument {
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        struct OperandVisitor;

        impl Visitor<'_> for OperandVisitor {
            type Value = OperandDocument;

            fn expecting(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
                f.write_str("a number, a register \"r0\", or a value of a source \"name[0]\"")
            }
            fn visit_f64<E>(self, value: f64) -> Result<OperandDocument, E> {
                Ok(OperandDocument::Constant(value))
            }
            fn visit_i64<E>(self, value: i64) -> Result<OperandDocument, E> {
                Ok(OperandDocument::Constant(value as f64))
            }
            fn visit_u64<E>(self, value: u64) -> Result<OperandDocument, E> {
                Ok(OperandDocument::Constant(value as f64))
            }
            fn visit_str<E>(self, value: &str) -> Result<OperandDocument, E> {
                Ok(OperandDocument::Place(value.to_owned()))
            }
        }

        deserializer.deserialize_any(OperandVisitor)
    }
}

/// Origin of a graph.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Provenance {
    /// Program that created it.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub tool: Option<String>,
    /// Version of that program.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub version: Option<String>,
    /// Seed used in training.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub seed: Option<u64>,
    /// Configuration used in training.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub config: Option<serde_json::Value>,
    /// Scores, by name.
    #[serde(default, skip_serializing_if = "BTreeMap::is_empty")]
    pub scores: BTreeMap<String, f64>,
    /// Any other remark.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub note: Option<String>,
}
