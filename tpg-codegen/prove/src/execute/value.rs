//! Values of registers and memory, and conditions of flags.

use crate::elf::Address;
use crate::term::{Bool, Float, Node, Operator, Terms, Width, Word, decided};
use crate::thumb::{Condition, Register};
use Flags::*;
use Value::*;
use std::collections::HashMap;
use std::rc::Rc;

/// A part of memory that no other overlaps.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub(super) enum Region {
    /// The values of the state, which are only read.
    State,
    /// The values of the memory.
    Memory,
    /// The outputs.
    Outputs,
    /// The stack; offset 0 is where the function begins with it.
    Stack,
    /// The address behind a call; its offset is the call's place.
    Return,
    /// A section of the image.
    Section(usize),
}

/// A place in memory, and its bytes; cells do not overlap.
pub(super) type Cell = (Region, u32, u8);

/// 32 bits.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub(super) enum Value {
    Word(Word),
    Float(Float),
    Pointer(Region, Word),
    /// The lower half of an address, before its upper half is set.
    Half(Address),
    /// What a register held when the function began.
    Initial(Register),
}

/// The last comparison that set flags.
#[derive(Clone, Debug, PartialEq, Eq, Hash)]
pub(super) enum Flags {
    Unknown,
    /// Two floats were compared.
    Floats(Float, Float),
    /// The second was subtracted from the first.
    Difference(Word, Word),
    /// Two words were added.
    Sum(Word, Word),
    /// A result set the flags of sign and zero; carry and overflow are unknown.
    Result(Word),
    /// The first where the condition holds, else the second.
    If(Bool, Rc<[Flags; 2]>),
}

const W: Width = Width::W32;

impl Flags {
    /// Returns the condition as a truth value; none if the flags do not give it.
    pub(super) fn condition(&self, terms: &Terms, condition: Condition) -> Option<Bool> {
        use Condition::*;
        let negated = match condition {
            Ne => Eq,
            Cc => Cs,
            Pl => Mi,
            Vc => Vs,
            Ls => Hi,
            Lt => Ge,
            Le => Gt,
            Always => return Some(Terms::TRUE),
            _ => return self.positive(terms, condition),
        };
        Some(!self.positive(terms, negated)?)
    }

    fn positive(&self, terms: &Terms, condition: Condition) -> Option<Bool> {
        use Condition::*;
        Some(match *self {
            Unknown => return None,
            Flags::If(choice, ref flags) => {
                let [a, b] = &**flags;
                let (a, b) = (a.positive(terms, condition)?, b.positive(terms, condition)?);
                terms.choose(choice, a, b)
            }
            Floats(a, b) => match condition {
                Eq => terms.equal(a, b),
                Cs => !terms.less(a, b),
                Mi => terms.less(a, b),
                Vs => terms.or(terms.is_nan(a), terms.is_nan(b)),
                Hi => !terms.less_or_equal(a, b),
                Ge => terms.less_or_equal(b, a),
                Gt => terms.less(b, a),
                _ => return None,
            },
            Difference(a, b) => match condition {
                Eq => terms.same(W, a, b),
                Cs => !terms.below(false, W, a, b),
                Mi => terms.is_negative(W, terms.apply(Operator::Subtract, W, a, b)),
                Hi => terms.below(false, W, b, a),
                Ge => !terms.below(true, W, a, b),
                Gt => terms.below(true, W, b, a),
                _ => return None,
            },
            Sum(a, b) => {
                let sum = terms.apply(Operator::Add, W, a, b);
                match condition {
                    Cs => terms.below(false, W, sum, a),
                    _ => return Result(sum).positive(terms, condition),
                }
            }
            Result(word) => match condition {
                Eq => terms.same(W, word, terms.number(0)),
                Mi => terms.is_negative(W, word),
                _ => return None,
            },
        })
    }

    /// Returns flags that are these where the condition holds, else others.
    pub(super) fn merged(condition: Bool, a: &Self, b: &Self) -> Self {
        if a == b {
            return a.clone();
        }
        Self::If(condition, Rc::new([a.clone(), b.clone()]))
    }

    /// Returns the flags without the choices that are decided where the conditions hold.
    pub(super) fn restricted(&self, facts: &[Bool]) -> &Self {
        match self {
            Self::If(condition, flags) => match decided(facts, *condition) {
                Some(holds) => flags[usize::from(!holds)].restricted(facts),
                None => self,
            },
            _ => self,
        }
    }
}

/// Something whose bits are not known.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub(super) enum Name {
    Region(Region),
    Half(Address),
    Register(Register),
}

/// What stands for bits that are not known: of addresses, and of what registers held before.
#[derive(Debug, Default)]
pub(super) struct Unknowns(HashMap<Name, Float>, HashMap<Float, Region>);

impl Unknowns {
    /// Returns the bits of any value; those of an address are a sum.
    pub(super) fn word(&mut self, terms: &Terms, value: Value) -> Word {
        let (name, offset) = match value {
            Value::Word(word) => return word,
            Value::Float(float) => return terms.bits(float),
            Pointer(region, offset) => (Name::Region(region), Some(offset)),
            Half(address) => (Name::Half(address), None),
            Initial(register) => (Name::Register(register), None),
        };
        let float = *self.0.entry(name).or_insert_with(|| terms.unknown());
        if let Name::Region(region) = name {
            self.1.insert(float, region);
        }
        let base = terms.bits(float);
        offset.map_or(base, |offset| terms.apply(Operator::Add, W, base, offset))
    }

    /// Returns a value as an address, if its bits are those of one.
    pub(super) fn pointer(&self, terms: &Terms, value: Value) -> Value {
        let Value::Word(word) = value else { return value };
        let (base, offset) = match terms.of_word(word) {
            Node::Apply(Operator::Add, W, base, offset) => (base, offset),
            _ => (word, terms.number(0)),
        };
        let Node::Bits(float) = terms.of_word(base) else { return value };
        self.1.get(&float).map_or(value, |&region| Pointer(region, offset))
    }

    /// Returns a value that is the first where the condition holds, else the second.
    pub(super) fn merged(&mut self, terms: &Terms, condition: Bool, a: Value, b: Value) -> Value {
        match (a, b) {
            (a, b) if a == b => a,
            (Pointer(x, a), Pointer(y, b)) if x == y => Pointer(x, terms.choose_word(condition, a, b)),
            (Value::Float(a), Value::Float(b)) => Value::Float(terms.choose_float(condition, a, b)),
            _ => Value::Word(terms.choose_word(condition, self.word(terms, a), self.word(terms, b))),
        }
    }
}

/// Returns the bits of a number.
pub(super) fn word(terms: &Terms, value: Value) -> Option<Word> {
    match value {
        Value::Word(word) => Some(word),
        Value::Float(float) => Some(terms.bits(float)),
        _ => None,
    }
}

pub(super) fn restricted(terms: &Terms, value: Value, facts: &[Bool]) -> Value {
    match value {
        Value::Float(float) => Value::Float(terms.given_float(float, facts)),
        Value::Word(word) => Value::Word(terms.given_word(word, facts)),
        Pointer(region, offset) => Pointer(region, terms.given_word(offset, facts)),
        _ => value,
    }
}
