//! Cells of variables, and constants in them.

use super::{Compiler, Lvalue, Operand, Type};
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

    /// The bytes of each scalar in a type, if all have the same.
    pub(super) fn scalar_bytes(&self, ty: &Type) -> Option<u32> {
        match ty {
            Integer(bytes, _) => Some(u32::from(*bytes)),
            Float => Some(4),
            Array(ty, _) => self.scalar_bytes(ty),
            Struct(number) => {
                let mut sizes = self.structs[*number].iter().map(|(_, ty)| self.scalar_bytes(ty));
                let first = sizes.next()??;
                sizes.all(|size| size == Some(first)).then_some(first)
            }
            _ => None,
        }
    }

    pub(super) fn allocate(&mut self, ty: &Type) -> u32 {
        let start = self.program.cells;
        let end = start + self.cells(ty).max(1);
        self.program.objects.push(Object { start, end, array: matches!(ty, Array(..)) });
        self.program.cells = end;
        start
    }

    /// Makes a variable of constants.
    pub(super) fn fixed(&mut self, ty: Type, parts: Vec<(u32, Type, Operand)>) -> Result<Lvalue> {
        let offset = self.program.constants.len();
        let address = CONSTANTS + u32::try_from(offset).map_err(|_| self.missing("smaller tables"))?;
        let mut cells = vec![0; self.cells(&ty) as usize];
        for (offset, ty, item) in parts {
            let value = self.value(item)?;
            let value = self.converted(value, &ty)?;
            cells[offset as usize] = self.constant_of(&value).ok_or_else(|| self.missing("a constant initialiser"))?;
        }
        self.program.constants.extend(cells);
        self.program.objects.push(Object { start: address, end: address + self.cells(&ty).max(1), array: true });
        Ok(Lvalue { address, ty })
    }

    pub(super) fn bind(&mut self, name: String, place: Lvalue) {
        if let Some(names) = self.names.last_mut() {
            names.insert(name, place);
        }
    }

    pub(super) fn find(&self, name: &str) -> Option<&Lvalue> {
        self.names.iter().rev().find_map(|names| names.get(name))
    }
}
