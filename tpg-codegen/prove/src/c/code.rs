//! Functions as a flat list of operations, with every call inlined.

use crate::term::{Arithmetic, Bool, Float, Operator, Terms, Width};
use std::collections::BTreeMap;

/// What a cell is read as.
#[derive(Clone, Copy, Debug)]
pub(super) enum Scalar {
    Float,
    Word,
}

/// A value without side effects. Words of 32 bits hold narrower integers as C extends them.
#[derive(Clone, Debug)]
pub(super) enum Value {
    Number(u64),
    Float(u32),
    Load(Box<Value>, Scalar),
    Apply(Operator, Width, Box<Value>, Box<Value>),
    Arithmetic(Arithmetic, Box<Value>, Box<Value>),
    Negative(Box<Value>),
    Magnitude(Box<Value>),
    If(Box<Condition>, Box<Value>, Box<Value>),
    OfCondition(Box<Condition>),
    OfInteger(bool, Box<Value>),
    /// A number that must be below a length
    Below(Box<Value>, u32),
    /// An address moved by cells; both must be in one object
    Moved(Box<Value>, Box<Value>),
}

#[derive(Clone, Debug)]
pub(super) enum Condition {
    Same(Width, Value, Value),
    Below(bool, Width, Value, Value),
    /// A relation of floats
    Compared(fn(&Terms, Float, Float) -> Bool, Value, Value),
    Nan(Value),
    /// Both hold, or one of them; the second is not evaluated where the first decides
    Logical(bool, Box<Condition>, Box<Condition>),
    Not(Box<Condition>),
}

impl std::ops::Not for Condition {
    type Output = Self;

    fn not(self) -> Self {
        Self::Not(Box::new(self))
    }
}

/// An operation.
#[derive(Clone, Debug)]
pub(super) enum Operation {
    Set(Value, Value),
    /// Copies so many cells
    Copy(Value, Value, u32),
    /// A scope ends
    Leave(usize),
    /// Goes on behind if the condition holds, else there
    Branch(Condition, usize),
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
    pub(super) array: bool,
}

/// Where constants begin.
pub(super) const CONSTANTS: u32 = 0x4000_0000;

/// A constant cell.
#[derive(Clone, Copy, Debug)]
pub(super) enum Constant {
    Float(u32),
    Number(u64),
}

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
    pub(super) constants: Vec<Constant>,
    pub(super) cells: u32,
    /// Where the state is, and the answer with the next memory, if the function has none of its own
    pub(super) state: u32,
    pub(super) memory: Option<u32>,
    pub(super) action: Option<u32>,
    /// The cell of the result
    pub(super) result: Option<u32>,
}

impl Program {
    pub(super) fn object(&self, address: u32) -> Option<Object> {
        let after = self.objects.partition_point(|object| object.start <= address);
        let object = *self.objects.get(after.checked_sub(1)?)?;
        (address < object.end).then_some(object)
    }

    pub(super) fn is_array(&self, address: u32) -> bool {
        self.object(address).is_some_and(|object| object.array)
    }
}
