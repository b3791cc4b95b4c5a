//! Lowers the syntax tree of a function into operations.

mod expression;
mod memory;
mod statement;

use crate::c::code::{Condition, Constant, Operation, Program, Scalar, Value};
use crate::c::syntax::{Function, Type, Unit};
use crate::input::Missing;
use crate::machine::Interface;
use crate::term::{Operator, Width};
use Operation::*;
use Type::*;
use std::collections::HashMap;

#[derive(Clone, Debug)]
struct Lvalue {
    address: u32,
    ty: Type,
}

/// What `break` and `continue` of a loop or switch refer to.
#[derive(Default)]
struct JumpTarget {
    breaks: Vec<usize>,
    /// None in a switch
    continues: Option<Vec<usize>>,
    /// Those of a switch: the numbers, none for the default, and where they are
    cases: Vec<(Option<u64>, usize)>,
    scopes: usize,
}

/// A function that is being inlined.
#[derive(Default)]
struct CallFrame {
    labels: HashMap<String, (usize, Vec<usize>)>,
    gotos: Vec<(usize, String, Vec<usize>, u32)>,
    returns: Vec<usize>,
    result: Option<Lvalue>,
    scopes: usize,
    targets: Vec<JumpTarget>,
}

pub(super) struct Lowering<'u> {
    file: &'u str,
    unit: &'u Unit,
    program: Program,
    names: Vec<HashMap<String, Lvalue>>,
    scopes: Vec<usize>,
    frame: CallFrame,
    calls: Vec<&'u str>,
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
    let argument = lowering.allocate(&Float);
    let argument = lowering.loaded(number(argument), Float)?;
    let called = lowering.function(name)?;
    let result = lowering.inlined(called, vec![argument])?;
    lowering.program.result = result.map(|place| place.address);
    lowering.emit(Return);
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
            frame: CallFrame::default(),
            calls: Vec::new(),
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
        for (_, ty) in &function.parameters {
            let Pointer(target) = ty else { return Err(self.missing("a parameter that is a pointer")) };
            let address = self.allocate(target);
            structures.push((address, (**target).clone()));
            arguments.push((number(address), ty.clone()));
        }
        let memory = !interface.memory.is_empty();
        let values = !interface.outputs.is_empty();
        if structures.len() != 1 + usize::from(memory) + usize::from(values) {
            return Err(self.missing(format!("other parameters of `{name}`")));
        }
        let single = |names: &[String]| names.iter().map(|name| (name.clone(), 1)).collect::<Vec<_>>();
        self.fields(&structures[0].1, &interface.sources)?;
        self.program.state = structures[0].0;
        if memory {
            self.fields(&structures[1].1, &single(&interface.memory))?;
            self.program.memory = Some(structures[1].0);
        }
        if values {
            let (address, ty) = &structures[structures.len() - 1];
            self.program.action = Some(*address);
            self.fields(ty, &single(&interface.outputs))?;
        }
        let result = self.inlined(function, arguments)?;
        self.program.result = result.map(|place| place.address);
        if self.program.result.is_none() != values {
            return Err(self.missing(format!("another result of `{name}`")));
        }
        self.emit(Return);
        Ok(())
    }

    /// Checks that a structure holds floats with these names, in this order; underscores may follow a name.
    fn fields(&self, ty: &Type, names: &[(String, u32)]) -> Result<(), Missing> {
        let Struct(number) = ty else { return Err(self.missing("a pointer to a structure")) };
        let members = &self.unit.structs[*number].members;
        let fits = |member: &(String, Type), (name, length): &(String, u32)| {
            let floats = match &member.1 {
                Float => 1,
                Array(ty, count) if **ty == Float => *count,
                _ => 0,
            };
            floats == *length && member.0.trim_end_matches('_') == name.trim_end_matches('_')
        };
        let all = members.len() == names.len() && members.iter().zip(names).all(|(member, name)| fits(member, name));
        if all { Ok(()) } else { Err(self.missing(format!("a structure of the floats {names:?}"))) }
    }

    fn emit(&mut self, operation: Operation) -> usize {
        self.program.operations.push((self.line, operation));
        self.program.operations.len() - 1
    }

    fn here(&self) -> usize {
        self.program.operations.len()
    }

    /// Execution may be cut here.
    fn head(&mut self) {
        let here = self.here();
        self.program.heads.entry(here).or_insert(false);
    }

    /// Goes on if the condition holds; where else is told later.
    fn branch(&mut self, condition: Condition) -> usize {
        self.emit(Branch(condition, usize::MAX))
    }

    fn land(&mut self, jumps: &[usize]) {
        let here = self.here();
        for &jump in jumps {
            match &mut self.program.operations[jump].1 {
                Jump(to, _) | Branch(_, to) => *to = here,
                _ => {}
            }
        }
    }

    fn jump(&mut self, from_scope: usize) -> usize {
        let left = self.scopes[from_scope..].to_vec();
        self.emit(Jump(usize::MAX, left))
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
            self.emit(Leave(scope));
        }
    }

    /// Inlines a call. The result's place, if it has one.
    fn inlined(&mut self, function: &'u Function, arguments: Vec<(Value, Type)>) -> Result<Option<Lvalue>, Missing> {
        if self.calls.contains(&function.name.as_str()) {
            return Err(self.missing(format!("`{}` calls itself", function.name)));
        }
        if arguments.len() != function.parameters.len() {
            return Err(self.missing(format!("arguments of `{}`", function.name)));
        }
        let line = self.line;
        let result = (function.result != Void)
            .then(|| Lvalue { address: self.allocate(&function.result), ty: function.result.clone() });
        let outside = std::mem::take(&mut self.names);
        self.names.push(outside[0].clone());
        let scopes = self.scopes.len();
        self.enter();
        for (value, (name, ty)) in arguments.into_iter().zip(&function.parameters) {
            let place = Lvalue { address: self.allocate(ty), ty: ty.clone() };
            self.put(number(place.address), value, ty)?;
            self.bind(name.clone(), place);
        }
        self.calls.push(&function.name);
        let frame = CallFrame { result: result.clone(), scopes, ..CallFrame::default() };
        let caller = std::mem::replace(&mut self.frame, frame);
        for statement in &function.body {
            self.statement(statement)?;
        }
        self.leave();
        self.calls.pop();
        let frame = std::mem::replace(&mut self.frame, caller);
        for (jump, label, left, line) in frame.gotos {
            let Some((to, inside)) = frame.labels.get(&label) else {
                self.line = line;
                return Err(self.missing(format!("the label `{label}`")));
            };
            let left = left.into_iter().filter(|scope| !inside.contains(scope)).collect();
            self.program.operations[jump].1 = Jump(*to, left);
        }
        self.land(&frame.returns);
        if frame.returns.len() > 1 {
            self.head();
        }
        self.names = outside;
        self.line = line;
        Ok(result)
    }

    /// Sets what is at an address.
    fn put(&mut self, address: Value, value: (Value, Type), ty: &Type) -> Result<(), Missing> {
        let value = self.converted(value, ty)?;
        self.scalar(ty)?;
        self.emit(Set(address, value));
        Ok(())
    }

    fn loaded(&self, address: Value, ty: Type) -> Result<(Value, Type), Missing> {
        Ok((Value::Load(Box::new(address), self.scalar(&ty)?), ty))
    }

    fn scalar(&self, ty: &Type) -> Result<Scalar, Missing> {
        match ty {
            Float => Ok(Scalar::Float),
            Type::Integer(..) | Pointer(_) => Ok(Scalar::Word),
            Double => Err(self.missing("arithmetic in binary64")),
            _ => Err(self.missing("a scalar")),
        }
    }
}

fn is_float(ty: &Type) -> bool {
    match ty {
        Array(ty, _) => is_float(ty),
        ty => *ty == Float,
    }
}

fn apply(operator: Operator, width: Width, a: Value, b: Value) -> Value {
    Value::Apply(operator, width, Box::new(a), Box::new(b))
}

fn moved(address: Value, offset: Value) -> Value {
    Value::Moved(Box::new(address), Box::new(offset))
}

fn promoted(ty: &Type) -> Type {
    match ty {
        Type::Integer(1 | 2, _) => Type::INT,
        ty => ty.clone(),
    }
}

fn width(ty: &Type) -> Width {
    match ty {
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
                Some(Constant::Number(crate::term::word::computed(*operator, *width, a, b)))
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
