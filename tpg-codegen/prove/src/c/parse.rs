//! A parser of the subset of C, by recursive descent.

use super::syntax::{Expression, Function, Kind, Statement, StatementKind, Struct, Type, Unit, Variable};
use super::token::{Placed, Token};
use crate::machine::Missing;
use std::collections::HashMap;

struct Parser<'a> {
    file: &'a str,
    tokens: Vec<Placed>,
    at: usize,
    unit: Unit,
    types: HashMap<String, Type>,
    tags: HashMap<String, usize>,
}

/// What stands before declarators.
struct Specifiers {
    of: Type,
    is_static: bool,
    is_typedef: bool,
    is_extern: bool,
}

/// Parses a file.
pub(super) fn parse(file: &str, tokens: Vec<Placed>) -> Result<Unit, Missing> {
    let mut types = HashMap::new();
    for (bytes, bits) in [(1, 8), (2, 16), (4, 32), (8, 64)] {
        types.insert(format!("int{bits}_t"), Type::Integer(bytes, true));
        types.insert(format!("uint{bits}_t"), Type::Integer(bytes, false));
    }
    types.insert("size_t".to_owned(), Type::UNSIGNED);
    let mut parser = Parser { file, tokens, at: 0, unit: Unit::default(), types, tags: HashMap::new() };
    while *parser.peek() != Token::End {
        parser.external()?;
    }
    Ok(parser.unit)
}

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

