//! A parser of declarations and statements of C, by recursive descent.

use super::parser::Parser;
use super::syntax::{Expression, Function, Kind, Statement, StatementKind, Struct, Type, Unit, Variable};
use super::token::{Placed, Token::*};
use crate::input::Missing;
use StatementKind::*;
use Type::*;
use std::collections::HashMap;

/// What stands before declarators.
struct Specifiers {
    ty: Type,
    is_static: bool,
    is_typedef: bool,
    is_extern: bool,
}

/// Parses a file.
pub(super) fn parse(file: &str, tokens: Vec<Placed>) -> Result<Unit, Missing> {
    let mut parser = parser(file, tokens);
    while *parser.peek() != End {
        parser.external()?;
    }
    Ok(parser.unit)
}

/// The value of a constant expression.
pub(super) fn constant(file: &str, tokens: Vec<Placed>) -> Result<i64, Missing> {
    let mut parser = parser(file, tokens);
    let value = parser.conditional()?;
    if *parser.peek() == End { parser.constant(&value) } else { Err(parser.missing("an operator")) }
}

fn parser(file: &str, tokens: Vec<Placed>) -> Parser<'_> {
    let mut types = HashMap::new();
    for (bytes, bits) in [(1, 8), (2, 16), (4, 32), (8, 64)] {
        types.insert(format!("int{bits}_t"), Integer(bytes, true));
        types.insert(format!("uint{bits}_t"), Integer(bytes, false));
    }
    types.insert("size_t".to_owned(), Type::UNSIGNED);
    Parser { file, tokens, at: 0, unit: Unit::default(), types, tags: HashMap::new() }
}

