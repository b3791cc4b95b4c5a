//! The values of a plan's nodes: one column per node, with one value per lane.
//!
//! A column is a whole number of blocks, and every loop runs over whole blocks or parts of them: lanes beyond the last are
//! computed as well and never read. An operation is computed only in the parts of a column whose lanes need it. Nothing is fused or reordered, so
//! the bits are the same as for one lane at a time. Functions marked `inline(always)` are inlined into [`Columns::compute`], which
//! is compiled for the widest vectors of the processor.

use crate::nodes::{Node, NodeId};
use crate::parts::Parts;
use crate::plan::Plan;
use crate::view::{BLOCK, Block, PART, View, part, part_mut};
use fearless_simd::{Level, dispatch};
use std::marker::PhantomData;
use tpg_runtime::ops::{Instruction, Maths};
use tpg_runtime::scalar::Scalar;

/// The values of a plan's nodes in every lane.
#[derive(Debug)]
pub(super) struct Columns<S, M> {
    /// Number of blocks in a column.
    blocks: usize,
    values: Vec<Block<S>>,
    /// Parts of each operation's column that are up to date for the current state.
    fresh: Vec<Parts>,
    level: Level,
    maths: PhantomData<M>,
}

impl<S: Scalar, M: Maths<S>> Columns<S, M> {
    pub(super) fn new(lanes: usize) -> Self {
        Self {
            blocks: lanes.div_ceil(BLOCK),
            values: Vec::new(),
            fresh: Vec::new(),
            level: Level::new(),
            maths: PhantomData,
        }
    }

    /// Allocates columns for a plan's nodes and fills in its constants.
    pub(super) fn prepare(&mut self, plan: &Plan<S>) {
        self.values.clear();
        self.values.resize(plan.nodes.len() * self.blocks, [S::ZERO; BLOCK]);
        for (column, node) in self.values.chunks_exact_mut(self.blocks).zip(&plan.nodes) {
            if let Node::Constant(value) = node {
                column.fill([*value; BLOCK]);
            }
        }
        self.fresh.clear();
        self.fresh.resize(plan.nodes.len(), Parts::NONE);
    }

    /// Marks all columns as stale for the next state.
    pub(super) fn next_step(&mut self) {
        self.fresh.fill(Parts::NONE);
    }

    /// Returns the columns for the flat state; `places` maps its values to their nodes.
    pub(super) fn view<'a>(&'a mut self, places: &'a [u32]) -> View<'a, S> {
        View { columns: &mut self.values, blocks: self.blocks, places }
    }

    #[inline]
    pub(super) fn get(&self, node: NodeId, lane: usize) -> S {
        self.values[node.index() * self.blocks + lane / BLOCK][lane % BLOCK]
    }

    /// Returns the values of a node in a block of lanes.
    #[inline(always)]
    pub(super) fn block(&self, node: NodeId, block: usize) -> &Block<S> {
        &self.values[node.index() * self.blocks..][..self.blocks][block]
    }

    /// Computes those operations that are stale for the first lane alone, as scalars.
    pub(super) fn compute_one(&mut self, plan: &Plan<S>, needs: &[NodeId]) {
        for &node in needs {
            if self.fresh[node.index()].contains(0) {
                continue;
            }
            self.fresh[node.index()].insert(0);
            if let Node::Operation(instruction, a, b) = plan.nodes[node.index()] {
                let value = instruction.apply::<S, M>(self.get(a, 0), self.get(b, 0));
                self.values[node.index() * self.blocks][0] = value;
            }
        }
    }

    /// Computes operations where they are stale: each in some parts of the first `lanes` lanes. Operands come before what
    /// they enter.
    pub(super) fn compute(&mut self, plan: &Plan<S>, needs: impl Iterator<Item = (NodeId, Parts)>, lanes: usize) {
        dispatch!(self.level, _ => self.compute_in_vectors(plan, needs, lanes));
    }

    #[inline(always)]
    fn compute_in_vectors(&mut self, plan: &Plan<S>, needs: impl Iterator<Item = (NodeId, Parts)>, lanes: usize) {
        let Self { blocks, values, fresh, .. } = self;
        for (node, within) in needs {
            let stale = within.without(fresh[node.index()]);
            if stale.is_empty() {
                continue;
            }
            fresh[node.index()].add(stale);
            let Node::Operation(instruction, a, b) = plan.nodes[node.index()] else { continue };
            let (before, from) = values.split_at_mut(node.index() * *blocks);
            let a = &before[a.index() * *blocks..][..*blocks];
            let b = &before[b.index() * *blocks..][..*blocks];
            let to = &mut from[..*blocks];
            compute_column::<S, M>(instruction, [a, b], to, stale, lanes);
        }
    }
}

/// Computes an instruction in some parts of the first `lanes` lanes. Dispatches once per instruction, so that the loops do not
/// test it again.
///
/// Short bodies are computed in whole blocks, also where one part is asked for: the other is either up to date, and stays as it
/// is, or is computed again before it is read.
#[inline(always)]
fn compute_column<S: Scalar, M: Maths<S>>(
    instruction: Instruction,
    [a, b]: [&[Block<S>]; 2],
    to: &mut [Block<S>],
    parts: Parts,
    lanes: usize,
) {
    macro_rules! loops {
        (short: $($short:ident)*; long: $($long:ident $many:ident)*) => {
            match instruction {
                $(Instruction::$short => {
                    for block in parts.blocks() {
                        for ((to, &a), &b) in to[block].iter_mut().zip(&a[block]).zip(&b[block]) {
                            *to = Instruction::$short.apply::<S, M>(a, b);
                        }
                    }
                })*
                $(Instruction::$long => {
                    for place in parts {
                        let to = part_mut(to, place);
                        *to = *part(a, place);
                        M::$many(to, (lanes - place * PART).min(PART));
                    }
                })*
            }
        };
    }
    loops!(
        short: Sub Add Mul Div NegateIfLess Abs Min Max Gate Fmod Quotient Sqrt;
        long: Cos cosines Sin sines Tan tangents Ln logarithms Exp exponentials Atan arctangents Tanh hyperbolic_tangents
    );
}
