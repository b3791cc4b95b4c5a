//! Lowers the syntax tree of a function into operations.

use super::code::{CONSTANTS, Condition, Constant, Object, Operation, Program, Scalar, Value};
use super::syntax::{Expression, Function, Kind, Statement, StatementKind, Type, Unit, Variable};
use crate::machine::{Interface, Missing};
use crate::term::{Arithmetic, Operator, Width};
use std::collections::HashMap;

#[derive(Clone, Debug)]
struct Place {
    address: u32,
    of: Type,
}

/// What `break` and `continue` of a loop or switch refer to.
#[derive(Default)]
struct Target {
    breaks: Vec<usize>,
    /// None in a switch
    continues: Option<Vec<usize>>,
    scopes: usize,
}

/// A function that is being inlined.
struct Frame {
    labels: HashMap<String, (usize, Vec<usize>)>,
    gotos: Vec<(usize, String, Vec<usize>, u32)>,
    returns: Vec<usize>,
    result: Option<Place>,
    scopes: usize,
    targets: Vec<Target>,
}

/// A case of a switch: its number, none for the default, and where it is.
type Case = (Option<u64>, usize);

pub(super) struct Lowering<'u> {
    file: &'u str,
    unit: &'u Unit,
    program: Program,
    names: Vec<HashMap<String, Place>>,
    scopes: Vec<usize>,
    frames: Vec<Frame>,
    calls: Vec<&'u str>,
    cases: Vec<Vec<Case>>,
    statics: HashMap<(u32, String), u32>,
    line: u32,
}

/// Lowers a function that has the interface of a policy.
pub(super) fn policy(file: &str, unit: &Unit, name: &str, interface: &Interface) -> Result<Program, Missing> {
    let mut lowering = Lowering::new(file, unit)?;
    lowering.policy(name, interface)?;
    Ok(lowering.finished())
}

/// Lowers a function of one float, which is cell 0.
pub(super) fn function(file: &str, unit: &Unit, name: &str) -> Result<Program, Missing> {
    let mut lowering = Lowering::new(file, unit)?;
    let argument = lowering.allocate(&Type::Float);
    let load = Value::Load(Box::new(Value::Number(u64::from(argument))), Scalar::Float);
    let called = lowering.function(name)?;
    let result = lowering.inlined(called, vec![(load, Type::Float)])?;
    lowering.program.result = result.map(|place| place.address);
    lowering.emit(Operation::Return);
    Ok(lowering.finished())
}

fn number(number: u32) -> Value {
    Value::Number(u64::from(number))
}

impl<'u> Lowering<'u> {
    fn new(file: &'u str, unit: &'u Unit) -> Result<Self, Missing> {
        let mut lowering = Self {
            file,
            unit,
            program: Program::default(),
            names: vec![HashMap::new()],
            scopes: Vec::new(),
            frames: Vec::new(),
            calls: Vec::new(),
            cases: Vec::new(),
            statics: HashMap::new(),
            line: 0,
        };
        for variable in &unit.variables {
            lowering.line = variable.line;
            lowering.constant(variable)?;
        }
        Ok(lowering)
    }

    fn finished(mut self) -> Program {
        self.program.objects.sort_by_key(|object| object.start);
        self.program
    }

    fn missing(&self, what: impl Into<String>) -> Missing {
        Missing::new(format!("{}:{}", self.file, self.line), what)
    }

