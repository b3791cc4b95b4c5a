//! Values and conditions over the cells of a state.

use super::code::{CONSTANTS, Condition, Constant, Scalar, Value};
use super::execute::{Cell, Code};
use crate::input::Missing;
use crate::term::word::computed;
use crate::term::{Bool, Float, Node, Operator::*, Terms, Width::*, Word};
use Value::*;
use std::collections::BTreeSet;
use std::rc::Rc;

/// A place in the code, and the cells there.
pub(super) struct Here<'a> {
    pub(super) code: &'a Code,
    pub(super) terms: &'a mut Terms,
    pub(super) at: usize,
    pub(super) cells: &'a [Option<Cell>],
}

impl Here<'_> {
    fn missing<T>(&self, what: &str) -> Result<T, Missing> {
        Err(self.code.missing(self.at, what))
    }

    pub(super) fn cell(&mut self, address: u64) -> Result<Cell, Missing> {
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

    pub(super) fn read_float(&mut self, address: u64) -> Result<Float, Missing> {
        Ok(match self.cell(address)? {
            Cell::Word(word) => self.terms.of_bits(word),
            Cell::Float(float) => float,
        })
    }

    pub(super) fn read_word(&mut self, address: u64) -> Result<Word, Missing> {
        Ok(match self.cell(address)? {
            Cell::Float(float) => self.terms.bits(float),
            Cell::Word(word) => word,
        })
    }

    /// The constant address of some cells of one variable.
    pub(super) fn range(&mut self, address: &Value, count: u32) -> Result<u64, Missing> {
        let word = self.word(address)?;
        let first = self.terms.number_of(word).and_then(|address| u32::try_from(address).ok());
        let Some(first) = first else { return self.missing("an address that is a constant") };
        match self.code.program.object(first) {
            Some(object) if first + count <= object.end => Ok(first.into()),
            _ => self.missing("a copy in bounds"),
        }
    }

    fn loaded_float(&mut self, address: Word) -> Result<Float, Missing> {
        match *self.terms.of_word(address) {
            Node::Number(number) => self.read_float(number),
            Node::WordIf(condition, a, b) => {
                let (a, b) = (self.loaded_float(a)?, self.loaded_float(b)?);
                Ok(self.terms.choose_float(condition, a, b))
            }
            _ => self.missing("an index that is a constant"),
        }
    }

    fn loaded_word(&mut self, address: Word) -> Result<Word, Missing> {
        if let Some(numbers) = self.terms.numbers(address) {
            for number in numbers {
                self.read_word(number)?;
            }
            let Self { code, at, cells, .. } = *self;
            return Ok(self.terms.mapped(address, &mut |terms, leaf| {
                let number = terms.number_of(leaf).unwrap_or_default();
                Here { code, terms, at, cells }.read_word(number).unwrap_or(leaf)
            }));
        }
        // an element of a constant table
        let terms = &mut *self.terms;
        if let Node::Apply(Add, W32, index, base) = *terms.of_word(address)
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
            let offset = terms.number(base - u64::from(object.start));
            let index = terms.apply(Add, W32, index, offset);
            let length = object.end - object.start;
            if largest(terms, index) >= u64::from(length) && !terms.is_granted(index, length) {
                return self.missing("an index that is in bounds");
            }
            return Ok(terms.element(&table, index));
        }
        self.missing("an index that is a constant")
    }

    pub(super) fn float(&mut self, value: &Value) -> Result<Float, Missing> {
        match self.value(value)? {
            Cell::Float(float) => Ok(float),
            Cell::Word(_) => self.missing("a float"),
        }
    }

    pub(super) fn word(&mut self, value: &Value) -> Result<Word, Missing> {
        match self.value(value)? {
            Cell::Word(word) => Ok(word),
            Cell::Float(_) => self.missing("an integer"),
        }
    }

    pub(super) fn value(&mut self, value: &Value) -> Result<Cell, Missing> {
        let word = match value {
            Load(address, Scalar::Float) => {
                let address = self.word(address)?;
                return self.loaded_float(address).map(Cell::Float);
            }
            Value::Float(bits) => return Ok(Cell::Float(self.terms.constant_bits(*bits))),
            Arithmetic(operation, a, b) => {
                let (a, b) = (self.float(a)?, self.float(b)?);
                return Ok(Cell::Float(self.terms.arithmetic(*operation, a, b)));
            }
            Negative(a) => {
                let a = self.float(a)?;
                return Ok(Cell::Float(self.terms.negate(a)));
            }
            Magnitude(a) => {
                let a = self.float(a)?;
                return Ok(Cell::Float(self.terms.magnitude(a)));
            }
            OfInteger(signed, a) => {
                let a = self.word(a)?;
                return Ok(Cell::Float(self.terms.of_integer(*signed, a)));
            }
            If(condition, a, b) => {
                let condition = self.condition(condition)?;
                if condition == Terms::TRUE {
                    return self.value(a);
                }
                if condition == Terms::FALSE {
                    return self.value(b);
                }
                let (a, b) = (self.value(a)?, self.value(b)?);
                return chosen(self.terms, condition, a, b).map_or_else(|| self.missing("one kind of value"), Ok);
            }
            Load(address, Scalar::Word) => {
                let address = self.word(address)?;
                self.loaded_word(address)?
            }
            Number(number) => self.terms.number(*number),
            Apply(operator, width, a, b) => {
                let (a, b) = (self.word(a)?, self.word(b)?);
                match operator {
                    Divide | Modulo if self.terms.numbers(b).is_none_or(|numbers| numbers.contains(&0)) => {
                        return self.missing("a divisor that is not 0");
                    }
                    ShiftLeft | ShiftRight | ShiftArithmetic if largest(self.terms, b) >= u64::from(width.bits()) => {
                        return self.missing("a shift below the width");
                    }
                    _ => self.terms.apply(*operator, *width, a, b),
                }
            }
            OfCondition(condition) => {
                let condition = self.condition(condition)?;
                self.terms.word_of(condition)
            }
            Below(a, length) => {
                let a = self.word(a)?;
                let largest = largest(self.terms, a);
                if largest >= u64::from(*length) {
                    if self.code.defines {
                        self.terms.grant(a, *length);
                    } else if !self.terms.is_granted(a, *length) {
                        return self.missing("an index that is in bounds");
                    }
                }
                if largest < FEW && self.terms.numbers(a).is_none() { each(self.terms, a, largest) } else { a }
            }
            Moved(address, offset) => {
                let (address, offset) = (self.word(address)?, self.word(offset)?);
                let sum = self.terms.apply(Add, W32, address, offset);
                // constants are checked here, other indices where they are below a length
                if let (Some(from), Some(to)) = (self.terms.numbers(address), self.terms.numbers(sum)) {
                    let objects: BTreeSet<_> = (from.iter().chain(&to))
                        .map(|&address| Some(self.code.program.object(u32::try_from(address).ok()?)?.start))
                        .collect();
                    if objects.len() != 1 || objects.contains(&None) {
                        return self.missing("an address in bounds");
                    }
                }
                sum
            }
        };
        Ok(Cell::Word(word))
    }

    pub(super) fn condition(&mut self, condition: &Condition) -> Result<Bool, Missing> {
        Ok(match condition {
            Condition::Same(width, a, b) => {
                let (a, b) = (self.word(a)?, self.word(b)?);
                self.terms.same(*width, a, b)
            }
            Condition::Below(signed, width, a, b) => {
                let (a, b) = (self.word(a)?, self.word(b)?);
                self.terms.below(*signed, *width, a, b)
            }
            Condition::Compared(relation, a, b) => {
                let (a, b) = (self.float(a)?, self.float(b)?);
                relation(self.terms, a, b)
            }
            Condition::Nan(a) => {
                let a = self.float(a)?;
                self.terms.is_nan(a)
            }
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
pub(super) fn chosen(terms: &mut Terms, condition: Bool, a: Cell, b: Cell) -> Option<Cell> {
    match (a, b) {
        (Cell::Float(a), Cell::Float(b)) => Some(Cell::Float(terms.choose_float(condition, a, b))),
        (Cell::Word(a), Cell::Word(b)) => Some(Cell::Word(terms.choose_word(condition, a, b))),
        _ => None,
    }
}

/// Symbolic indices up to here become choices of constants.
const FEW: u64 = 4;

/// A word as a choice of the numbers up to the largest.
fn each(terms: &mut Terms, word: Word, largest: u64) -> Word {
    let mut result = terms.number(largest);
    for number in (0..largest).rev() {
        let number = terms.number(number);
        let is = terms.same(W32, word, number);
        result = terms.choose_word(is, number, result);
    }
    result
}

/// A number that a word is at most.
fn largest(terms: &mut Terms, word: Word) -> u64 {
    match *terms.of_word(word) {
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
