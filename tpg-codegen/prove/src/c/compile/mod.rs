//! Compiles functions from their tokens straight into operations; a call reads the function's text again, where it is called.

mod declaration;
mod expression;
mod memory;
mod operation;
mod statement;

use super::code::{Operation, Program};
use super::token::{Placed, Token};
use super::value::Here;
use crate::code::{Computed, Expression, number, of};
use crate::input::{Missing, Result};
use crate::machine::{Cells, Interface, Value};
use crate::term::{Operator, Terms, Width};
use Operation::*;
use Token::{End, Name, Sign};
use Type::*;
use std::collections::HashMap;
use std::rc::Rc;

/// A type. Scalars are one cell each, however many bytes.
#[derive(Clone, Debug, PartialEq)]
pub(super) enum Type {
    Void,
    /// Bytes, and whether it is signed
    Integer(u8, bool),
    Float,

    Struct(usize),
    Array(Box<Type>, u32),
    Pointer(Box<Type>),
}

impl Type {
    const INT: Self = Self::Integer(4, true);
    const UNSIGNED: Self = Self::Integer(4, false);
}

/// The members of a structure.
type Members = Vec<(String, Type)>;

/// A function, and the token at which its body begins.
#[derive(Debug)]
pub(super) struct Function {
    pub(super) name: String,
    result: Type,
    parameters: Vec<(String, Type)>,
    body: usize,
}

/// A loop or switch around a `break` or `continue`.
#[derive(Default)]
struct JumpTarget {
    breaks: Vec<usize>,
    continues: Vec<usize>,
    /// Those of a switch: the numbers, none for the default, and where they are
    cases: Option<Vec<(Option<u64>, usize)>>,
    scopes: usize,
}

/// A function that is being inlined.
#[derive(Default)]
struct CallFrame {
    labels: HashMap<String, (usize, Vec<usize>)>,
    gotos: Vec<(usize, String, Vec<usize>)>,
    returns: Vec<usize>,
    /// Its address
    result: Option<Typed>,
    scopes: usize,
    targets: Vec<JumpTarget>,
}

/// What an expression is.
enum Operand {
    Place(Expression, Type),
    Value(Expression, Type),
}

type Typed = (Expression, Type);

/// A compiler of a file, at one of its tokens.
pub(super) struct Compiler<'t> {
    file: &'t str,
    tokens: Vec<Placed>,
    at: usize,
    /// The line of the last token
    line: u32,
    types: HashMap<String, Type>,
    tags: HashMap<String, usize>,
    structs: Vec<Members>,
    pub(super) functions: Vec<Rc<Function>>,
    /// Members of enumerations
    constants: HashMap<String, i64>,
    program: Program,
    /// Addresses of variables
    names: Vec<HashMap<String, Typed>>,
    scopes: Vec<usize>,
    frame: CallFrame,
    calls: Vec<Rc<Function>>,
    /// Signed integers are whole numbers, and do not overflow
    exact: bool,
    /// What is being declared is constant
    is_constant: bool,
}

fn apply(operator: Operator, width: Width, a: Expression, b: Expression) -> Expression {
    of(Computed::Apply(operator, width), [a, b])
}

/// Evaluates a constant expression.
pub(super) fn constant(file: &str, tokens: Vec<Placed>) -> Result<i64> {
    let mut compiler = Compiler::new(file, tokens);
    let value = compiler.constant()?;
    if *compiler.peek() == End { Ok(value) } else { compiler.refuse("an operator") }
}

impl<'t> Compiler<'t> {
    fn new(file: &'t str, tokens: Vec<Placed>) -> Self {
        let names = [
            ("void", Void),
            ("float", Float),
            ("int", Type::INT),
            ("unsigned", Type::UNSIGNED),
            ("size_t", Type::UNSIGNED),
            ("uint_fast8_t", Integer(1, false)),
        ];
        let mut types: HashMap<_, _> = names.map(|(name, ty)| (name.to_owned(), ty)).into();
        for bytes in [1, 2, 4, 8] {
            types.insert(format!("uint{}_t", 8 * bytes), Integer(bytes, false));
            types.insert(format!("int{}_t", 8 * bytes), Integer(bytes, true));
        }
        Self {
            file,
            tokens,
            at: 0,
            line: 0,
            types,
            tags: HashMap::new(),
            structs: Vec::new(),
            functions: Vec::new(),
            constants: HashMap::new(),
            program: Program::default(),
            names: vec![HashMap::new()],
            scopes: Vec::new(),
            frame: CallFrame::default(),
            calls: Vec::new(),
            exact: false,
            is_constant: false,
        }
    }

