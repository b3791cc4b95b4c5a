//! `graph.json` as it is written: plain data, not yet validated.

use super::effect::{Effect, WrittenAction};
use schemars::JsonSchema;
use serde::de::{Deserializer, Visitor};
use serde::{Deserialize, Serialize};
use std::collections::BTreeMap;
use std::fmt;
use tpg_runtime::ops::Instruction;

/// The value of [`Document::format`].
pub const FORMAT: &str = "tpg-graph";

/// The version of the format that this tool reads and writes.
pub const VERSION: u32 = 1;

/// A tangled program graph with everything that decides its behaviour.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
#[schemars(title = "graph.json")]
pub struct Document {
    /// Always "tpg-graph".
    #[schemars(extend("const" = FORMAT))]
    pub format: String,
    /// Always 1.
    #[schemars(extend("const" = VERSION))]
    pub version: u32,
    /// The type programs compute in.
    pub scalar: ScalarType,
    /// Who computes sin, cos, ln and exp.
    pub maths: MathsProvider,
    /// Registers of a program, all zero when it starts; register 0 holds its bid when it ends.
    #[schemars(range(min = 1, max = 256))]
    pub registers: u32,
    /// What programs can read, in the order of the state.
    #[schemars(length(min = 1))]
    pub sources: Vec<SourceDocument>,
    /// The instructions that programs may use. The order numbers them for GEGELATI's `.dot` format.
    #[schemars(length(min = 1), extend("items" = {"type": "string", "enum": instruction_names()}))]
    pub instructions: Vec<String>,
    /// What the policy can do; an action's id is its place in this list.
    #[schemars(length(min = 1))]
    pub actions: Vec<ActionDocument>,
    /// The id of the team where the walk starts: the one team that no edge leads to.
    pub root: u32,
    /// The teams.
    #[schemars(length(min = 1))]
    pub teams: Vec<TeamDocument>,
    /// The programs.
    #[schemars(length(min = 1))]
    pub programs: Vec<ProgramDocument>,
    /// Where the graph comes from. It does not decide behaviour.
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
    /// `f32` or `f64`.
    pub const fn name(self) -> &'static str {
        match self {
            Self::F32 => "f32",
            Self::F64 => "f64",
        }
    }

    /// The value nearest to `value`, as an `f64`.
    pub fn round(self, value: f64) -> f64 {
        match self {
            Self::F32 => f64::from(value as f32),
            Self::F64 => value,
        }
    }
}

/// A provider of sin, cos, ln and exp.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "lowercase")]
pub enum MathsProvider {
    /// This project's loop-free kernels: the same bits everywhere.
    Own,
    /// The platform's libm.
    #[default]
    System,
}

impl MathsProvider {
    /// `own` or `system`.
    pub const fn name(self) -> &'static str {
        match self {
            Self::Own => "own",
            Self::System => "system",
        }
    }
}

/// A data source: a named run of values.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct SourceDocument {
    /// An identifier: a lower-case letter, then lower-case letters, digits and underscores.
    #[schemars(regex(pattern = r"^[a-z][a-z0-9_]*$"))]
    pub name: String,
    /// How many values.
    #[schemars(range(min = 1))]
    pub length: u32,
    /// Their unit, for people.
    pub unit: String,
    /// The lowest and highest value of each, finite.
    pub ranges: Vec<[f64; 2]>,
}

/// An action.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(try_from = "WrittenAction", into = "WrittenAction")]
pub struct ActionDocument {
    /// Its place in the list, from 0.
    pub id: u32,
    /// What it is called.
    pub name: String,
    /// The numbers it carries for its problem.
    pub effect: Option<Effect>,
}

/// A team.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct TeamDocument {
    /// Any number that no other team has.
    pub id: u32,
    /// Its bidders. The highest bid wins, of equal bids the last; a NaN counts as −∞.
    #[schemars(length(min = 1))]
    pub edges: Vec<EdgeDocument>,
}

/// An edge of a team: a program and what it bids for.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
#[schemars(extend("oneOf" = [{"required": ["team"]}, {"required": ["action"]}]))]
pub struct EdgeDocument {
    /// The id of the program that bids.
    pub program: u32,
    /// The id of the team it leads to; exactly one of `team` and `action` is given.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub team: Option<u32>,
    /// The id of the action it leads to.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub action: Option<u32>,
}

/// A program.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct ProgramDocument {
    /// Any number that no other program has.
    pub id: u32,
    /// Its lines, in order.
    pub lines: Vec<LineDocument>,
}

/// A line: `to = op(args)`.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct LineDocument {
    /// The register that takes the result.
    pub to: u32,
    /// An instruction of the declared set.
    #[schemars(extend("enum" = instruction_names()))]
    pub op: String,
    /// Its operands, as many as it has.
    #[schemars(length(min = 1, max = 2))]
    pub args: Vec<OperandDocument>,
}

fn instruction_names() -> [&'static str; Instruction::ALL.len()] {
    Instruction::ALL.map(Instruction::name)
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

/// By hand, because a derived one says of anything else only that it "did not match any variant".
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

/// Where a graph comes from.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Provenance {
    /// The program that made it.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub tool: Option<String>,
    /// That program's version.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub version: Option<String>,
    /// The seed it was trained with.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub seed: Option<u64>,
    /// The configuration it was trained with.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub config: Option<serde_json::Value>,
    /// Scores, by name.
    #[serde(default, skip_serializing_if = "BTreeMap::is_empty")]
    pub scores: BTreeMap<String, f64>,
    /// Anything else worth knowing.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub note: Option<String>,
}
