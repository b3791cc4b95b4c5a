//! Values and conditions over the cells of a state.

use super::code::{CONSTANTS, Condition, Constant, Scalar, Value};
use super::execute::{Cell, Code};
use crate::input::Missing;
use crate::term::word::computed;
use crate::term::{Bool, Float, Node, Operator, Terms, Width, Word};
use std::collections::BTreeSet;
use std::rc::Rc;

impl Code {
    pub(super) fn cell(&self, terms: &mut Terms, at: usize, cells: &[Cell], address: u64) -> Result<Cell, Missing> {
        let address = u32::try_from(address).map_err(|_| self.missing(at, "an address"))?;
        let found = if address >= CONSTANTS {
            match self.program.constants.get((address - CONSTANTS) as usize) {
                Some(&Constant::Float(bits)) => Some(Cell::Float(terms.constant_bits(bits))),
                Some(&Constant::Number(number)) => Some(Cell::Word(terms.number(number))),
                None => None,
            }
        } else {
            cells.get(address as usize).copied()
        };
        match found {
            Some(Cell::Undefined) => Err(self.missing(at, "a value: it is not set on every way here")),
            Some(cell) => Ok(cell),
            None => Err(self.missing(at, "an address in bounds")),
        }
    }

    pub(super) fn read_float(
        &self,
        terms: &mut Terms,
        at: usize,
        cells: &[Cell],
        address: u32,
    ) -> Result<Float, Missing> {
        match self.cell(terms, at, cells, u64::from(address))? {
            Cell::Word(word) => Ok(terms.of_bits(word)),
            Cell::Float(float) => Ok(float),
            Cell::Undefined => Err(self.missing(at, "a value")),
        }
    }

    pub(super) fn read_word(
        &self,
        terms: &mut Terms,
        at: usize,
        cells: &[Cell],
        address: u64,
    ) -> Result<Word, Missing> {
        match self.cell(terms, at, cells, address)? {
            Cell::Float(float) => Ok(terms.bits(float)),
            Cell::Word(word) => Ok(word),
            Cell::Undefined => Err(self.missing(at, "a value")),
        }
    }

    pub(super) fn float(&self, terms: &mut Terms, at: usize, cells: &[Cell], value: &Value) -> Result<Float, Missing> {
        Ok(match value {
            Value::Float(bits) => terms.constant_bits(*bits),
            Value::Load(address, Scalar::Float) => {
                let address = self.word(terms, at, cells, address)?;
                self.loaded_float(terms, at, cells, address)?
            }
            Value::Arithmetic(operation, a, b) => {
                let (a, b) = (self.float(terms, at, cells, a)?, self.float(terms, at, cells, b)?);
                terms.arithmetic(*operation, a, b)
            }
            Value::Negative(a) => {
                let a = self.float(terms, at, cells, a)?;
                terms.negate(a)
            }
            Value::Magnitude(a) => {
                let a = self.float(terms, at, cells, a)?;
                terms.magnitude(a)
            }
            Value::If(condition, a, b) => {
                let condition = self.condition(terms, at, cells, condition)?;
                if condition == Terms::TRUE {
                    return self.float(terms, at, cells, a);
                }
                if condition == Terms::FALSE {
                    return self.float(terms, at, cells, b);
                }
                let (a, b) = (self.float(terms, at, cells, a)?, self.float(terms, at, cells, b)?);
                terms.choose_float(condition, a, b)
            }
            Value::OfInteger(signed, a) => {
                let a = self.word(terms, at, cells, a)?;
                terms.of_integer(*signed, a)
            }
            _ => return Err(self.missing(at, "a float")),
        })
    }

    fn loaded_float(&self, terms: &mut Terms, at: usize, cells: &[Cell], address: Word) -> Result<Float, Missing> {
        match *terms.of_word(address) {
            Node::Number(number) => match self.cell(terms, at, cells, number)? {
                Cell::Float(float) => Ok(float),
                Cell::Word(word) => Ok(terms.of_bits(word)),
                Cell::Undefined => Err(self.missing(at, "a value")),
            },
            Node::WordIf(condition, a, b) => {
                let (a, b) = (self.loaded_float(terms, at, cells, a)?, self.loaded_float(terms, at, cells, b)?);
                Ok(terms.choose_float(condition, a, b))
            }
            _ => Err(self.missing(at, "an index that is a constant")),
        }
    }