    fn function(&self, name: &str) -> Result<&'u Function, Missing> {
        let found = self.unit.functions.iter().find(|function| function.name == name);
        found.ok_or_else(|| self.missing(format!("the meaning of the function `{name}`")))
    }

    fn policy(&mut self, name: &str, interface: &Interface) -> Result<(), Missing> {
        let function = self.function(name)?;
        let mut arguments = Vec::new();
        let mut structures = Vec::new();
        for (_, of) in &function.parameters {
            let Type::Pointer(target) = of else { return Err(self.missing("a parameter that is a pointer")) };
            let address = self.allocate(target);
            structures.push((address, (**target).clone()));
            arguments.push((number(address), of.clone()));
        }
        let memory = !interface.memory.is_empty();
        let values = !interface.outputs.is_empty();
        if structures.len() != 1 + usize::from(memory) + usize::from(values) {
            return Err(self.missing(format!("other parameters of `{name}`")));
        }
        let sources: Vec<_> = interface.sources.iter().map(|(name, length)| (name.clone(), *length)).collect();
        let single = |names: &[String]| names.iter().map(|name| (name.clone(), 1)).collect::<Vec<_>>();
        self.fields(&structures[0].1, &sources)?;
        self.program.state = structures[0].0;
        if memory {
            self.fields(&structures[1].1, &single(&interface.memory))?;
            self.program.memory = Some(structures[1].0);
        }
        if values {
            let (address, of) = &structures[structures.len() - 1];
            self.program.action = Some(*address);
            self.fields(&of.clone(), &single(&interface.outputs))?;
        }
        let result = self.inlined(function, arguments)?;
        self.program.result = result.map(|place| place.address);
        if self.program.result.is_none() != values {
            return Err(self.missing(format!("another result of `{name}`")));
        }
        self.emit(Operation::Return);
        Ok(())
    }

    /// Checks that a structure holds floats with these names, in this order; underscores may follow a name.
    fn fields(&self, of: &Type, names: &[(String, u32)]) -> Result<(), Missing> {
        let Type::Struct(number) = of else { return Err(self.missing("a pointer to a structure")) };
        let members = &self.unit.structs[*number].members;
        let fits = |member: &(String, Type), (name, length): &(String, u32)| {
            let floats = match &member.1 {
                Type::Float => 1,
                Type::Array(of, count) if **of == Type::Float => *count,
                _ => 0,
            };
            floats == *length && member.0.trim_end_matches('_') == name.trim_end_matches('_')
        };
        let all = members.len() == names.len() && members.iter().zip(names).all(|(member, name)| fits(member, name));
        if all { Ok(()) } else { Err(self.missing(format!("a structure of the floats {names:?}"))) }
    }

    // ---- memory

    /// The cells of a type.
    fn cells(&self, of: &Type) -> u32 {
        match of {
            Type::Void => 0,
            Type::Struct(number) => {
                let structure = &self.unit.structs[*number];
                let sizes = structure.members.iter().map(|(_, of)| self.cells(of));
                if structure.union { sizes.max().unwrap_or(0) } else { sizes.sum() }
            }
            Type::Array(of, count) => self.cells(of).saturating_mul(*count),
            _ => 1,
        }
    }

    /// The bytes of a type.
    fn bytes(&self, of: &Type) -> u32 {
        match of {
            Type::Void => 0,
            Type::Integer(bytes, _) => u32::from(*bytes),
            Type::Float | Type::Pointer(_) => 4,
            Type::Double => 8,
            Type::Struct(number) => {
                let structure = &self.unit.structs[*number];
                let sizes = structure.members.iter().map(|(_, of)| self.bytes(of));
                if structure.union { sizes.max().unwrap_or(0) } else { sizes.sum() }
            }
            Type::Array(of, count) => self.bytes(of).saturating_mul(*count),
        }
    }

    fn allocate(&mut self, of: &Type) -> u32 {
        let start = self.program.cells;
        let end = start + self.cells(of).max(1);
        self.program.objects.push(Object { start, end, array: matches!(of, Type::Array(..)) });
        self.program.cells = end;
        start
    }

    /// A variable that is set once, before everything.
    fn constant(&mut self, variable: &'u Variable) -> Result<(), Missing> {
        let mut of = variable.of.clone();
        if let (Type::Array(_, count @ 0), Some(Expression { kind: Kind::List(items), .. })) =
            (&mut of, &variable.initial)
        {
            *count = u32::try_from(items.len()).map_err(|_| self.missing("a length"))?;
        }
        let key = (variable.line, variable.name.clone());
        let address = match self.statics.get(&key) {
            Some(&address) => address,
            None => {
                let offset = self.program.constants.len();
                let address = CONSTANTS + u32::try_from(offset).map_err(|_| self.missing("smaller tables"))?;
                let fill = if is_float(&of) { Constant::Float(0) } else { Constant::Number(0) };
                let mut cells = vec![fill; self.cells(&of) as usize];
                if let Some(initial) = &variable.initial {
                    self.fill(&of, initial, &mut cells)?;
                }
                let end = address + self.cells(&of).max(1);
                self.program.constants.extend(cells);
                self.program.objects.push(Object { start: address, end, array: true });
                self.statics.insert(key, address);
                address
            }
        };
        self.bind(variable.name.clone(), Place { address, of });
        Ok(())
    }

    fn fill(&mut self, of: &Type, initial: &'u Expression, cells: &mut [Constant]) -> Result<(), Missing> {
        match (of, &initial.kind) {
            (Type::Array(inner, _), Kind::List(items)) => {
                let size = self.cells(inner) as usize;
                for (item, cells) in items.iter().zip(cells.chunks_mut(size.max(1))) {
                    self.fill(inner, item, cells)?;
                }
                Ok(())
            }
            (Type::Struct(structure), Kind::List(items)) => {
                let members: Vec<_> = self.unit.structs[*structure].members.iter().map(|(_, of)| of.clone()).collect();
                let mut rest = cells;
                for (item, of) in items.iter().zip(&members) {
                    let (cells, after) = rest.split_at_mut(self.cells(of) as usize);
                    self.fill(of, item, cells)?;
                    rest = after;
                }
                Ok(())
            }
            _ => {
                let (value, from) = self.value(initial)?;
                let value = self.converted(value, &from, of)?;
                cells[0] = match constant_of(&value) {
                    Some(constant) => constant,
                    None => return Err(self.missing("a constant initialiser")),
                };
                Ok(())
            }
        }
    }

    fn bind(&mut self, name: String, place: Place) {
        if let Some(names) = self.names.last_mut() {
            names.insert(name, place);
        }
    }

    fn find(&self, name: &str) -> Option<&Place> {
        self.names.iter().rev().find_map(|names| names.get(name))
    }

    // ---- operations

    fn emit(&mut self, operation: Operation) -> usize {
        self.program.operations.push((self.line, operation));
        self.program.operations.len() - 1
    }

    fn here(&self) -> usize {
        self.program.operations.len()
    }

    fn land(&mut self, jumps: &[usize]) {
        let here = self.here();
        for &jump in jumps {
            match &mut self.program.operations[jump].1 {
                Operation::Jump(to, _) | Operation::Branch(_, to) => *to = here,
                _ => {}
            }
        }
    }

    fn jump(&mut self, from_scope: usize) -> usize {
        let left = self.scopes[from_scope..].to_vec();
        self.emit(Operation::Jump(usize::MAX, left))
    }

    fn enter(&mut self) {
        self.scopes.push(self.program.scopes.len());
        self.program.scopes.push((self.program.cells, self.program.cells));
        self.names.push(HashMap::new());
    }

    fn leave(&mut self) {
        self.names.pop();
        if let Some(scope) = self.scopes.pop() {
            self.program.scopes[scope].1 = self.program.cells;
            self.emit(Operation::Leave(scope));
        }
    }

    /// Inlines a call. The result's place, if it has one.
    fn inlined(&mut self, function: &'u Function, arguments: Vec<(Value, Type)>) -> Result<Option<Place>, Missing> {
        if self.calls.contains(&function.name.as_str()) {
            return Err(self.missing(format!("`{}` calls itself", function.name)));
        }
        if arguments.len() != function.parameters.len() {
            return Err(self.missing(format!("arguments of `{}`", function.name)));
        }
        let line = self.line;
        let result = (function.result != Type::Void)
            .then(|| Place { address: self.allocate(&function.result), of: function.result.clone() });
        let outside = std::mem::take(&mut self.names);
        self.names.push(outside[0].clone());
        let scopes = self.scopes.len();
        self.enter();
        for ((value, from), (name, of)) in arguments.into_iter().zip(&function.parameters) {
            let value = self.converted(value, &from, of)?;
            let place = Place { address: self.allocate(of), of: of.clone() };
            self.store(number(place.address), value, of)?;
            self.bind(name.clone(), place);
        }
        self.calls.push(&function.name);
        self.frames.push(Frame {
            labels: HashMap::new(),
            gotos: Vec::new(),
            returns: Vec::new(),
            result: result.clone(),
            scopes,
            targets: Vec::new(),
        });
        for statement in &function.body {
            self.statement(statement)?;
        }
        self.leave();
        self.calls.pop();
        if let Some(frame) = self.frames.pop() {
            for (jump, label, left, line) in frame.gotos {
                let Some((to, inside)) = frame.labels.get(&label) else {
                    self.line = line;
                    return Err(self.missing(format!("the label `{label}`")));
                };
                let left = left.into_iter().filter(|scope| !inside.contains(scope)).collect();
                self.program.operations[jump].1 = Operation::Jump(*to, left);
            }
            self.land(&frame.returns);
            if frame.returns.len() > 1 {
                let here = self.here();
                self.program.heads.entry(here).or_insert(false);
            }
        }
        self.names = outside;
        self.line = line;
        Ok(result)
    }

    fn store(&mut self, address: Value, value: Value, of: &Type) -> Result<(), Missing> {
        let scalar = self.scalar(of)?;
        self.emit(Operation::Set(address, value, scalar));
        Ok(())
    }

    fn scalar(&self, of: &Type) -> Result<Scalar, Missing> {
        match of {
            Type::Float => Ok(Scalar::Float),
            Type::Integer(8, _) => Ok(Scalar::Word(Width::W64)),
            Type::Integer(..) | Type::Pointer(_) => Ok(Scalar::Word(Width::W32)),
            Type::Double => Err(self.missing("arithmetic in binary64")),
            _ => Err(self.missing("a scalar")),
        }
    }

    // ---- statements

    fn statement(&mut self, statement: &'u Statement) -> Result<(), Missing> {
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

    fn returns(&mut self, value: Option<&'u Expression>) -> Result<(), Missing> {
        let place = self.frames.last().and_then(|frame| frame.result.clone());
        match (value, place) {
            (Some(value), Some(place)) => {
                let (value, from) = self.value(value)?;
                let value = self.converted(value, &from, &place.of)?;
                self.store(number(place.address), value, &place.of)?;
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

    fn declare(&mut self, variable: &'u Variable) -> Result<(), Missing> {
        self.line = variable.line;
        if variable.is_static {
            return self.constant(variable);
        }
        let mut of = variable.of.clone();
        if let (Type::Array(_, count @ 0), Some(Expression { kind: Kind::List(items), .. })) =
            (&mut of, &variable.initial)
        {
            *count = u32::try_from(items.len()).map_err(|_| self.missing("a length"))?;
        }
        let place = Place { address: self.allocate(&of), of };
        if let Some(initial) = &variable.initial {
            self.initialise(place.address, &place.of, initial)?;
        }
        self.bind(variable.name.clone(), place);
        Ok(())
    }

    fn initialise(&mut self, address: u32, of: &Type, initial: &'u Expression) -> Result<(), Missing> {
        let parts: Vec<Type> = match (of, &initial.kind) {
            (Type::Array(inner, count), Kind::List(_)) => vec![(**inner).clone(); *count as usize],
            (Type::Struct(number), Kind::List(_)) => {
                self.unit.structs[*number].members.iter().map(|(_, of)| of.clone()).collect()
            }
            (Type::Struct(_), _) => {
                let (from, _) = self.place(initial)?;
                let count = self.cells(of);
                self.emit(Operation::Copy(number(address), from, count));
                return Ok(());
            }
            _ => {
                let (value, from) = self.value(initial)?;
                let value = self.converted(value, &from, of)?;
                return self.store(number(address), value, of);
            }
        };
        let Kind::List(items) = &initial.kind else { return Err(self.missing("an initialiser in braces")) };
        if items.len() != parts.len() {
            return Err(self.missing("an initialiser for each part"));
        }
        let mut address = address;
        for (item, of) in items.iter().zip(&parts) {
            self.initialise(address, of, item)?;
            address += self.cells(of);
        }
        Ok(())
    }

    fn repeat(
        &mut self,
        condition: Option<&'u Expression>,
        step: Option<&'u Expression>,
        body: &'u Statement,
        body_first: bool,
    ) -> Result<(), Missing> {
        let target = Target { continues: Some(Vec::new()), scopes: self.scopes.len(), ..Target::default() };
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

    fn switch(&mut self, value: &'u Expression, body: &'u Statement) -> Result<(), Missing> {
        let (value, from) = self.value(value)?;
        if !from.is_integer() {
            return Err(self.missing("a switch over an integer"));
        }
        let value = self.converted(value, &from, &Type::UNSIGNED)?;
        let cell = self.allocate(&Type::UNSIGNED);
        self.store(number(cell), value, &Type::UNSIGNED)?;
        let dispatch = self.jump(self.scopes.len());
        if let Some(frame) = self.frames.last_mut() {
            frame.targets.push(Target { scopes: self.scopes.len(), ..Target::default() });
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

    // ---- expressions

    /// Evaluates an expression for what it does.
    fn effect(&mut self, expression: &'u Expression) -> Result<(), Missing> {
        self.line = expression.line;
        match &expression.kind {
            Kind::Assign(operator, target, value) => self.assign(*operator, target, value),
            Kind::Step(up, _, target) => self.step(*up, target),
            Kind::Cast(Type::Void, inner) => self.effect(inner),
            Kind::Call(name, arguments) if name == "memcpy" => self.copy(arguments),
            Kind::Call(name, arguments) => self.call(name, arguments).map(|_| ()),
            Kind::Name(_) => Ok(()),
            _ => self.value(expression).map(|_| ()),
        }
    }

    fn assign(
        &mut self,
        operator: Option<&'static str>,
        target: &'u Expression,
        value: &'u Expression,
    ) -> Result<(), Missing> {
        let (address, of) = self.place(target)?;
        if let (Type::Struct(_), None) = (&of, operator) {
            let (from, _) = self.place(value)?;
            let count = self.cells(&of);
            self.emit(Operation::Copy(address, from, count));
            return Ok(());
        }
        let (mut value, mut from) = self.value(value)?;
        if let Some(operator) = operator {
            let before = Value::Load(Box::new(address.clone()), self.scalar(&of)?);
            (value, from) = self.operated(operator, (before, of.clone()), (value, from))?;
        }
        let value = self.converted(value, &from, &of)?;
        self.store(address, value, &of)
    }

    fn step(&mut self, up: bool, target: &'u Expression) -> Result<(), Missing> {
        let (address, of) = self.place(target)?;
        let before = Value::Load(Box::new(address.clone()), self.scalar(&of)?);
        let one = (Value::Number(1), Type::INT);
        let (value, from) = self.operated(if up { "+" } else { "-" }, (before, of.clone()), one)?;
        let value = self.converted(value, &from, &of)?;
        self.store(address, value, &of)
    }

    /// `memcpy` of whole scalars; a cell holds its bits, whatever it is read as.
    fn copy(&mut self, arguments: &'u [Expression]) -> Result<(), Missing> {
        let [to, from, size] = arguments else { return Err(self.missing("memcpy of three arguments")) };
        let ((to, to_type), (from, from_type)) = (self.value(to)?, self.value(from)?);
        let (size, _) = self.value(size)?;
        let Some(Constant::Number(size)) = constant_of(&size) else { return Err(self.missing("a constant size")) };
        let mut widths = Vec::new();
        for of in [&to_type, &from_type] {
            let Type::Pointer(of) = of else { return Err(self.missing("pointers for memcpy")) };
            widths.push(self.scalar_bytes(of).ok_or_else(|| self.missing("memcpy of mixed scalars"))?);
        }
        if widths[0] != widths[1] || size % u64::from(widths[0]) != 0 {
            return Err(self.missing("memcpy of scalars of one size"));
        }
        let count = u32::try_from(size / u64::from(widths[0])).map_err(|_| self.missing("a smaller memcpy"))?;
        self.emit(Operation::Copy(to, from, count));
        Ok(())
    }

    /// The bytes of each scalar in a type, if all have the same.
    fn scalar_bytes(&self, of: &Type) -> Option<u32> {
        match of {
            Type::Integer(bytes, _) => Some(u32::from(*bytes)),
            Type::Float => Some(4),
            Type::Array(of, _) => self.scalar_bytes(of),
            Type::Struct(number) => {
                let mut sizes = self.unit.structs[*number].members.iter().map(|(_, of)| self.scalar_bytes(of));
                let first = sizes.next()??;
                sizes.all(|size| size == Some(first)).then_some(first)
            }
            _ => None,
        }
    }

    fn call(&mut self, name: &'u str, arguments: &'u [Expression]) -> Result<Option<(Value, Type)>, Missing> {
        let function = self.function(name)?;
        let mut values = Vec::new();
        for argument in arguments {
            values.push(self.value(argument)?);
        }
        let Some(place) = self.inlined(function, values)? else { return Ok(None) };
        let load = Value::Load(Box::new(number(place.address)), self.scalar(&place.of)?);
        Ok(Some((load, place.of)))
    }

    /// The address of what an expression names, and its type.
    fn place(&mut self, expression: &'u Expression) -> Result<(Value, Type), Missing> {
        match &expression.kind {
            Kind::Name(name) => match self.find(name) {
                Some(place) => Ok((number(place.address), place.of.clone())),
                None => Err(self.missing(format!("the name `{name}`"))),
            },
            Kind::Unary("*", pointer) => match self.value(pointer)? {
                (address, Type::Pointer(of)) => Ok((address, *of)),
                _ => Err(self.missing("a pointer")),
            },
            Kind::Member(of, name) => {
                let (address, of) = self.place(of)?;
                let Type::Struct(structure) = of else { return Err(self.missing("a structure")) };
                let structure = &self.unit.structs[structure];
                let mut offset = 0;
                for (member, of) in &structure.members {
                    if member == name {
                        return Ok((moved(address, number(offset)), of.clone()));
                    }
                    offset += if structure.union { 0 } else { self.cells(of) };
                }
                Err(self.missing(format!("the member `{name}`")))
            }
            Kind::Index(array, index) => {
                let (index, from) = self.value(index)?;
                if !from.is_integer() {
                    return Err(self.missing("an integer as index"));
                }
                let index = self.converted(index, &from, &Type::UNSIGNED)?;
                let (address, of, index) = match self.try_place(array)? {
                    Some((address, Type::Array(of, count))) => {
                        let index = Value::Below(Box::new(index), count);
                        (address, *of, index)
                    }
                    _ => match self.value(array)? {
                        (address, Type::Pointer(of)) => (address, *of, index),
                        _ => return Err(self.missing("an array")),
                    },
                };
                let size = number(self.cells(&of));
                let offset = Value::Apply(Operator::Multiply, Width::W32, Box::new(index), Box::new(size));
                Ok((moved(address, offset), of))
            }
            _ => Err(self.missing("something with an address")),
        }
    }

    fn try_place(&mut self, expression: &'u Expression) -> Result<Option<(Value, Type)>, Missing> {
        match expression.kind {
            Kind::Name(_) | Kind::Unary("*", _) | Kind::Member(..) | Kind::Index(..) => {
                self.place(expression).map(Some)
            }
            _ => Ok(None),
        }
    }

    /// The value of an expression. Its side effects are emitted before.
    fn value(&mut self, expression: &'u Expression) -> Result<(Value, Type), Missing> {
        self.line = expression.line;
        match &expression.kind {
            Kind::Integer(number, of) => Ok((Value::Number(*number), of.clone())),
            Kind::Float(value, of) => Ok((Value::Float((*value as f32).to_bits()), of.clone())),
            Kind::Name(name) if self.find(name).is_none() => match self.unit.constants.get(name) {
                Some(&value) => Ok((Value::Number(u64::from(value as u32)), Type::INT)),
                None => Err(self.missing(format!("the name `{name}`"))),
            },
            Kind::Name(_) | Kind::Index(..) | Kind::Member(..) | Kind::Unary("*", _) => {
                let (address, of) = self.place(expression)?;
                match of {
                    Type::Array(of, _) => Ok((address, Type::Pointer(of))),
                    of => Ok((Value::Load(Box::new(address), self.scalar(&of)?), of)),
                }
            }
            Kind::Unary("&", inner) => {
                let (address, of) = self.place(inner)?;
                Ok((address, Type::Pointer(Box::new(of))))
            }
            Kind::Unary("!", _) => {
                let condition = self.condition(expression)?;
                Ok((Value::OfCondition(Box::new(condition)), Type::INT))
            }
            Kind::Unary(sign, inner) => {
                let (value, of) = self.value(inner)?;
                match (*sign, &of) {
                    ("-", Type::Float) => Ok((Value::Negative(Box::new(value)), of)),
                    ("-", Type::Double) => match value {
                        Value::Float(bits) => Ok((Value::Float(bits ^ 0x8000_0000), of)),
                        _ => Err(self.missing("arithmetic in binary64")),
                    },
                    ("+", Type::Float | Type::Double) => Ok((value, of)),
                    ("-" | "~" | "+", Type::Integer(..)) => {
                        let wide = promoted(&of);
                        let value = self.converted(value, &of, &wide)?;
                        let width = width(&wide);
                        let (operator, first) = match *sign {
                            "-" => (Operator::Subtract, 0),
                            "~" => (Operator::Xor, width.mask()),
                            _ => (Operator::Add, 0),
                        };
                        Ok((Value::Apply(operator, width, Box::new(Value::Number(first)), Box::new(value)), wide))
                    }
                    _ => Err(self.missing(format!("`{sign}` of another type"))),
                }
            }
            Kind::Binary("&&" | "||" | "==" | "!=" | "<" | ">" | "<=" | ">=", ..) => {
                let condition = self.condition(expression)?;
                Ok((Value::OfCondition(Box::new(condition)), Type::INT))
            }
            Kind::Binary(operator, a, b) => {
                let (a, b) = (self.value(a)?, self.value(b)?);
                self.line = expression.line;
                self.operated(operator, a, b)
            }
            Kind::Conditional(condition, a, b) => self.chosen(condition, a, b),
            Kind::Cast(of, inner) => {
                let (value, from) = self.value(inner)?;
                Ok((self.converted(value, &from, of)?, of.clone()))
            }
            Kind::Call(name, arguments) => match (name.as_str(), &arguments[..]) {
                ("fabsf", [inner]) => {
                    let (value, from) = self.value(inner)?;
                    let value = self.converted(value, &from, &Type::Float)?;
                    Ok((Value::Magnitude(Box::new(value)), Type::Float))
                }
                ("isnan", [_]) => {
                    let condition = self.condition(expression)?;
                    Ok((Value::OfCondition(Box::new(condition)), Type::INT))
                }
                _ => self.call(name, arguments)?.ok_or_else(|| self.missing(format!("a result of `{name}`"))),
            },
            Kind::Assign(_, target, _) | Kind::Step(_, false, target) => {
                self.effect(expression)?;
                self.value(target)
            }
            Kind::Step(_, true, target) => {
                let (value, of) = self.value(target)?;
                let cell = self.allocate(&of);
                self.store(number(cell), value, &of)?;
                self.effect(expression)?;
                Ok((Value::Load(Box::new(number(cell)), self.scalar(&of)?), of))
            }
            Kind::SizeOf(inner) => {
                let mark = self.here();
                let of = match self.try_place(inner)? {
                    Some((_, of)) => of,
                    None => self.value(inner)?.1,
                };
                self.program.operations.truncate(mark);
                Ok((number(self.bytes(&of)), Type::UNSIGNED))
            }
            Kind::SizeOfType(of) => Ok((number(self.bytes(of)), Type::UNSIGNED)),
            Kind::List(_) => Err(self.missing("braces here")),
        }
    }

    fn chosen(
        &mut self,
        condition: &'u Expression,
        a: &'u Expression,
        b: &'u Expression,
    ) -> Result<(Value, Type), Missing> {
        let condition = self.condition(condition)?;
        let mark = self.here();
        let ((first, x), (second, y)) = (self.value(a)?, self.value(b)?);
        let of = if x == y && !x.is_integer() { x.clone() } else { self.common(&x, &y)? };
        if self.here() == mark {
            let (first, second) = (self.converted(first, &x, &of)?, self.converted(second, &y, &of)?);
            return Ok((Value::If(Box::new(condition), Box::new(first), Box::new(second)), of));
        }
        // something happens on the way: only on the side that is chosen
        self.program.operations.truncate(mark);
        let cell = self.allocate(&of);
        let branch = self.emit(Operation::Branch(condition, usize::MAX));
        let (first, x) = self.value(a)?;
        let first = self.converted(first, &x, &of)?;
        self.store(number(cell), first, &of)?;
        let end = self.jump(self.scopes.len());
        self.land(&[branch]);
        let (second, y) = self.value(b)?;
        let second = self.converted(second, &y, &of)?;
        self.store(number(cell), second, &of)?;
        self.land(&[end]);
        Ok((Value::Load(Box::new(number(cell)), self.scalar(&of)?), of))
    }

    /// An expression as a condition.
    fn condition(&mut self, expression: &'u Expression) -> Result<Condition, Missing> {
        self.line = expression.line;
        match &expression.kind {
            Kind::Unary("!", inner) => Ok(Condition::Not(Box::new(self.condition(inner)?))),
            Kind::Binary(sign @ ("&&" | "||"), a, b) => {
                let first = self.condition(a)?;
                let mark = self.here();
                let second = self.condition(b)?;
                if self.here() != mark {
                    // what happens in the second operand happens only if the first asks for it
                    self.program.operations.truncate(mark);
                    return self.lazily(*sign == "&&", first, b);
                }
                let (first, second) = (Box::new(first), Box::new(second));
                Ok(if *sign == "&&" { Condition::And(first, second) } else { Condition::Or(first, second) })
            }
            Kind::Binary(sign @ ("==" | "!=" | "<" | ">" | "<=" | ">="), a, b) => {
                let ((a, x), (b, y)) = (self.value(a)?, self.value(b)?);
                self.line = expression.line;
                self.compared(sign, (a, x), (b, y))
            }
            Kind::Call(name, arguments) if name == "isnan" && arguments.len() == 1 => {
                let (value, from) = self.value(&arguments[0])?;
                Ok(Condition::Nan(self.converted(value, &from, &Type::Float)?))
            }
            _ => {
                let (value, of) = self.value(expression)?;
                match of {
                    Type::Integer(..) => Ok(Condition::NonZero(width(&of), value)),
                    Type::Float => Ok(Condition::Not(Box::new(Condition::Equal(value, Value::Float(0))))),
                    _ => Err(self.missing("a condition of another type")),
                }
            }
        }
    }

    fn lazily(&mut self, and: bool, first: Condition, second: &'u Expression) -> Result<Condition, Missing> {
        let cell = self.allocate(&Type::INT);
        self.store(number(cell), Value::Number(u64::from(!and)), &Type::INT)?;
        let first = if and { first } else { Condition::Not(Box::new(first)) };
        let branch = self.emit(Operation::Branch(first, usize::MAX));
        let second = self.condition(second)?;
        self.store(number(cell), Value::OfCondition(Box::new(second)), &Type::INT)?;
        self.land(&[branch]);
        Ok(Condition::NonZero(Width::W32, Value::Load(Box::new(number(cell)), Scalar::Word(Width::W32))))
    }

    fn compared(&mut self, sign: &str, (a, x): (Value, Type), (b, y): (Value, Type)) -> Result<Condition, Missing> {
        if self.common(&x, &y)? == Type::Float {
            let (a, b) = (self.converted(a, &x, &Type::Float)?, self.converted(b, &y, &Type::Float)?);
            return Ok(match sign {
                "==" => Condition::Equal(a, b),
                "!=" => Condition::Not(Box::new(Condition::Equal(a, b))),
                "<" => Condition::Less(a, b),
                ">" => Condition::Less(b, a),
                "<=" => Condition::LessOrEqual(a, b),
                _ => Condition::LessOrEqual(b, a),
            });
        }
        let of = self.common(&x, &y)?;
        let (a, b) = (self.converted(a, &x, &of)?, self.converted(b, &y, &of)?);
        let Type::Integer(_, signed) = of else { return Err(self.missing("a comparison of another type")) };
        let width = width(&of);
        let not = |condition| Condition::Not(Box::new(condition));
        Ok(match sign {
            "==" => Condition::Same(width, a, b),
            "!=" => not(Condition::Same(width, a, b)),
            "<" => Condition::Below(signed, width, a, b),
            ">" => Condition::Below(signed, width, b, a),
            "<=" => not(Condition::Below(signed, width, b, a)),
            _ => not(Condition::Below(signed, width, a, b)),
        })
    }

    fn operated(&mut self, sign: &str, (a, x): (Value, Type), (b, y): (Value, Type)) -> Result<(Value, Type), Missing> {
        if let (Type::Pointer(of), "+", Type::Integer(..)) = (&x, sign, &y) {
            let index = self.converted(b, &y, &Type::UNSIGNED)?;
            let size = number(self.cells(of));
            let offset = Value::Apply(Operator::Multiply, Width::W32, Box::new(index), Box::new(size));
            return Ok((moved(a, offset), x));
        }
        let shifts = matches!(sign, "<<" | ">>");
        let of = if shifts { promoted(&x) } else { self.common(&x, &y)? };
        if of == Type::Float {
            let (a, b) = (self.converted(a, &x, &of)?, self.converted(b, &y, &of)?);
            let (operation, b) = match sign {
                "+" => (Arithmetic::Add, b),
                "-" => (Arithmetic::Add, Value::Negative(Box::new(b))),
                "*" => (Arithmetic::Multiply, b),
                "/" => (Arithmetic::Divide, b),
                _ => return Err(self.missing(format!("`{sign}` of floats"))),
            };
            return Ok((Value::Arithmetic(operation, Box::new(a), Box::new(b)), of));
        }
        let Type::Integer(_, signed) = of else { return Err(self.missing(format!("`{sign}` of this type"))) };
        let operator = match sign {
            "+" => Operator::Add,
            "-" => Operator::Subtract,
            "*" => Operator::Multiply,
            "/" if !signed => Operator::Divide,
            "%" if !signed => Operator::Modulo,
            "&" => Operator::And,
            "|" => Operator::Or,
            "^" => Operator::Xor,
            "<<" => Operator::ShiftLeft,
            ">>" if signed => Operator::ShiftArithmetic,
            ">>" => Operator::ShiftRight,
            _ => return Err(self.missing(format!("`{sign}` of signed integers"))),
        };
        let a = self.converted(a, &x, &of)?;
        let b = if shifts { self.converted(b, &y, &Type::UNSIGNED)? } else { self.converted(b, &y, &of)? };
        Ok((Value::Apply(operator, width(&of), Box::new(a), Box::new(b)), of))
    }

    /// The type in which two operands are computed with.
    fn common(&self, x: &Type, y: &Type) -> Result<Type, Missing> {
        match (x, y) {
            (Type::Double, _) | (_, Type::Double) => Err(self.missing("arithmetic in binary64")),
            (Type::Float, Type::Float | Type::Integer(..)) | (Type::Integer(..), Type::Float) => Ok(Type::Float),
            (Type::Integer(..), Type::Integer(..)) => {
                let (Type::Integer(a, s), Type::Integer(b, t)) = (promoted(x), promoted(y)) else {
                    return Err(self.missing("integers"));
                };
                // the wider one, or unsigned if either of the same size is
                Ok(Type::Integer(
                    a.max(b),
                    if a == b {
                        s && t
                    } else if a > b {
                        s
                    } else {
                        t
                    },
                ))
            }
            _ => Err(self.missing("operands of another type")),
        }
    }

    fn converted(&self, value: Value, from: &Type, to: &Type) -> Result<Value, Missing> {
        let apply =
            |operator, width, a: Value, b: u64| Value::Apply(operator, width, Box::new(a), Box::new(Value::Number(b)));
        match (from, to) {
            _ if from == to => Ok(value),
            (Type::Pointer(_), Type::Pointer(_)) | (_, Type::Void) => Ok(value),
            // a constant of the wider type: it is rounded once more
            (Type::Double, Type::Float) if matches!(value, Value::Float(_)) => Ok(value),
            (Type::Integer(bytes, signed), Type::Float) if *bytes <= 4 => {
                Ok(Value::OfInteger(*signed, Box::new(value)))
            }
            (Type::Float, Type::Integer(..)) => Err(self.missing("a float that is in the range of an integer")),
            (Type::Integer(a, signed), Type::Integer(b, to_signed)) => Ok(match (a, b) {
                (8, 8) => value,
                (_, 8) if *signed => {
                    let flipped = apply(Operator::Xor, Width::W64, value, 0x8000_0000);
                    apply(Operator::Subtract, Width::W64, flipped, 0x8000_0000)
                }
                (_, 8) => value,
                (8, _) | (_, 1 | 2) if *to_signed && *b < 4 => {
                    let unused = 32 - 8 * u64::from(*b);
                    let upper = apply(Operator::ShiftLeft, Width::W32, value, unused);
                    apply(Operator::ShiftArithmetic, Width::W32, upper, unused)
                }
                (8, _) | (_, 1 | 2) => {
                    let width = if *a == 8 { Width::W64 } else { Width::W32 };
                    apply(Operator::And, width, value, (1 << (8 * u64::from(*b))) - 1)
                }
                _ => value,
            }),
            _ => Err(self.missing(format!("a conversion from {from:?} to {to:?}"))),
        }
    }
}

fn is_float(of: &Type) -> bool {
    match of {
        Type::Array(of, _) => is_float(of),
        of => *of == Type::Float,
    }
}

fn moved(address: Value, offset: Value) -> Value {
    Value::Moved(Box::new(address), Box::new(offset))
}

fn promoted(of: &Type) -> Type {
    match of {
        Type::Integer(1 | 2, _) => Type::INT,
        of => of.clone(),
    }
}

fn width(of: &Type) -> Width {
    match of {
        Type::Integer(8, _) => Width::W64,
        _ => Width::W32,
    }
}

/// The constant that a value is.
fn constant_of(value: &Value) -> Option<Constant> {
    match value {
        Value::Number(number) => Some(Constant::Number(*number)),
        Value::Float(bits) => Some(Constant::Float(*bits)),
        Value::Negative(inner) => match constant_of(inner)? {
            Constant::Float(bits) => Some(Constant::Float(bits ^ 0x8000_0000)),
            Constant::Number(_) => None,
        },
        Value::Apply(operator, width, a, b) => match (constant_of(a)?, constant_of(b)?) {
            (Constant::Number(a), Constant::Number(b)) => {
                Some(Constant::Number(crate::term::computed(*operator, *width, a, b)))
            }
            _ => None,
        },
        Value::OfInteger(signed, inner) => match constant_of(inner)? {
            Constant::Number(number) => {
                let value = if *signed { number as u32 as i32 as f32 } else { number as u32 as f32 };
                Some(Constant::Float(value.to_bits()))
            }
            Constant::Float(_) => None,
        },
        _ => None,
    }
}
