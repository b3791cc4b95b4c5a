//! The tokens of a file as a parser reads them.

use super::syntax::{Type, Unit};
use super::token::{Placed, Token};
use crate::input::Missing;
use Token::*;
use std::collections::HashMap;

/// A parser of a file.
pub(super) struct Parser<'a> {
    pub(super) file: &'a str,
    pub(super) tokens: Vec<Placed>,
    pub(super) at: usize,
    pub(super) unit: Unit,
    pub(super) types: HashMap<String, Type>,
    pub(super) tags: HashMap<String, usize>,
}

impl Parser<'_> {
    pub(super) fn peek(&self) -> &Token {
        &self.tokens[self.at].token
    }

    pub(super) fn line(&self) -> u32 {
        self.tokens[self.at].line
    }

    pub(super) fn next(&mut self) -> Token {
        let token = self.tokens[self.at].token.clone();
        self.at = (self.at + 1).min(self.tokens.len() - 1);
        token
    }

    pub(super) fn missing(&self, what: impl Into<String>) -> Missing {
        Missing::new(format!("{}:{}", self.file, self.line()), what)
    }

    /// Reads a sign or a word, if it is next.
    pub(super) fn accept(&mut self, text: &str) -> bool {
        let is = match self.peek() {
            Sign(sign) => *sign == text,
            Name(name) => name == text,
            _ => false,
        };
        if is {
            self.next();
        }
        is
    }

    pub(super) fn expect(&mut self, sign: &str) -> Result<(), Missing> {
        if self.accept(sign) { Ok(()) } else { Err(self.missing(format!("`{sign}`, found {:?}", self.peek()))) }
    }

    pub(super) fn name(&mut self) -> Result<String, Missing> {
        match self.next() {
            Name(name) => Ok(name),
            other => Err(self.missing(format!("a name, found {other:?}"))),
        }
    }

    /// Reads what stands between commas up to a sign, before which another comma may be.
    pub(super) fn list<T>(
        &mut self,
        end: &str,
        mut item: impl FnMut(&mut Self) -> Result<T, Missing>,
    ) -> Result<Vec<T>, Missing> {
        let mut items = Vec::new();
        while !self.accept(end) {
            items.push(item(self)?);
            if !self.accept(",") {
                self.expect(end)?;
                break;
            }
        }
        Ok(items)
    }

    /// Skips `__attribute__((...))` and the like; they ask for no other results.
    pub(super) fn attributes(&mut self) -> Result<(), Missing> {
        while self.accept("__attribute__") {
            let mut depth = 0;
            loop {
                match self.next() {
                    Sign("(") => depth += 1,
                    Sign(")") => depth -= 1,
                    End => return Err(self.missing("`)`")),
                    _ => {}
                }
                if depth == 0 {
                    break;
                }
            }
        }
        Ok(())
    }
}