    fn loaded_word(&self, terms: &mut Terms, at: usize, cells: &[Cell], address: Word) -> Result<Word, Missing> {
        if let Some(numbers) = terms.numbers(address) {
            for number in numbers {
                self.read_word(terms, at, cells, number)?;
            }
            return Ok(terms.mapped(address, &mut |terms, leaf| {
                let number = terms.number_of(leaf).unwrap_or_default();
                self.read_word(terms, at, cells, number).unwrap_or(leaf)
            }));
        }
        // an element of a constant table
        if let Node::Apply(Operator::Add, Width::W32, index, base) = *terms.of_word(address)
            && let Some(base) = terms.number_of(base)
            && let Some(object) = u32::try_from(base).ok().and_then(|base| self.object(base))
            && object.start >= CONSTANTS
        {
            let range = (object.start - CONSTANTS) as usize..(object.end - CONSTANTS) as usize;
            let table: Rc<[u64]> = (self.program.constants[range].iter())
                .map(|constant| match *constant {
                    Constant::Float(bits) => u64::from(bits),
                    Constant::Number(number) => number,
                })
                .collect();
            let offset = terms.number(base - u64::from(object.start));
            let index = terms.apply(Operator::Add, Width::W32, index, offset);
            let length = object.end - object.start;
            if largest(terms, index) >= u64::from(length) && !terms.is_granted(index, length) {
                return Err(self.missing(at, "an index that is in bounds"));
            }
            return Ok(terms.element(&table, index));
        }
        Err(self.missing(at, "an index that is a constant"))
    }

    pub(super) fn word(&self, terms: &mut Terms, at: usize, cells: &[Cell], value: &Value) -> Result<Word, Missing> {
        Ok(match value {
            Value::Number(number) => terms.number(*number),
            Value::Load(address, Scalar::Word(_)) => {
                let address = self.word(terms, at, cells, address)?;
                self.loaded_word(terms, at, cells, address)?
            }
            Value::Apply(operator, width, a, b) => {
                let (a, b) = (self.word(terms, at, cells, a)?, self.word(terms, at, cells, b)?);
                match operator {
                    Operator::Divide | Operator::Modulo
                        if terms.numbers(b).is_none_or(|numbers| numbers.contains(&0)) =>
                    {
                        return Err(self.missing(at, "a divisor that is not 0"));
                    }
                    Operator::ShiftLeft | Operator::ShiftRight | Operator::ShiftArithmetic
                        if largest(terms, b) >= u64::from(width.bits()) =>
                    {
                        return Err(self.missing(at, "a shift below the width"));
                    }
                    _ => terms.apply(*operator, *width, a, b),
                }
            }
            Value::If(condition, a, b) => {
                let condition = self.condition(terms, at, cells, condition)?;
                if condition == Terms::TRUE {
                    return self.word(terms, at, cells, a);
                }
                if condition == Terms::FALSE {
                    return self.word(terms, at, cells, b);
                }
                let (a, b) = (self.word(terms, at, cells, a)?, self.word(terms, at, cells, b)?);
                terms.choose_word(condition, a, b)
            }
            Value::OfCondition(condition) => {
                let condition = self.condition(terms, at, cells, condition)?;
                terms.word_of(condition)
            }
            Value::Below(a, length) => {
                let a = self.word(terms, at, cells, a)?;
                let largest = largest(terms, a);
                if largest >= u64::from(*length) {
                    if self.defines {
                        terms.grant(a, *length);
                    } else if !terms.is_granted(a, *length) {
                        return Err(self.missing(at, "an index that is in bounds"));
                    }
                }
                if largest < FEW && terms.numbers(a).is_none() { each(terms, a, largest) } else { a }
            }
            Value::Moved(address, offset) => {
                let (address, offset) = (self.word(terms, at, cells, address)?, self.word(terms, at, cells, offset)?);
                let sum = terms.apply(Operator::Add, Width::W32, address, offset);
                // constants are checked here, other indices where they are below a length
                if let (Some(from), Some(to)) = (terms.numbers(address), terms.numbers(sum)) {
                    let objects: BTreeSet<_> = (from.iter().chain(&to))
                        .map(|&address| Some(self.object(u32::try_from(address).ok()?)?.start))
                        .collect();
                    if objects.len() != 1 || objects.contains(&None) {
                        return Err(self.missing(at, "an address in bounds"));
                    }
                }
                sum
            }
            _ => return Err(self.missing(at, "an integer")),
        })
    }

