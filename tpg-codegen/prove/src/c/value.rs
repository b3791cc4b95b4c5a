//! Values and conditions over the cells of a state.

use super::code::{CONSTANTS, Condition, Constant, Scalar, Value};
use super::execute::{Cell, Code};
use crate::input::Result;
use crate::term::word::computed;
use crate::term::{Bool, Float, Node, Operator::*, Terms, Width::*, Word};
use Value::*;
use std::collections::BTreeSet;
use std::rc::Rc;

/// A place in the code, and the cells there.
pub(super) struct Here<'a> {
    pub(super) code: &'a Code,
    pub(super) terms: &'a Terms,
    pub(super) at: usize,
    pub(super) cells: &'a [Option<Cell>],
}

impl Here<'_> {
    fn missing<T>(&self, what: &str) -> Result<T> {
        Err(self.code.missing(self.at, what))
    }

    pub(super) fn cell(&self, address: u64) -> Result<Cell> {
        let Ok(address) = u32::try_from(address) else { return self.missing("an address") };
        let found = match address.checked_sub(CONSTANTS) {
            None => self.cells.get(address as usize).copied(),
            Some(place) => self.code.program.constants.get(place as usize).map(|constant| {
                Some(match *constant {
                    Constant::Float(bits) => Cell::Float(self.terms.constant_bits(bits)),
                    Constant::Number(number) => Cell::Word(self.terms.number(number)),
                })
            }),
        };
        match found {
            Some(Some(cell)) => Ok(cell),
            Some(None) => self.missing("a value: it is not set on every way here"),
            None => self.missing("an address in bounds"),
        }
    }

    pub(super) fn read_float(&self, address: u64) -> Result<Float> {
        Ok(match self.cell(address)? {
            Cell::Word(word) => self.terms.of_bits(word),
            Cell::Float(float) => float,
        })
    }

    pub(super) fn read_word(&self, address: u64) -> Result<Word> {
        Ok(match self.cell(address)? {
            Cell::Float(float) => self.terms.bits(float),
            Cell::Word(word) => word,
        })
    }

    /// The constant address of some cells of one variable.
    pub(super) fn range(&self, address: &Value, count: u32) -> Result<u64> {
        let word = self.word(address)?;
        let first = self.terms.number_of(word).and_then(|address| u32::try_from(address).ok());
        let Some(first) = first else { return self.missing("an address that is a constant") };
        match self.code.program.object(first) {
            Some(object) if first + count <= object.end => Ok(first.into()),
            _ => self.missing("a copy in bounds"),
        }
    }

    fn loaded_float(&self, address: Word) -> Result<Float> {
        match self.terms.of_word(address) {
            Node::Number(number) => self.read_float(number),
            Node::WordIf(condition, a, b) => {
                let (a, b) = (self.loaded_float(a)?, self.loaded_float(b)?);
                Ok(self.terms.choose_float(condition, a, b))
            }
            _ => self.missing("an index that is a constant"),
        }
    }

    fn loaded_word(&self, address: Word) -> Result<Word> {
        if let Some(numbers) = self.terms.numbers(address) {
            for number in numbers {
                self.read_word(number)?;
            }
            return Ok(self.terms.mapped(address, &mut |leaf| {
                let number = self.terms.number_of(leaf).unwrap_or_default();
                self.read_word(number).unwrap_or(leaf)
            }));
        }
        // an element of a constant table
        let terms = self.terms;
        if let Node::Apply(Add, W32, index, base) = terms.of_word(address)
            && let Some(base) = terms.number_of(base)
            && let Some(object) = u32::try_from(base).ok().and_then(|base| self.code.program.object(base))
            && object.start >= CONSTANTS
        {
            let range = (object.start - CONSTANTS) as usize..(object.end - CONSTANTS) as usize;
            let table: Rc<[u64]> = (self.code.program.constants[range].iter())
                .map(|constant| match *constant {
                    Constant::Float(bits) => u64::from(bits),
                    Constant::Number(number) => number,
                })
                .collect();
            let index = terms.apply(Add, W32, index, terms.number(base - u64::from(object.start)));
            let length = object.end - object.start;
            if largest(terms, index) >= u64::from(length) && !terms.is_granted(index, length) {
                return self.missing("an index that is in bounds");
            }
            return Ok(terms.element(&table, index));
        }
        self.missing("an index that is a constant")
    }

    pub(super) fn float(&self, value: &Value) -> Result<Float> {
        match self.value(value)? {
            Cell::Float(float) => Ok(float),
            Cell::Word(_) => self.missing("a float"),
        }
    }

    pub(super) fn word(&self, value: &Value) -> Result<Word> {
        match self.value(value)? {
            Cell::Word(word) => Ok(word),
            Cell::Float(_) => self.missing("an integer"),
        }
    }

    pub(super) fn value(&self, value: &Value) -> Result<Cell> {
        let terms = self.terms;
        Ok(match value {
            Load(address, Scalar::Float) => Cell::Float(self.loaded_float(self.word(address)?)?),
            Load(address, Scalar::Word) => Cell::Word(self.loaded_word(self.word(address)?)?),
            Value::Float(bits) => Cell::Float(terms.constant_bits(*bits)),
            Number(number) => Cell::Word(terms.number(*number)),
            Arithmetic(operation, a, b) => Cell::Float(terms.arithmetic(*operation, self.float(a)?, self.float(b)?)),
            Negative(a) => Cell::Float(terms.negate(self.float(a)?)),
            Magnitude(a) => Cell::Float(terms.magnitude(self.float(a)?)),
            OfInteger(signed, a) => Cell::Float(terms.of_integer(*signed, self.word(a)?)),
            OfCondition(condition) => Cell::Word(terms.word_of(self.condition(condition)?)),
            If(condition, a, b) => match self.condition(condition)? {
                Terms::TRUE => self.value(a)?,
                Terms::FALSE => self.value(b)?,
                condition => match chosen(terms, condition, self.value(a)?, self.value(b)?) {
                    Some(value) => value,
                    None => return self.missing("one kind of value"),
                },
            },
            Apply(operator, width, a, b) => {
                let (a, b) = (self.word(a)?, self.word(b)?);
                match operator {
                    Divide | Modulo if terms.numbers(b).is_none_or(|numbers| numbers.contains(&0)) => {
                        return self.missing("a divisor that is not 0");
                    }
                    ShiftLeft | ShiftRight | ShiftArithmetic if largest(terms, b) >= u64::from(width.bits()) => {
                        return self.missing("a shift below the width");
                    }
                    _ => Cell::Word(terms.apply(*operator, *width, a, b)),
                }
            }
            Below(a, length) => {
                let a = self.word(a)?;
                let largest = largest(terms, a);
                if largest >= u64::from(*length) {
                    if self.code.defines {
                        terms.grant(a, *length);
                    } else if !terms.is_granted(a, *length) {
                        return self.missing("an index that is in bounds");
                    }
                }
                let is_choice = largest < FEW && terms.numbers(a).is_none();
                Cell::Word(if is_choice { each(terms, a, largest) } else { a })
            }
            Moved(address, offset) => {
                let (address, offset) = (self.word(address)?, self.word(offset)?);
                let sum = terms.apply(Add, W32, address, offset);
                // constants are checked here, other indices where they are below a length
                if let (Some(from), Some(to)) = (terms.numbers(address), terms.numbers(sum)) {
                    let objects: BTreeSet<_> = (from.iter().chain(&to))
                        .map(|&address| Some(self.code.program.object(u32::try_from(address).ok()?)?.start))
                        .collect();
                    if objects.len() != 1 || objects.contains(&None) {
                        return self.missing("an address in bounds");
                    }
                }
                Cell::Word(sum)
            }
        })
    }

    pub(super) fn condition(&self, condition: &Condition) -> Result<Bool> {
        Ok(match condition {
            Condition::Same(width, a, b) => self.terms.same(*width, self.word(a)?, self.word(b)?),
            Condition::Below(signed, width, a, b) => self.terms.below(*signed, *width, self.word(a)?, self.word(b)?),
            Condition::Compared(relation, a, b) => relation(self.terms, self.float(a)?, self.float(b)?),
            Condition::Nan(a) => self.terms.is_nan(self.float(a)?),
            Condition::Logical(and, a, b) => {
                let a = self.condition(a)?;
                if a == Terms::known(!and) {
                    return Ok(a);
                }
                let b = self.condition(b)?;
                if *and { self.terms.and(a, b) } else { self.terms.or(a, b) }
            }
            Condition::Not(a) => !self.condition(a)?,
        })
    }
}

/// One of two values of one kind.
pub(super) fn chosen(terms: &Terms, condition: Bool, a: Cell, b: Cell) -> Option<Cell> {
    match (a, b) {
        (Cell::Float(a), Cell::Float(b)) => Some(Cell::Float(terms.choose_float(condition, a, b))),
        (Cell::Word(a), Cell::Word(b)) => Some(Cell::Word(terms.choose_word(condition, a, b))),
        _ => None,
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
