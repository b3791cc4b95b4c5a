//! Cells of variables, and constants in them.

use super::{Lowering, Lvalue, constant_of, is_float};
use crate::c::code::{CONSTANTS, Constant, Object};
use crate::c::syntax::{Expression, Kind, Type, Variable};
use crate::input::Missing;
use Type::*;

impl<'u> Lowering<'u> {
    /// The size of a type, by that of scalars.
    fn size(&self, ty: &Type, scalar: fn(&Type) -> u32) -> u32 {
        match ty {
            Void => 0,
            Struct(number) => {
                let structure = &self.unit.structs[*number];
                let sizes = structure.members.iter().map(|(_, ty)| self.size(ty, scalar));
                if structure.union { sizes.max().unwrap_or(0) } else { sizes.sum() }
            }
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
            Double => 8,
            _ => 4,
        })
    }

    /// The type of a variable, with the length that an initialiser has.
    pub(super) fn type_of(&self, variable: &Variable) -> Result<Type, Missing> {
        let mut ty = variable.ty.clone();
        if let (Array(_, count @ 0), Some(Expression { kind: Kind::List(items), .. })) = (&mut ty, &variable.initial) {
            *count = u32::try_from(items.len()).map_err(|_| self.missing("a length"))?;
        }
        Ok(ty)
    }

    pub(super) fn allocate(&mut self, ty: &Type) -> u32 {
        let start = self.program.cells;
        let end = start + self.cells(ty).max(1);
        self.program.objects.push(Object { start, end, array: matches!(ty, Array(..)) });
        self.program.cells = end;
        start
    }

    /// A variable that is set once, before everything.
    pub(super) fn constant(&mut self, variable: &'u Variable) -> Result<(), Missing> {
        let ty = self.type_of(variable)?;
        let key = (variable.line, variable.name.clone());
        let address = match self.statics.get(&key) {
            Some(&address) => address,
            None => {
                let offset = self.program.constants.len();
                let address = CONSTANTS + u32::try_from(offset).map_err(|_| self.missing("smaller tables"))?;
                let fill = if is_float(&ty) { Constant::Float(0) } else { Constant::Number(0) };
                let mut cells = vec![fill; self.cells(&ty) as usize];
                let parts = variable.initial.as_ref().map(|initial| self.parts(&ty, initial));
                for (offset, ty, item) in parts.unwrap_or_default() {
                    let value = self.value(item)?;
                    let value = self.converted(value, &ty)?;
                    let constant = constant_of(&value).ok_or_else(|| self.missing("a constant initialiser"))?;
                    cells[offset as usize] = constant;
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

    /// The parts of an initialiser that are no lists, each with the offset of its cells.
    pub(super) fn parts(&self, ty: &Type, initial: &'u Expression) -> Vec<(u32, Type, &'u Expression)> {
        let (types, items): (Vec<&Type>, _) = match (ty, &initial.kind) {
            (Array(inner, count), Kind::List(items)) => (vec![inner; *count as usize], items),
            (Struct(number), Kind::List(items)) => {
                (self.unit.structs[*number].members.iter().map(|(_, ty)| ty).collect(), items)
            }
            _ => return vec![(0, ty.clone(), initial)],
        };
        let (mut start, mut parts) = (0, Vec::new());
        for (item, ty) in items.iter().zip(types) {
            let inner = self.parts(ty, item).into_iter();
            parts.extend(inner.map(|(offset, ty, item)| (start + offset, ty, item)));
            start += self.cells(ty);
        }
        parts
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
