//! The syntax of the subset of C as a tree.

/// A type. Scalars are one cell each, however many bytes.
#[derive(Clone, Debug, PartialEq)]
pub(super) enum Type {
    Void,
    /// Bytes, and whether it is signed
    Integer(u8, bool),
    Float,
    /// Constants without a suffix only
    Double,
    Struct(usize),
    Array(Box<Type>, u32),
    Pointer(Box<Type>),
}

impl Type {
    pub(super) const INT: Self = Self::Integer(4, true);
    pub(super) const UNSIGNED: Self = Self::Integer(4, false);

    pub(super) fn is_integer(&self) -> bool {
        matches!(self, Self::Integer(..))
    }
}

/// The members of a structure or union.
#[derive(Clone, Debug, Default)]
pub(super) struct Struct {
    pub(super) union: bool,
    pub(super) members: Vec<(String, Type)>,
}

/// An expression and its line.
#[derive(Clone, Debug)]
pub(super) struct Expression {
    pub(super) line: u32,
    pub(super) kind: Kind,
}

#[derive(Clone, Debug)]
pub(super) enum Kind {
    Integer(u64, Type),
    Float(f64, Type),
    Name(String),
    Unary(&'static str, Box<Expression>),
    Binary(&'static str, Box<Expression>, Box<Expression>),
    Conditional(Box<Expression>, Box<Expression>, Box<Expression>),
    Cast(Type, Box<Expression>),
    Call(String, Vec<Expression>),
    Index(Box<Expression>, Box<Expression>),
    Member(Box<Expression>, String),
    /// With the operator of a compound assignment
    Assign(Option<&'static str>, Box<Expression>, Box<Expression>),
    /// An assignment whose result is the old value
    Postfix(Box<Expression>),
    SizeOf(Box<Expression>),
    SizeOfType(Type),
    /// An initialiser in braces
    List(Vec<Expression>),
}

/// A variable that is declared.
#[derive(Clone, Debug)]
pub(super) struct Variable {
    pub(super) line: u32,
    pub(super) name: String,
    pub(super) ty: Type,
    pub(super) is_static: bool,
    pub(super) initial: Option<Expression>,
}

#[derive(Clone, Debug)]
pub(super) struct Statement {
    pub(super) line: u32,
    pub(super) kind: StatementKind,
}

#[derive(Clone, Debug)]
pub(super) enum StatementKind {
    Empty,
    Block(Vec<Statement>),
    Declare(Vec<Variable>),
    Evaluate(Expression),
    If(Expression, Box<Statement>, Option<Box<Statement>>),
    /// First, condition, step, body; whether the body comes before the first test
    Loop(Option<Box<Statement>>, Option<Expression>, Option<Expression>, Box<Statement>, bool),
    Switch(Expression, Box<Statement>),
    Case(Option<Expression>),
    Break,
    Continue,
    Goto(String),
    Label(String),
    Return(Option<Expression>),
}

/// A function with its body.
#[derive(Clone, Debug)]
pub(super) struct Function {
    pub(super) name: String,
    pub(super) result: Type,
    pub(super) parameters: Vec<(String, Type)>,
    pub(super) body: Vec<Statement>,
}

/// A file.
#[derive(Clone, Debug, Default)]
pub(super) struct Unit {
    pub(super) structs: Vec<Struct>,
    pub(super) functions: Vec<Function>,
    pub(super) variables: Vec<Variable>,
    /// Members of enumerations
    pub(super) constants: std::collections::HashMap<String, i64>,
}
