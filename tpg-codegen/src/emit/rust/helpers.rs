//! The functions that expressions of the profile `fast` call.

use super::expression::{Printer, literal};
use crate::graph::MathsProvider;
use crate::ir::Node;
use crate::passes::bound;
use askama::Template;
use std::collections::BTreeSet;
use tpg_runtime::ops::Instruction;

#[derive(Template)]
#[template(path = "rust/helpers.rs", escape = "none")]
struct Helpers<'a> {
    scalar: &'a str,
    zero: String,
    short_ln: bool,
    short_exp: bool,
    infinite_above: String,
    zero_below: String,
    uppers: Vec<Upper>,
}

struct Upper {
    name: &'static str,
    /// Whether negative arguments give NaN.
    logarithm: bool,
    steps: Vec<(String, String)>,
    beyond: String,
}

/// Renders what the printer's nodes call.
pub(super) fn render(printer: &Printer<'_>) -> String {
    let scalar = printer.graph.scalar();
    let short = printer.short_cuts && printer.graph.maths() == MathsProvider::System;
    let uses = |wanted| printer.nodes.iter().any(|node| matches!(*node, Node::Operation(i, _) if i == wanted));
    let bounded: BTreeSet<Instruction> = (printer.nodes.iter())
        .filter_map(|node| if let Node::Upper(instruction, _) = *node { Some(instruction) } else { None })
        .collect();
    let number = |value: f64| literal(scalar, value);
    let (infinite_above, zero_below) = bound::beyond_exponentials(scalar);
    let helpers = Helpers {
        scalar: scalar.name(),
        zero: number(0.0),
        short_ln: short && uses(Instruction::Ln),
        short_exp: short && uses(Instruction::Exp),
        infinite_above: number(infinite_above),
        zero_below: number(zero_below),
        uppers: (bounded.into_iter())
            .map(|instruction| Upper {
                name: instruction.name(),
                logarithm: instruction == Instruction::Ln,
                steps: bound::steps(scalar, instruction)
                    .iter()
                    .map(|&(up_to, value)| (number(up_to), number(value)))
                    .collect(),
                beyond: number(f64::INFINITY),
            })
            .collect(),
    };
    helpers.render().expect("the template renders")
}
