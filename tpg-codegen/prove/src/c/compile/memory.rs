//! Cells of variables, and constants in them.

use super::{Compiler, Operand, Type, Typed, number};
use crate::c::code::{CONSTANTS, Object};
use crate::input::Result;
use Type::*;

impl Compiler<'_> {
    /// The size of a type, by that of scalars.
    fn size(&self, ty: &Type, scalar: fn(&Type) -> u32) -> u32 {
        match ty {
            Void => 0,
            Struct(number) => self.structs[*number].iter().map(|(_, ty)| self.size(ty, scalar)).sum(),
            Array(ty, count) => self.size(ty, scalar).saturating_mul(*count),
            _ => scalar(ty),
        }
    }

    pub(super) fn cells(&self, ty: &Type) -> u32 {
        self.size(ty, |_| 1)
    }

    pub(super) fn bytes(&self, ty: &Type) -> u32 {
        self.size(ty, |ty| match ty {
            Integer(bytes, _) => u32::from(*bytes),
            _ => 4,
        })
    }

    /// Tests whether all scalars in a type are floats; nothing if some are neither that nor integers of 4 bytes.
    pub(super) fn words(&self, ty: &Type) -> Option<bool> {
        match ty {
            Float => Some(true),
            Integer(4, _) => Some(false),
            Array(ty, _) => self.words(ty),
            Struct(number) => {
                let floats = self.structs[*number].iter().all(|(_, ty)| self.words(ty) == Some(true));
                floats.then_some(true)
            }
            _ => None,
        }
    }

    pub(super) fn allocate(&mut self, ty: &Type) -> u32 {
        let start = self.program.cells;
        let end = start + self.cells(ty).max(1);
        self.program.objects.push(Object { start, end, aggregate: matches!(ty, Array(..) | Struct(_)) });
        self.program.cells = end;
        start
    }

    /// Makes a variable of constants.
    pub(super) fn fixed(&mut self, ty: Type, parts: Vec<(u32, Type, Operand)>) -> Result<Typed> {
        let offset = self.program.constants.len();
        let address = CONSTANTS + u32::try_from(offset).map_err(|_| self.missing("smaller tables"))?;
        let mut cells = vec![0; self.cells(&ty) as usize];
        for (offset, ty, item) in parts {
            let value = self.value(item)?;
            let value = self.converted(value, &ty)?;
            cells[offset as usize] = self.constant_of(&value).ok_or_else(|| self.missing("a constant initialiser"))?;
        }
        self.program.constants.extend(cells);
        self.program.objects.push(Object { start: address, end: address + self.cells(&ty).max(1), aggregate: true });
        Ok((number(address), ty))
    }

    pub(super) fn bind(&mut self, name: String, place: Typed) {
        if let Some(names) = self.names.last_mut() {
            names.insert(name, place);
        }
    }

    pub(super) fn find(&self, name: &str) -> Option<&Typed> {
        self.names.iter().rev().find_map(|names| names.get(name))
    }
}
