//! Meanings of instructions.

use super::flow::FLAGS;
use super::{Cell, Here, Region};
use crate::elf::{Address, Part};
use crate::input::Result;
use crate::machine::Value;
use crate::term::{Bool, Operator, Terms, Width, Word};
use crate::thumb::{ALWAYS, Computed, Condition, Operand, Operation, PC};
use Operation::*;
use Operator::*;
use Value::{Float, Truth, Word as Bits};

const W: Width = Width::W32;

/// The test of flags for each condition that negates no other, in the order in which they are encoded: equal, carry, negative,
/// overflow, higher, at least, greater.
type Flags = [Option<Bool>; FLAG_COUNT as usize];

pub(super) const FLAG_COUNT: u8 = 7;

/// The number of the condition *carry*.
const CARRY: Condition = 2;

/// The flags after the second was subtracted from the first.
fn of_difference(terms: &Terms, a: Word, b: Word) -> Flags {
    let negative = terms.is_negative(W, terms.apply(Subtract, W, a, b));
    let below = |signed, a, b| terms.below(signed, W, a, b);
    let (higher, greater) = (below(false, b, a), below(true, b, a));
    let (carry, at_least) = (!below(false, a, b), !below(true, a, b));
    [Some(terms.same(W, a, b)), Some(carry), Some(negative), None, Some(higher), Some(at_least), Some(greater)]
}

/// The flags that a result alone gives: of zero and sign.
fn of_result(terms: &Terms, word: Word) -> Flags {
    let zero = terms.same(W, word, terms.number(0));
    [Some(zero), None, Some(terms.is_negative(W, word)), None, None, None, None]
}

