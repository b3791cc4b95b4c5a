//! The functions that expressions call beside the instructions, and the numbers in them.

use super::syntax::Syntax;
use crate::ir::Node;
use crate::passes::estimate;
use std::collections::BTreeSet;
use tpg_runtime::ops::Instruction;

/// The instructions that some nodes call, and those that they estimate.
pub(super) struct Calls {
    operations: BTreeSet<Instruction>,
    estimates: BTreeSet<Instruction>,
}

/// The constants of an estimated logarithm.
pub(super) struct LnEstimate {
    pub(super) scale: String,
    pub(super) offset: String,
}

/// The constants of an estimated exponential.
pub(super) struct ExpEstimate {
    pub(super) from: String,
    pub(super) to: String,
    pub(super) scale: String,
    pub(super) offset: String,
    pub(super) below: String,
    pub(super) infinite_above: String,
}

impl Calls {
    pub(super) fn of(nodes: &[Node]) -> Self {
        let mut calls = Self { operations: BTreeSet::new(), estimates: BTreeSet::new() };
        for node in nodes {
            match *node {
                Node::Operation(instruction, _) => calls.operations.insert(instruction),
                Node::Upper(instruction, _) => calls.estimates.insert(instruction),
                Node::Constant(_) | Node::Input(_) => false,
            };
        }
        calls
    }

    /// Tests for calls of any of `instructions`.
    pub(super) fn any(&self, instructions: &[Instruction]) -> bool {
        instructions.iter().any(|instruction| self.operations.contains(instruction))
    }

    pub(super) fn ln_estimate(&self, syntax: &impl Syntax) -> Option<LnEstimate> {
        let estimate = estimate::of(syntax.graph().scalar());
        let [scale, offset] = [estimate.ln_scale, estimate.ln_offset].map(|number| syntax.literal(number));
        self.estimates.contains(&Instruction::Ln).then_some(LnEstimate { scale, offset })
    }

    /// The suffix is that of unsigned integers of the scalar's size.
    pub(super) fn exp_estimate(&self, syntax: &impl Syntax, suffix: &str) -> Option<ExpEstimate> {
        let estimate = estimate::of(syntax.graph().scalar());
        self.estimates.contains(&Instruction::Exp).then(|| ExpEstimate {
            from: syntax.literal(estimate.exp_between.0),
            to: syntax.literal(estimate.exp_between.1),
            scale: syntax.literal(estimate.exp_scale),
            offset: format!("{:#x}{suffix}", estimate.exp_offset),
            below: syntax.literal(estimate.exp_below),
            infinite_above: syntax.literal(estimate.exp_infinite_above),
        })
    }
}
