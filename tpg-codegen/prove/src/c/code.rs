//! Functions as a flat list of operations, with every call inlined.

use crate::code::Expression;
use std::collections::BTreeMap;

/// An operation.
#[derive(Clone, Debug)]
pub(super) enum Operation {
    /// Sets what is at an address; with `true`, a float
    Set(Expression, Expression, bool),
    /// A scope ends
    Leave(usize),
    /// Goes on behind if the condition holds, else there
    Branch(Expression, usize),
    /// Goes there, out of some scopes
    Jump(usize, Vec<usize>),
    /// The whole function returns
    Return,
}

/// Memory that one variable occupies.
#[derive(Clone, Copy, Debug)]
pub(super) struct Object {
    pub(super) start: u32,
    pub(super) end: u32,
    pub(super) aggregate: bool,
}

/// Where constants begin.
pub(super) const CONSTANTS: u32 = 0x4000_0000;

/// The function.
#[derive(Debug, Default)]
pub(super) struct Program {
    pub(super) operations: Vec<(u32, Operation)>,
    /// Places that are good to cut at; with `true`, also where floats are alive
    pub(super) heads: BTreeMap<usize, bool>,
    /// Ranges of cells
    pub(super) scopes: Vec<(u32, u32)>,
    /// Sorted by their starts
    pub(super) objects: Vec<Object>,
    /// Numbers, and floats by their bits
    pub(super) constants: Vec<u64>,
    pub(super) cells: u32,
    /// The cells of the state, then those of the memory
    pub(super) inputs: Vec<u32>,
    /// The cells of the outputs and of the next memory, or else the result
    pub(super) answers: Vec<u32>,
}

impl Program {
    pub(super) fn object(&self, address: u32) -> Option<Object> {
        let after = self.objects.partition_point(|object| object.start <= address);
        let object = *self.objects.get(after.checked_sub(1)?)?;
        (address < object.end).then_some(object)
    }

    pub(super) fn is_aggregate(&self, address: u32) -> bool {
        self.object(address).is_some_and(|object| object.aggregate)
    }
}
