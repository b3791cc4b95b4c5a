//! Cells of variables, and constants in them.

use super::{Lowering, Place, constant_of, is_float};
use crate::c::code::{CONSTANTS, Constant, Object};
use crate::c::syntax::{Expression, Kind, Type, Variable};
use crate::input::Missing;

impl<'u> Lowering<'u> {
    /// The cells of a type.
    pub(super) fn cells(&self, of: &Type) -> u32 {
        match of {
            Type::Void => 0,
            Type::Struct(number) => {
                let structure = &self.unit.structs[*number];
                let sizes = structure.members.iter().map(|(_, of)| self.cells(of));
                if structure.union { sizes.max().unwrap_or(0) } else { sizes.sum() }
            }
            Type::Array(of, count) => self.cells(of).saturating_mul(*count),
            _ => 1,
        }
    }

    /// The bytes of a type.
    pub(super) fn bytes(&self, of: &Type) -> u32 {
        match of {
            Type::Void => 0,
            Type::Integer(bytes, _) => u32::from(*bytes),
            Type::Float | Type::Pointer(_) => 4,
            Type::Double => 8,
            Type::Struct(number) => {
                let structure = &self.unit.structs[*number];
                let sizes = structure.members.iter().map(|(_, of)| self.bytes(of));
                if structure.union { sizes.max().unwrap_or(0) } else { sizes.sum() }
            }
            Type::Array(of, count) => self.bytes(of).saturating_mul(*count),
        }
    }

    pub(super) fn allocate(&mut self, of: &Type) -> u32 {
        let start = self.program.cells;
        let end = start + self.cells(of).max(1);
        self.program.objects.push(Object { start, end, array: matches!(of, Type::Array(..)) });
        self.program.cells = end;
        start
    }

    /// A variable that is set once, before everything.
    pub(super) fn constant(&mut self, variable: &'u Variable) -> Result<(), Missing> {
        let mut of = variable.of.clone();
        if let (Type::Array(_, count @ 0), Some(Expression { kind: Kind::List(items), .. })) =
            (&mut of, &variable.initial)
        {
            *count = u32::try_from(items.len()).map_err(|_| self.missing("a length"))?;
        }
        let key = (variable.line, variable.name.clone());
        let address = match self.statics.get(&key) {
            Some(&address) => address,
            None => {
                let offset = self.program.constants.len();
                let address = CONSTANTS + u32::try_from(offset).map_err(|_| self.missing("smaller tables"))?;
                let fill = if is_float(&of) { Constant::Float(0) } else { Constant::Number(0) };
                let mut cells = vec![fill; self.cells(&of) as usize];
                if let Some(initial) = &variable.initial {
                    self.fill(&of, initial, &mut cells)?;
                }
                let end = address + self.cells(&of).max(1);
                self.program.constants.extend(cells);
                self.program.objects.push(Object { start: address, end, array: true });
                self.statics.insert(key, address);
                address
            }
        };
        self.bind(variable.name.clone(), Place { address, of });
        Ok(())
    }

    pub(super) fn fill(&mut self, of: &Type, initial: &'u Expression, cells: &mut [Constant]) -> Result<(), Missing> {
        match (of, &initial.kind) {
            (Type::Array(inner, _), Kind::List(items)) => {
                let size = self.cells(inner) as usize;
                for (item, cells) in items.iter().zip(cells.chunks_mut(size.max(1))) {
                    self.fill(inner, item, cells)?;
                }
                Ok(())
            }
            (Type::Struct(structure), Kind::List(items)) => {
                let members: Vec<_> = self.unit.structs[*structure].members.iter().map(|(_, of)| of.clone()).collect();
                let mut rest = cells;
                for (item, of) in items.iter().zip(&members) {
                    let (cells, after) = rest.split_at_mut(self.cells(of) as usize);
                    self.fill(of, item, cells)?;
                    rest = after;
                }
                Ok(())
            }
            _ => {
                let (value, from) = self.value(initial)?;
                let value = self.converted(value, &from, of)?;
                cells[0] = match constant_of(&value) {
                    Some(constant) => constant,
                    None => return Err(self.missing("a constant initialiser")),
                };
                Ok(())
            }
        }
    }

    pub(super) fn bind(&mut self, name: String, place: Place) {
        if let Some(names) = self.names.last_mut() {
            names.insert(name, place);
        }
    }

    pub(super) fn find(&self, name: &str) -> Option<&Place> {
        self.names.iter().rev().find_map(|names| names.get(name))
    }
}
