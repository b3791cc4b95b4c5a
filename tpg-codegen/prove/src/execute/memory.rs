//! Registers, loads and stores.

use super::value::{Region, Value, word};
use super::{Here, Object, Point};
use crate::elf::{Address, Part};
use crate::input::{Missing, Result};
use crate::machine::Answer;
use crate::term::{Float, Operator::*, Terms, Width as Bits, Word};
use crate::thumb::{Index, Instruction, Offset, PC, Place, Register, SP, WORD, Width};
use Region::*;
use Value::*;

impl Object {
    pub(super) fn here<'a>(&'a self, terms: &'a Terms, point: &'a mut Point, at: &'a Instruction) -> Here<'a> {
        Here { object: self, terms, point, at }
    }

    /// Returns the place of an address in the section of the code.
    pub(super) fn code(&self, point: &Point, address: u32) -> Address {
        let function = point.function;
        let offset = address.wrapping_sub(self.image.absolute(function)).wrapping_add(function.offset);
        Address { section: function.section, offset }
    }
}

impl Here<'_> {
    /// Says why the instruction is refused.
    pub(super) fn refusal(&self, what: impl std::fmt::Display) -> Missing {
        Missing::new(format!("{:#x}", self.at.address), format!("{:?}: {what}", self.at.operation))
    }

    pub(super) fn refuse<T>(&self, what: impl std::fmt::Display) -> Result<T> {
        Err(self.refusal(what))
    }

    /// Returns a register; what is unknown is refused.
    pub(super) fn register(&self, register: Register) -> Result<Value> {
        let value = self.point.registers[usize::from(register)];
        value.ok_or_else(|| self.refusal(format_args!("register {register} holds nothing known")))
    }

    pub(super) fn word(&self, register: Register) -> Result<Word> {
        let value = self.register(register)?;
        word(self.terms, value).ok_or_else(|| self.refusal(format_args!("register {register} is no number")))
    }

    pub(super) fn float(&self, register: Register) -> Result<Float> {
        match self.register(register)? {
            Value::Float(float) => Ok(float),
            _ => self.word(register).map(|word| self.terms.of_bits(word)),
        }
    }

    fn moved(&self, base: Value, distance: Word) -> Result<Value> {
        moved(self.terms, base, distance).ok_or_else(|| self.refusal("not an address"))
    }

    /// Loads or stores registers.
    pub(super) fn transfer(&mut self, load: bool, width: Width, registers: &[Register], place: Place) -> Result<()> {
        let (accessed, written) = self.addresses(place)?;
        let mut loaded = Vec::new();
        for (number, &register) in registers.iter().enumerate() {
            let address = self.moved(accessed, self.terms.number(4 * number as u64))?;
            if load {
                loaded.push((register, self.load(address, width)?));
            } else {
                let stored = self.register(register)?;
                self.store(address, width, stored)?;
            }
        }
        for (register, value) in written.map(|written| (place.base, written)).into_iter().chain(loaded) {
            self.point.registers[usize::from(register)] = Some(value);
        }
        Ok(())
    }

    /// Returns the address that is accessed, and the one that is written back.
    pub(super) fn addresses(&self, place: Place) -> Result<(Value, Option<Value>)> {
        let unknowns = &self.object.unknowns;
        let base = if place.base == PC {
            let code = self.object.code(self.point, self.at.address.wrapping_add(4) & !3);
            Pointer(Section(code.section), self.terms.number(code.offset.into()))
        } else {
            unknowns.pointer(self.terms, self.register(place.base)?)
        };
        let (base, offset) = match place.offset {
            Offset::Number(number) => (base, self.terms.number(u64::from(number as u32))),
            Offset::Register(register, shift) => {
                let value = self.register(register)?;
                match (unknowns.pointer(self.terms, value), base) {
                    // The address is the register that is added.
                    (value @ Pointer(..), Word(word)) if shift == 0 => (value, word),
                    _ => (base, self.with(ShiftLeft, self.word(register)?, shift.into())),
                }
            }
        };
        let sum = self.moved(base, offset)?;
        Ok(match place.index {
            Index::Offset => (sum, None),
            Index::Before => (sum, Some(sum)),
            Index::After => (base, Some(sum)),
        })
    }

    fn load(&self, address: Value, width: Width) -> Result<Value> {
        let (region, offset) = match address {
            Pointer(region, offset) => (region, offset),
            // A number is an address of a linked image.
            Word(word) => {
                let number = self.terms.number_of(word);
                let Some(located) = number.and_then(|number| self.object.image.locate(number as u32)) else {
                    return self.refuse("loads from a number");
                };
                (Section(located.section), self.terms.number(located.offset.into()))
            }
            _ => return self.refuse("loads from no address"),
        };
        if let Some(offset) = self.terms.number_of(offset) {
            return self.load_at(region, offset as u32, width).ok_or_else(|| {
                let offset = offset as u32 as i32;
                self.refusal(format_args!("loads from {region:?}, offset {offset}, which is not known"))
            });
        }
        // One of a few constants.
        let mut failed = false;
        let value = self.terms.mapped(offset, &mut |offset| {
            let value = self.terms.number_of(offset).and_then(|offset| {
                let value = self.load_at(region, offset as u32, width)?;
                word(self.terms, value)
            });
            failed |= value.is_none();
            value.unwrap_or(offset)
        });
        if failed { self.refuse("loads from an unknown address") } else { Ok(Word(value)) }
    }

    fn load_at(&self, region: Region, offset: u32, width: Width) -> Option<Value> {
        let is_word = width.bytes == 4 && offset.is_multiple_of(4);
        let unused = 32 - 8 * u32::from(width.bytes);
        let Object { image, interface, .. } = self.object;
        match region {
            Section(section) => {
                let address = Address { section, offset };
                if image.is_relocated(address, width.bytes.into()) {
                    let target = if is_word { image.pointer(address)? } else { return None };
                    return Some(Pointer(Section(target.section), self.terms.number(target.offset.into())));
                }
                let number = image.number(address, width.bytes)?;
                let number = if width.signed { ((number << unused) as i32 >> unused) as u32 } else { number };
                Some(Word(self.terms.number(number.into())))
            }
            State => {
                let known = is_word && offset / 4 < interface.state_length();
                known.then(|| Value::Float(self.terms.source(offset / 4)))
            }
            _ => match *self.point.memory.get(&(region, offset, width.bytes))? {
                Word(word) if width.signed => {
                    Some(Word(self.with(ShiftArithmetic, self.with(ShiftLeft, word, unused.into()), unused.into())))
                }
                value => Some(value),
            },
        }
    }

    fn store(&mut self, address: Value, width: Width, mut value: Value) -> Result<()> {
        let Pointer(region, offset) = address else { return self.refuse("stores to no known address") };
        let Some(offset) = self.terms.number_of(offset) else { return self.refuse("stores to an unknown address") };
        let offset = offset as u32;
        let length = match region {
            Memory => self.object.interface.memory.len(),
            Outputs => self.object.interface.outputs.len(),
            // Below the place where the function began with it.
            Stack if (offset as i32) < 0 => usize::MAX,
            _ => 0,
        };
        // Parts of words are stored on the stack only.
        let bytes = u32::from(width.bytes);
        let aligned = offset.is_multiple_of(bytes) && (bytes == 4 || region == Stack);
        if !aligned || (region != Stack && (offset / 4) as usize >= length) || length == 0 {
            return self.refuse(format_args!("stores to {region:?}, offset {}", offset as i32));
        }
        if bytes < 4 {
            let Some(word) = word(self.terms, value) else { return self.refuse("stores a part of no number") };
            value = Word(self.with(And, word, (1 << (8 * bytes)) - 1));
        }
        let last = |offset: u32, bytes: u32| offset.wrapping_add(bytes - 1);
        self.point.memory.retain(|&(other, at, size), _| {
            other != region || last(at, size.into()) < offset || last(offset, bytes) < at
        });
        self.point.memory.insert((region, offset, width.bytes), value);
        Ok(())
    }

    /// Checks the calling convention at the end, and returns the answer.
    pub(super) fn answer(&self) -> Result<Answer> {
        let missing = |what: String| Err(Missing::new(format!("{:#x}", self.at.address), what));
        for register in super::flow::preserved() {
            let expected = if register == SP { Pointer(Stack, self.terms.number(0)) } else { Initial(register) };
            if self.point.registers[usize::from(register)] != Some(expected) {
                return missing(format!("register {register} is not what it was before"));
            }
        }
        let interface = &self.object.interface;
        if interface.outputs.is_empty() {
            let value = self.point.registers[0].and_then(|value| word(self.terms, value));
            return value
                .map_or_else(|| missing("the answer is not known".to_owned()), |word| Ok(Answer::Action(word)));
        }
        let mut values = Vec::new();
        for (region, count) in [(Outputs, interface.outputs.len()), (Memory, interface.memory.len())] {
            for index in 0..count as u32 {
                values.push(match self.load_at(region, 4 * index, WORD) {
                    Some(Value::Float(float)) => float,
                    Some(Word(word)) => self.terms.of_bits(word),
                    _ => return self.refuse(format_args!("{region:?}, value {index}, is not written")),
                });
            }
        }
        Ok(Answer::Values(values))
    }

    /// Returns the half of an address that the linker inserts.
    pub(super) fn inserted(&self, part: Part) -> Option<Address> {
        let relocation = self.object.image.relocation(self.object.code(self.point, self.at.address))?;
        relocation.target.clone().ok().filter(|_| relocation.part == part)
    }
}

/// Returns an address moved by a distance, or a sum of numbers.
pub(super) fn moved(terms: &Terms, base: Value, distance: Word) -> Option<Value> {
    match base {
        Pointer(region, offset) => Some(Pointer(region, terms.apply(Add, Bits::W32, offset, distance))),
        Word(word) => Some(Word(terms.apply(Add, Bits::W32, word, distance))),
        _ => None,
    }
}
