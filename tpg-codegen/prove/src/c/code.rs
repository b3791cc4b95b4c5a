//! Functions as a flat list of operations, with every call inlined.

use crate::term::{Arithmetic, Bool, Float, Operator, Terms, Width};
use std::collections::BTreeMap;

/// A value without side effects. Words of 32 bits hold narrower integers as C extends them; conditions are 1 or 0.
#[derive(Clone, Debug)]
pub(super) enum Expression {
    Number(u64),
    Float(u32),
    Of(Computed, Vec<Expression>),
}

/// A computation on values.
#[derive(Clone, Copy, Debug)]
pub(super) enum Computed {
    LoadedFloat,
    LoadedWord,
    Apply(Operator, Width),
    Arithmetic(Arithmetic),
    Negative,
    Magnitude,
    OfInteger(bool),
    /// The second where the first is not 0, else the third
    If,
    Same(Width),
    Below(bool, Width),
    /// A relation of floats
    Compared(fn(&Terms, Float, Float) -> Bool),
    /// A number that must be below a length
    Bounded(u32),
    /// An address moved by cells; both must be in one object
    Moved,
}

/// Makes an expression.
pub(super) fn of<const N: usize>(computed: Computed, parts: [Expression; N]) -> Expression {
    Expression::Of(computed, parts.into())
}

impl std::ops::Not for Expression {
    type Output = Self;

    fn not(self) -> Self {
        of(Computed::Same(Width::W32), [self, Self::Number(0)])
    }
}

/// An operation.
#[derive(Clone, Debug)]
pub(super) enum Operation {
    Set(Expression, Expression),
    /// Copies so many cells
    Copy(Expression, Expression, u32),
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

    pub(super) fn is_array(&self, address: u32) -> bool {
        self.object(address).is_some_and(|object| object.array)
    }
}
