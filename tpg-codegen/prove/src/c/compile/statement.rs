//! Statements: declarations, branches, loops, switches.

use super::{Compiler, JumpTarget, Type, number};
use crate::c::code::{Computed, Expression, Operation, of};
use crate::c::token::Token::{Name, Sign};
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
            "while" | "for" => {
                self.enter();
                if word == "for" {
                    self.expect("(")?;
                    self.statement()?;
                }
                self.repeat(&word)?;
                self.leave();
                Ok(())
            }
            "switch" => self.switch(),
            "case" | "default" => {
                let value = if word == "case" { Some(u64::from(self.constant()? as u32)) } else { None };
                self.expect(":")?;
                let here = self.here();
                match self.frame.targets.iter_mut().rfind(|target| target.continues.is_none()) {
                    Some(switch) => switch.cases.push((value, here)),
                    None => return self.refuse("the switch of a case"),
                }
                Ok(())
            }
            "break" | "continue" => {
                let breaks = word == "break";
                let target = self.frame.targets.iter().rposition(|target| breaks || target.continues.is_some());
                let Some(target) = target else { return self.refuse("a loop around") };
                let jump = self.jump(self.frame.targets[target].scopes);
                let target = &mut self.frame.targets[target];
                match &mut target.continues {
                    Some(continues) if !breaks => continues.push(jump),
                    _ => target.breaks.push(jump),
                }
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
                    let Some(place) = self.frame.result.clone() else { return self.refuse("a function with a result") };
                    let value = self.assigned()?;
                    self.put(number(place.address), value, &place.ty)?;
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

    /// Reads a loop behind its first word, or behind the first statement in its brackets.
    fn repeat(&mut self, word: &str) -> Result<()> {
        let target = JumpTarget { continues: Some(Vec::new()), scopes: self.scopes.len(), ..JumpTarget::default() };
        let mut exits = Vec::new();
        let head = self.here();
        self.head();
        let mut step = None;
        if word == "while" {
            let condition = self.bracketed()?;
            exits.push(self.branch(condition));
        } else {
            if *self.peek() != Sign(";") {
                let condition = self.tested(Self::assignment)?;
                exits.push(self.branch(condition));
            }
            self.expect(";")?;
            step = Some(self.at).filter(|_| *self.peek() != Sign(")"));
            self.skip("(", ")")?;
        }
        self.frame.targets.push(target);
        self.statement()?;
        let target = self.frame.targets.pop().unwrap_or_default();
        self.land(&target.continues.unwrap_or_default());
        if let Some(step) = step {
            let behind = std::mem::replace(&mut self.at, step);
            self.assignment()?;
            self.at = behind;
        }

        self.emit(Operation::Jump(head, Vec::new()));
        exits.extend(target.breaks);
        self.land(&exits);
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
        self.frame.targets.push(JumpTarget { scopes: self.scopes.len(), ..JumpTarget::default() });
        self.statement()?;
        let mut target = self.frame.targets.pop().unwrap_or_default();
        target.breaks.push(self.jump(self.scopes.len()));
        self.land(&[dispatch]);
        for &(value, at) in &target.cases {
            let Some(value) = value else { continue };
            let (load, _) = self.loaded(number(cell), Type::UNSIGNED)?;
            // a branch goes there where its condition fails
            self.emit(Operation::Branch(!of(Computed::Same(Width::W32), [load, Expression::Number(value)]), at));
        }
        let default = target.cases.iter().find(|(value, _)| value.is_none()).map(|&(_, at)| at);
        let last = self.emit(Operation::Jump(default.unwrap_or(usize::MAX), Vec::new()));
        if default.is_none() {
            target.breaks.push(last);
        }
        self.land(&target.breaks);
        Ok(())
    }
}
