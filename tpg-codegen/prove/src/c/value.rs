//! Values of expressions over the cells of a state.

use super::code::{CONSTANTS, Program};
use crate::code::{self, Computed, Expression, Found};
use crate::machine::{Cell, Cells, Value};
use crate::order::together;
use crate::term::{Bool, Node, Operator::Add, Terms, Width::W32, Word};
use std::collections::BTreeSet;

/// The cells where something is evaluated.
pub(super) struct Here<'a> {
    pub(super) program: &'a Program,
    pub(super) terms: &'a Terms,
    pub(super) cells: &'a Cells,
    /// They hold here
    pub(super) facts: &'a [Bool],
}

impl Here<'_> {
    pub(super) fn cell(&self, address: u64) -> Found<Value> {
        let address = u32::try_from(address).map_err(|_| "an address")?;
        match address.checked_sub(CONSTANTS) {
            None if address < self.program.cells => {
                self.cells.get(&Cell::Variable(address)).copied().ok_or("a value: it is not set on every way here")
            }
            None => Err("an address in bounds"),
            Some(place) => {
                let constant = self.program.constants.get(place as usize).ok_or("an address in bounds")?;
                Ok(Value::Word(self.terms.number(*constant)))
            }
        }
    }

    fn loaded(&self, address: Word) -> Found<Value> {
        let terms = self.terms;
        if let Some(number) = terms.number_of(address) {
            return self.cell(number);
        }
        // an element of a constant table
        if let Node::Apply(Add, W32, index, base) = terms.of_word(address)
            && let Some(base) = terms.number_of(base)
            && let Some(object) = u32::try_from(base).ok().and_then(|base| self.program.object(base))
            && object.start >= CONSTANTS
        {
            let range = (object.start - CONSTANTS) as usize..(object.end - CONSTANTS) as usize;
            let table = self.program.constants[range].into();
            let index = terms.apply(Add, W32, index, terms.number(base - u64::from(object.start)));
            self.bounded(index, object.end - object.start)?;
            return Ok(Value::Word(terms.element(&table, index)));
        }
        Err("an index that is a constant")
    }

    /// Proves that an index is below a length.
    fn bounded(&self, index: Word, length: u32) -> Found<()> {
        let terms = self.terms;
        if terms.largest(index) < u64::from(length) {
            return Ok(());
        }
        let within = terms.within(index, W32, &[(0, u64::from(length) - 1)]);
        let outside = terms.all(self.facts.iter().copied().chain([!within]));
        let found = together(terms, outside, [&[Terms::TRUE], &[Terms::TRUE]], CASES);
        if found.is_some_and(|found| found.pairs.is_empty()) { Ok(()) } else { Err("an index that is in bounds") }
    }

    pub(super) fn word(&self, expression: &Expression) -> Found<Word> {
        Ok(self.value(expression)?.bits(self.terms))
    }

    pub(super) fn value(&self, expression: &Expression) -> Found<Value> {
        code::value(self.terms, expression, self.facts, &|name, values| self.own(name, values))
    }

    /// The value of what depends on memory.
    fn own(&self, name: Computed, values: &[Value]) -> Found<Value> {
        let terms = self.terms;
        let first = values[0].bits(terms);
        match (name, values) {
            (Computed::Loaded(_), _) => code::loaded(terms, first, &|address| self.loaded(address)),
            (Computed::Bounded(length), _) => {
                self.bounded(first, length)?;
                let largest = terms.largest(first);
                let is_choice = largest < FEW && terms.numbers(first).is_none();
                Ok(Value::Word(if is_choice { each(terms, first, largest) } else { first }))
            }
            (Computed::Moved, &[_, offset]) => {
                let sum = terms.apply(Add, W32, first, offset.bits(terms));
                // constants are checked here, other indices where they are below a length
                if let (Some(from), Some(to)) = (terms.numbers(first), terms.numbers(sum)) {
                    let objects: BTreeSet<_> = (from.iter().chain(&to))
                        .map(|&address| Some(self.program.object(u32::try_from(address).ok()?)?.start))
                        .collect();
                    if objects.len() != 1 || objects.contains(&None) {
                        return Err("an address in bounds");
                    }
                }
                Ok(Value::Word(sum))
            }
            _ => Err("other operands"),
        }
    }
}

/// Cases of a proof that an index is in bounds.
const CASES: u64 = 1_000;
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
