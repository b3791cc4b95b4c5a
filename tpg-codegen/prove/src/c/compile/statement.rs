//! Statements: declarations, branches, loops, switches.

use super::{Compiler, JumpTarget, Type, number};
use crate::c::code::Operation;
use crate::c::token::Token::{Name, Sign};
use crate::code::{Computed, Expression, of};
use crate::input::Result;
use crate::term::Width;

impl Compiler<'_> {
    pub(super) fn statement(&mut self) -> Result<()> {
        if self.accept(";") {
            return Ok(());
        }
        if self.accept("{") {
            self.enter();
            while !self.accept("}") {
                self.statement()?;
            }
            self.leave();
            self.head();
            return Ok(());
        }
        if self.starts_type() {
            return self.declaration();
        }
        let Name(word) = self.peek().clone() else { return self.evaluated() };
        if word != "default" && self.tokens.get(self.at + 1).is_some_and(|next| next.token == Sign(":")) {
            self.at += 2;
            let here = self.here();
            self.program.heads.insert(here, true);
            self.frame.labels.insert(word, (here, self.scopes.clone()));
            return Ok(());
        }
        self.next();
        match word.as_str() {
            "if" => {
                let condition = self.bracketed()?;
                let branch = self.branch(condition);
                self.statement()?;
                if self.accept("else") {
                    let end = self.jump(self.scopes.len());
                    self.land(&[branch]);
                    self.statement()?;
                    self.land(&[end]);
                } else {
                    self.land(&[branch]);
                }
                Ok(())
            }
            "for" => self.repeat(),
            "switch" => self.switch(),
            "case" | "default" => {
                let value = if word == "case" { Some(u64::from(self.constant()? as u32)) } else { None };
                self.expect(":")?;
                let here = self.here();
                match self.frame.targets.last_mut().and_then(|target| target.cases.as_mut()) {
                    Some(cases) => cases.push((value, here)),
                    None => return self.refuse("the switch of a case"),
                }
                Ok(())
            }
            "break" | "continue" => {
                let is_break = word == "break";
                let target = self.frame.targets.iter().rposition(|target| is_break || target.cases.is_none());
                let Some(target) = target else { return self.refuse("a loop or switch around") };
                let jump = self.jump(self.frame.targets[target].scopes);
                let JumpTarget { breaks, continues, .. } = &mut self.frame.targets[target];
                if is_break { breaks } else { continues }.push(jump);
                self.expect(";")
            }
            "goto" => {
                let label = self.name()?;
                let jump = self.emit(Operation::Jump(usize::MAX, Vec::new()));
                self.frame.gotos.push((jump, label, self.scopes.clone()));
                self.expect(";")
            }
            "return" => {
                if *self.peek() != Sign(";") {
                    let Some((address, ty)) = self.frame.result.clone() else {
                        return self.refuse("a function with a result");
                    };
                    let value = self.assigned()?;
                    self.put(address, value, &ty)?;
                }
                let jump = self.jump(self.frame.scopes);
                self.frame.returns.push(jump);
                self.expect(";")
            }
            _ => {
                self.at -= 1;
                self.evaluated()
            }
        }
    }

    fn evaluated(&mut self) -> Result<()> {
        self.assignment()?;
        self.expect(";")
    }

    fn bracketed(&mut self) -> Result<Expression> {
        self.expect("(")?;
        let condition = self.tested(Self::assignment)?;
        self.expect(")").map(|()| condition)
    }

    /// Reads a loop behind its first word.
    fn repeat(&mut self) -> Result<()> {
        self.enter();
        self.expect("(")?;
        self.statement()?;
        let head = self.here();
        self.head();
        let condition = self.tested(Self::assignment)?;
        let exit = self.branch(condition);
        self.expect(";")?;
        let step = self.at;
        self.skip("(", ")")?;
        self.frame.targets.push(JumpTarget { scopes: self.scopes.len(), ..JumpTarget::default() });
        self.statement()?;
        let target = self.frame.targets.pop().unwrap_or_default();
        self.land(&target.continues);
        let behind = std::mem::replace(&mut self.at, step);
        self.assignment()?;
        self.at = behind;
        self.emit(Operation::Jump(head, Vec::new()));
        self.land(&[exit]);
        self.land(&target.breaks);
        self.leave();
        Ok(())
    }

    fn switch(&mut self) -> Result<()> {
        self.expect("(")?;
        let value = self.assigned()?;
        self.expect(")")?;
        if !matches!(value.1, Type::Integer(..)) {
            return self.refuse("a switch over an integer");
        }
        let cell = self.allocate(&Type::UNSIGNED);
        self.put(number(cell), value, &Type::UNSIGNED)?;
        let dispatch = self.jump(self.scopes.len());
        let scopes = self.scopes.len();
        self.frame.targets.push(JumpTarget { cases: Some(Vec::new()), scopes, ..JumpTarget::default() });
        self.statement()?;
        let target = self.frame.targets.pop().unwrap_or_default();
        let end = self.jump(scopes);
        self.land(&[dispatch]);
        let (mut default, cases) = (None, target.cases.unwrap_or_default());
        for (value, at) in cases {
            let Some(value) = value else {
                default = Some(at);
                continue;
            };
            let (load, _) = self.loaded(number(cell), Type::UNSIGNED)?;
            // a branch goes there where its condition fails
            self.emit(Operation::Branch(!of(Computed::Same(Width::W32), [load, Expression::Number(value)]), at));
        }
        let Some(default) = default else { return self.refuse("a switch with a default") };
        self.emit(Operation::Jump(default, Vec::new()));
        self.land(&[end]);
        self.land(&target.breaks);
        Ok(())
    }
}
