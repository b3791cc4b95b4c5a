//! Loads and stores.

use super::value::{Region, Value};
use super::{MachineState, Object, Point};
use crate::elf::{Address, Part};
use crate::input::Missing;
use crate::machine::Answer;
use crate::term::{Float, Operator::*, Terms, Width as Bits, Word};
use crate::thumb::{Index, Instruction, Offset, PC, Place, Register, SP, Width};
use Region::*;
use Value::*;

type Result<T> = std::result::Result<T, Missing>;

/// Says why an instruction is refused.
pub(super) fn refuse(instruction: &Instruction, what: impl std::fmt::Display) -> Missing {
    Missing::new(format!("{:#x}", instruction.address), format!("{:?}: {what}", instruction.operation))
}

impl Object {
    /// Returns a register; what is unknown is refused.
    pub(super) fn register(&self, point: &Point, at: &Instruction, register: Register) -> Result<Value> {
        let value = point.registers[usize::from(register)];
        value.ok_or_else(|| refuse(at, format_args!("register {register} holds nothing known")))
    }

    pub(super) fn word(&self, terms: &mut Terms, point: &Point, at: &Instruction, register: Register) -> Result<Word> {
        let value = self.register(point, at, register)?;
        super::value::word(terms, value).ok_or_else(|| refuse(at, format_args!("register {register} is no number")))
    }

    pub(super) fn float(
        &self,
        terms: &mut Terms,
        point: &Point,
        at: &Instruction,
        register: Register,
    ) -> Result<Float> {
        match self.register(point, at, register)? {
            Value::Float(float) => Ok(float),
            Value::Word(word) => Ok(terms.of_bits(word)),
            _ => Err(refuse(at, format_args!("register {register} is no number"))),
        }
    }

    /// Loads or stores registers.
    pub(super) fn transfer(
        &self,
        terms: &mut Terms,
        state: &mut MachineState,
        at: &Instruction,
        (load, width, registers, place): (bool, Width, &[Register], Place),
    ) -> Result<()> {
        let (accessed, written) = self.addresses(terms, &state.point, at, place)?;
        let mut loaded = Vec::new();
        for (number, &register) in registers.iter().enumerate() {
            let distance = terms.number(4 * number as u64);
            let value = moved(terms, accessed, distance).ok_or_else(|| refuse(at, "not an address"))?;
            if load {
                loaded.push((register, self.load(terms, &state.point, at, value, width)?));
            } else {
                let stored = self.register(&state.point, at, register)?;
                self.store(terms, &mut state.point, at, value, width, stored)?;
            }
        }
        if let Some(written) = written {
            state.point.registers[usize::from(place.base)] = Some(written);
        }
        for (register, value) in loaded {
            state.point.registers[usize::from(register)] = Some(value);
        }
        Ok(())
    }

    /// Returns the address that is accessed, and the one that is written back.
    pub(super) fn addresses(
        &self,
        terms: &mut Terms,
        point: &Point,
        at: &Instruction,
        place: Place,
    ) -> Result<(Value, Option<Value>)> {
        let base = if place.base == PC {
            let code = self.code(point, at.address.wrapping_add(4) & !3);
            Pointer(Section(code.section), terms.number(code.offset.into()))
        } else {
            let base = self.register(point, at, place.base)?;
            self.unknowns.pointer(terms, base)
        };
        let (base, offset) = match place.offset {
            Offset::Number(number) => (base, terms.number(u64::from(number as u32))),
            Offset::Register(register, shift) => {
                let value = self.register(point, at, register)?;
                match (self.unknowns.pointer(terms, value), base) {
                    // The address is the register that is added.
                    (value @ Pointer(..), Value::Word(word)) if shift == 0 => (value, word),
                    _ => {
                        let (word, shift) = (self.word(terms, point, at, register)?, terms.number(shift.into()));
                        (base, terms.apply(ShiftLeft, Bits::W32, word, shift))
                    }
                }
            }
        };
        let sum = moved(terms, base, offset).ok_or_else(|| refuse(at, "not an address"))?;
        Ok(match place.index {
            Index::Offset => (sum, None),
            Index::Before => (sum, Some(sum)),
            Index::After => (base, Some(sum)),
        })
    }

    /// Returns the place of an address in the section of the code.
    pub(super) fn code(&self, point: &Point, address: u32) -> Address {
        let function = point.function;
        let offset = address.wrapping_sub(self.image.absolute(function)).wrapping_add(function.offset);
        Address { section: function.section, offset }
    }

    fn load(&self, terms: &mut Terms, point: &Point, at: &Instruction, address: Value, width: Width) -> Result<Value> {
        let (region, offset) = match address {
            Pointer(region, offset) => (region, offset),
            // A number is an address of a linked image.
            Value::Word(word) => {
                let located = terms.number_of(word).and_then(|number| self.image.locate(number as u32));
                let located = located.ok_or_else(|| refuse(at, "loads from a number"))?;
                (Section(located.section), terms.number(located.offset.into()))
            }
            _ => return Err(refuse(at, "loads from no address")),
        };
        if let Some(offset) = terms.number_of(offset) {
            return self.load_at(terms, point, region, offset as u32, width).ok_or_else(|| {
                refuse(at, format_args!("loads from {region:?}, offset {}, which is not known", offset as u32 as i32))
            });
        }
        // One of a few constants.
        let mut failed = false;
        let value = terms.mapped(offset, &mut |terms, offset| {
            let value = terms.number_of(offset).and_then(|offset| {
                let value = self.load_at(terms, point, region, offset as u32, width)?;
                super::value::word(terms, value)
            });
            failed |= value.is_none();
            value.unwrap_or(offset)
        });
        if failed { Err(refuse(at, "loads from an unknown address")) } else { Ok(Value::Word(value)) }
    }

