//! The bids of each policy as a table, made of the same optimised graph as its code: `web/src/bids.rs` for the problems, data for
//! the arm, whose table is greater than what the module may weigh.

use crate::policies::{POLICIES, Policy};
use std::fmt::Write as _;
use std::io;
use tpg_codegen::report::{Bids, Destination, Value};

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

/// The table of a policy, whose numbers JSON can hold.
pub(crate) fn bids(policy: &Policy) -> io::Result<Bids> {
    let bids = Bids::of(&policy.graph()?, &policy.options()?);
    let is_odd = |value: &&Value| matches!(value, Value::Constant(number) if !number.is_finite());
    match bids.values.iter().find(is_odd) {
        Some(value) => Err(io::Error::other(format!("{value:?} among the values of a bid"))),
        None => Ok(bids),
    }
}

fn table(text: &mut String, policy: &Policy) -> io::Result<()> {
    let Bids { values, teams } = bids(policy)?;
    let name = policy.folder.replace('-', "_").to_uppercase();
    let mut put = |line: String| writeln!(text, "{line}").map_err(io::Error::other);
    put(format!("\n/// Of `generated/{}`.", policy.folder))?;
    put(format!("pub static {name}: Bids = Bids {{\n    values: &["))?;
    for value in values {
        put(match value {
            Value::Constant(number) => format!("        Constant({:?}),", number as f32),
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
                Destination::Team(team) => format!("Team({team})"),
                Destination::End(end) => format!("End({end})"),
            };
            put(format!("            Edge {{ bid: {bid}, to: {to} }},"))?;
        }
        put("        ],".to_owned())?;
    }
    put("    ],\n};".to_owned())
}
