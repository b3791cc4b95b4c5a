//! Expressions, by recursive descent. Their side effects are emitted where they are read.

use super::{Compiler, Operand, Type, Typed, apply, number, width};
use crate::c::code::Operation;
use crate::c::token::Token;
use crate::code::{Computed, Expression, Integral, of};
use crate::input::Result;
use crate::term::{Operator::*, Width};
use Operand::*;
use Type::*;

/// Binary operators from the loosest on.
const LEVELS: [&[&str]; 10] = [
    &["||"],
    &["&&"],
    &["|"],
    &["^"],
    &["&"],
    &["==", "!="],
    &["<", ">", "<=", ">="],
    &["<<", ">>"],
    &["+", "-"],
    &["*", "/", "%"],
];

impl Compiler<'_> {
    /// The value of what was read.
    pub(super) fn value(&mut self, operand: Operand) -> Result<Typed> {
        match operand {
            Operand::Value(value, ty) => Ok((value, ty)),
            Place(address, Array(ty, _)) => Ok((address, Pointer(ty))),
            Place(address, ty) => self.loaded(address, ty),
        }
    }

    fn changed(&mut self, address: Expression, ty: Type, sign: &str, by: Typed) -> Result<Operand> {
        let before = self.loaded(address.clone(), ty.clone())?;
        let value = self.operated(sign, before, by)?;
        self.put(address.clone(), value, &ty)?;
        Ok(Place(address, ty))
    }

    fn place(&mut self, operand: Operand) -> Result<Typed> {
        match operand {
            Place(address, ty) => Ok((address, ty)),
            _ => self.refuse("something with an address"),
        }
    }

    pub(super) fn assignment(&mut self) -> Result<Operand> {
        let target = self.conditional()?;
        let Token::Sign(sign) = *self.peek() else { return Ok(target) };
        let Some(operator) = sign.strip_suffix('=').filter(|operator| !["=", "<", ">", "!"].contains(operator)) else {
            return Ok(target);
        };
        self.next();
        let (address, ty) = self.place(target)?;
        let value = self.assignment()?;
        let value = self.value(value)?;
        if operator.is_empty() {
            self.put(address.clone(), value, &ty)?;
            return Ok(Place(address, ty));
        }
        self.changed(address, ty, operator, value)
    }

    pub(super) fn assigned(&mut self) -> Result<Typed> {
        let operand = self.assignment()?;
        self.value(operand)
    }

    pub(super) fn conditional(&mut self) -> Result<Operand> {
        let condition = self.binary(0)?;
        if !self.accept("?") {
            return Ok(condition);
        }
        let condition = self.condition(condition)?;
        // sides with effects lie on two ways, which meet with the value in a cell
        let (mark, cell) = (self.here(), number(self.allocate(&Type::INT)));
        let branch = self.branch(condition.clone());
        let first = self.assigned()?;
        let stored = self.emit(Operation::Return);
        let end = self.jump(self.scopes.len());
        self.expect(":")?;
        self.land(&[branch]);
        let behind = self.here();
        let second = self.conditional()?;
        let second = self.value(second)?;
        let ty = if first.1 == second.1 && !matches!(first.1, Integer(..)) {
            first.1.clone()
        } else {
            self.common(&first.1, &second.1)?
        };
        let (first, second) = (self.converted(first, &ty)?, self.converted(second, &ty)?);
        if stored == mark + 1 && self.here() == behind {
            self.program.operations.truncate(mark);
            return Ok(Operand::Value(of(Computed::If, [condition, first, second]), ty));
        }
        self.program.operations[stored].1 = Operation::Set(cell.clone(), first, ty == Float);
        self.emit(Operation::Set(cell.clone(), second, ty == Float));
        self.land(&[end]);
        self.loaded(cell, ty).map(|(value, ty)| Operand::Value(value, ty))
    }

    fn binary(&mut self, level: usize) -> Result<Operand> {
        let Some(operators) = LEVELS.get(level) else { return self.unary() };
        let mut left = self.binary(level + 1)?;
        while let Token::Sign(sign) = *self.peek()
            && operators.contains(&sign)
        {
            self.next();
            if matches!(sign, "&&" | "||") {
                left = self.logical(sign == "&&", left, level + 1)?;
                continue;
            }
            let left_value = self.value(left)?;
            let right = self.binary(level + 1)?;
            let right = self.value(right)?;
            left = if matches!(level, 5 | 6) {
                Operand::Value(self.compared(sign, left_value, right)?, Type::INT)
            } else {
                let (value, ty) = self.operated(sign, left_value, right)?;
                Operand::Value(value, ty)
            };
        }
        Ok(left)
    }

    fn logical(&mut self, and: bool, first: Operand, level: usize) -> Result<Operand> {
        let first = self.condition(first)?;
        let mark = self.here();
        let second = self.tested(|compiler| compiler.binary(level))?;
        if self.here() != mark {
            return self.refuse("conditions without side effects");
        }
        let parts = if and { [first, second, number(0)] } else { [first, number(1), second] };
        Ok(Operand::Value(of(Computed::If, parts), Type::INT))
    }

    /// What is read as a condition.
    pub(super) fn tested(&mut self, read: impl FnOnce(&mut Self) -> Result<Operand>) -> Result<Expression> {
        let operand = read(self)?;
        self.condition(operand)
    }

    /// What was read as a condition.
    fn condition(&mut self, operand: Operand) -> Result<Expression> {
        match self.value(operand)? {
            (value, ty @ Integer(..)) => Ok(!self.integral(Integral::Same, &ty, [value, number(0)])),
            _ => self.refuse("a condition of another type"),
        }
    }

    fn unary(&mut self) -> Result<Operand> {
        for sign in ["-", "!", "~", "&", "*"] {
            if self.accept(sign) {
                let inner = self.unary()?;
                return self.signed(sign, inner);
            }
        }
        if self.accept("sizeof") {
            let mark = self.here();
            let inner = self.unary()?;
            let (_, ty) = self.place(inner)?;
            self.program.operations.truncate(mark);
            return Ok(Operand::Value(number(self.bytes(&ty)), Type::UNSIGNED));
        }
        if !self.accept("(") {
            let primary = self.primary()?;
            return self.postfix(primary);
        }
        if self.starts_type() {
            let ty = self.type_name()?;
            self.expect(")")?;
            let inner = self.unary()?;
            if ty == Void {
                return Ok(inner);
            }
            let value = self.value(inner)?;
            return Ok(Operand::Value(self.converted(value, &ty)?, ty));
        }
        let inner = self.assignment()?;
        self.expect(")")?;
        self.postfix(inner)
    }

    fn signed(&mut self, sign: &str, inner: Operand) -> Result<Operand> {
        match sign {
            "&" => {
                let (address, ty) = self.place(inner)?;
                return Ok(Operand::Value(address, Pointer(Box::new(ty))));
            }
            "!" => return Ok(Operand::Value(!self.condition(inner)?, Type::INT)),
            _ => {}
        }
        let (value, ty) = self.value(inner)?;
        let value = match (sign, &ty) {
            ("*", Pointer(inner)) => return Ok(Place(value, (**inner).clone())),
            ("*", _) => return self.refuse("a pointer"),
            ("-", Float) => of(Computed::Negative, [value]),
            ("-" | "~", Integer(..)) => {
                let wide = self.promoted(&ty);
                let value = self.converted((value, ty), &wide)?;
                let width = width(&wide);
                let (operator, first) = if sign == "-" { (Subtract, 0) } else { (Xor, width.mask()) };
                let parts = [Expression::Number(first), value];
                return Ok(Operand::Value(self.integral(Integral::Apply(operator), &wide, parts), wide));
            }
            _ => return self.refuse(format!("`{sign}` of another type")),
        };
        Ok(Operand::Value(value, ty))
    }

    fn steps(&mut self) -> Option<&'static str> {
        [("++", "+"), ("--", "-")].into_iter().find(|(sign, _)| self.accept(sign)).map(|(_, sign)| sign)
    }

    fn postfix(&mut self, mut inner: Operand) -> Result<Operand> {
        loop {
            inner = if self.accept("[") {
                let index = self.assigned()?;
                self.expect("]")?;
                self.item(inner, index)?
            } else if self.accept(".") {
                self.member(inner)?
            } else if self.accept("->") {
                let target = self.signed("*", inner)?;
                self.member(target)?
            } else if let Some(sign) = self.steps() {
                // what it was before has no use in generated code
                let (address, ty) = self.place(inner)?;
                self.changed(address, ty, sign, (number(1), Type::INT))?;
                Operand::Value(number(0), Void)
            } else {
                return Ok(inner);
            };
        }
    }

    fn item(&mut self, array: Operand, index: Typed) -> Result<Operand> {
        if !matches!(index.1, Integer(..)) {
            return self.refuse("an integer as index");
        }
        let index = self.converted(index, &Type::UNSIGNED)?;
        let (address, ty, index) = match array {
            Place(address, Array(ty, count)) => (address, ty, of(Computed::Bounded(count), [index])),
            array => match self.value(array)? {
                (address, Pointer(ty)) => (address, ty, index),
                _ => return self.refuse("an array"),
            },
        };
        Ok(Place(self.element(address, &ty, index), *ty))
    }

    /// The address of a later element of a type.
    pub(super) fn element(&self, address: Expression, ty: &Type, index: Expression) -> Expression {
        of(Computed::Moved, [address, apply(Multiply, Width::W32, index, number(self.cells(ty)))])
    }

    fn member(&mut self, structure: Operand) -> Result<Operand> {
        let name = self.name()?;
        let (address, Struct(structure)) = self.place(structure)? else { return self.refuse("a structure") };
        let mut offset = 0;
        for (member, ty) in &self.structs[structure] {
            if *member == name {
                return Ok(Place(of(Computed::Moved, [address, number(offset)]), ty.clone()));
            }
            offset += self.cells(ty);
        }
        self.refuse(format!("the member `{name}`"))
    }

    fn primary(&mut self) -> Result<Operand> {
        let (value, ty) = match self.next() {
            Token::Number(text) => self.number(&text)?,
            Token::Name(name) if self.accept("(") => return self.call(&name),
            Token::Name(name) => match (self.find(&name), self.constants.get(&name)) {
                (Some((address, ty)), _) => return Ok(Place(address.clone(), ty.clone())),
                (None, Some(&value)) => (number(value as u32), Type::INT),
                (None, None) => return self.refuse(format!("the name `{name}`")),
            },
            other => return self.refuse(format!("an expression, found {other:?}")),
        };
        Ok(Operand::Value(value, ty))
    }

    fn call(&mut self, name: &str) -> Result<Operand> {
        let known = matches!(name, "memcpy" | "fabsf" | "sqrtf" | "INT64_C");
        let function = if known { None } else { Some(self.function(name)?) };
        let mut arguments = self.list(")", Self::assigned)?;
        let Some(function) = function else {
            if name == "memcpy" {
                return self.copy(arguments);
            }
            let (Some(value), true) = (arguments.pop(), arguments.is_empty()) else {
                return self.refuse(format!("`{name}` of one argument"));
            };
            if name == "INT64_C" {
                return Ok(Operand::Value(self.converted(value, &Integer(8, true))?, Integer(8, true)));
            }
            let value = self.converted(value, &Float)?;
            let computed = if name == "fabsf" { Computed::Magnitude } else { Computed::Root };
            return Ok(Operand::Value(of(computed, [value]), Float));
        };
        Ok(match self.inlined(&function, arguments)? {
            Some((address, ty)) => Place(address, ty),
            None => Operand::Value(number(0), Void),
        })
    }

    /// `memcpy` of whole scalars of 4 bytes.
    fn copy(&mut self, arguments: Vec<Typed>) -> Result<Operand> {
        let [(to, Pointer(to_type)), (from, Pointer(from_type)), (size, _)] = &arguments[..] else {
            return self.refuse("memcpy of two pointers and a size");
        };
        let size = self.constant_of(size).filter(|size| size % 4 == 0);
        let (Some(size), Some(is_float), Some(_)) = (size, self.words(to_type), self.words(from_type)) else {
            return self.refuse("memcpy of scalars of 4 bytes");
        };
        for at in 0..size / 4 {
            let cell = |address: &Expression| of(Computed::Moved, [address.clone(), Expression::Number(at)]);
            self.emit(Operation::Set(cell(to), of(Computed::Loaded(4), [cell(from)]), is_float));
        }
        Ok(Operand::Value(number(0), Void))
    }

    fn number(&self, text: &str) -> Result<Typed> {
        let fault = || self.missing(format!("the number {text}"));
        let lower = text.to_ascii_lowercase();
        if !lower.starts_with("0x") && lower.contains(['.', 'e']) {
            let Some(digits) = lower.strip_suffix('f') else { return self.refuse("arithmetic in binary64") };
            let value: f32 = digits.parse().map_err(|_| fault())?;
            return Ok((Expression::Float(value.to_bits()), Float));
        }
        let digits = lower.trim_end_matches(['u', 'l']);
        let suffix = &lower[digits.len()..];
        let value = match digits.strip_prefix("0x") {
            Some(digits) => u64::from_str_radix(digits, 16),
            None if digits.len() > 1 && digits.starts_with('0') => return Err(fault()),
            None => digits.parse(),
        };
        let value = value.map_err(|_| fault())?;
        let ty = match suffix {
            "" if value <= i16::MAX as u64 => Integer(self.int(), true),
            "" if value <= i32::MAX as u64 => Type::INT,
            "" if value <= i64::MAX as u64 => Integer(8, true),
            "u" if value <= u64::from(u16::MAX) => Integer(self.int(), false),
            "u" if value <= u64::from(u32::MAX) => Type::UNSIGNED,
            "ull" => Integer(8, false),
            _ => return Err(fault()),
        };
        Ok((Expression::Number(value), ty))
    }
}
