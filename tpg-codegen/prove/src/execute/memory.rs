//! Registers, loads and stores.

use super::{Cell, Here, Object, Region};
use crate::elf::Address;
use crate::input::{Missing, Result};
use crate::machine::{Answer, Value};
use crate::term::{self, Operator::*};
use crate::thumb::{Index, Offset, PC, Place, Register};
use Region::*;
use Value::*;

impl Here<'_> {
    /// Says why the instruction is refused.
    pub(super) fn refusal(&self, what: impl std::fmt::Display) -> Missing {
        let (address, operation) = (self.node.address.offset, &self.node.instruction.operation);
        Missing::new(format!("{address:#x}"), format!("{operation:?}: {what}"))
    }

    pub(super) fn refuse<T>(&self, what: impl std::fmt::Display) -> Result<T> {
        Err(self.refusal(what))
    }

    /// Returns a register; what is unknown is refused.
    pub(super) fn register(&self, register: Register) -> Result<Value> {
        let value = self.cells.get(&Cell::Register(register)).copied();
        value.ok_or_else(|| self.refusal(format_args!("register {register} holds nothing known")))
    }

    /// Returns the bits of a value that is no address.
    pub(super) fn bits(&self, value: Value) -> Result<term::Word> {
        value.bits(self.terms).ok_or_else(|| self.refusal("computes with no number"))
    }

    pub(super) fn word(&self, register: Register) -> Result<term::Word> {
        self.bits(self.register(register)?)
    }

    /// Returns a value that is no address as a float.
    pub(super) fn number(&self, value: Value) -> Result<term::Float> {
        value.float(self.terms).ok_or_else(|| self.refusal("computes with no number"))
    }

    /// Loads or stores registers.
    pub(super) fn transfer(&mut self, load: bool, bytes: u8, registers: &[Register], place: Place) -> Result<()> {
        let (accessed, written) = self.addresses(place)?;
        let mut loaded = Vec::new();
        for (number, &register) in registers.iter().enumerate() {
            let address = self.with(Add, accessed, 4 * number as u64);
            if load {
                loaded.push((register, self.load(address, bytes)?));
            } else {
                let stored = self.register(register)?;
                self.store(address, bytes, stored)?;
            }
        }
        for (register, value) in written.map(|written| (place.base, Word(written))).into_iter().chain(loaded) {
            self.cells.insert(Cell::Register(register), value);
        }
        Ok(())
    }

    /// Returns the address that is accessed, and the one that is written back.
    pub(super) fn addresses(&self, place: Place) -> Result<(term::Word, Option<term::Word>)> {
        let base = if place.base == PC {
            self.bits(self.section(self.node.address.at(self.node.address.offset.wrapping_add(4) & !3)))?
        } else {
            self.word(place.base)?
        };
        let offset = match place.offset {
            Offset::Number(number) => self.terms.number(u64::from(number as u32)),
            Offset::Register(register, shift) => self.with(ShiftLeft, self.word(register)?, shift.into()),
        };
        let sum = self.terms.apply(Add, term::Width::W32, base, offset);
        Ok(match place.index {
            Index::Offset => (sum, None),
            Index::Before => (sum, Some(sum)),
            Index::After => (base, Some(sum)),
        })
    }

    /// Loads from an address, or from one of a few.
    fn load(&self, address: term::Word, bytes: u8) -> Result<Value> {
        let load = |address| {
            let (region, offset) = self.object.located(self.terms, address)?;
            self.load_at(region, offset, bytes)
        };
        let refusal = || self.refusal("loads what is not known");
        if !matches!(self.terms.of_word(address), term::Node::WordIf(..)) {
            return load(address).ok_or_else(refusal);
        }
        let mut failed = false;
        let value = self.terms.mapped(address, &mut |address| {
            let value = load(address).and_then(|value| value.bits(self.terms));
            failed |= value.is_none();
            value.unwrap_or(address)
        });
        if failed { Err(refusal()) } else { Ok(Word(value)) }
    }

    fn load_at(&self, region: Region, offset: u32, bytes: u8) -> Option<Value> {
        let is_word = bytes == 4 && offset.is_multiple_of(4);

        let Object { image, interface, .. } = self.object;
        match region {
            Section(section) => {
                let address = Address { section, offset };
                if image.is_relocated(address, bytes.into()) {
                    return if is_word { image.pointer(address).map(|target| self.section(target)) } else { None };
                }
                Some(Word(self.terms.number(image.number(address, bytes)?.into())))
            }
            State => {
                let known = is_word && offset / 4 < interface.state_length();
                known.then(|| Value::Float(self.terms.source(offset / 4)))
            }
            _ => self.cells.get(&Cell::Memory(region, offset, bytes)).copied(),
        }
    }

    fn store(&mut self, address: term::Word, size: u8, mut value: Value) -> Result<()> {
        let Some((region, offset)) = self.object.located(self.terms, address) else {
            return self.refuse("stores to an unknown address");
        };
        let length = match region {
            Memory => self.object.interface.memory.len(),
            Outputs => self.object.interface.outputs.len(),
            // Below the place where the function began with it.
            Stack if (offset as i32) < 0 => usize::MAX,
            _ => 0,
        };
        // Parts of words are stored on the stack only.
        let bytes = u32::from(size);
        let aligned = offset.is_multiple_of(bytes) && (bytes == 4 || region == Stack);
        if !aligned || (region != Stack && (offset / 4) as usize >= length) || length == 0 {
            return self.refuse(format_args!("stores to {region:?}, offset {}", offset as i32));
        }
        if bytes < 4 {
            value = Word(self.with(And, self.bits(value)?, (1 << (8 * bytes)) - 1));
        }
        let last = |offset: u32, bytes: u32| offset.wrapping_add(bytes - 1);
        self.cells.retain(|cell, _| match *cell {
            Cell::Memory(other, at, size) => {
                other != region || last(at, size.into()) < offset || last(offset, bytes) < at
            }
            _ => true,
        });
        self.cells.insert(Cell::Memory(region, offset, size), value);
        Ok(())
    }

    /// Checks the calling convention at the end, and returns the answer.
    pub(super) fn answer(&self) -> Result<Answer> {
        for register in super::flow::preserved() {
            if self.register(register)? != self.object.first[&Cell::Register(register)] {
                return self.refuse(format_args!("register {register} is not what it was before"));
            }
        }
        let interface = &self.object.interface;
        if interface.outputs.is_empty() {
            return self.word(0).map(Answer::Action);
        }
        let mut values = Vec::new();
        for (region, count) in [(Outputs, interface.outputs.len()), (Memory, interface.memory.len())] {
            for index in 0..count as u32 {
                let value = self.load_at(region, 4 * index, 4).and_then(|value| value.float(self.terms));
                let refusal = || self.refusal(format_args!("{region:?}, value {index}, is not written"));
                values.push(value.ok_or_else(refusal)?);
            }
        }
        Ok(Answer::Values(values))
    }
}