    /// Reads a file: its types, its constants, and where its functions are.
    pub(super) fn read(file: &'t str, tokens: Vec<Placed>, exact: bool) -> Result<Self> {
        let mut compiler = Self { exact, ..Self::new(file, tokens) };
        while *compiler.peek() != End {
            compiler.external()?;
        }
        Ok(compiler)
    }

    /// Compiles a function that has the interface of a policy.
    pub(super) fn policy(mut self, name: &str, interface: &Interface) -> Result<Program> {
        let function = self.function(name)?;
        let mut kinds = interface.bytes.iter().map(|&bytes| Integer(bytes, true));
        let mut arguments = Vec::new();
        let mut structures = Vec::new();
        for (_, ty) in &function.parameters {
            let Pointer(target) = ty else { return self.refuse("a parameter that is a pointer") };
            let address = self.allocate(target);
            structures.push((address, &**target));
            arguments.push((number(address), ty.clone()));
        }
        let single = |names: &[String]| names.iter().map(|name| (name.clone(), 1)).collect::<Vec<_>>();
        let mut parameters = structures.into_iter();
        let mut cells = |names: &[(String, u32)]| match parameters.next() {
            Some((address, ty)) => {
                let kinds: Vec<_> = names.iter().map(|_| kinds.next().unwrap_or(Float)).collect();
                self.fields(ty, names, &kinds).map(|()| address..address + self.cells(ty))
            }
            None => self.refuse(format!("other parameters of `{name}`")),
        };
        let state = cells(&interface.sources)?;
        let memory = if interface.memory.is_empty() { 0..0 } else { cells(&single(&interface.memory))? };
        let outputs = if interface.outputs.is_empty() { 0..0 } else { cells(&single(&interface.outputs))? };
        if parameters.next().is_some() {
            return self.refuse(format!("other parameters of `{name}`"));
        }
        let result = self.inlined(&function, arguments)?;
        if result.is_none() == interface.outputs.is_empty() {
            return self.refuse(format!("another result of `{name}`"));
        }
        self.program.inputs = state.chain(memory.clone()).collect();
        self.program.answers = outputs.chain(memory).collect();
        if let Some((Expression::Number(address), _)) = result {
            self.program.answers.push(address as u32);
        }
        self.emit(Return);
        self.program.objects.sort_by_key(|object| object.start);
        Ok(self.program)
    }

    /// Checks that a structure holds numbers with these names and types, in this order; underscores may follow a name.
    fn fields(&self, ty: &Type, names: &[(String, u32)], kinds: &[Type]) -> Result<()> {
        let Struct(number) = ty else { return self.refuse("a pointer to a structure") };
        let members = &self.structs[*number];
        let fits = |member: &(String, Type), ((name, length), kind): (&(String, u32), &Type)| {
            let numbers = match &member.1 {
                ty if ty == kind => 1,
                Array(ty, count) if **ty == *kind => *count,
                _ => 0,
            };
            numbers == *length && member.0.trim_end_matches('_') == name.trim_end_matches('_')
        };
        let mut pairs = members.iter().zip(names.iter().zip(kinds));
        let all = members.len() == names.len() && pairs.all(|(member, name)| fits(member, name));
        if all { Ok(()) } else { self.refuse(format!("a structure of the numbers {names:?}: {kinds:?}")) }
    }

    fn function(&self, name: &str) -> Result<Rc<Function>> {
        let found = self.functions.iter().find(|function| function.name == name);
        found.cloned().ok_or_else(|| self.missing(format!("the meaning of the function `{name}`")))
    }