impl Parser<'_> {
    pub(super) fn starts_type(&self) -> bool {
        const QUALIFIERS: &str = "const volatile static inline extern typedef struct union enum";
        const TYPES: &str = "void float double int unsigned signed char short";
        let is_word = |name: &String| QUALIFIERS.split(' ').chain(TYPES.split(' ')).any(|word| word == name);
        matches!(self.peek(), Name(name) if is_word(name) || self.types.contains_key(name))
    }

    fn specifiers(&mut self) -> Result<Specifiers, Missing> {
        let mut found = Specifiers { ty: Void, is_static: false, is_typedef: false, is_extern: false };
        let (mut ty, mut signed) = (None, None);
        loop {
            self.attributes()?;
            let Name(word) = self.peek().clone() else { break };
            match word.as_str() {
                "const" | "volatile" | "inline" | "register" | "restrict" | "__inline" => {}
                "static" => found.is_static = true,
                "extern" => found.is_extern = true,
                "typedef" => found.is_typedef = true,
                "void" => ty = Some(Void),
                "float" => ty = Some(Float),
                "double" => ty = Some(Double),
                "char" => ty = Some(Integer(1, false)),
                "short" => ty = Some(Integer(2, true)),
                "int" => ty = ty.or(Some(Type::INT)),
                "unsigned" => signed = Some(false),
                "signed" => signed = Some(true),
                "struct" | "union" => {
                    self.next();
                    ty = Some(self.structure(word == "union")?);
                    continue;
                }
                "enum" => {
                    self.next();
                    ty = Some(self.enumeration()?);
                    continue;
                }
                _ if ty.is_none() && signed.is_none() && self.types.contains_key(&word) => {
                    ty = self.types.get(&word).cloned();
                }
                _ => break,
            }
            self.next();
        }
        found.ty = match (ty, signed) {
            (None, Some(signed)) => Integer(4, signed),
            (Some(Integer(bytes, _)), Some(signed)) => Integer(bytes, signed),
            (Some(ty), None) => ty,
            _ => return Err(self.missing(format!("a type, found {:?}", self.peek()))),
        };
        Ok(found)
    }

    fn structure(&mut self, union: bool) -> Result<Type, Missing> {
        let tag = if let Name(tag) = self.peek().clone() {
            self.next();
            tag
        } else {
            format!("{} on line {}", if union { "union" } else { "struct" }, self.line())
        };
        let number = *self.tags.entry(tag).or_insert_with(|| {
            self.unit.structs.push(Struct::default());
            self.unit.structs.len() - 1
        });
        if self.accept("{") {
            let mut members = Vec::new();
            while !self.accept("}") {
                let ty = self.specifiers()?.ty;
                members.extend(self.list(";", |parser| parser.declarator(ty.clone()))?);
            }
            self.unit.structs[number] = Struct { union, members };
        }
        Ok(Type::Struct(number))
    }

    fn enumeration(&mut self) -> Result<Type, Missing> {
        if let Name(_) = self.peek() {
            self.next();
        }
        if self.accept("{") {
            let mut next = 0;
            self.list("}", |parser| {
                let name = parser.name()?;
                if parser.accept("=") {
                    let value = parser.conditional()?;
                    next = parser.constant(&value)?;
                }
                parser.unit.constants.insert(name, next);
                next += 1;
                Ok(())
            })?;
        }
        Ok(Type::UNSIGNED)
    }

    fn constant(&self, value: &Expression) -> Result<i64, Missing> {
        let binary = |a: i64, operator: &str, b: i64| match operator {
            "+" => a.checked_add(b),
            "-" => a.checked_sub(b),
            "*" => a.checked_mul(b),
            "||" => Some(i64::from(a != 0 || b != 0)),
            "&&" => Some(i64::from(a != 0 && b != 0)),
            "==" => Some(i64::from(a == b)),
            "!=" => Some(i64::from(a != b)),
            "<" => Some(i64::from(a < b)),
            ">" => Some(i64::from(a > b)),
            "<=" => Some(i64::from(a <= b)),
            ">=" => Some(i64::from(a >= b)),
            _ => None,
        };
        let found = match &value.kind {
            Kind::Integer(number, _) => i64::try_from(*number).ok(),
            Kind::Name(name) => self.unit.constants.get(name).copied(),
            Kind::Cast(Integer(..), inner) => Some(self.constant(inner)?),
            Kind::Unary("!", inner) => Some(i64::from(self.constant(inner)? == 0)),
            Kind::Unary("-", inner) => self.constant(inner)?.checked_neg(),
            Kind::Binary(operator, a, b) => binary(self.constant(a)?, operator, self.constant(b)?),
            _ => None,
        };
        found.ok_or_else(|| self.missing("a constant"))
    }

    /// A name with the type that stars, brackets and parameters around it make.
    fn declarator(&mut self, mut ty: Type) -> Result<(String, Type), Missing> {
        loop {
            self.attributes()?;
            if self.accept("*") {
                ty = Pointer(Box::new(ty));
            } else if !(self.accept("const") || self.accept("volatile") || self.accept("restrict")) {
                break;
            }
        }
        let name = if let Name(_) = self.peek() { self.name()? } else { String::new() };
        Ok((name, self.brackets(ty)?))
    }

    fn brackets(&mut self, ty: Type) -> Result<Type, Missing> {
        if !self.accept("[") {
            return Ok(ty);
        }
        if self.accept("]") {
            // as many as are written
            return Ok(Array(Box::new(self.brackets(ty)?), 0));
        }
        let count = self.conditional()?;
        let count = u32::try_from(self.constant(&count)?).map_err(|_| self.missing("a length"))?;
        self.expect("]")?;
        Ok(Array(Box::new(self.brackets(ty)?), count))
    }

    pub(super) fn type_name(&mut self) -> Result<Type, Missing> {
        let ty = self.specifiers()?.ty;
        let (name, ty) = self.declarator(ty)?;
        if name.is_empty() { Ok(ty) } else { Err(self.missing("a type without a name")) }
    }

    fn external(&mut self) -> Result<(), Missing> {
        if self.accept(";") {
            return Ok(());
        }
        let specifiers = self.specifiers()?;
        if self.accept(";") {
            return Ok(());
        }
        loop {
            let line = self.line();
            let (name, ty) = self.declarator(specifiers.ty.clone())?;
            if specifiers.is_typedef {
                self.types.insert(name, ty);
            } else if self.accept("(") {
                let parameters = self.parameters()?;
                self.attributes()?;
                if self.accept("{") {
                    let body = self.block()?;
                    self.unit.functions.push(Function { name, result: ty, parameters, body });
                    return Ok(());
                }
            } else {
                let initial = if self.accept("=") { Some(self.initialiser()?) } else { None };
                if !specifiers.is_extern {
                    self.unit.variables.push(Variable { line, name, ty, is_static: true, initial });
                }
            }
            if self.accept(";") {
                return Ok(());
            }
            self.expect(",")?;
        }
    }

    fn parameters(&mut self) -> Result<Vec<(String, Type)>, Missing> {
        let mut parameters = self.list(")", |parser| {
            let ty = parser.specifiers()?.ty;
            let (name, ty) = parser.declarator(ty)?;
            Ok((name, if let Array(ty, _) = ty { Pointer(ty) } else { ty }))
        })?;
        parameters.retain(|(_, ty)| *ty != Void);
        Ok(parameters)
    }

    fn block(&mut self) -> Result<Vec<Statement>, Missing> {
        let mut statements = Vec::new();
        while !self.accept("}") {
            statements.push(self.statement()?);
        }
        Ok(statements)
    }

    fn declaration(&mut self) -> Result<Vec<Variable>, Missing> {
        let specifiers = self.specifiers()?;
        self.list(";", |parser| {
            let line = parser.line();
            let (name, ty) = parser.declarator(specifiers.ty.clone())?;
            let initial = if parser.accept("=") { Some(parser.initialiser()?) } else { None };
            Ok(Variable { line, name, ty, is_static: specifiers.is_static, initial })
        })
    }

    pub(super) fn initialiser(&mut self) -> Result<Expression, Missing> {
        let line = self.line();
        if !self.accept("{") {
            return self.assignment();
        }
        Ok(Expression { line, kind: Kind::List(self.list("}", Self::initialiser)?) })
    }

    fn statement(&mut self) -> Result<Statement, Missing> {
        let line = self.line();
        let kind = self.statement_kind()?;
        Ok(Statement { line, kind })
    }

    fn statement_kind(&mut self) -> Result<StatementKind, Missing> {
        if self.accept(";") {
            return Ok(Empty);
        }
        if self.accept("{") {
            return Ok(Block(self.block()?));
        }
        if self.starts_type() {
            return Ok(Declare(self.declaration()?));
        }
        if let (Name(name), Sign(":")) = (self.peek().clone(), &self.tokens[self.at + 1].token)
            && name != "default"
        {
            self.at += 2;
            return Ok(Label(name));
        }
        let Name(word) = self.peek().clone() else { return self.evaluated() };
        self.next();
        match word.as_str() {
            "if" => {
                let condition = self.bracketed()?;
                let first = Box::new(self.statement()?);
                let second = if self.accept("else") { Some(Box::new(self.statement()?)) } else { None };
                Ok(If(condition, first, second))
            }
            "while" => {
                let condition = self.bracketed()?;
                Ok(Loop(None, Some(condition), None, Box::new(self.statement()?), false))
            }
            "do" => {
                let body = Box::new(self.statement()?);
                self.expect("while")?;
                let condition = self.bracketed()?;
                self.expect(";")?;
                Ok(Loop(None, Some(condition), None, body, true))
            }
            "for" => {
                self.expect("(")?;
                let first = Box::new(self.statement()?);
                let condition = if self.accept(";") {
                    None
                } else {
                    let condition = self.expression()?;
                    self.expect(";")?;
                    Some(condition)
                };
                let step = if *self.peek() == Sign(")") { None } else { Some(self.expression()?) };
                self.expect(")")?;
                Ok(Loop(Some(first), condition, step, Box::new(self.statement()?), false))
            }
            "switch" => {
                let value = self.bracketed()?;
                Ok(Switch(value, Box::new(self.statement()?)))
            }
            "case" => {
                let value = self.conditional()?;
                self.expect(":")?;
                Ok(Case(Some(value)))
            }
            "default" => {
                self.expect(":")?;
                Ok(Case(None))
            }
            "break" | "continue" => {
                self.expect(";")?;
                Ok(if word == "break" { Break } else { Continue })
            }
            "goto" => {
                let label = self.name()?;
                self.expect(";")?;
                Ok(Goto(label))
            }
            "return" => {
                if self.accept(";") {
                    return Ok(Return(None));
                }
                let value = self.expression()?;
                self.expect(";")?;
                Ok(Return(Some(value)))
            }
            _ => {
                self.at -= 1;
                self.evaluated()
            }
        }
    }

    fn evaluated(&mut self) -> Result<StatementKind, Missing> {
        let expression = self.expression()?;
        self.expect(";")?;
        Ok(Evaluate(expression))
    }

    pub(super) fn bracketed(&mut self) -> Result<Expression, Missing> {
        self.expect("(")?;
        let inner = self.expression()?;
        self.expect(")")?;
        Ok(inner)
    }
}