    fn load_at(&self, terms: &mut Terms, point: &Point, region: Region, offset: u32, width: Width) -> Option<Value> {
        let is_word = width.bytes == 4 && offset.is_multiple_of(4);
        let index = offset / 4;
        let sources = self.interface.state_length();
        match region {
            Section(section) => {
                let address = Address { section, offset };
                if self.image.is_relocated(address, width.bytes.into()) {
                    let target = if is_word { self.image.pointer(address)? } else { return None };
                    let offset = terms.number(target.offset.into());
                    return Some(Pointer(Section(target.section), offset));
                }
                let number = self.image.number(address, width.bytes)?;
                let unused = 32 - 8 * u32::from(width.bytes);
                let number = if width.signed { ((number << unused) as i32 >> unused) as u32 } else { number };
                Some(Value::Word(terms.number(number.into())))
            }
            State if !is_word => None,
            State => (index < sources).then(|| Value::Float(terms.source(index))),
            _ => {
                let value = *point.memory.get(&(region, offset, width.bytes))?;
                let Value::Word(word) = value else { return Some(value) };
                let unused = terms.number(32 - 8 * u64::from(width.bytes));
                let high = terms.apply(ShiftLeft, Bits::W32, word, unused);
                let extended = terms.apply(ShiftArithmetic, Bits::W32, high, unused);
                Some(Value::Word(if width.signed { extended } else { word }))
            }
        }
    }

    fn store(
        &self,
        terms: &mut Terms,
        point: &mut Point,
        at: &Instruction,
        address: Value,
        width: Width,
        value: Value,
    ) -> Result<()> {
        let Pointer(region, offset) = address else { return Err(refuse(at, "stores to no known address")) };
        let offset = terms.number_of(offset).ok_or_else(|| refuse(at, "stores to an unknown address"))? as u32;
        let length = match region {
            Memory => self.interface.memory.len(),
            Outputs => self.interface.outputs.len(),
            // Below the place where the function began with it.
            Stack if (offset as i32) < 0 => usize::MAX,
            _ => 0,
        };
        // Parts of words are stored on the stack only.
        let bytes = u32::from(width.bytes);
        let aligned = offset.is_multiple_of(bytes) && (bytes == 4 || region == Stack);
        if !aligned || (region != Stack && (offset / 4) as usize >= length) || length == 0 {
            return Err(refuse(at, format_args!("stores to {region:?}, offset {}", offset as i32)));
        }
        let value = if bytes == 4 {
            value
        } else {
            let word = super::value::word(terms, value).ok_or_else(|| refuse(at, "stores a part of no number"))?;
            let mask = terms.number((1 << (8 * bytes)) - 1);
            Value::Word(terms.apply(And, Bits::W32, word, mask))
        };
        let last = |offset: u32, bytes: u32| offset.wrapping_add(bytes - 1);
        point.memory.retain(|&(other, at, size), _| {
            other != region || last(at, size.into()) < offset || last(offset, bytes) < at
        });
        point.memory.insert((region, offset, width.bytes), value);
        Ok(())
    }

    /// Checks the calling convention at the end, and returns the answer.
    pub(super) fn answer(&self, terms: &mut Terms, point: &Point) -> Result<Answer> {
        let place = self.function_place(point);
        for register in super::flow::preserved() {
            let expected = if register == SP { Pointer(Stack, terms.number(0)) } else { Initial(register) };
            if point.registers[usize::from(register)] != Some(expected) {
                return Err(Missing::new(place, format!("register {register} is not what it was before")));
            }
        }
        if self.interface.outputs.is_empty() {
            let value = point.registers[0].and_then(|value| super::value::word(terms, value));
            return Ok(Answer::Action(value.ok_or_else(|| Missing::new(place, "the answer is not known"))?));
        }
        let mut values = Vec::new();
        for (region, count) in [(Outputs, self.interface.outputs.len()), (Memory, self.interface.memory.len())] {
            for index in 0..count as u32 {
                let value = self.load_at(terms, point, region, 4 * index, crate::thumb::WORD);
                values.push(match value {
                    Some(Value::Float(float)) => float,
                    Some(Value::Word(word)) => terms.of_bits(word),
                    _ => return Err(Missing::new(place, format!("{region:?}, value {index}, is not written"))),
                });
            }
        }
        Ok(Answer::Values(values))
    }

    fn function_place(&self, point: &Point) -> String {
        format!("{:#x}", point.address)
    }

    /// Returns the half of an address that the linker inserts.
    pub(super) fn inserted(&self, point: &Point, at: &Instruction, part: Part) -> Option<Address> {
        let relocation = self.image.relocation(self.code(point, at.address))?;
        relocation.target.clone().ok().filter(|_| relocation.part == part)
    }
}

/// Returns an address moved by a distance, or a sum of numbers.
pub(super) fn moved(terms: &mut Terms, base: Value, distance: Word) -> Option<Value> {
    match base {
        Pointer(region, offset) => Some(Pointer(region, terms.apply(Add, Bits::W32, offset, distance))),
        Value::Word(word) => Some(Value::Word(terms.apply(Add, Bits::W32, word, distance))),
        _ => None,
    }
}
