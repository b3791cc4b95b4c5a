//! The comment beside a sum: its formula in the units of the sources, and its bound.

use crate::integers::{Form, Whole};
use crate::ir::{Module, Node, NodeId};
use Node::*;
use std::collections::BTreeMap;
use std::fmt::Write as _;
use tpg_graph::{Counts, Graph, Input, Output};
use tpg_runtime::ops::Instruction::*;

/// A sum of multiples of values of the state.
#[derive(Clone, Debug, Default, PartialEq)]
pub(super) struct LinearSum {
    pub(super) weights: BTreeMap<Input, f64>,
    pub(super) constant: f64,
}

impl LinearSum {
    /// The sum that a node is, if it is one.
    pub(super) fn new(module: &Module<'_>, form: &Form) -> Option<Self> {
        let weights = form.terms.iter().map(|(&term, &weight)| match module.node(term) {
            Node::Input(input) => Some((input, weight)),
            _ => None,
        });
        Some(Self { weights: weights.collect::<Option<_>>()?, constant: form.constant })
    }

    /// The same sum of values instead of counts.
    fn in_units(&self, graph: &Graph) -> Self {
        let mut linear = Self { constant: self.constant, ..Self::default() };
        for (&input, &weight) in &self.weights {
            let counts = graph.counts_of(input);
            let scale = counts.map_or(1.0, |counts| counts.scale);
            linear.constant += weight * counts.map_or(0.0, |counts| counts.offset);
            linear.weights.insert(input, weight / scale);
        }
        linear
    }

    fn divided(&self, by: f64, less: f64) -> Self {
        let weights = self.weights.iter().map(|(&input, weight)| (input, weight / by)).collect();
        Self { weights, constant: self.constant / by - less }
    }

    fn text(&self, graph: &Graph) -> String {
        let mut text = String::new();
        let terms = self.weights.iter().map(|(&input, &weight)| (Some(input), weight));
        for (input, number) in terms.chain([(None, self.constant)]).filter(|(_, number)| *number != 0.0) {
            let sign = match (text.is_empty(), number < 0.0) {
                (true, false) => "",
                (true, true) => "-",
                (false, false) => " + ",
                (false, true) => " - ",
            };
            let number = five_digits(number.abs());
            let term = input.map(|input| {
                let (source, place) = graph.source_of(input);
                let place = if source.ranges.len() == 1 { String::new() } else { format!("[{place}]") };
                let factor = if number == "1" { String::new() } else { format!("{number} * ") };
                format!("{factor}{}{place}", source.name)
            });
            let _ = write!(text, "{sign}{}", term.unwrap_or(number));
        }
        if text.is_empty() { "0".to_owned() } else { text }
    }
}

/// The comments of a block's sums.
pub(super) struct Comments<'a> {
    module: &'a Module<'a>,
    /// The name of each root, with its formula.
    names: BTreeMap<NodeId, String>,
}

impl<'a> Comments<'a> {
    /// The comments of a team's bids, with the names of what they bid for: formulas to one scale.
    pub(super) fn for_bids(module: &'a Module<'a>, forms: &[Form], bids: &[(NodeId, String)]) -> Self {
        let mut names: BTreeMap<NodeId, String> = BTreeMap::new();
        let ids: Vec<NodeId> = bids.iter().map(|(id, _)| *id).collect();
        for ((id, name), text) in bids.iter().zip(bids_in_units(module, forms, &ids)) {
            if let Some(text) = text.filter(|_| forms[id.index()].number().is_none()) {
                names.entry(*id).or_insert_with(|| format!("{name} bids in proportion to {text}"));
            }
        }
        Self { module, names }
    }

    /// The comments of a leaf's outputs: their formulas are in the outputs' units.
    pub(super) fn for_outputs(module: &'a Module<'a>, forms: &[Form], values: &[NodeId]) -> Self {
        let mut names = BTreeMap::new();
        for (output, &value) in module.graph.outputs().iter().zip(values) {
            let (inner, _) = divided(module, value);
            let Some(text) =
                output_in_units(module, forms, output, value).filter(|_| forms[inner.index()].number().is_none())
            else {
                continue;
            };
            names.entry(inner).or_insert_with(|| format!("{} = {text}", output.name));
        }
        Self { module, names }
    }

