//! Values that code computes: what a reader of C and a decoder of machine code have in common.

use crate::elf::Address;
use crate::machine::{Region, Value};
use crate::term::{Arithmetic, Bool, Float, Node, Operator, Terms, Width, Word};
use crate::thumb::Register;

/// A value without side effects. Words of 32 bits hold narrower integers as C extends them; conditions are 1 or 0.
#[derive(Clone, Debug)]
pub(crate) enum Expression {
    Number(u64),
    Float(u32),
    Of(Computed, Vec<Expression>),
}

/// A computation on values.
#[derive(Clone, Copy, Debug)]
pub(crate) enum Computed {
    Apply(Operator, Width),
    Arithmetic(Arithmetic),
    Negative,
    Magnitude,
    OfInteger(bool),
    /// The second where the first is not 0, else the third
    If,
    Same(Width),
    Below(bool, Width),
    /// A relation of floats
    Compared(fn(&Terms, Float, Float) -> Bool),
    /// The content of so many bytes at an address
    Loaded(u8),
    /// A number that must be below a length
    Bounded(u32),
    /// An address moved by cells; both must be in one object
    Moved,
    Register(Register),
    /// The address of a part of memory
    Base(Region),
    /// An address of which the operand must be the lower half
    Completed(Address),
    /// Something of which nothing is known
    Unknown,
}

/// A number of 32 bits.
pub(crate) fn number(number: u32) -> Expression {
    Expression::Number(number.into())
}

/// Makes an expression.
pub(crate) fn of<const N: usize>(computed: Computed, parts: [Expression; N]) -> Expression {
    Expression::Of(computed, parts.into())
}

impl std::ops::Not for Expression {
    type Output = Self;

    fn not(self) -> Self {
        of(Computed::Same(Width::W32), [self, Self::Number(0)])
    }
}

/// A value, or what it lacks.
pub(crate) type Found<T> = Result<T, &'static str>;

/// The value of an expression. What depends on the kind of code is computed by a function.
pub(crate) fn value(
    terms: &Terms,
    expression: &Expression,
    own: &dyn Fn(Computed, &[Value]) -> Found<Value>,
) -> Found<Value> {
    let (name, parts) = match expression {
        Expression::Number(number) => return Ok(Value::Word(terms.number(*number))),
        Expression::Float(bits) => return Ok(Value::Float(terms.constant_bits(*bits))),
        Expression::Of(name, parts) => (*name, parts),
    };
    if let (Computed::If, [condition, a, b]) = (name, &parts[..]) {
        let condition = holds(terms, value(terms, condition, own)?);
        return match condition {
            Terms::TRUE => value(terms, a, own),
            Terms::FALSE => value(terms, b, own),
            _ => Ok(Value::chosen(terms, condition, value(terms, a, own)?, value(terms, b, own)?)),
        };
    }
    let values = parts.iter().map(|part| value(terms, part, own)).collect::<Found<Vec<_>>>()?;
    let (word, float) = (|at: usize| values[at].bits(terms), |at: usize| values[at].float(terms));
    let truth = |condition| Value::Word(terms.word_of(condition));
    Ok(match name {
        Computed::Apply(operator, width) => Value::Word(terms.apply(operator, width, word(0), word(1))),
        Computed::Arithmetic(operation) => Value::Float(terms.arithmetic(operation, float(0), float(1))),
        Computed::Negative => Value::Float(terms.negate(float(0))),
        Computed::Magnitude => Value::Float(terms.magnitude(float(0))),
        Computed::OfInteger(signed) => Value::Float(terms.of_integer(signed, word(0))),
        Computed::Same(width) => truth(terms.same(width, word(0), word(1))),
        Computed::Below(signed, width) => truth(terms.below(signed, width, word(0), word(1))),
        Computed::Compared(relation) => truth(relation(terms, float(0), float(1))),
        _ => return own(name, &values),
    })
}

/// Returns the value at an address, or at one of a few that it is chosen from.
pub(crate) fn loaded(terms: &Terms, address: Word, load: &dyn Fn(Word) -> Found<Value>) -> Found<Value> {
    if !matches!(terms.of_word(address), Node::WordIf(..)) {
        return load(address);
    }
    let mut failed = None;
    let value = terms.mapped(address, &mut |address| {
        let value = load(address).map(|value| value.bits(terms));
        value.unwrap_or_else(|error| {
            failed = Some(error);
            address
        })
    });
    failed.map_or(Ok(Value::Word(value)), Err)
}

/// Tests whether a value is not 0.
pub(crate) fn holds(terms: &Terms, value: Value) -> Bool {
    !terms.same(Width::W32, value.bits(terms), terms.number(0))
}
