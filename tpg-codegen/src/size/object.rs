//! The sections of an object file.

use object::{Object as _, ObjectSection, ObjectSymbol as _, RelocationTarget, SectionKind};
use serde::Serialize;
use std::collections::BTreeSet;
use std::{fmt, io};

/// Bytes of an object file that end up on the device.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize)]
pub struct Size {
    /// Instructions, and constants that the compiler puts between them.
    pub code: u64,
    /// Constant tables.
    pub constants: u64,
    /// Initialised variables, which take flash and RAM.
    pub data: u64,
    /// Variables that start as zero, which take RAM.
    pub bss: u64,
}

impl Size {
    /// Bytes of flash.
    pub fn flash(self) -> u64 {
        self.code + self.constants + self.data
    }

    /// Bytes of RAM, without the stack.
    pub fn ram(self) -> u64 {
        self.data + self.bss
    }

    fn add<'data>(&mut self, section: &impl ObjectSection<'data>) {
        let bytes = match section.kind() {
            SectionKind::Text => &mut self.code,
            SectionKind::ReadOnlyData | SectionKind::ReadOnlyString | SectionKind::ReadOnlyDataWithRel => {
                &mut self.constants
            }
            SectionKind::Data => &mut self.data,
            // A library's linker script reserves a stack, and fills up to the next word.
            SectionKind::UninitializedData if !matches!(section.name(), Ok(".stack" | ".persistent")) => &mut self.bss,
            _ => return,
        };
        *bytes += section.size();
    }
}

impl fmt::Display for Size {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let Self { code, constants, data, bss } = self;
        write!(f, "{code} bytes of code, {constants} of constants, {data} of data, {bss} of bss")
    }
}

/// Sums the sections of an object file.
///
/// # Errors
/// If it is not an object file.
pub fn measure(object: &[u8]) -> io::Result<Size> {
    let file = object::File::parse(object).map_err(io::Error::other)?;
    let mut size = Size::default();
    file.sections().for_each(|section| size.add(&section));
    Ok(size)
}

/// Sums the sections of an object file that a symbol's section reaches.
///
/// # Errors
/// If it is not an object file, or defines no such symbol.
pub(super) fn measure_reached(object: &[u8], symbol: &str) -> io::Result<Size> {
    let file = object::File::parse(object).map_err(io::Error::other)?;
    let start = file.symbol_by_name(symbol).and_then(|symbol| symbol.section_index());
    let mut waiting = vec![start.ok_or_else(|| io::Error::other(format!("the object file defines no {symbol}")))?];
    let (mut reached, mut size) = (BTreeSet::new(), Size::default());
    while let Some(index) = waiting.pop() {
        if !reached.insert(index.0) {
            continue;
        }
        let section = file.section_by_index(index).map_err(io::Error::other)?;
        size.add(&section);
        waiting.extend(section.relocations().filter_map(|(_, relocation)| match relocation.target() {
            RelocationTarget::Symbol(symbol) => file.symbol_by_index(symbol).ok()?.section_index(),
            RelocationTarget::Section(section) => Some(section),
            _ => None,
        }));
    }
    Ok(size)
}