impl Here<'_> {
    /// Returns whether a condition holds.
    pub(super) fn flag(&self, condition: Condition) -> Result<Bool> {
        if condition == ALWAYS {
            return Ok(Terms::TRUE);
        }
        match self.cells.get(&Cell::Flag(false, condition / 2)) {
            Some(&Truth(flag)) => {
                let clear = self.terms.same(W, flag, self.terms.number(0));
                Ok(if condition % 2 == 1 { clear } else { !clear })
            }
            _ => self.refuse(format_args!("the flags do not say condition {condition}")),
        }
    }

    fn set_flags(&mut self, floats: bool, flags: Flags) {
        for (number, flag) in (0..).zip(flags) {
            let value = flag.map(|flag| Truth(self.terms.word_of(flag)));
            self.set(Cell::Flag(floats, number), value);
        }
    }

    fn set(&mut self, cell: Cell, value: Option<Value>) {
        match value {
            Some(value) => self.cells.insert(cell, value),
            None => self.cells.remove(&cell),
        };
    }

    /// Executes an instruction that goes on with the next.
    pub(super) fn execute(&mut self) -> Result<()> {
        let terms = self.terms;
        match self.node.instruction.operation {
            Nop | If => Ok(()),
            Compute { name, flags, to, ref from, inverted } => {
                let mut values = Vec::new();
                for &operand in from {
                    values.push(self.operand(operand)?);
                }
                if let Some(last) = values.last_mut()
                    && inverted
                {
                    *last = Bits(self.with(Xor, self.bits(*last)?, 0xffff_ffff));
                }
                let value = self.computed(name, &values)?;
                if flags {
                    self.set_flags(false, self.flags(name, &values, value));
                }
                match to {
                    Some(PC) => self.refuse("a computed jump"),
                    Some(to) => {
                        self.cells.insert(Cell::Register(to), value);
                        Ok(())
                    }
                    None => Ok(()),
                }
            }
            Transfer { load, bytes, ref registers, place } => self.transfer(load, bytes, registers, place),
            Compare { left, right } => {
                let a = self.number(self.register(left)?)?;
                let b = match right {
                    Some(right) => self.number(self.register(right)?)?,
                    None => terms.constant(0.0),
                };
                let flags = [
                    terms.equal(a, b),
                    !terms.less(a, b),
                    terms.less(a, b),
                    terms.or(terms.is_nan(a), terms.is_nan(b)),
                    !terms.less_or_equal(a, b),
                    terms.less_or_equal(b, a),
                    terms.less(b, a),
                ];
                self.set_flags(true, flags.map(Some));
                Ok(())
            }
            ReadFlags => {
                for number in 0..FLAG_COUNT {
                    let flag = self.cells.get(&Cell::Flag(true, number)).copied();
                    self.set(Cell::Flag(false, number), flag);
                }
                Ok(())
            }
            _ => self.refuse("a branch"),
        }
    }

    fn operand(&self, operand: Operand) -> Result<Value> {
        match operand {
            Operand::Number(number) => Ok(Bits(self.terms.number(number.into()))),
            Operand::Register(register, _, 0) => self.register(register),
            Operand::Register(register, shift, amount) => {
                Ok(Bits(self.with(shift, self.word(register)?, amount.into())))
            }
        }
    }

    /// Returns a result.
    fn computed(&self, name: Computed, values: &[Value]) -> Result<Value> {
        let terms = self.terms;
        match (name, values) {
            (Computed::Same, &[value]) => Ok(value),
            (Computed::Integers(operator @ (ShiftLeft | ShiftRight | ShiftArithmetic)), &[a, b]) => {
                match terms.number_of(self.bits(b)?) {
                    Some(amount) => Ok(Bits(self.with(operator, self.bits(a)?, amount & 255))),
                    None => self.refuse("shifts by an unknown number"),
                }
            }
            (Computed::Integers(operator), &[a, b]) => Ok(Bits(terms.apply(operator, W, self.bits(a)?, self.bits(b)?))),
            (Computed::WithCarry, &[a, b]) => {
                let (sum, carry) = (terms.apply(Add, W, self.bits(a)?, self.bits(b)?), self.flag(CARRY)?);
                Ok(Bits(terms.apply(Add, W, sum, terms.word_of(carry))))
            }
            (Computed::OfProduct(operator), &[sum, a, b]) => {
                let product = terms.apply(Multiply, W, self.bits(a)?, self.bits(b)?);
                Ok(Bits(terms.apply(operator, W, self.bits(sum)?, product)))
            }
            (Computed::Extracted { low, width }, &[value]) => {
                let above = self.with(ShiftRight, self.bits(value)?, low.into());
                Ok(Bits(self.with(And, above, (1 << width) - 1)))
            }
            (Computed::Inserted { low, width }, &[into, from]) => {
                let mask = ((1u64 << width) - 1) << low;
                let kept = self.with(And, self.bits(into)?, !mask & 0xffff_ffff);
                let new = self.with(ShiftLeft, self.bits(from)?, low.into());
                Ok(Bits(terms.apply(Or, W, kept, self.with(And, new, mask))))
            }
            (Computed::Lower, &[number]) => match self.inserted(Part::Low)? {
                Some(address) => Ok(Bits(self.object.base(terms, Region::Half(address)))),
                None => Ok(number),
            },
            (Computed::Upper, &[lower, upper]) => match self.inserted(Part::High)? {
                Some(address) if lower == Bits(self.object.base(terms, Region::Half(address))) => {
                    Ok(self.section(address))
                }
                None => {
                    let lower = self.with(And, self.bits(lower)?, 0xffff);
                    Ok(Bits(terms.apply(Or, W, lower, self.with(ShiftLeft, self.bits(upper)?, 16))))
                }
                _ => self.refuse("half of another address"),
            },
            (Computed::Address, &[number]) => {
                let number = terms.number_of(self.bits(number)?).unwrap_or_default();
                Ok(self.section(self.node.address.at(number as u32)))
            }
            (Computed::Floats { operation, negated }, &[a, b]) => {
                let (a, b) = (self.number(a)?, self.number(b)?);
                Ok(Float(terms.arithmetic(operation, a, if negated { terms.negate(b) } else { b })))
            }
            (Computed::Product { negated, sum_negated }, &[ref sum @ .., a, b]) => {
                let product = terms.multiply(self.number(a)?, self.number(b)?);
                let product = if negated { terms.negate(product) } else { product };
                let [sum] = *sum else { return Ok(Float(product)) };
                let sum = self.number(sum)?;
                Ok(Float(terms.add(if sum_negated { terms.negate(sum) } else { sum }, product)))
            }
            (Computed::Negated, &[value]) => Ok(Float(terms.negate(self.number(value)?))),
            (Computed::Magnitude, &[value]) => Ok(Float(terms.magnitude(self.number(value)?))),
            (Computed::FromInteger { signed }, &[value]) => Ok(Float(terms.of_integer(signed, self.bits(value)?))),
            _ => self.refuse("other operands"),
        }
    }

    /// Returns the flags that a result sets, if they are read.
    fn flags(&self, name: Computed, values: &[Value], result: Value) -> Flags {
        let terms = self.terms;
        let is_read = self.node.next.iter().any(|&next| self.object.flow[next].live & FLAGS != 0);
        let numbers: Vec<_> = values.iter().chain([&result]).filter_map(|value| value.bits(terms)).collect();
        match (name, &numbers[..]) {
            _ if !is_read => [None; FLAG_COUNT as usize],
            (Computed::Integers(Subtract), &[a, b, _]) => of_difference(terms, a, b),
            (Computed::Integers(Add), &[a, b, sum]) => match terms.number_of(b) {
                // The flags of a sum with such a constant are those of the difference from its opposite.
                Some(b) if b != 0 && b != 0x8000_0000 => {
                    of_difference(terms, a, terms.number(b.wrapping_neg() & 0xffff_ffff))
                }
                _ => {
                    let mut flags = of_result(terms, sum);
                    flags[1] = Some(terms.below(false, W, sum, a));
                    flags
                }
            },
            (_, &[.., result]) => of_result(terms, result),
            _ => [None; FLAG_COUNT as usize],
        }
    }

    /// Returns the half of an address that the linker inserts.
    fn inserted(&self, part: Part) -> Result<Option<Address>> {
        match self.object.image.relocation(self.node.address) {
            None => Ok(None),
            Some(relocation) if relocation.part == part => match &relocation.target {
                Ok(address) => Ok(Some(*address)),
                Err(name) => self.refuse(format_args!("the address of {name}, which is elsewhere")),
            },
            Some(_) => self.refuse("a constant that the linker changes"),
        }
    }

    pub(super) fn section(&self, address: Address) -> Value {
        let base = self.object.base(self.terms, Region::Section(address.section));
        Bits(self.with(Add, base, address.offset.into()))
    }

    /// Applies an operator to a word and a constant.
    pub(super) fn with(&self, operator: Operator, word: Word, number: u64) -> Word {
        self.terms.apply(operator, W, word, self.terms.number(number))
    }
}
