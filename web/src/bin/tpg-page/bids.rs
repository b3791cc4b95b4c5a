//! The bids of each policy as a table, made of the same optimised graph as its code: `web/src/bids.rs` for the problems, data for
//! the arm, whose table is greater than what the module may weigh.

use crate::policies::{POLICIES, Policy};
use serde::{Serialize, Serializer};
use std::collections::BTreeMap;
use std::fmt::Write as _;
use std::io;
use tpg_codegen::compile;
use tpg_codegen::ir::{Edge, Module, Node, NodeId, Target};
use tpg_codegen::options::Language;
use tpg_runtime::ops::Instruction;

/// The text of the file.
pub(crate) fn text() -> io::Result<String> {
    let mut text = "//! The bids of the shipped policies as tables; written by `tpg-page bids`, do not edit.\n\n\
                    use crate::decision::To::{End, Team};\nuse crate::decision::Value::{Constant, Input, Operation};\n\
                    use crate::decision::{Bids, Edge};\nuse tpg_runtime::ops::Instruction::*;\nuse tpg_runtime::ops::Own;\n"
        .to_owned();
    for policy in &POLICIES {
        table(&mut text, policy)?;
    }
    Ok(text)
}

/// The bids of a policy: every value once, operands before operations, and the edges of each team, the root first.
#[derive(Serialize)]
pub(crate) struct Table {
    values: Vec<Value>,
    /// The place of each edge's bid among the values, and its destination.
    teams: Vec<Vec<(usize, To)>>,
}

/// A value that bids are made of.
#[derive(Serialize)]
#[serde(rename_all = "snake_case")]
enum Value {
    /// A value of the state, by its place.
    Input(usize),
    /// A number.
    Constant(f32),
    /// An instruction on two earlier values, by their places.
    #[serde(untagged)]
    Operation(#[serde(serialize_with = "name")] Instruction, usize, usize),
}

/// A destination: the place of a team, or an action or leaf.
#[derive(Serialize)]
#[serde(rename_all = "snake_case")]
enum To {
    Team(usize),
    End(u16),
}

fn name<S: Serializer>(instruction: &Instruction, serializer: S) -> Result<S::Ok, S::Error> {
    serializer.serialize_str(instruction.name())
}

impl Table {
    /// Makes the table of a policy, whose numbers JSON can hold.
    pub(crate) fn of(policy: &Policy) -> io::Result<Self> {
        let (graph, options) = (policy.graph()?, policy.options()?);
        let program = compile(&graph, &options, Language::C);
        let module = &program.module;
        let places = places(module);
        let value = |&id: &NodeId| match module.node(id) {
            Node::Constant(bits) => match f64::from_bits(bits) as f32 {
                number if number.is_finite() => Ok(Value::Constant(number)),
                number => Err(io::Error::other(format!("{number} among the values of a bid"))),
            },
            Node::Input(input) => Ok(Value::Input(input.index())),
            Node::Operation(instruction, [a, b]) => {
                let b = if instruction.arity() == 1 { a } else { b };
                Ok(Value::Operation(instruction, places[&a], places[&b]))
            }
            Node::Upper(..) => Err(io::Error::other("a bound among the values of a bid")),
        };
        let edge = |edge: &Edge| {
            let to = match edge.to {
                Target::Team(team) => To::Team(team),
                Target::Action(end) => To::End(end.0),
            };
            (places[&module.bidders[edge.bidder].value], to)
        };
        Ok(Self {
            values: places.keys().map(value).collect::<io::Result<_>>()?,
            teams: module.teams.iter().map(|team| team.edges.iter().map(edge).collect()).collect(),
        })
    }
}

fn table(text: &mut String, policy: &Policy) -> io::Result<()> {
    let Table { values, teams } = Table::of(policy)?;
    let name = policy.folder.replace('-', "_").to_uppercase();
    let mut put = |line: String| writeln!(text, "{line}").map_err(io::Error::other);
    put(format!("\n/// Of `generated/{}`.", policy.folder))?;
    put(format!("pub static {name}: Bids = Bids {{\n    values: &["))?;
    for value in values {
        put(match value {
            Value::Constant(number) => format!("        Constant({number:?}),"),
            Value::Input(input) => format!("        Input({input}),"),
            Value::Operation(instruction, a, b) => {
                format!("        Operation(|a, b| {instruction:?}.apply::<f32, Own>(a, b), {a}, {b}),")
            }
        })?;
    }
    put("    ],\n    teams: &[".to_owned())?;
    for team in teams {
        put("        &[".to_owned())?;
        for (bid, to) in team {
            let to = match to {
                To::Team(team) => format!("Team({team})"),
                To::End(end) => format!("End({end})"),
            };
            put(format!("            Edge {{ bid: {bid}, to: {to} }},"))?;
        }
        put("        ],".to_owned())?;
    }
    put("    ],\n};".to_owned())
}

/// The nodes that bids need, numbered in order: operands before operations.
fn places(module: &Module<'_>) -> BTreeMap<NodeId, usize> {
    let mut open: Vec<NodeId> =
        module.teams.iter().flat_map(|team| &team.edges).map(|edge| module.bidders[edge.bidder].value).collect();
    let mut places = BTreeMap::new();
    while let Some(id) = open.pop() {
        if places.insert(id, 0).is_none() {
            open.extend(module.node(id).operands());
        }
    }
    places.values_mut().zip(0..).for_each(|(place, number)| *place = number);
    places
}