    /// The comment of a node, if there is something to say.
    pub(super) fn text(&self, id: NodeId, whole: Whole) -> Option<String> {
        let sums = matches!(self.module.node(id), Operation(Add | Sub | Mul, _));
        let bound = if whole.fits(32) {
            format!("at most {} of {}", grouped(whole.magnitude()), grouped(i32::MAX as u64))
        } else {
            format!("at most {}: 64 bits", grouped(whole.magnitude()))
        };
        match self.names.get(&id) {
            Some(name) => Some(format!("{name}; {bound}")),
            None => sums.then_some(bound),
        }
    }
}

/// The formulas of bids that are sums, in units and to one scale.
pub(crate) fn bids_in_units(module: &Module<'_>, forms: &[Form], bids: &[NodeId]) -> Vec<Option<String>> {
    let sum = |id: &NodeId| Some(LinearSum::new(module, &forms[id.index()])?.in_units(module.graph));
    let sums: Vec<Option<LinearSum>> = bids.iter().map(sum).collect();
    let weights = sums.iter().flatten().flat_map(|linear| linear.weights.values());
    let greatest = weights.fold(0.0, |most: f64, weight| most.max(weight.abs()));
    let unit = greatest.log2().floor().max(0.0).exp2();
    sums.into_iter().map(|linear| Some(linear?.divided(unit, 0.0).text(module.graph))).collect()
}

/// The formula of an output that is a sum, in its unit.
pub(crate) fn output_in_units(module: &Module<'_>, forms: &[Form], output: &Output, value: NodeId) -> Option<String> {
    let (scale, offset) = output.counts.map_or((1.0, 0.0), |counts| (counts.scale, counts.offset));
    let (inner, divisor) = divided(module, value);
    let (linear, divisor) = (LinearSum::new(module, &forms[inner.index()])?.in_units(module.graph), divisor?);
    // The half that makes rounding down rounding to the nearest.
    let half = (divisor / 2.0).floor();
    let linear = LinearSum { constant: linear.constant - half, ..linear };
    Some(linear.divided(divisor / scale, offset * scale).text(module.graph))
}

/// What a value divides, and by what number; itself by 1 if it is no quotient.
fn divided(module: &Module<'_>, value: NodeId) -> (NodeId, Option<f64>) {
    match module.node(value) {
        Operation(Quotient, [a, b]) => (a, module.node(b).as_constant()),
        _ => (value, Some(1.0)),
    }
}

/// The worth of a count.
pub(in crate::emit) fn worth(scale: f64, unit: &str) -> String {
    with_unit(&five_digits(scale), unit) + " a count"
}

/// The worth of a count, and the value of the count 0 unless that is 0.
pub(crate) fn worth_from(counts: &Counts, unit: &str) -> String {
    let offset = if counts.offset == 0.0 { String::new() } else { format!(" from {} on", counts.offset) };
    worth(counts.scale, unit) + &offset
}

/// A number and its unit, if it has one.
pub(in crate::emit) fn with_unit(number: &str, unit: &str) -> String {
    if unit.is_empty() { number.to_owned() } else { format!("{number} {unit}") }
}

/// A number with five significant digits.
fn five_digits(number: f64) -> String {
    format!("{number:.4e}").parse::<f64>().map_or_else(|_| number.to_string(), |number| number.to_string())
}

/// A number with commas between thousands.
pub(super) fn grouped(number: u64) -> String {
    let digits = number.to_string();
    let mut text = String::new();
    for (place, digit) in digits.chars().enumerate() {
        if place > 0 && (digits.len() - place).is_multiple_of(3) {
            text.push(',');
        }
        text.push(digit);
    }
    text
}

#[cfg(test)]
mod tests {
    use super::{five_digits, grouped};

    #[test]
    fn numbers_are_short() {
        assert_eq!([861_784_409, 1000, 999].map(grouped), ["861,784,409", "1,000", "999"]);
        assert_eq!([8.037_242, 0.000_123_456_7, 11.0].map(five_digits), ["8.0372", "0.00012346", "11"]);
    }
}
