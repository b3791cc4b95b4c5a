//! `web/src/bids.rs`: the bids of each policy as a table, made of the same optimised graph as its code.

use crate::policies::{POLICIES, Policy};
use std::collections::BTreeMap;
use std::fmt::Write as _;
use std::io;
use tpg_codegen::compile;
use tpg_codegen::ir::{Module, Node, NodeId, Target};
use tpg_codegen::options::Language;

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

fn table(text: &mut String, policy: &Policy) -> io::Result<()> {
    let (graph, options) = (policy.graph()?, policy.options()?);
    let program = compile(&graph, &options, Language::C);
    let module = &program.module;
    let places = places(module);
    let place = |id: NodeId| places[&id];
    let mut put = |line: String| writeln!(text, "{line}").map_err(io::Error::other);
    put(format!("\n/// Of `generated/{}`.", policy.folder))?;
    put(format!("pub static {}: Bids = Bids {{\n    values: &[", policy.table))?;
    for &id in places.keys() {
        put(match module.node(id) {
            Node::Constant(bits) => format!("        Constant({:?}),", f64::from_bits(bits) as f32),
            Node::Input(input) => format!("        Input({}),", input.index()),
            Node::Operation(instruction, [a, b]) => {
                let b = if instruction.arity() == 1 { a } else { b };
                format!(
                    "        Operation(|a, b| {instruction:?}.apply::<f32, Own>(a, b), {}, {}),",
                    place(a),
                    place(b)
                )
            }
            Node::Upper(..) => return Err(io::Error::other("a bound among the values of a bid")),
        })?;
    }
    put("    ],\n    teams: &[".to_owned())?;
    for team in &module.teams {
        put("        &[".to_owned())?;
        for edge in &team.edges {
            let to = match edge.to {
                Target::Team(team) => format!("Team({team})"),
                Target::Action(end) => format!("End({})", end.0),
            };
            put(format!("            Edge {{ bid: {}, to: {to} }},", place(module.bidders[edge.bidder].value)))?;
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