    /// Inlines a call. The result's place, if it has one.
    fn inlined(&mut self, function: &Rc<Function>, arguments: Vec<Typed>) -> Result<Option<Typed>> {
        if self.calls.iter().any(|call| call.name == function.name) {
            return self.refuse(format!("`{}` calls itself", function.name));
        }
        if arguments.len() != function.parameters.len() {
            return self.refuse(format!("arguments of `{}`", function.name));
        }
        let back = (self.at, self.line);
        let result =
            (function.result != Void).then(|| (number(self.allocate(&function.result)), function.result.clone()));
        let outside = std::mem::take(&mut self.names);
        self.names.push(outside[0].clone());
        let scopes = self.scopes.len();
        self.enter();
        for (value, (name, ty)) in arguments.into_iter().zip(&function.parameters) {
            let address = number(self.allocate(ty));
            self.put(address.clone(), value, ty)?;
            self.bind(name.clone(), (address, ty.clone()));
        }
        self.calls.push(function.clone());
        let frame = CallFrame { result: result.clone(), scopes, ..CallFrame::default() };
        let caller = std::mem::replace(&mut self.frame, frame);
        self.at = function.body;
        while !self.accept("}") {
            self.statement()?;
        }
        self.leave();
        self.calls.pop();
        let frame = std::mem::replace(&mut self.frame, caller);
        for (jump, label, left) in frame.gotos {
            let Some((to, inside)) = frame.labels.get(&label) else {
                self.line = self.program.operations[jump].0;
                return self.refuse(format!("the label `{label}`"));
            };
            let left = left.into_iter().filter(|scope| !inside.contains(scope)).collect();
            self.program.operations[jump].1 = Jump(*to, left);
        }
        self.land(&frame.returns);
        if frame.returns.len() > 1 {
            self.head();
        }
        self.names = outside;
        (self.at, self.line) = back;
        Ok(result)
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
    fn branch(&mut self, condition: Expression) -> usize {
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

    /// Sets what is at an address.
    fn put(&mut self, address: Expression, value: Typed, ty: &Type) -> Result<()> {
        let value = self.converted(value, ty)?;
        self.scalar(ty)?;
        self.emit(Set(address, value, *ty == Float));
        Ok(())
    }

    fn loaded(&self, address: Expression, ty: Type) -> Result<Typed> {
        self.scalar(&ty)?;
        Ok((of(Computed::Loaded(4), [address]), ty))
    }

    /// Refuses what is no scalar.
    fn scalar(&self, ty: &Type) -> Result<()> {
        if matches!(ty, Float | Integer(..) | Pointer(_)) { Ok(()) } else { self.refuse("a scalar") }
    }

    fn peek(&self) -> &Token {
        &self.tokens[self.at].token
    }

    fn next(&mut self) -> Token {
        let Placed { token, line } = self.tokens[self.at].clone();
        self.line = line;
        self.at = (self.at + 1).min(self.tokens.len() - 1);
        token
    }

    fn missing(&self, what: impl Into<String>) -> Missing {
        Missing::new(format!("{}:{}", self.file, self.line), what)
    }

    fn refuse<T>(&self, what: impl Into<String>) -> Result<T> {
        Err(self.missing(what))
    }

    /// Reads a sign or a word, if it is next.
    fn accept(&mut self, text: &str) -> bool {
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

    fn expect(&mut self, sign: &str) -> Result<()> {
        if self.accept(sign) {
            return Ok(());
        }
        let found = self.next();
        self.refuse(format!("`{sign}`, found {found:?}"))
    }

    fn name(&mut self) -> Result<String> {
        match self.next() {
            Name(name) => Ok(name),
            other => self.refuse(format!("a name, found {other:?}")),
        }
    }

    /// Reads what stands between commas up to a sign, before which another comma may be.
    fn list<T>(&mut self, end: &str, mut item: impl FnMut(&mut Self) -> Result<T>) -> Result<Vec<T>> {
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

    /// Skips everything up to the bracket that closes one which was read.
    fn skip(&mut self, open: &'static str, close: &'static str) -> Result<()> {
        let mut depth = 1;
        while depth > 0 {
            match self.next() {
                Sign(sign) if sign == open => depth += 1,
                Sign(sign) if sign == close => depth -= 1,
                End => return self.refuse(format!("`{close}`")),
                _ => {}
            }
        }
        Ok(())
    }
}

fn width(ty: &Type) -> Width {
    match ty {
        Integer(8, _) => Width::W64,
        _ => Width::W32,
    }
}

impl Compiler<'_> {
    /// The constant that a value is: a number, or the bits of a float.
    fn constant_of(&self, value: &Expression) -> Option<u64> {
        let (terms, cells) = (Terms::new(), Cells::new());
        let here = Here { program: &self.program, terms: &terms, cells: &cells, facts: &[] };
        match here.value(value).ok()? {
            Value::Float(float) => {
                terms.bits_of(float).map(u64::from).or_else(|| terms.whole_of(float).map(|value| value as u64))
            }
            Value::Word(word) => terms.number_of(word),
        }
    }
}
