//! Declarations: types, names, functions, variables with their initial values.

use super::{Compiler, Function, Operand, Type, number};
use crate::c::token::Token::{Name, Sign};
use crate::input::Result;
use Type::*;
use std::rc::Rc;

/// Words before a type that change no result, and those that say where something is.
const QUALIFIERS: &str = "const volatile inline register restrict __inline";
const STORAGE: &str = "static extern typedef";

fn is_one(words: &str, word: &str) -> bool {
    words.split(' ').any(|one| one == word)
}

impl Compiler<'_> {
    pub(super) fn starts_type(&self) -> bool {
        let starts = |word| is_one(QUALIFIERS, word) || is_one(STORAGE, word) || is_one("struct enum", word);
        matches!(self.peek(), Name(name) if starts(name) || self.types.contains_key(name))
    }

    /// Reads what stands before declarators: a type of one word, and the last word of storage.
    fn specifiers(&mut self) -> Result<(Type, String)> {
        let (mut ty, mut storage) = (None, String::new());
        let mut is_volatile = false;
        self.is_constant = false;
        while let Name(word) = self.peek().clone() {
            match self.types.get(&word) {
                Some(known) if ty.is_none() => ty = Some(known.clone()),
                _ if is_one(STORAGE, &word) => storage.clone_from(&word),
                _ if is_one("struct enum", &word) || is_one(QUALIFIERS, &word) => {}
                _ => break,
            }
            self.next();
            is_volatile |= word == "volatile";
            self.is_constant = !is_volatile && (self.is_constant || word == "const");
            match word.as_str() {
                "struct" => ty = Some(self.structure()?),
                "enum" => ty = Some(self.enumeration()?),
                _ => {}
            }
        }
        match ty {
            Some(ty) => Ok((ty, storage)),
            None => {
                let found = self.next();
                self.refuse(format!("a type, found {found:?}"))
            }
        }
    }

    fn structure(&mut self) -> Result<Type> {
        let tag = if let Name(_) = self.peek() { self.name()? } else { format!("at {}", self.at) };
        let number = *self.tags.entry(tag).or_insert(self.structs.len());
        if number == self.structs.len() {
            self.structs.push(Vec::new());
        }
        if self.accept("{") {
            let mut members = Vec::new();
            while !self.accept("}") {
                let (ty, _) = self.specifiers()?;
                members.extend(self.list(";", |compiler| compiler.declarator(ty.clone()))?);
            }
            self.structs[number] = members;
        }
        Ok(Type::Struct(number))
    }

    fn enumeration(&mut self) -> Result<Type> {
        if let Name(_) = self.peek() {
            self.next();
        }
        if self.accept("{") {
            let mut next = 0;
            self.list("}", |compiler| {
                let name = compiler.name()?;
                if compiler.accept("=") {
                    next = compiler.constant()?;
                }
                compiler.constants.insert(name, next);
                next += 1;
                Ok(())
            })?;
        }
        Ok(Type::UNSIGNED)
    }

    /// The value of a constant expression.
    pub(super) fn constant(&mut self) -> Result<i64> {
        let value = self.conditional()?;
        match self.value(value)? {
            (value, Integer(bytes, signed)) => match self.constant_of(&value) {
                Some(number) if signed && bytes < 8 => Ok(i64::from(number as u32 as i32)),
                Some(number) => Ok(number as i64),
                None => self.refuse("a constant"),
            },
            _ => self.refuse("a constant"),
        }
    }

    /// A name with the type that stars, brackets and parameters around it make.
    fn declarator(&mut self, mut ty: Type) -> Result<(String, Type)> {
        loop {
            if self.accept("*") {
                ty = Pointer(Box::new(ty));
            } else if !(self.accept("const") || self.accept("volatile") || self.accept("restrict")) {
                break;
            }
        }
        let name = if let Name(_) = self.peek() { self.name()? } else { String::new() };
        Ok((name, self.brackets(ty)?))
    }

    fn brackets(&mut self, ty: Type) -> Result<Type> {
        if !self.accept("[") {
            return Ok(ty);
        }
        // as many as are written
        let count = if *self.peek() == Sign("]") { 0 } else { self.constant()? };
        let count = u32::try_from(count).map_err(|_| self.missing("a length"))?;
        self.expect("]")?;
        Ok(Array(Box::new(self.brackets(ty)?), count))
    }

    pub(super) fn type_name(&mut self) -> Result<Type> {
        let (ty, _) = self.specifiers()?;
        let (name, ty) = self.declarator(ty)?;
        if name.is_empty() { Ok(ty) } else { self.refuse("a type without a name") }
    }

    pub(super) fn external(&mut self) -> Result<()> {
        let (ty, storage) = self.specifiers()?;
        if self.accept(";") {
            return Ok(());
        }
        let (name, ty) = self.declarator(ty)?;
        if storage == "typedef" {
            self.types.insert(name, ty);
            return self.expect(";");
        }
        if *self.peek() == Sign("=") {
            self.constants_only(&ty)?;
            self.variable(name, ty, true)?;
            return self.expect(";");
        }
        self.expect("(")?;
        let parameters = self.parameters()?;
        if !self.accept("{") {
            return self.expect(";");
        }
        self.functions.push(Rc::new(Function { name, result: ty, parameters, body: self.at }));
        self.skip("{", "}")
    }

    fn parameters(&mut self) -> Result<Vec<(String, Type)>> {
        let mut parameters = self.list(")", |compiler| {
            let ty = compiler.specifiers()?.0;
            let (name, ty) = compiler.declarator(ty)?;
            Ok((name, if let Array(ty, _) = ty { Pointer(ty) } else { ty }))
        })?;
        parameters.retain(|(_, ty)| *ty != Void);
        Ok(parameters)
    }

    /// Declares the variables of a statement.
    pub(super) fn declaration(&mut self) -> Result<()> {
        let (ty, storage) = self.specifiers()?;
        let variable = |compiler: &mut Self| {
            let (name, ty) = compiler.declarator(ty.clone())?;
            if storage == "static" {
                compiler.constants_only(&ty)?;
            }
            compiler.variable(name, ty, storage == "static")
        };
        self.list(";", variable).map(|_| ())
    }

    /// Refuses a variable that keeps a value from one call to the next.
    fn constants_only(&self, ty: &Type) -> Result<()> {
        let is_constant = self.is_constant && !matches!(ty, Pointer(_));
        if is_constant { Ok(()) } else { self.refuse("a constant: other static variables may change") }
    }

    /// Declares a variable, whose initial value may follow. A static one is a constant.
    fn variable(&mut self, name: String, mut ty: Type, is_static: bool) -> Result<()> {
        let mut parts = Vec::new();
        let has_value = self.accept("=");
        if has_value {
            self.parts(&ty, 0, &mut parts)?;
        }
        if let Array(item, count @ 0) = &mut ty {
            if self.cells(item) != 1 {
                return self.refuse("a length");
            }
            *count = parts.len() as u32;
        }
        if is_static {
            let place = self.fixed(ty, parts)?;
            self.bind(name, place);
            return Ok(());
        }
        let address = self.allocate(&ty);
        if has_value && parts.iter().map(|(_, ty, _)| self.cells(ty)).sum::<u32>() != self.cells(&ty) {
            return self.refuse("an initialiser for each part");
        }
        for (offset, ty, item) in parts {
            let value = self.value(item)?;
            self.put(number(address + offset), value, &ty)?;
        }
        self.bind(name, (number(address), ty));
        Ok(())
    }

    /// Reads the parts of an initialiser that are no lists, each with the offset of its cells.
    fn parts(&mut self, ty: &Type, start: u32, parts: &mut Vec<(u32, Type, Operand)>) -> Result<()> {
        if !self.accept("{") {
            let value = self.assignment()?;
            parts.push((start, ty.clone(), value));
            return Ok(());
        }
        let Array(inner, count) = ty else { return self.refuse("an array of the items") };
        let mut offset = start;
        self.list("}", |compiler| {
            if *count > 0 && offset == start + compiler.cells(ty) {
                return compiler.refuse(format!("{count} items"));
            }
            compiler.parts(inner, offset, parts)?;
            offset += compiler.cells(inner);
            Ok(())
        })?;
        Ok(())
    }
}
