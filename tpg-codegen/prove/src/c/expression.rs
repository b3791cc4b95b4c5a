//! Expressions of C, by recursive descent.

use super::parser::Parser;
use super::syntax::{Expression, Kind, Type};
use super::token::Token;
use crate::input::Missing;
use Kind::*;

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

/// The assignment that `++` or `--` is.
fn stepped(sign: &'static str, line: u32, target: Expression) -> Expression {
    let one = Expression { line, kind: Integer(1, Type::INT) };
    Expression { line, kind: Assign(Some(&sign[..1]), Box::new(target), Box::new(one)) }
}

impl Parser<'_> {
    pub(super) fn expression(&mut self) -> Result<Expression, Missing> {
        self.assignment()
    }

    pub(super) fn assignment(&mut self) -> Result<Expression, Missing> {
        const COMPOUND: [&str; 10] = ["+=", "-=", "*=", "/=", "%=", "&=", "|=", "^=", "<<=", ">>="];
        let line = self.line();
        let target = self.conditional()?;
        let Token::Sign(sign) = *self.peek() else { return Ok(target) };
        let operator = if sign == "=" {
            None
        } else if COMPOUND.contains(&sign) {
            Some(&sign[..sign.len() - 1])
        } else {
            return Ok(target);
        };
        self.next();
        let value = self.assignment()?;
        Ok(Expression { line, kind: Assign(operator, Box::new(target), Box::new(value)) })
    }

    pub(super) fn conditional(&mut self) -> Result<Expression, Missing> {
        let line = self.line();
        let condition = self.binary(0)?;
        if !self.accept("?") {
            return Ok(condition);
        }
        let first = self.expression()?;
        self.expect(":")?;
        let second = self.conditional()?;
        let kind = Conditional(Box::new(condition), Box::new(first), Box::new(second));
        Ok(Expression { line, kind })
    }

    fn binary(&mut self, level: usize) -> Result<Expression, Missing> {
        let Some(operators) = LEVELS.get(level) else { return self.unary() };
        let mut left = self.binary(level + 1)?;
        while let Token::Sign(sign) = *self.peek()
            && operators.contains(&sign)
        {
            let line = self.line();
            self.next();
            let right = self.binary(level + 1)?;
            left = Expression { line, kind: Binary(sign, Box::new(left), Box::new(right)) };
        }
        Ok(left)
    }

    fn unary(&mut self) -> Result<Expression, Missing> {
        let line = self.line();
        for sign in ["-", "+", "!", "~", "&", "*"] {
            if self.accept(sign) {
                let inner = Box::new(self.unary()?);
                return Ok(Expression { line, kind: Unary(sign, inner) });
            }
        }
        if let Some(sign) = self.step() {
            let inner = self.unary()?;
            return Ok(stepped(sign, line, inner));
        }
        if self.accept("sizeof") {
            let bracket = *self.peek() == Token::Sign("(");
            self.at += usize::from(bracket);
            if bracket && self.starts_type() {
                let ty = self.type_name()?;
                self.expect(")")?;
                return Ok(Expression { line, kind: SizeOfType(ty) });
            }
            self.at -= usize::from(bracket);
            let inner = Box::new(self.unary()?);
            return Ok(Expression { line, kind: SizeOf(inner) });
        }
        if *self.peek() == Token::Sign("(") {
            self.next();
            if self.starts_type() {
                let ty = self.type_name()?;
                self.expect(")")?;
                let inner = Box::new(self.unary()?);
                return Ok(Expression { line, kind: Cast(ty, inner) });
            }
            let inner = self.expression()?;
            self.expect(")")?;
            return self.postfix(inner);
        }
        let primary = self.primary()?;
        self.postfix(primary)
    }

    fn step(&mut self) -> Option<&'static str> {
        ["++", "--"].into_iter().find(|sign| self.accept(sign))
    }

    fn postfix(&mut self, mut inner: Expression) -> Result<Expression, Missing> {
        loop {
            let line = self.line();
            let kind = if self.accept("[") {
                let index = self.expression()?;
                self.expect("]")?;
                Index(Box::new(inner), Box::new(index))
            } else if self.accept(".") {
                Member(Box::new(inner), self.name()?)
            } else if self.accept("->") {
                let target = Expression { line, kind: Unary("*", Box::new(inner)) };
                Member(Box::new(target), self.name()?)
            } else if let Some(sign) = self.step() {
                Postfix(Box::new(stepped(sign, line, inner)))
            } else {
                return Ok(inner);
            };
            inner = Expression { line, kind };
        }
    }

    fn primary(&mut self) -> Result<Expression, Missing> {
        let line = self.line();
        let kind = match self.next() {
            Token::Number(text) => self.number(&text)?,
            Token::Name(name) if name == "__infinity" => Float(f64::INFINITY, Type::Float),
            Token::Name(name) if name == "__nan" => Float(f64::NAN, Type::Float),
            Token::Name(name) if self.accept("(") => Call(name, self.list(")", Self::assignment)?),
            Token::Name(name) => Name(name),
            other => return Err(self.missing(format!("an expression, found {other:?}"))),
        };
        Ok(Expression { line, kind })
    }

    fn number(&self, text: &str) -> Result<Kind, Missing> {
        let fault = || self.missing(format!("the number {text}"));
        let lower = text.to_ascii_lowercase();
        if !lower.starts_with("0x") && lower.contains(['.', 'e']) {
            return match lower.strip_suffix('f') {
                Some(digits) => {
                    let value: f32 = digits.parse().map_err(|_| fault())?;
                    Ok(Float(f64::from(value), Type::Float))
                }
                None => Ok(Float(lower.parse().map_err(|_| fault())?, Type::Double)),
            };
        }
        let digits = lower.trim_end_matches(['u', 'l']);
        let suffix = &lower[digits.len()..];
        let value = match digits.strip_prefix("0x") {
            Some(digits) => u64::from_str_radix(digits, 16),
            None if digits.len() > 1 && digits.starts_with('0') => u64::from_str_radix(digits, 8),
            None => digits.parse(),
        };
        let value = value.map_err(|_| fault())?;
        let unsigned = suffix.contains('u');
        let long = suffix.contains("ll") || value > u64::from(u32::MAX);
        let ty = if long {
            Type::Integer(8, !unsigned)
        } else if unsigned || value > i32::MAX as u64 && digits.starts_with("0x") {
            Type::UNSIGNED
        } else if value > i32::MAX as u64 {
            Type::Integer(8, true)
        } else {
            Type::INT
        };
        Ok(Integer(value, ty))
    }
}
