//! The values of a plan's nodes: a column for each node, with one value for each lane.
//!
//! Loops over lanes run in the widest vectors that the processor has (the crate pulp looks once), without fusing or
//! reordering anything: the same bits as one lane at a time.

use super::nodes::{Node, NodeId};
use super::plan::Plan;
use pulp::Arch;
use std::marker::PhantomData;
use tpg_runtime::ops::{Instruction, Maths};
use tpg_runtime::scalar::Scalar;

/// The values of a plan's nodes, in every lane.
#[derive(Debug)]
pub(super) struct Columns<S, M> {
    lanes: usize,
    values: Vec<S>,
    /// The step in which each node was computed last.
    computed_at: Vec<u64>,
    now: u64,
    arch: Arch,
    maths: PhantomData<M>,
}

impl<S: Scalar, M: Maths<S>> Columns<S, M> {
    pub(super) fn new(lanes: usize) -> Self {
        Self { lanes, values: Vec::new(), computed_at: Vec::new(), now: 0, arch: Arch::new(), maths: PhantomData }
    }

    /// Makes room for a plan's nodes, and fills its constants in.
    pub(super) fn prepare(&mut self, plan: &Plan<S>) {
        self.values.clear();
        self.values.resize(plan.nodes.len() * self.lanes, S::ZERO);
        for (column, node) in self.values.chunks_exact_mut(self.lanes).zip(&plan.nodes) {
            if let Node::Constant(value) = node {
                column.fill(*value);
            }
        }
        self.computed_at.clear();
        self.computed_at.resize(plan.nodes.len(), 0);
        self.now = 0;
    }

    /// From here on what was computed is old.
    pub(super) fn next_step(&mut self) {
        self.now += 1;
    }

    #[inline]
    pub(super) fn set(&mut self, node: NodeId, lane: usize, value: S) {
        self.values[node.index() * self.lanes + lane] = value;
    }

    #[inline]
    pub(super) fn get(&self, node: NodeId, lane: usize) -> S {
        self.values[node.index() * self.lanes + lane]
    }

    /// A node's values in the first `count` lanes.
    #[inline]
    pub(super) fn column(&self, node: NodeId, count: usize) -> &[S] {
        &self.values[node.index() * self.lanes..][..count]
    }

    /// Computes a node in the first `count` lanes, once a step; its operands are there already.
    pub(super) fn compute(&mut self, plan: &Plan<S>, node: NodeId, count: usize) {
        if std::mem::replace(&mut self.computed_at[node.index()], self.now) == self.now {
            return;
        }
        let Node::Operation(instruction, a, b) = plan.nodes[node.index()] else { return };
        let (before, from) = self.values.split_at_mut(node.index() * self.lanes);
        let operands = [a, b].map(|operand| &before[operand.index() * self.lanes..][..count]);
        let to = &mut from[..count];
        self.arch.dispatch(
            #[inline(always)]
            || compute_column::<S, M>(instruction, operands, to),
        );
    }

    /// A node's value in one lane, computed for it alone where this step has not computed it for all.
    pub(super) fn value(&self, plan: &Plan<S>, node: NodeId, lane: usize) -> S {
        match plan.nodes[node.index()] {
            Node::Operation(instruction, a, b) if self.computed_at[node.index()] != self.now => {
                let a_value = self.value(plan, a, lane);
                let b_value = if a == b { a_value } else { self.value(plan, b, lane) };
                instruction.apply::<S, M>(a_value, b_value)
            }
            _ => self.get(node, lane),
        }
    }
}

/// One loop for each instruction, so that none has to look at it again. Always inlined, into a function that may use wide
/// vectors.
#[inline(always)]
fn compute_column<S: Scalar, M: Maths<S>>(instruction: Instruction, [a, b]: [&[S]; 2], to: &mut [S]) {
    macro_rules! loops {
        ($($name:ident)*) => {
            match instruction {
                $(Instruction::$name => {
                    for ((to, &a), &b) in to.iter_mut().zip(a).zip(b) {
                        *to = Instruction::$name.apply::<S, M>(a, b);
                    }
                })*
            }
        };
    }
    loops!(Sub Add Mul Div NegateIfLess Cos Sin Ln Exp Abs Min Max);
}
