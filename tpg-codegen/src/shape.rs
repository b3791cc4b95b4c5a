//! The shape of code: what the text is made of.

use crate::integers::Integers;
use crate::ir::{Module, NodeId};
use crate::options::Profile;
use crate::passes::bytecode::Bytecode;
use crate::passes::cases::Cases;
use crate::passes::schedule::Schedule;
use std::collections::BTreeSet;

/// The shape of code, with the results of its passes.
#[derive(Clone, Debug, PartialEq)]
pub(crate) enum Shape {
    /// See [`Profile::Fast`].
    Fast(Schedule),
    /// See [`Profile::Balanced`].
    Balanced(Cases),
    /// Tables and an evaluator: [`Profile::Small`], unless another shape of a small graph is less.
    Small(Bytecode),
    /// See [`Profile::ConstantTime`].
    ConstantTime,
    /// Nothing to decide: the outputs of the only leaf. In any profile; without a branch for [`Profile::ConstantTime`].
    Formula(Formula),
    /// See [`Style::Gegelati`].
    Gegelati,
    /// See [`integers`](crate::integers).
    Integers(Integers),
}

/// The outputs of the only leaf.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(crate) struct Formula {
    /// The value of each output, before it is limited.
    pub values: Vec<NodeId>,
    /// The operations that they need, operands before operations.
    pub operations: BTreeSet<NodeId>,
    /// No comparison may become a branch.
    pub branch_free: bool,
}

impl Formula {
    pub(crate) fn new(module: &Module<'_>, profile: Profile) -> Option<Self> {
        let values = module.only_leaf()?.values.clone();
        let operations = values.iter().flat_map(|&value| module.operations_of(value)).collect();
        Some(Self { values, operations, branch_free: profile == Profile::ConstantTime })
    }
}
