//! Statements: declarations, branches, loops, switches.

use super::{JumpTarget, Lowering, Lvalue, constant_of, number};
use crate::c::code::{Condition, Constant, Operation, Value};
use crate::c::syntax::{Expression, Statement, StatementKind::*, Type, Variable};
use crate::input::Missing;
use crate::term::Width;

impl<'u> Lowering<'u> {
    pub(super) fn statement(&mut self, statement: &'u Statement) -> Result<(), Missing> {
        self.line = statement.line;
        match &statement.kind {
            Empty => {}
            Block(statements) => {
                self.enter();
                for statement in statements {
                    self.statement(statement)?;
                }
                self.leave();
                self.head();
            }
            Declare(variables) => {
                for variable in variables {
                    self.declare(variable)?;
                }
            }
            Evaluate(expression) => self.effect(expression)?,
            If(condition, first, second) => {
                let condition = self.condition(condition)?;
                let branch = self.branch(condition);
                self.statement(first)?;
                if let Some(second) = second {
                    let end = self.jump(self.scopes.len());
                    self.land(&[branch]);
                    self.statement(second)?;
                    self.land(&[end]);
                } else {
                    self.land(&[branch]);
                }
            }
            Loop(first, condition, step, body, body_first) => {
                self.enter();
                if let Some(first) = first {
                    self.statement(first)?;
                }
                self.repeat(condition.as_ref(), step.as_ref(), body, *body_first)?;
                self.leave();
            }
            Switch(value, body) => self.switch(value, body)?,
            Case(value) => {
                let value = match value {
                    None => None,
                    Some(value) => {
                        let value = self.value(value)?;
                        match constant_of(&self.converted(value, &Type::UNSIGNED)?) {
                            Some(Constant::Number(number)) => Some(number),
                            _ => return Err(self.missing("a constant case")),
                        }
                    }
                };
                let here = self.here();
                let switch = self.frame.targets.iter_mut().rfind(|target| target.continues.is_none());
                match switch {
                    Some(switch) => switch.cases.push((value, here)),
                    None => return Err(self.missing("the switch of a case")),
                }
            }
            Break | Continue => {
                let breaks = matches!(statement.kind, Break);
                let target = self.frame.targets.iter().rposition(|target| breaks || target.continues.is_some());
                let Some(target) = target else { return Err(self.missing("a loop around")) };
                let jump = self.jump(self.frame.targets[target].scopes);
                let target = &mut self.frame.targets[target];
                match &mut target.continues {
                    Some(continues) if !breaks => continues.push(jump),
                    _ => target.breaks.push(jump),
                }
            }
            Goto(label) => {
                let jump = self.emit(Operation::Jump(usize::MAX, Vec::new()));
                self.frame.gotos.push((jump, label.clone(), self.scopes.clone(), statement.line));
            }
            Label(label) => {
                let here = self.here();
                self.program.heads.insert(here, true);
                self.frame.labels.insert(label.clone(), (here, self.scopes.clone()));
            }
            Return(value) => self.returns(value.as_ref())?,
        }
        Ok(())
    }

    fn returns(&mut self, value: Option<&'u Expression>) -> Result<(), Missing> {
        match (value, self.frame.result.clone()) {
            (Some(value), Some(place)) => {
                let value = self.value(value)?;
                self.put(number(place.address), value, &place.ty)?;
            }
            (Some(value), None) => self.effect(value)?,
            _ => {}
        }
        let jump = self.jump(self.frame.scopes);
        self.frame.returns.push(jump);
        Ok(())
    }

    fn declare(&mut self, variable: &'u Variable) -> Result<(), Missing> {
        self.line = variable.line;
        if variable.is_static {
            return self.constant(variable);
        }
        let ty = self.type_of(variable)?;
        let place = Lvalue { address: self.allocate(&ty), ty };
        if let Some(initial) = &variable.initial {
            let parts = self.parts(&place.ty, initial);
            if parts.iter().map(|(_, ty, _)| self.cells(ty)).sum::<u32>() != self.cells(&place.ty) {
                return Err(self.missing("an initialiser for each part"));
            }
            for (offset, ty, item) in parts {
                self.set(number(place.address + offset), &ty, item)?;
            }
        }
        self.bind(variable.name.clone(), place);
        Ok(())
    }

    fn repeat(
        &mut self,
        condition: Option<&'u Expression>,
        step: Option<&'u Expression>,
        body: &'u Statement,
        body_first: bool,
    ) -> Result<(), Missing> {
        let target = JumpTarget { continues: Some(Vec::new()), scopes: self.scopes.len(), ..JumpTarget::default() };
        self.frame.targets.push(target);
        let mut exits = Vec::new();
        let head = self.here();
        self.head();
        if !body_first && let Some(condition) = condition {
            let condition = self.condition(condition)?;
            exits.push(self.branch(condition));
        }
        self.statement(body)?;
        let target = self.frame.targets.pop().unwrap_or_default();
        self.land(&target.continues.unwrap_or_default());
        if let Some(step) = step {
            self.effect(step)?;
        }
        if body_first && let Some(condition) = condition {
            let condition = self.condition(condition)?;
            exits.push(self.branch(condition));
        }
        self.emit(Operation::Jump(head, Vec::new()));
        exits.extend(target.breaks);
        self.land(&exits);
        Ok(())
    }

    fn switch(&mut self, value: &'u Expression, body: &'u Statement) -> Result<(), Missing> {
        let value = self.value(value)?;
        if !value.1.is_integer() {
            return Err(self.missing("a switch over an integer"));
        }
        let cell = self.allocate(&Type::UNSIGNED);
        self.put(number(cell), value, &Type::UNSIGNED)?;
        let dispatch = self.jump(self.scopes.len());
        self.frame.targets.push(JumpTarget { scopes: self.scopes.len(), ..JumpTarget::default() });
        self.statement(body)?;
        let mut target = self.frame.targets.pop().unwrap_or_default();
        target.breaks.push(self.jump(self.scopes.len()));
        self.land(&[dispatch]);
        for &(value, at) in &target.cases {
            let Some(value) = value else { continue };
            let (load, _) = self.loaded(number(cell), Type::UNSIGNED)?;
            // a branch goes there where its condition fails
            self.emit(Operation::Branch(!Condition::Same(Width::W32, load, Value::Number(value)), at));
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
