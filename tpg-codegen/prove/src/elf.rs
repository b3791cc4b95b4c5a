//! Reader of ARM objects: functions, constant data, and what the linker would insert.

use object::read::{Object as _, ObjectSection as _, ObjectSymbol as _};
use object::{RelocationFlags, RelocationTarget, SectionFlags, SectionIndex, elf};
use std::collections::{BTreeMap, HashMap};

/// Place in an image.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub struct Address {
    /// Number of the section.
    pub(crate) section: usize,
    /// Bytes from the section's start.
    pub(crate) offset: u32,
}

impl Address {
    /// Returns another address in the section.
    pub(crate) const fn at(self, offset: u32) -> Self {
        Self { offset, ..self }
    }
}

/// Address inserted by the linker.
#[derive(Clone, Debug)]
pub(crate) struct Relocation {
    /// Part of the address that is inserted, and where.
    pub(crate) part: Part,
    /// The address; the symbol's name if it is in another object.
    pub(crate) target: Result<Address, String>,
}

/// Part of an address inserted by the linker.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) enum Part {
    /// A word.
    Word,
    /// The lower half, in `movw`.
    Low,
    /// The upper half, in `movt`.
    High,
    /// The target of a branch or call.
    Branch,
}

/// A function of an image.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub(crate) struct Function {
    /// Its first instruction.
    pub(crate) start: Address,
    /// Bytes of code and of constants between it.
    pub(crate) size: u32,
}

#[derive(Clone, Debug)]
struct ElfSection {
    bytes: Vec<u8>,
    constant: bool,
}

/// An object.
#[derive(Clone, Debug)]
pub(crate) struct Image {
    sections: Vec<ElfSection>,
    relocations: BTreeMap<Address, Relocation>,
    functions: BTreeMap<String, Vec<Function>>,
}

impl Image {
    /// Reads an ELF file.
    ///
    /// # Errors
    /// If it is not a little-endian ELF file for ARM.
    pub(crate) fn read(file: &[u8]) -> Result<Self, String> {
        let format = |error: &dyn std::fmt::Display| format!("not an ELF object for ARM, little-endian: {error}");
        let file = object::File::parse(file).map_err(|error| format(&error))?;
        let found = (file.format(), file.architecture(), file.is_little_endian());
        if found != (object::BinaryFormat::Elf, object::Architecture::Arm, true) {
            return Err(format(&format_args!("found {:?}, {:?}", found.0, found.1)));
        }
        if file.kind() != object::ObjectKind::Relocatable {
            return Err(format(&"found a linked image"));
        }
        let mut image = Self { sections: Vec::new(), relocations: BTreeMap::new(), functions: BTreeMap::new() };
        let mut numbers: HashMap<SectionIndex, usize> = HashMap::new();
        for section in file.sections() {
            let SectionFlags::Elf { sh_flags, .. } = section.flags() else { continue };
            if !sh_flags.contains(elf::SHF_ALLOC) {
                continue;
            }
            let bytes = section.data().map_err(|error| format(&error))?.to_vec();
            let constant = !sh_flags.contains(elf::SHF_WRITE);
            numbers.insert(section.index(), image.sections.len());
            image.sections.push(ElfSection { bytes, constant });
        }
        image.find_functions(&file, &numbers);
        image.find_relocations(&file, &numbers)?;
        Ok(image)
    }

    fn find_functions(&mut self, file: &object::File<'_>, numbers: &HashMap<SectionIndex, usize>) {
        for symbol in file.symbols().filter(|symbol| symbol.kind() == object::SymbolKind::Text) {
            let Ok(name) = symbol.name() else { continue };
            if name.is_empty() || name.starts_with('$') || symbol.is_undefined() {
                continue;
            }
            let thumb = symbol.address() & 1 == 1;
            let start = self.place(&symbol, numbers, symbol.address() & !1);
            let size = u32::try_from(symbol.size()).ok().filter(|&size| size > 0 && thumb);
            let Some((start, size)) = start.zip(size) else { continue };
            let (function, known) = (Function { start, size }, self.functions.entry(name.to_owned()).or_default());
            if self.sections[start.section].constant && !known.contains(&function) {
                known.push(function);
            }
        }
    }