    pub(super) fn condition(
        &self,
        terms: &mut Terms,
        at: usize,
        cells: &[Cell],
        condition: &Condition,
    ) -> Result<Bool, Missing> {
        let floats = |terms: &mut Terms, a: &Value, b: &Value| -> Result<(Float, Float), Missing> {
            Ok((self.float(terms, at, cells, a)?, self.float(terms, at, cells, b)?))
        };
        Ok(match condition {
            Condition::NonZero(width, a) => {
                let (a, zero) = (self.word(terms, at, cells, a)?, terms.number(0));
                !terms.same(*width, a, zero)
            }
            Condition::Same(width, a, b) => {
                let (a, b) = (self.word(terms, at, cells, a)?, self.word(terms, at, cells, b)?);
                terms.same(*width, a, b)
            }
            Condition::Below(signed, width, a, b) => {
                let (a, b) = (self.word(terms, at, cells, a)?, self.word(terms, at, cells, b)?);
                terms.below(*signed, *width, a, b)
            }
            Condition::Less(a, b) => {
                let (a, b) = floats(terms, a, b)?;
                terms.less(a, b)
            }
            Condition::LessOrEqual(a, b) => {
                let (a, b) = floats(terms, a, b)?;
                terms.less_or_equal(a, b)
            }
            Condition::Equal(a, b) => {
                let (a, b) = floats(terms, a, b)?;
                terms.equal(a, b)
            }
            Condition::Nan(a) => {
                let a = self.float(terms, at, cells, a)?;
                terms.is_nan(a)
            }
            Condition::And(a, b) | Condition::Or(a, b) => {
                let and = matches!(condition, Condition::And(..));
                let a = self.condition(terms, at, cells, a)?;
                // the second operand is not evaluated where the first decides
                if a == Terms::known(!and) {
                    return Ok(a);
                }
                let b = self.condition(terms, at, cells, b)?;
                if and { terms.and(a, b) } else { terms.or(a, b) }
            }
            Condition::Not(a) => !self.condition(terms, at, cells, a)?,
        })
    }
}

/// Symbolic indices up to here become choices of constants.
const FEW: u64 = 4;

/// A word as a choice of the numbers up to the largest.
fn each(terms: &mut Terms, word: Word, largest: u64) -> Word {
    let mut result = terms.number(largest);
    for number in (0..largest).rev() {
        let number = terms.number(number);
        let is = terms.same(Width::W32, word, number);
        result = terms.choose_word(is, number, result);
    }
    result
}

/// A number that a word is at most.
fn largest(terms: &mut Terms, word: Word) -> u64 {
    match *terms.of_word(word) {
        Node::Number(number) => number,
        Node::WordIf(_, a, b) => largest(terms, a).max(largest(terms, b)),
        Node::Apply(Operator::And, _, a, b) => largest(terms, a).min(largest(terms, b)),
        Node::Apply(Operator::ShiftRight, width, a, b) => match terms.number_of(b) {
            Some(by) => computed(Operator::ShiftRight, width, largest(terms, a), by),
            None => width.mask(),
        },
        Node::Apply(_, width, ..) => width.mask(),
        Node::Bits(_) => Width::W32.mask(),
        _ => Width::W64.mask(),
    }
}