impl Parser<'_> {
    fn peek(&self) -> &Token {
        &self.tokens[self.at].token
    }

    fn line(&self) -> u32 {
        self.tokens[self.at].line
    }

    fn next(&mut self) -> Token {
        let token = self.tokens[self.at].token.clone();
        self.at = (self.at + 1).min(self.tokens.len() - 1);
        token
    }

    fn missing(&self, what: impl Into<String>) -> Missing {
        Missing::new(format!("{}:{}", self.file, self.line()), what)
    }

    fn accept(&mut self, sign: &str) -> bool {
        let is = matches!(self.peek(), Token::Sign(found) if *found == sign);
        if is {
            self.next();
        }
        is
    }

    fn accept_word(&mut self, word: &str) -> bool {
        let is = matches!(self.peek(), Token::Name(found) if found == word);
        if is {
            self.next();
        }
        is
    }

    fn expect(&mut self, sign: &str) -> Result<(), Missing> {
        if self.accept(sign) { Ok(()) } else { Err(self.missing(format!("`{sign}`, found {:?}", self.peek()))) }
    }

    fn name(&mut self) -> Result<String, Missing> {
        match self.next() {
            Token::Name(name) => Ok(name),
            other => Err(self.missing(format!("a name, found {other:?}"))),
        }
    }

    /// Skips `__attribute__((...))` and the like; they ask for no other results.
    fn attributes(&mut self) -> Result<(), Missing> {
        while self.accept_word("__attribute__") {
            let mut depth = 0;
            loop {
                match self.next() {
                    Token::Sign("(") => depth += 1,
                    Token::Sign(")") => depth -= 1,
                    Token::End => return Err(self.missing("`)`")),
                    _ => {}
                }
                if depth == 0 {
                    break;
                }
            }
        }
        Ok(())
    }

    fn starts_type(&self) -> bool {
        const WORDS: [&str; 17] = [
            "const", "volatile", "static", "inline", "extern", "typedef", "struct", "union", "enum", "void", "float",
            "double", "int", "unsigned", "signed", "char", "short",
        ];
        matches!(self.peek(), Token::Name(name) if WORDS.contains(&name.as_str()) || self.types.contains_key(name))
    }

    fn specifiers(&mut self) -> Result<Specifiers, Missing> {
        let mut found = Specifiers { of: Type::Void, is_static: false, is_typedef: false, is_extern: false };
        let (mut of, mut signed) = (None, None);
        loop {
            self.attributes()?;
            let Token::Name(word) = self.peek().clone() else { break };
            match word.as_str() {
                "const" | "volatile" | "inline" | "register" | "restrict" | "__inline" => {}
                "static" => found.is_static = true,
                "extern" => found.is_extern = true,
                "typedef" => found.is_typedef = true,
                "void" => of = Some(Type::Void),
                "float" => of = Some(Type::Float),
                "double" => of = Some(Type::Double),
                "char" => of = Some(Type::Integer(1, false)),
                "short" => of = Some(Type::Integer(2, true)),
                "int" => of = of.or(Some(Type::INT)),
                "unsigned" => signed = Some(false),
                "signed" => signed = Some(true),
                "struct" | "union" => {
                    self.next();
                    of = Some(self.structure(word == "union")?);
                    continue;
                }
                "enum" => {
                    self.next();
                    of = Some(self.enumeration()?);
                    continue;
                }
                _ if of.is_none() && signed.is_none() && self.types.contains_key(&word) => {
                    of = self.types.get(&word).cloned();
                }
                _ => break,
            }
            self.next();
        }
        found.of = match (of, signed) {
            (None, Some(signed)) => Type::Integer(4, signed),
            (Some(Type::Integer(bytes, _)), Some(signed)) => Type::Integer(bytes, signed),
            (Some(of), None) => of,
            _ => return Err(self.missing(format!("a type, found {:?}", self.peek()))),
        };
        Ok(found)
    }

    fn structure(&mut self, union: bool) -> Result<Type, Missing> {
        let tag = if let Token::Name(tag) = self.peek().clone() {
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
                let of = self.specifiers()?.of;
                loop {
                    let (name, of) = self.declarator(of.clone())?;
                    members.push((name, of));
                    if !self.accept(",") {
                        break;
                    }
                }
                self.expect(";")?;
            }
            self.unit.structs[number] = Struct { union, members };
        }
        Ok(Type::Struct(number))
    }

    fn enumeration(&mut self) -> Result<Type, Missing> {
        if let Token::Name(_) = self.peek() {
            self.next();
        }
        if self.accept("{") {
            let mut next = 0;
            while !self.accept("}") {
                let name = self.name()?;
                if self.accept("=") {
                    let value = self.conditional()?;
                    next = self.constant(&value)?;
                }
                self.unit.constants.insert(name, next);
                next += 1;
                if !self.accept(",") {
                    self.expect("}")?;
                    break;
                }
            }
        }
        Ok(Type::UNSIGNED)
    }

    fn constant(&self, value: &Expression) -> Result<i64, Missing> {
        let binary = |a: i64, operator: &str, b: i64| match operator {
            "+" => a.checked_add(b),
            "-" => a.checked_sub(b),
            "*" => a.checked_mul(b),
            _ => None,
        };
        let found = match &value.kind {
            Kind::Integer(number, _) => i64::try_from(*number).ok(),
            Kind::Name(name) => self.unit.constants.get(name).copied(),
            Kind::Cast(Type::Integer(..), inner) => Some(self.constant(inner)?),
            Kind::Unary("-", inner) => self.constant(inner)?.checked_neg(),
            Kind::Binary(operator, a, b) => binary(self.constant(a)?, operator, self.constant(b)?),
            _ => None,
        };
        found.ok_or_else(|| self.missing("a constant"))
    }

    /// A name with the type that stars, brackets and parameters around it make.
    fn declarator(&mut self, mut of: Type) -> Result<(String, Type), Missing> {
        loop {
            self.attributes()?;
            if self.accept("*") {
                of = Type::Pointer(Box::new(of));
            } else if !(self.accept_word("const") || self.accept_word("volatile") || self.accept_word("restrict")) {
                break;
            }
        }
        let name = if let Token::Name(_) = self.peek() { self.name()? } else { String::new() };
        Ok((name, self.brackets(of)?))
    }

    fn brackets(&mut self, of: Type) -> Result<Type, Missing> {
        if !self.accept("[") {
            return Ok(of);
        }
        if self.accept("]") {
            // as many as are written
            return Ok(Type::Array(Box::new(self.brackets(of)?), 0));
        }
        let count = self.conditional()?;
        let count = u32::try_from(self.constant(&count)?).map_err(|_| self.missing("a length"))?;
        self.expect("]")?;
        Ok(Type::Array(Box::new(self.brackets(of)?), count))
    }

    fn type_name(&mut self) -> Result<Type, Missing> {
        let of = self.specifiers()?.of;
        let (name, of) = self.declarator(of)?;
        if name.is_empty() { Ok(of) } else { Err(self.missing("a type without a name")) }
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
            let (name, of) = self.declarator(specifiers.of.clone())?;
            if specifiers.is_typedef {
                self.types.insert(name, of);
            } else if self.accept("(") {
                let parameters = self.parameters()?;
                self.attributes()?;
                if self.accept("{") {
                    let body = self.block()?;
                    self.unit.functions.push(Function { name, result: of, parameters, body });
                    return Ok(());
                }
            } else {
                let initial = if self.accept("=") { Some(self.initialiser()?) } else { None };
                if !specifiers.is_extern {
                    self.unit.variables.push(Variable { line, name, of, is_static: true, initial });
                }
            }
            if self.accept(";") {
                return Ok(());
            }
            self.expect(",")?;
        }
    }

    fn parameters(&mut self) -> Result<Vec<(String, Type)>, Missing> {
        let mut parameters = Vec::new();
        if self.accept(")") {
            return Ok(parameters);
        }
        loop {
            let of = self.specifiers()?.of;
            let (name, of) = self.declarator(of)?;
            match of {
                Type::Void => {}
                Type::Array(of, _) => parameters.push((name, Type::Pointer(of))),
                of => parameters.push((name, of)),
            }
            if self.accept(")") {
                return Ok(parameters);
            }
            self.expect(",")?;
        }
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
        let mut variables = Vec::new();
        while !self.accept(";") {
            let line = self.line();
            let (name, of) = self.declarator(specifiers.of.clone())?;
            let initial = if self.accept("=") { Some(self.initialiser()?) } else { None };
            variables.push(Variable { line, name, of, is_static: specifiers.is_static, initial });
            if !self.accept(",") {
                self.expect(";")?;
                break;
            }
        }
        Ok(variables)
    }

    fn initialiser(&mut self) -> Result<Expression, Missing> {
        let line = self.line();
        if !self.accept("{") {
            return self.assignment();
        }
        let mut items = Vec::new();
        while !self.accept("}") {
            items.push(self.initialiser()?);
            if !self.accept(",") {
                self.expect("}")?;
                break;
            }
        }
        Ok(Expression { line, kind: Kind::List(items) })
    }

    fn statement(&mut self) -> Result<Statement, Missing> {
        let line = self.line();
        let kind = self.statement_kind()?;
        Ok(Statement { line, kind })
    }

    fn statement_kind(&mut self) -> Result<StatementKind, Missing> {
        if self.accept(";") {
            return Ok(StatementKind::Empty);
        }
        if self.accept("{") {
            return Ok(StatementKind::Block(self.block()?));
        }
        if self.starts_type() {
            return Ok(StatementKind::Declare(self.declaration()?));
        }
        if let (Token::Name(name), Token::Sign(":")) = (self.peek().clone(), &self.tokens[self.at + 1].token)
            && name != "default"
        {
            self.at += 2;
            return Ok(StatementKind::Label(name));
        }
        let Token::Name(word) = self.peek().clone() else { return self.evaluated() };
        match word.as_str() {
            "if" => {
                self.next();
                let condition = self.bracketed()?;
                let first = Box::new(self.statement()?);
                let second = if self.accept_word("else") { Some(Box::new(self.statement()?)) } else { None };
                Ok(StatementKind::If(condition, first, second))
            }
            "while" => {
                self.next();
                let condition = self.bracketed()?;
                Ok(StatementKind::Loop(None, Some(condition), None, Box::new(self.statement()?), false))
            }
            "do" => {
                self.next();
                let body = Box::new(self.statement()?);
                if !self.accept_word("while") {
                    return Err(self.missing("`while`"));
                }
                let condition = self.bracketed()?;
                self.expect(";")?;
                Ok(StatementKind::Loop(None, Some(condition), None, body, true))
            }
            "for" => {
                self.next();
                self.expect("(")?;
                let first = Box::new(self.statement()?);
                let condition = if self.accept(";") {
                    None
                } else {
                    let condition = self.expression()?;
                    self.expect(";")?;
                    Some(condition)
                };
                let step = if *self.peek() == Token::Sign(")") { None } else { Some(self.expression()?) };
                self.expect(")")?;
                Ok(StatementKind::Loop(Some(first), condition, step, Box::new(self.statement()?), false))
            }
            "switch" => {
                self.next();
                let value = self.bracketed()?;
                Ok(StatementKind::Switch(value, Box::new(self.statement()?)))
            }
            "case" => {
                self.next();
                let value = self.conditional()?;
                self.expect(":")?;
                Ok(StatementKind::Case(Some(value)))
            }
            "default" => {
                self.next();
                self.expect(":")?;
                Ok(StatementKind::Case(None))
            }
            "break" | "continue" => {
                self.next();
                self.expect(";")?;
                Ok(if word == "break" { StatementKind::Break } else { StatementKind::Continue })
            }
            "goto" => {
                self.next();
                let label = self.name()?;
                self.expect(";")?;
                Ok(StatementKind::Goto(label))
            }
            "return" => {
                self.next();
                if self.accept(";") {
                    return Ok(StatementKind::Return(None));
                }
                let value = self.expression()?;
                self.expect(";")?;
                Ok(StatementKind::Return(Some(value)))
            }
            _ => self.evaluated(),
        }
    }

    fn evaluated(&mut self) -> Result<StatementKind, Missing> {
        let expression = self.expression()?;
        self.expect(";")?;
        Ok(StatementKind::Evaluate(expression))
    }

    fn bracketed(&mut self) -> Result<Expression, Missing> {
        self.expect("(")?;
        let inner = self.expression()?;
        self.expect(")")?;
        Ok(inner)
    }

    fn expression(&mut self) -> Result<Expression, Missing> {
        self.assignment()
    }

    fn assignment(&mut self) -> Result<Expression, Missing> {
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
        Ok(Expression { line, kind: Kind::Assign(operator, Box::new(target), Box::new(value)) })
    }

    fn conditional(&mut self) -> Result<Expression, Missing> {
        let line = self.line();
        let condition = self.binary(0)?;
        if !self.accept("?") {
            return Ok(condition);
        }
        let first = self.expression()?;
        self.expect(":")?;
        let second = self.conditional()?;
        let kind = Kind::Conditional(Box::new(condition), Box::new(first), Box::new(second));
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
            left = Expression { line, kind: Kind::Binary(sign, Box::new(left), Box::new(right)) };
        }
        Ok(left)
    }

    fn unary(&mut self) -> Result<Expression, Missing> {
        let line = self.line();
        for sign in ["-", "+", "!", "~", "&", "*"] {
            if self.accept(sign) {
                let inner = Box::new(self.unary()?);
                return Ok(Expression { line, kind: Kind::Unary(sign, inner) });
            }
        }
        for (sign, up) in [("++", true), ("--", false)] {
            if self.accept(sign) {
                let inner = Box::new(self.unary()?);
                return Ok(Expression { line, kind: Kind::Step(up, false, inner) });
            }
        }
        if self.accept_word("sizeof") {
            let bracket = *self.peek() == Token::Sign("(");
            self.at += usize::from(bracket);
            if bracket && self.starts_type() {
                let of = self.type_name()?;
                self.expect(")")?;
                return Ok(Expression { line, kind: Kind::SizeOfType(of) });
            }
            self.at -= usize::from(bracket);
            let inner = Box::new(self.unary()?);
            return Ok(Expression { line, kind: Kind::SizeOf(inner) });
        }
        if *self.peek() == Token::Sign("(") {
            self.next();
            if self.starts_type() {
                let of = self.type_name()?;
                self.expect(")")?;
                let inner = Box::new(self.unary()?);
                return Ok(Expression { line, kind: Kind::Cast(of, inner) });
            }
            let inner = self.expression()?;
            self.expect(")")?;
            return self.postfix(inner);
        }
        let primary = self.primary()?;
        self.postfix(primary)
    }

    fn postfix(&mut self, mut inner: Expression) -> Result<Expression, Missing> {
        loop {
            let line = self.line();
            let kind = if self.accept("[") {
                let index = self.expression()?;
                self.expect("]")?;
                Kind::Index(Box::new(inner), Box::new(index))
            } else if self.accept(".") {
                Kind::Member(Box::new(inner), self.name()?)
            } else if self.accept("->") {
                let target = Expression { line, kind: Kind::Unary("*", Box::new(inner)) };
                Kind::Member(Box::new(target), self.name()?)
            } else if self.accept("++") {
                Kind::Step(true, true, Box::new(inner))
            } else if self.accept("--") {
                Kind::Step(false, true, Box::new(inner))
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
            Token::Name(name) if name == "__infinity" => Kind::Float(f64::INFINITY, Type::Float),
            Token::Name(name) if name == "__nan" => Kind::Float(f64::NAN, Type::Float),
            Token::Name(name) if self.accept("(") => {
                let mut arguments = Vec::new();
                while !self.accept(")") {
                    arguments.push(self.assignment()?);
                    if !self.accept(",") {
                        self.expect(")")?;
                        break;
                    }
                }
                Kind::Call(name, arguments)
            }
            Token::Name(name) => Kind::Name(name),
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
                    Ok(Kind::Float(f64::from(value), Type::Float))
                }
                None => Ok(Kind::Float(lower.parse().map_err(|_| fault())?, Type::Double)),
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
        let of = if long {
            Type::Integer(8, !unsigned)
        } else if unsigned || value > i32::MAX as u64 && digits.starts_with("0x") {
            Type::UNSIGNED
        } else if value > i32::MAX as u64 {
            Type::Integer(8, true)
        } else {
            Type::INT
        };
        Ok(Kind::Integer(value, of))
    }
}
