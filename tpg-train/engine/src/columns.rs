//! The values of a plan's nodes: a column for each node, with one value for each lane.
//!
//! A column is a whole number of blocks, and every loop runs over whole blocks: what stands in lanes beyond the last is
//! computed along and never read. Nothing is fused or reordered: the same bits as one lane at a time. What is marked
//! `inline(always)` here becomes part of [`Decider::decide`](super::decide::Decider::decide), which is compiled for the
//! widest vectors that the processor has.

use crate::nodes::{Node, NodeId, NodeSet};
use crate::plan::Plan;
use crate::view::{BLOCK, Block, View};
use std::marker::PhantomData;
use tpg_runtime::ops::{Instruction, Maths};
use tpg_runtime::scalar::Scalar;

/// The values of a plan's nodes, in every lane.
#[derive(Debug)]
pub(super) struct Columns<S, M> {
    /// Blocks of a column.
    blocks: usize,
    values: Vec<Block<S>>,
    /// The operations whose columns are those of the state that is shown.
    fresh: NodeSet,
    /// The operations that only a new episode changes.
    lasting: NodeSet,
    maths: PhantomData<M>,
}

impl<S: Scalar, M: Maths<S>> Columns<S, M> {
    pub(super) fn new(lanes: usize) -> Self {
        Self {
            blocks: lanes.div_ceil(BLOCK),
            values: Vec::new(),
            fresh: NodeSet::default(),
            lasting: NodeSet::default(),
            maths: PhantomData,
        }
    }

    /// Makes room for a plan's nodes, and fills its constants in. Inputs in `constant` change with the episode only.
    pub(super) fn prepare(&mut self, plan: &Plan<S>, constant: &[u16]) {
        self.values.clear();
        self.values.resize(plan.nodes.len() * self.blocks, [S::ZERO; BLOCK]);
        for (column, node) in self.values.chunks_exact_mut(self.blocks).zip(&plan.nodes) {
            if let Node::Constant(value) = node {
                column.fill([*value; BLOCK]);
            }
        }
        self.fresh = NodeSet::empty(plan.nodes.len());
        self.lasting = NodeSet::empty(plan.nodes.len());
        let mut lasts = vec![false; plan.nodes.len()];
        for (place, node) in (0u32..).zip(&plan.nodes) {
            lasts[place as usize] = match node {
                Node::Constant(_) => true,
                Node::Input(input) => constant.contains(input),
                Node::Operation(_, a, b) => lasts[a.index()] && lasts[b.index()],
            };
            if lasts[place as usize] {
                self.lasting.insert(NodeId(place));
            }
        }
    }

    /// Another state is shown: from here on what was computed is old, but for what follows from the episode alone.
    #[inline(always)]
    pub(super) fn next_step(&mut self) {
        self.fresh.keep(&self.lasting);
    }

    /// In some lane another episode is shown: all that was computed is old.
    pub(super) fn forget(&mut self) {
        self.fresh.clear();
    }

    /// Where the values of the flat state go; `places` are those of their nodes.
    pub(super) fn view<'a>(&'a mut self, places: &'a [u32]) -> View<'a, S> {
        View { columns: &mut self.values, blocks: self.blocks, places }
    }

    #[inline]
    pub(super) fn get(&self, node: NodeId, lane: usize) -> S {
        self.values[node.index() * self.blocks + lane / BLOCK][lane % BLOCK]
    }

    /// A node's values, block by block.
    #[inline(always)]
    pub(super) fn column(&self, node: NodeId) -> &[Block<S>] {
        &self.values[node.index() * self.blocks..][..self.blocks]
    }

    /// Computes what is needed and not fresh, in the first `lanes` lanes. Every operand of what is needed is needed too.
    #[inline(always)]
    pub(super) fn compute(&mut self, plan: &Plan<S>, needs: &NodeSet, lanes: usize) {
        let Self { blocks, values, fresh, .. } = self;
        let used = lanes.div_ceil(BLOCK);
        fresh.add(
            needs,
            #[inline(always)]
            |node| {
                let Node::Operation(instruction, a, b) = plan.nodes[node.index()] else { return };
                let (before, from) = values.split_at_mut(node.index() * *blocks);
                let a = &before[a.index() * *blocks..][..used];
                let b = &before[b.index() * *blocks..][..used];
                match (lanes, a, b, &mut from[..used]) {
                    // One value is sooner computed than a block of them.
                    (1, [a], [b], [to]) => to[0] = instruction.apply::<S, M>(a[0], b[0]),
                    (_, a, b, to) => compute_column::<S, M>(instruction, [a, b], to),
                }
            },
        );
    }

    /// A node's value in one lane, computed for it alone where it is not fresh.
    pub(super) fn value(&self, plan: &Plan<S>, node: NodeId, lane: usize) -> S {
        match plan.nodes[node.index()] {
            Node::Operation(instruction, a, b) if !self.fresh.contains(node) => {
                let a_value = self.value(plan, a, lane);
                let b_value = if a == b { a_value } else { self.value(plan, b, lane) };
                instruction.apply::<S, M>(a_value, b_value)
            }
            _ => self.get(node, lane),
        }
    }
}

/// One loop for each instruction, so that none has to look at it again.
///
/// The shape of the loops is the compiler's: short bodies over single values (of nested loops it would unroll the inner
/// one and turn the outer one into gathers), long ones block by block (they get no remainder that goes value by value).
#[inline(always)]
fn compute_column<S: Scalar, M: Maths<S>>(instruction: Instruction, [a, b]: [&[Block<S>]; 2], to: &mut [Block<S>]) {
    macro_rules! loops {
        (short: $($short:ident)*; long: $($long:ident)*) => {
            match instruction {
                $(Instruction::$short => {
                    let (a, b) = (a.as_flattened(), b.as_flattened());
                    for ((to, &a), &b) in to.as_flattened_mut().iter_mut().zip(a).zip(b) {
                        *to = Instruction::$short.apply::<S, M>(a, b);
                    }
                })*
                $(Instruction::$long => {
                    for (to, a) in to.iter_mut().zip(a) {
                        let mut values = *a;
                        for value in &mut values {
                            *value = Instruction::$long.apply::<S, M>(*value, *value);
                        }
                        *to = values;
                    }
                })*
            }
        };
    }
    loops!(short: Sub Add Mul Div NegateIfLess Abs Min Max; long: Cos Sin Ln Exp);
}
