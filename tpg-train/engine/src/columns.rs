//! The values of a plan's nodes: one column per node, with one value per lane.
//!
//! A column is a whole number of blocks, and every loop runs over whole blocks: lanes beyond the last are computed as
//! well and never read. Nothing is fused or reordered, so the bits are the same as for one lane at a time. Functions
//! marked `inline(always)` are inlined into [`Decider::decide`](super::decide::Decider::decide), which is compiled for
//! the widest vectors of the processor.

use crate::nodes::{Node, NodeId, NodeSet};
use crate::plan::Plan;
use crate::view::{BLOCK, Block, HALF, View};
use std::marker::PhantomData;
use tpg_runtime::ops::{Instruction, Maths};
use tpg_runtime::scalar::Scalar;

/// The values of a plan's nodes in every lane.
#[derive(Debug)]
pub(super) struct Columns<S, M> {
    /// Number of blocks in a column.
    blocks: usize,
    values: Vec<Block<S>>,
    /// Operations whose columns are up to date for the current state.
    fresh: NodeSet,
    /// Operations that change only with the episode.
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

    /// Allocates columns for a plan's nodes and fills in its constants. The inputs in `constant` change only with the
    /// episode.
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

    /// Marks all columns as stale for the next state, except those that depend on the episode alone.
    #[inline(always)]
    pub(super) fn next_step(&mut self) {
        self.fresh.keep(&self.lasting);
    }

    /// Marks all columns as stale because some lane starts another episode.
    pub(super) fn forget(&mut self) {
        self.fresh.clear();
    }

    /// Returns the columns for the flat state; `places` maps its values to their nodes.
    pub(super) fn view<'a>(&'a mut self, places: &'a [u32]) -> View<'a, S> {
        View { columns: &mut self.values, blocks: self.blocks, places }
    }

    #[inline]
    pub(super) fn get(&self, node: NodeId, lane: usize) -> S {
        self.values[node.index() * self.blocks + lane / BLOCK][lane % BLOCK]
    }

    /// Returns a node's values, block by block.
    #[inline(always)]
    pub(super) fn column(&self, node: NodeId) -> &[Block<S>] {
        &self.values[node.index() * self.blocks..][..self.blocks]
    }

    /// Computes the needed nodes that are stale in the first `lanes` lanes. The operands of a needed node are also in
    /// `needs`.
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
                    // A single lane is cheaper to compute as a scalar than as a block, few are cheaper as half of one.
                    (1, [a], [b], [to]) => to[0] = instruction.apply::<S, M>(a[0], b[0]),
                    (..=HALF, [a], [b], [to]) => {
                        compute_column::<S, M, HALF>(instruction, [&a[..HALF], &b[..HALF]], &mut to[..HALF], lanes);
                    }
                    (_, a, b, to) => {
                        let (a, b) = (a.as_flattened(), b.as_flattened());
                        compute_column::<S, M, BLOCK>(instruction, [a, b], to.as_flattened_mut(), lanes);
                    }
                }
            },
        );
    }

    /// Returns a node's value in one lane, computing it for that lane alone if its column is stale.
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

/// Dispatches once per instruction, so that the loops do not test it again. Columns are whole numbers of parts of `PART` lanes.
///
/// The shape of the loops suits the compiler. Short bodies loop over single values (it would unroll the inner of two
/// nested loops and turn the outer one into gathers); long bodies loop over blocks (which leaves no scalar remainder). Long
/// bodies in doubles go by eight lanes, because a block of them is two vectors; so do those that compute in 64 bits.
#[inline(always)]
fn compute_column<S: Scalar, M: Maths<S>, const PART: usize>(
    instruction: Instruction,
    [a, b]: [&[S]; 2],
    to: &mut [S],
    lanes: usize,
) {
    let by_eight = size_of::<S>() == size_of::<f64>() || matches!(instruction, Instruction::Cos | Instruction::Sin);
    macro_rules! loops {
        (short: $($short:ident)*; long: $($long:ident $many:ident)*) => {
            match instruction {
                $(Instruction::$short => {
                    for ((to, &a), &b) in to.iter_mut().zip(a).zip(b) {
                        *to = Instruction::$short.apply::<S, M>(a, b);
                    }
                })*
                $(Instruction::$long if by_eight => {
                    let (to, a) = (to.as_chunks_mut().0, a.as_chunks().0);
                    for (place, (to, a)) in (0..lanes).step_by(8).zip(to.iter_mut().zip(a)) {
                        *to = *a;
                        M::$many(to, (lanes - place).min(8));
                    }
                })*
                $(Instruction::$long => {
                    for (to, a) in to.as_chunks_mut::<PART>().0.iter_mut().zip(a.as_chunks::<PART>().0) {
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
    loops!(
        short: Sub Add Mul Div NegateIfLess Abs Min Max Gate Fmod;
        long: Cos cosines Sin sines Tan tangents Ln logarithms Exp exponentials
    );
}
