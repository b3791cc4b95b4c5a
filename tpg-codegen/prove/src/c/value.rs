//! Values of expressions over the cells of a state.

use super::code::{CONSTANTS, Computed, Constant, Expression, Program};
use crate::machine::{Cells, Value};
use crate::term::word::computed;
use crate::term::{Bool, Float, Node, Operator::*, Terms, Width::*, Word};
use std::collections::BTreeSet;
use std::rc::Rc;

/// A value, or what it lacks.
pub(super) type Found<T> = Result<T, &'static str>;

/// The cells where something is evaluated.
pub(super) struct Here<'a> {
    pub(super) program: &'a Program,
    pub(super) terms: &'a Terms,
    pub(super) cells: &'a Cells<u32>,
    /// That indices are in bounds is known
    pub(super) defines: bool,
}

impl Here<'_> {
    pub(super) fn cell(&self, address: u64) -> Found<Value> {
        let address = u32::try_from(address).map_err(|_| "an address")?;
        match address.checked_sub(CONSTANTS) {
            None if address < self.program.cells => {
                self.cells.get(&address).copied().ok_or("a value: it is not set on every way here")
            }
            None => Err("an address in bounds"),
            Some(place) => match self.program.constants.get(place as usize) {
                Some(&Constant::Float(bits)) => Ok(Value::Float(self.terms.constant_bits(bits))),
                Some(&Constant::Number(number)) => Ok(Value::Word(self.terms.number(number))),
                None => Err("an address in bounds"),
            },
        }
    }

    pub(super) fn read_float(&self, address: u64) -> Found<Float> {
        self.cell(address)?.float(self.terms).ok_or("a float")
    }

    pub(super) fn read_word(&self, address: u64) -> Found<Word> {
        self.cell(address)?.bits(self.terms).ok_or("an integer")
    }

    /// The constant address of some cells of one variable.
    pub(super) fn range(&self, address: &Expression, count: u32) -> Found<u64> {
        let address = self.terms.number_of(self.word(address)?).and_then(|address| u32::try_from(address).ok());
        let first = address.ok_or("an address that is a constant")?;
        match self.program.object(first) {
            Some(object) if first + count <= object.end => Ok(first.into()),
            _ => Err("a copy in bounds"),
        }
    }

    fn loaded_float(&self, address: Word) -> Found<Float> {
        match self.terms.of_word(address) {
            Node::Number(number) => self.read_float(number),
            Node::WordIf(condition, a, b) => {
                let (a, b) = (self.loaded_float(a)?, self.loaded_float(b)?);
                Ok(self.terms.choose_float(condition, a, b))
            }
            _ => Err("an index that is a constant"),
        }
    }

    fn loaded_word(&self, address: Word) -> Found<Word> {
        let terms = self.terms;
        if let Some(numbers) = terms.numbers(address) {
            for number in numbers {
                self.read_word(number)?;
            }
            return Ok(terms.mapped(address, &mut |leaf| {
                self.read_word(terms.number_of(leaf).unwrap_or_default()).unwrap_or(leaf)
            }));
        }
        // an element of a constant table
        if let Node::Apply(Add, W32, index, base) = terms.of_word(address)
            && let Some(base) = terms.number_of(base)
            && let Some(object) = u32::try_from(base).ok().and_then(|base| self.program.object(base))
            && object.start >= CONSTANTS
        {
            let range = (object.start - CONSTANTS) as usize..(object.end - CONSTANTS) as usize;
            let table: Rc<[u64]> = (self.program.constants[range].iter())
                .map(|constant| match *constant {
                    Constant::Float(bits) => u64::from(bits),
                    Constant::Number(number) => number,
                })
                .collect();
            let index = terms.apply(Add, W32, index, terms.number(base - u64::from(object.start)));
            self.bounded(index, object.end - object.start, false)?;
            return Ok(terms.element(&table, index));
        }
        Err("an index that is a constant")
    }

    /// Checks that an index is below a length. One that a definition uses is, where that `asks` for it.
    fn bounded(&self, index: Word, length: u32, asks: bool) -> Found<()> {
        if largest(self.terms, index) < u64::from(length) || self.terms.is_granted(index, length) {
            return Ok(());
        }
        if self.defines && asks {
            self.terms.grant(index, length);
            return Ok(());
        }
        Err("an index that is in bounds")
    }

    fn float(&self, value: &Expression) -> Found<Float> {
        match self.value(value)? {
            Value::Float(float) => Ok(float),
            _ => Err("a float"),
        }
    }

    pub(super) fn word(&self, value: &Expression) -> Found<Word> {
        match self.value(value)? {
            Value::Word(word) => Ok(word),
            _ => Err("an integer"),
        }
    }

    pub(super) fn condition(&self, value: &Expression) -> Found<Bool> {
        Ok(!self.terms.same(W32, self.word(value)?, self.terms.number(0)))
    }

    pub(super) fn value(&self, value: &Expression) -> Found<Value> {
        let terms = self.terms;
        let (name, parts) = match value {
            Expression::Number(number) => return Ok(Value::Word(terms.number(*number))),
            Expression::Float(bits) => return Ok(Value::Float(terms.constant_bits(*bits))),
            Expression::Of(name, parts) => (*name, &parts[..]),
        };
        let truth = |condition| Value::Word(terms.word_of(condition));
        Ok(match (name, parts) {
            (Computed::LoadedFloat, [address]) => Value::Float(self.loaded_float(self.word(address)?)?),
            (Computed::LoadedWord, [address]) => Value::Word(self.loaded_word(self.word(address)?)?),
            (Computed::Arithmetic(operation), [a, b]) => {
                Value::Float(terms.arithmetic(operation, self.float(a)?, self.float(b)?))
            }
            (Computed::Negative, [a]) => Value::Float(terms.negate(self.float(a)?)),
            (Computed::Magnitude, [a]) => Value::Float(terms.magnitude(self.float(a)?)),
            (Computed::OfInteger(signed), [a]) => Value::Float(terms.of_integer(signed, self.word(a)?)),
            (Computed::If, [condition, a, b]) => match self.condition(condition)? {
                Terms::TRUE => self.value(a)?,
                Terms::FALSE => self.value(b)?,
                condition => {
                    Value::chosen(terms, condition, self.value(a)?, self.value(b)?).ok_or("one kind of value")?
                }
            },
            (Computed::Same(width), [a, b]) => truth(terms.same(width, self.word(a)?, self.word(b)?)),
            (Computed::Below(signed, width), [a, b]) => truth(terms.below(signed, width, self.word(a)?, self.word(b)?)),
            (Computed::Compared(relation), [a, b]) => truth(relation(terms, self.float(a)?, self.float(b)?)),
            (Computed::Apply(operator, width), [a, b]) => {
                let (a, b) = (self.word(a)?, self.word(b)?);
                match operator {
                    ShiftLeft | ShiftRight | ShiftArithmetic if largest(terms, b) >= u64::from(width.bits()) => {
                        return Err("a shift below the width");
                    }
                    _ => Value::Word(terms.apply(operator, width, a, b)),
                }
            }
            (Computed::Bounded(length), [a]) => {
                let a = self.word(a)?;
                self.bounded(a, length, true)?;
                let largest = largest(terms, a);
                let is_choice = largest < FEW && terms.numbers(a).is_none();
                Value::Word(if is_choice { each(terms, a, largest) } else { a })
            }
            (Computed::Moved, [address, offset]) => {
                let (address, offset) = (self.word(address)?, self.word(offset)?);
                let sum = terms.apply(Add, W32, address, offset);
                // constants are checked here, other indices where they are below a length
                if let (Some(from), Some(to)) = (terms.numbers(address), terms.numbers(sum)) {
                    let objects: BTreeSet<_> = (from.iter().chain(&to))
                        .map(|&address| Some(self.program.object(u32::try_from(address).ok()?)?.start))
                        .collect();
                    if objects.len() != 1 || objects.contains(&None) {
                        return Err("an address in bounds");
                    }
                }
                Value::Word(sum)
            }
            _ => return Err("other operands"),
        })
    }
}

/// Symbolic indices up to here become choices of constants.
const FEW: u64 = 4;

/// A word as a choice of the numbers up to the largest.
fn each(terms: &Terms, word: Word, largest: u64) -> Word {
    let mut result = terms.number(largest);
    for number in (0..largest).rev() {
        let number = terms.number(number);
        result = terms.choose_word(terms.same(W32, word, number), number, result);
    }
    result
}

/// A number that a word is at most.
fn largest(terms: &Terms, word: Word) -> u64 {
    match terms.of_word(word) {
        Node::Number(number) => number,
        Node::WordIf(_, a, b) => largest(terms, a).max(largest(terms, b)),
        Node::Apply(And, _, a, b) => largest(terms, a).min(largest(terms, b)),
        Node::Apply(ShiftRight, width, a, b) => match terms.number_of(b) {
            Some(by) => computed(ShiftRight, width, largest(terms, a), by),
            None => width.mask(),
        },
        Node::Apply(_, width, ..) => width.mask(),
        Node::Bits(_) => W32.mask(),
        _ => W64.mask(),
    }
}