    /// Returns the place of an address in the section of a symbol.
    fn place<'data>(
        &self,
        symbol: &impl object::ObjectSymbol<'data>,
        numbers: &HashMap<SectionIndex, usize>,
        address: u64,
    ) -> Option<Address> {
        let section = *numbers.get(&symbol.section_index()?)?;
        Some(Address { section, offset: u32::try_from(address).ok()? })
    }

    fn find_relocations(
        &mut self,
        file: &object::File<'_>,
        numbers: &HashMap<SectionIndex, usize>,
    ) -> Result<(), String> {
        for section in file.sections() {
            let Some(&number) = numbers.get(&section.index()) else { continue };
            if !self.sections[number].constant {
                continue;
            }
            let name = section.name().unwrap_or_default();
            for (offset, relocation) in section.relocations() {
                let RelocationFlags::Elf { r_type } = relocation.flags() else { continue };
                let error = || {
                    let kind = r_type.0;
                    format!("section {name}, offset {offset:#x}: relocation of type {kind} is not understood")
                };
                let part = match r_type {
                    elf::R_ARM_NONE | elf::R_ARM_PREL31 => continue,
                    elf::R_ARM_ABS32 => Part::Word,
                    elf::R_ARM_THM_MOVW_ABS_NC => Part::Low,
                    elf::R_ARM_THM_MOVT_ABS => Part::High,
                    elf::R_ARM_THM_PC22 | elf::R_ARM_THM_JUMP24 => Part::Branch,
                    _ => return Err(error()),
                };
                let RelocationTarget::Symbol(index) = relocation.target() else { return Err(error()) };
                let symbol = file.symbol_by_index(index).map_err(|_| error())?;
                let place = Address { section: number, offset: u32::try_from(offset).map_err(|_| error())? };
                let addend = self.addend(place, part, &relocation).ok_or_else(error)?;
                // The lowest bit of a function's symbol says Thumb.
                let address =
                    if symbol.kind() == object::SymbolKind::Text { symbol.address() & !1 } else { symbol.address() };
                let target = match self.place(&symbol, numbers, address) {
                    Some(Address { section, offset }) => Ok(Address { section, offset: offset.wrapping_add(addend) }),
                    None => Err(symbol.name().unwrap_or_default().to_owned()),
                };
                self.relocations.insert(place, Relocation { part, target });
            }
        }
        Ok(())
    }

    /// Returns what is added to a symbol: objects for ARM have it in the code, except in tables with addends.
    fn addend(&self, place: Address, part: Part, relocation: &object::Relocation) -> Option<u32> {
        if !relocation.has_implicit_addend() {
            return Some(relocation.addend() as u32);
        }
        let word = self.sections[place.section].bytes.get(place.offset as usize..)?.first_chunk::<4>()?;
        let (first, second) =
            (u32::from(u16::from_le_bytes([word[0], word[1]])), u32::from(u16::from_le_bytes([word[2], word[3]])));
        match part {
            Part::Word => Some(u32::from_le_bytes(*word)),
            Part::Low | Part::High => {
                let half = (first & 15) << 12 | (first >> 10 & 1) << 11 | (second >> 12 & 7) << 8 | second & 255;
                Some(half as u16 as i16 as u32)
            }
            Part::Branch => Some(0),
        }
    }

    /// Returns the function of a name.
    ///
    /// # Errors
    /// If there is none, or several, or it is not Thumb code.
    pub(crate) fn function(&self, name: &str) -> Result<Function, String> {
        match self.functions.get(name).map(Vec::as_slice) {
            Some(&[function]) => Ok(function),
            Some(_) => Err(format!("several functions {name:?}")),
            None => {
                let names: Vec<&str> = self.functions.keys().map(String::as_str).collect();
                Err(format!("no function {name:?} in Thumb code with a size; there are: {}", names.join(", ")))
            }
        }
    }

    /// Returns the function that begins at a place.
    pub(crate) fn function_at(&self, start: Address) -> Option<Function> {
        let mut known = self.functions.values().flatten().filter(|function| function.start == start);
        known.next().copied()
    }

    /// Returns bytes that never change: of a section that is not writable.
    pub(crate) fn constant(&self, address: Address, count: u32) -> Option<&[u8]> {
        let section = self.sections.get(address.section).filter(|section| section.constant)?;
        let start = address.offset as usize;
        section.bytes.get(start..start.checked_add(count as usize)?)
    }

    /// Returns what the linker inserts at a place.
    pub(crate) fn relocation(&self, address: Address) -> Option<&Relocation> {
        self.relocations.get(&address)
    }

    /// Returns a constant number of up to four bytes.
    pub(crate) fn number(&self, address: Address, bytes: u8) -> Option<u32> {
        let bytes = self.constant(address, bytes.into())?;
        Some(bytes.iter().rev().fold(0, |number: u32, &byte| number << 8 | u32::from(byte)))
    }

    /// Returns the address in a constant word.
    pub(crate) fn pointer(&self, address: Address) -> Option<Address> {
        self.constant(address, 4)?;
        match self.relocations.get(&address)? {
            Relocation { part: Part::Word, target } => target.clone().ok(),
            _ => None,
        }
    }

    /// True if the linker changes any of `count` bytes from a place on.
    pub(crate) fn is_relocated(&self, address: Address, count: u32) -> bool {
        let from = Address { offset: address.offset.saturating_sub(3), ..address };
        let to = Address { offset: address.offset.saturating_add(count), ..address };
        self.relocations.range(from..to).next().is_some()
    }
}
