//! Cells of variables, and constants in them.

use super::{Lowering, Lvalue, constant_of, is_float};
use crate::c::code::{CONSTANTS, Constant, Object};
use crate::c::syntax::{Expression, Kind, Type, Variable};
use crate::input::Missing;

impl<'u> Lowering<'u> {
    /// The cells of a type.
    pub(super) fn cells(&self, ty: &Type) -> u32 {
        match ty {
            Type::Void => 0,
            Type::Struct(number) => {
                let structure = &self.unit.structs[*number];
                let sizes = structure.members.iter().map(|(_, ty)| self.cells(ty));
                if structure.union { sizes.max().unwrap_or(0) } else { sizes.sum() }
            }
            Type::Array(ty, count) => self.cells(ty).saturating_mul(*count),
            _ => 1,
        }
    }

    /// The bytes of a type.
    pub(super) fn bytes(&self, ty: &Type) -> u32 {
        match ty {
            Type::Void => 0,
            Type::Integer(bytes, _) => u32::from(*bytes),
            Type::Float | Type::Pointer(_) => 4,
            Type::Double => 8,
            Type::Struct(number) => {
                let structure = &self.unit.structs[*number];
                let sizes = structure.members.iter().map(|(_, ty)| self.bytes(ty));
                if structure.union { sizes.max().unwrap_or(0) } else { sizes.sum() }
            }
            Type::Array(ty, count) => self.bytes(ty).saturating_mul(*count),
        }
    }

    pub(super) fn allocate(&mut self, ty: &Type) -> u32 {
        let start = self.program.cells;
        let end = start + self.cells(ty).max(1);
        self.program.objects.push(Object { start, end, array: matches!(ty, Type::Array(..)) });
        self.program.cells = end;
        start
    }

    /// A variable that is set once, before everything.
    pub(super) fn constant(&mut self, variable: &'u Variable) -> Result<(), Missing> {
        let mut ty = variable.ty.clone();
        if let (Type::Array(_, count @ 0), Some(Expression { kind: Kind::List(items), .. })) =
            (&mut ty, &variable.initial)
        {
            *count = u32::try_from(items.len()).map_err(|_| self.missing("a length"))?;
        }
        let key = (variable.line, variable.name.clone());
        let address = match self.statics.get(&key) {
            Some(&address) => address,
            None => {
                let offset = self.program.constants.len();
                let address = CONSTANTS + u32::try_from(offset).map_err(|_| self.missing("smaller tables"))?;
                let fill = if is_float(&ty) { Constant::Float(0) } else { Constant::Number(0) };
                let mut cells = vec![fill; self.cells(&ty) as usize];
                if let Some(initial) = &variable.initial {
                    self.fill(&ty, initial, &mut cells)?;
                }
                let end = address + self.cells(&ty).max(1);
                self.program.constants.extend(cells);
                self.program.objects.push(Object { start: address, end, array: true });
                self.statics.insert(key, address);
                address
            }
        };
        self.bind(variable.name.clone(), Lvalue { address, ty });
        Ok(())
    }

    pub(super) fn fill(&mut self, ty: &Type, initial: &'u Expression, cells: &mut [Constant]) -> Result<(), Missing> {
        match (ty, &initial.kind) {
            (Type::Array(inner, _), Kind::List(items)) => {
                let size = self.cells(inner) as usize;
                for (item, cells) in items.iter().zip(cells.chunks_mut(size.max(1))) {
                    self.fill(inner, item, cells)?;
                }
                Ok(())
            }
            (Type::Struct(structure), Kind::List(items)) => {
                let members: Vec<_> = self.unit.structs[*structure].members.iter().map(|(_, ty)| ty.clone()).collect();
                let mut rest = cells;
                for (item, ty) in items.iter().zip(&members) {
                    let (cells, after) = rest.split_at_mut(self.cells(ty) as usize);
                    self.fill(ty, item, cells)?;
                    rest = after;
                }
                Ok(())
            }
            _ => {
                let (value, from) = self.value(initial)?;
                let value = self.converted(value, &from, ty)?;
                cells[0] = match constant_of(&value) {
                    Some(constant) => constant,
                    None => return Err(self.missing("a constant initialiser")),
                };
                Ok(())
            }
        }
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
