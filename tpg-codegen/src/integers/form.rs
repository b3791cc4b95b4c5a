//! Values as sums of multiples of what is no sum: inputs, and the results of other instructions.

use crate::ir::{Module, Node, NodeId};
use std::collections::BTreeMap;
use tpg_runtime::ops::Instruction;

/// A sum of multiples of nodes, and a constant.
#[derive(Clone, Debug, Default, PartialEq)]
pub(crate) struct Form {
    pub(crate) terms: BTreeMap<NodeId, f64>,
    pub(crate) constant: f64,
}

impl Form {
    fn node(id: NodeId) -> Self {
        Self { terms: BTreeMap::from([(id, 1.0)]), constant: 0.0 }
    }

    fn times(&self, factor: f64) -> Self {
        let terms = self.terms.iter().map(|(&id, weight)| (id, weight * factor)).collect();
        Self { terms, constant: self.constant * factor }
    }

    fn plus(&self, other: &Self, factor: f64) -> Self {
        let mut sum = self.clone();
        sum.constant += other.constant * factor;
        for (&id, weight) in &other.terms {
            *sum.terms.entry(id).or_default() += weight * factor;
        }
        sum.terms.retain(|_, weight| *weight != 0.0);
        sum
    }

    /// The number that it is, if it is one.
    pub(crate) fn number(&self) -> Option<f64> {
        self.terms.is_empty().then_some(self.constant)
    }

    /// The only node that it is a multiple of, with the factor.
    pub(crate) fn multiple(&self) -> Option<(NodeId, f64)> {
        let (&id, &factor) = self.terms.first_key_value()?;
        (self.terms.len() == 1 && self.constant == 0.0).then_some((id, factor))
    }
}

/// The form of every node of a module.
pub(crate) fn forms(module: &Module<'_>) -> Vec<Form> {
    let mut forms: Vec<Form> = Vec::with_capacity(module.nodes.len());
    for (place, node) in module.nodes.iter().enumerate() {
        let itself = || Form::node(NodeId(place as u32));
        forms.push(match *node {
            Node::Constant(bits) if f64::from_bits(bits).is_finite() => {
                Form { constant: f64::from_bits(bits), ..Form::default() }
            }
            Node::Operation(instruction, operands) => {
                let [a, b] = operands.map(|operand| &forms[operand.index()]);
                match (instruction, a.number(), b.number()) {
                    (Instruction::Add, ..) => a.plus(b, 1.0),
                    (Instruction::Sub, ..) => a.plus(b, -1.0),
                    (Instruction::Mul, Some(number), _) => b.times(number),
                    (Instruction::Mul, _, Some(number)) => a.times(number),
                    (Instruction::Div, _, Some(number)) if number != 0.0 => a.times(1.0 / number),
                    _ => itself(),
                }
            }
            Node::Constant(_) | Node::Input(_) | Node::Upper(..) => itself(),
        });
    }
    forms
}
