//! Loads and stores.

use super::{Here, Object};
use crate::code::Found;
use crate::elf::Address;
use crate::machine::{Answer, Cell, Cells, Region, Value};
use crate::term;
use crate::thumb::SP;
use Region::*;
use Value::*;

impl Here<'_> {
    pub(super) fn load_at(&self, region: Region, offset: u32, bytes: u8, cells: &Cells) -> Option<Value> {
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
            Stack if self.is_free(offset, cells) => None,
            _ => cells.get(&Cell::Memory(region, offset, bytes)).copied(),
        }
    }

    /// Tests for a place below the stack pointer, which an interrupt may overwrite.
    fn is_free(&self, offset: u32, cells: &Cells) -> bool {
        let pointer = cells.get(&Cell::Register(SP)).map(|pointer| pointer.bits(self.terms));
        let place = pointer.and_then(|pointer| self.object.located(self.terms, pointer));
        !matches!(place, Some((Stack, lowest)) if lowest as i32 <= offset as i32)
    }

    pub(super) fn store(&self, cells: &mut Cells, address: term::Word, size: u8, value: Value) -> Found<()> {
        let place = self.object.located(self.terms, address);
        let (region, offset) = place.ok_or("a place to store to that is known")?;
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
            return Err("a place to store to that is the function's");
        }
        let last = |offset: u32, bytes: u32| offset.wrapping_add(bytes - 1);
        cells.retain(|cell, _| match *cell {
            Cell::Memory(other, at, size) => {
                other != region || last(at, size.into()) < offset || last(offset, bytes) < at
            }
            _ => true,
        });
        cells.insert(Cell::Memory(region, offset, size), value);
        Ok(())
    }

    /// Checks the calling convention at the end, and returns the answer.
    pub(super) fn answer(&self, cells: &Cells) -> Found<Answer> {
        let kept = |register| {
            let cell = Cell::Register(register);
            cells.get(&cell) == self.object.first.get(&cell)
        };
        if !super::flow::preserved().all(kept) {
            return Err("preserved registers with what they held before");
        }
        let interface = &self.object.interface;
        if interface.outputs.is_empty() {
            let result = cells.get(&Cell::Register(0)).ok_or("a result")?;
            return Ok(Answer::Action(result.bits(self.terms)));
        }
        let mut values = Vec::new();
        for (region, count) in [(Outputs, interface.outputs.len()), (Memory, interface.memory.len())] {
            for index in 0..count as u32 {
                let value = self.load_at(region, 4 * index, 4, cells).ok_or("all outputs and memory")?;
                values.push(value.float(self.terms));
            }
        }
        Ok(Answer::Values(values))
    }
}
