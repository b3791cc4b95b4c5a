//! Statements: declarations, branches, loops, switches.

use super::{JumpTarget, Lowering, Lvalue, constant_of, number};
use crate::c::code::{Condition, Constant, Operation, Scalar, Value};
use crate::c::syntax::{Expression, Kind, Statement, StatementKind, Type, Variable};
use crate::input::Missing;
use crate::term::Width;

impl<'u> Lowering<'u> {
    pub(super) fn statement(&mut self, statement: &'u Statement) -> Result<(), Missing> {
        self.line = statement.line;
        match &statement.kind {
            StatementKind::Empty => {}
            StatementKind::Block(statements) => {
                self.enter();
                for statement in statements {
                    self.statement(statement)?;
                }
                self.leave();
                let here = self.here();
                self.program.heads.entry(here).or_insert(false);
            }
            StatementKind::Declare(variables) => {
                for variable in variables {
                    self.declare(variable)?;
                }
            }
            StatementKind::Evaluate(expression) => self.effect(expression)?,
            StatementKind::If(condition, first, second) => {
                let condition = self.condition(condition)?;
                let branch = self.emit(Operation::Branch(condition, usize::MAX));
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
            StatementKind::Loop(first, condition, step, body, body_first) => {
                self.enter();
                if let Some(first) = first {
                    self.statement(first)?;
                }
                self.repeat(condition.as_ref(), step.as_ref(), body, *body_first)?;
                self.leave();
            }
            StatementKind::Switch(value, body) => self.switch(value, body)?,
            StatementKind::Case(value) => {
                let value = match value {
                    None => None,
                    Some(value) => {
                        let (value, from) = self.value(value)?;
                        match constant_of(&self.converted(value, &from, &Type::UNSIGNED)?) {
                            Some(Constant::Number(number)) => Some(number),
                            _ => return Err(self.missing("a constant case")),
                        }
                    }
                };
                let here = self.here();
                match self.cases.last_mut() {
                    Some(cases) => cases.push((value, here)),
                    None => return Err(self.missing("the switch of a case")),
                }
            }
            StatementKind::Break | StatementKind::Continue => {
                let breaks = matches!(statement.kind, StatementKind::Break);
                let targets = self.frames.last().map_or(&[][..], |frame| &frame.targets);
                let target = targets.iter().rposition(|target| breaks || target.continues.is_some());
                let Some(target) = target else { return Err(self.missing("a loop around")) };
                let jump = self.jump(targets[target].scopes);
                if let Some(frame) = self.frames.last_mut() {
                    let target = &mut frame.targets[target];
                    match &mut target.continues {
                        Some(continues) if !breaks => continues.push(jump),
                        _ => target.breaks.push(jump),
                    }
                }
            }
            StatementKind::Goto(label) => {
                let jump = self.emit(Operation::Jump(usize::MAX, Vec::new()));
                let scopes = self.scopes.clone();
                if let Some(frame) = self.frames.last_mut() {
                    frame.gotos.push((jump, label.clone(), scopes, statement.line));
                }
            }
            StatementKind::Label(label) => {
                let (here, scopes) = (self.here(), self.scopes.clone());
                self.program.heads.insert(here, true);
                if let Some(frame) = self.frames.last_mut() {
                    frame.labels.insert(label.clone(), (here, scopes));
                }
            }
            StatementKind::Return(value) => self.returns(value.as_ref())?,
        }
        Ok(())
    }

    pub(super) fn returns(&mut self, value: Option<&'u Expression>) -> Result<(), Missing> {
        let place = self.frames.last().and_then(|frame| frame.result.clone());
        match (value, place) {
            (Some(value), Some(place)) => {
                let (value, from) = self.value(value)?;
                let value = self.converted(value, &from, &place.ty)?;
                self.store(number(place.address), value, &place.ty)?;
            }
            (Some(value), None) => self.effect(value)?,
            _ => {}
        }
        let jump = self.jump(self.frames.last().map_or(0, |frame| frame.scopes));
        if let Some(frame) = self.frames.last_mut() {
            frame.returns.push(jump);
        }
        Ok(())
    }

    pub(super) fn declare(&mut self, variable: &'u Variable) -> Result<(), Missing> {
        self.line = variable.line;
        if variable.is_static {
            return self.constant(variable);
        }
        let mut ty = variable.ty.clone();
        if let (Type::Array(_, count @ 0), Some(Expression { kind: Kind::List(items), .. })) =
            (&mut ty, &variable.initial)
        {
            *count = u32::try_from(items.len()).map_err(|_| self.missing("a length"))?;
        }
        let place = Lvalue { address: self.allocate(&ty), ty };
        if let Some(initial) = &variable.initial {
            self.initialise(place.address, &place.ty, initial)?;
        }
        self.bind(variable.name.clone(), place);
        Ok(())
    }

    pub(super) fn initialise(&mut self, address: u32, ty: &Type, initial: &'u Expression) -> Result<(), Missing> {
        let parts: Vec<Type> = match (ty, &initial.kind) {
            (Type::Array(inner, count), Kind::List(_)) => vec![(**inner).clone(); *count as usize],
            (Type::Struct(number), Kind::List(_)) => {
                self.unit.structs[*number].members.iter().map(|(_, ty)| ty.clone()).collect()
            }
            (Type::Struct(_), _) => {
                let (from, _) = self.place(initial)?;
                let count = self.cells(ty);
                self.emit(Operation::Copy(number(address), from, count));
                return Ok(());
            }
            _ => {
                let (value, from) = self.value(initial)?;
                let value = self.converted(value, &from, ty)?;
                return self.store(number(address), value, ty);
            }
        };
        let Kind::List(items) = &initial.kind else { return Err(self.missing("an initialiser in braces")) };
        if items.len() != parts.len() {
            return Err(self.missing("an initialiser for each part"));
        }
        let mut address = address;
        for (item, ty) in items.iter().zip(&parts) {
            self.initialise(address, ty, item)?;
            address += self.cells(ty);
        }
        Ok(())
    }

    pub(super) fn repeat(
        &mut self,
        condition: Option<&'u Expression>,
        step: Option<&'u Expression>,
        body: &'u Statement,
        body_first: bool,
    ) -> Result<(), Missing> {
        let target = JumpTarget { continues: Some(Vec::new()), scopes: self.scopes.len(), ..JumpTarget::default() };
        if let Some(frame) = self.frames.last_mut() {
            frame.targets.push(target);
        }
        let mut exits = Vec::new();
        let head = self.here();
        self.program.heads.entry(head).or_insert(false);
        if !body_first && let Some(condition) = condition {
            let condition = self.condition(condition)?;
            exits.push(self.emit(Operation::Branch(condition, usize::MAX)));
        }
        self.statement(body)?;
        let target = self.frames.last_mut().and_then(|frame| frame.targets.pop()).unwrap_or_default();
        self.land(&target.continues.unwrap_or_default());
        if let Some(step) = step {
            self.effect(step)?;
        }
        if body_first && let Some(condition) = condition {
            let condition = self.condition(condition)?;
            exits.push(self.emit(Operation::Branch(condition, usize::MAX)));
        }
        self.emit(Operation::Jump(head, Vec::new()));
        exits.extend(target.breaks);
        self.land(&exits);
        Ok(())
    }

    pub(super) fn switch(&mut self, value: &'u Expression, body: &'u Statement) -> Result<(), Missing> {
        let (value, from) = self.value(value)?;
        if !from.is_integer() {
            return Err(self.missing("a switch over an integer"));
        }
        let value = self.converted(value, &from, &Type::UNSIGNED)?;
        let cell = self.allocate(&Type::UNSIGNED);
        self.store(number(cell), value, &Type::UNSIGNED)?;
        let dispatch = self.jump(self.scopes.len());
        if let Some(frame) = self.frames.last_mut() {
            frame.targets.push(JumpTarget { scopes: self.scopes.len(), ..JumpTarget::default() });
        }
        self.cases.push(Vec::new());
        self.statement(body)?;
        let cases = self.cases.pop().unwrap_or_default();
        let target = self.frames.last_mut().and_then(|frame| frame.targets.pop()).unwrap_or_default();
        let end = self.jump(self.scopes.len());
        self.land(&[dispatch]);
        for &(value, at) in &cases {
            let Some(value) = value else { continue };
            let load = Value::Load(Box::new(number(cell)), Scalar::Word(Width::W32));
            let other = Condition::Not(Box::new(Condition::Same(Width::W32, load, Value::Number(value))));
            // a branch goes there where its condition fails
            self.emit(Operation::Branch(other, at));
        }
        let default = cases.iter().find(|(value, _)| value.is_none()).map(|&(_, at)| at);
        let last = self.emit(Operation::Jump(default.unwrap_or(usize::MAX), Vec::new()));
        if default.is_none() {
            self.land(&[last]);
        }
        self.land(&target.breaks);
        self.land(&[end]);
        Ok(())
    }
}
