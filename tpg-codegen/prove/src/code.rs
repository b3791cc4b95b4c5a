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
    Root,
    OfInteger(bool),
    /// The second where the first is not 0, else the third
    If,
    Same(Width),
    Below(bool, Width),
    /// What C does with integers
    Integer(Integral, Kind),
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

/// What C does with integers of one type.
#[derive(Clone, Copy, Debug)]
pub(crate) enum Integral {
    Apply(Operator),
    Divide,
    Remainder,
    Same,
    Below,
    /// A conversion from another type
    From(Kind),
}

/// A type of integers: bytes, whether it is signed, and whether code computes in whole numbers. Then all that is signed is one.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Kind {
    pub(crate) bytes: u8,
    pub(crate) signed: bool,
    pub(crate) exact: bool,
}

impl Kind {
    pub(crate) fn width(self) -> Width {
        if self.bytes == 8 { Width::W64 } else { Width::W32 }
    }

    /// A value of this type as a whole number, if it is one or a constant.
    pub(crate) fn whole(self, terms: &Terms, value: Value) -> Found<Float> {
        let found = match value {
            Value::Float(number) => terms.is_whole(number).then_some(number),
            Value::Word(word) => terms.whole_of_word(word, self.signed.then_some(self.width())),
        };
        found.ok_or("an integer that is computed exactly")
    }

    /// Tests whether the type holds the result of an operation of words whatever these are.
    fn holds(self, terms: &Terms, operator: Operator, words: [Word; 2]) -> bool {
        let width = self.width();
        let most = i128::from(width.mask() / 2);
        let ends = |word| match (terms.numbers(word), terms.largest(word).into()) {
            (Some(numbers), _) => numbers.iter().map(|&number| i128::from(width.signed(number))).collect(),
            (None, largest) if largest <= most => vec![0, largest],
            _ => vec![-most - 1, most],
        };
        let [first, second] = words.map(ends);
        let mut pairs = first.iter().flat_map(|a| second.iter().map(move |b| (*a, *b)));
        pairs.all(|(a, b)| {
            let result = match operator {
                Operator::Add => a + b,
                Operator::Subtract => a - b,
                Operator::Multiply => a * b,
                Operator::ShiftLeft if a >= 0 && (0..64).contains(&b) => a << b,
                Operator::ShiftLeft => return false,
                _ => 0,
            };
            (-most - 1..=most).contains(&result)
        })
    }

    /// Checks that the type holds a number wherever facts hold.
    fn holding(self, terms: &Terms, number: Float, facts: &[Bool]) -> Found<Float> {
        let end = 1_i128 << (8 * self.bytes - u8::from(self.signed));
        let fits = match terms.interval_under(number, facts) {
            Some([low, high]) => (if self.signed { -end } else { 0 }) <= low && high < end,
            None => true,
        };
        if fits { Ok(number) } else { Err("a number that its integer type holds") }
    }
}

/// The result of what C does with integers, where facts hold.
fn integral(terms: &Terms, what: Integral, kind: Kind, values: &[Value], facts: &[Bool]) -> Found<Value> {
    let of = if let Integral::From(from) = what { from } else { kind };
    let is_whole = |value: &Value| matches!(*value, Value::Float(number) if terms.is_whole(number));
    if values.iter().any(is_whole) || kind.exact && (kind.signed || of.signed) {
        let wholes = values.iter().map(|&value| of.whole(terms, value)).collect::<Found<Vec<_>>>()?;
        return exact(terms, what, kind, &wholes, facts);
    }
    let (width, word) = (of.width(), |at: usize| values[at].bits(terms));
    Ok(Value::Word(match what {
        Integral::Divide | Integral::Remainder => return Err("a quotient of whole numbers"),
        Integral::Apply(operator) if kind.signed && !kind.holds(terms, operator, [word(0), word(1)]) => {
            return Err("a signed integer that holds the result");
        }
        Integral::Apply(operator) => terms.apply(operator, width, word(0), word(1)),
        Integral::Same => terms.word_of(terms.same(width, word(0), word(1))),
        Integral::Below => terms.word_of(terms.below(kind.signed, width, word(0), word(1))),
        Integral::From(from) if from.signed && kind.bytes == 8 || kind.signed && kind.bytes < 4 => {
            return Err("an unsigned integer");
        }
        Integral::From(from) if kind.bytes < 4 || from.bytes == 8 && kind.bytes == 4 => {
            let mask = (1 << (8 * u64::from(kind.bytes))) - 1;
            let fits = || terms.numbers(word(0)).is_some_and(|numbers| numbers.iter().all(|&number| number <= mask));
            if kind.exact && !fits() {
                return Err("a number that its integer type holds");
            }
            terms.apply(Operator::And, width, word(0), terms.number(mask))
        }
        Integral::From(_) => word(0),
    }))
}

/// The result of what C does with integers that are whole numbers. It is refused unless nothing overflows.
fn exact(terms: &Terms, what: Integral, kind: Kind, values: &[Float], facts: &[Bool]) -> Found<Value> {
    use Operator::{Add, Multiply, ShiftArithmetic, ShiftRight, Subtract, Xor};
    let ones = terms.whole(if kind.signed { -1 } else { (1 << (8 * kind.bytes)) - 1 });
    let result = match (what, values) {
        (Integral::Same, &[a, b]) => return Ok(Value::Word(terms.word_of(terms.equal(a, b)))),
        (Integral::Below, &[a, b]) => return Ok(Value::Word(terms.word_of(terms.less(a, b)))),
        (Integral::Apply(Add), &[a, b]) => terms.add(a, b),
        (Integral::Apply(Subtract), &[a, b]) => terms.subtract(a, b),
        (Integral::Apply(Multiply), &[a, b]) => terms.multiply(a, b),
        (Integral::Apply(Xor), &[a, b]) if a == ones => terms.subtract(a, b),
        (Integral::Divide | Integral::Remainder, &[a, b]) => {
            if terms.all([facts, &[terms.equal(b, terms.whole(0))]].concat()) != Terms::FALSE {
                return Err("a divisor that is never 0");
            }
            let quotient = kind.holding(terms, terms.divide(a, b), facts)?;
            if let Integral::Divide = what { quotient } else { terms.remainder(a, b) }
        }
        (Integral::Apply(ShiftRight | ShiftArithmetic), &[a, b]) => {
            // C leaves it to the compiler what becomes of negative numbers
            Kind { signed: false, ..kind }.holding(terms, a, facts)?;
            let by = terms.whole_of(b).filter(|by| (0..64).contains(by)).ok_or("a shift by a constant")?;
            terms.shifted(a, 1 << by)
        }
        (Integral::From(_), &[a]) => a,
        _ => return Err("an operation of integers that is exact"),
    };
    let result = kind.holding(terms, result, facts)?;
    let word = terms.word_of_whole(result).filter(|_| !kind.signed);
    Ok(word.map_or(Value::Float(result), Value::Word))
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

/// The value of an expression where facts hold. What depends on the kind of code is computed by a function.
pub(crate) fn value(
    terms: &Terms,
    expression: &Expression,
    facts: &[Bool],
    own: &dyn Fn(Computed, &[Value]) -> Found<Value>,
) -> Found<Value> {
    let (name, parts) = match expression {
        Expression::Number(number) => return Ok(Value::Word(terms.number(*number))),
        Expression::Float(bits) => return Ok(Value::Float(terms.constant_bits(*bits))),
        Expression::Of(name, parts) => (*name, parts),
    };
    if let (Computed::If, [condition, a, b]) = (name, &parts[..]) {
        let condition = holds(terms, value(terms, condition, facts, own)?);
        let side = |side, held| value(terms, side, &[facts, &terms.parts(held)].concat(), own);
        return match condition {
            Terms::TRUE => side(a, condition),
            Terms::FALSE => side(b, !condition),
            _ => Ok(Value::chosen(terms, condition, side(a, condition)?, side(b, !condition)?)),
        };
    }
    let values = parts.iter().map(|part| value(terms, part, facts, own)).collect::<Found<Vec<_>>>()?;
    let (word, float) = (|at: usize| values[at].bits(terms), |at: usize| values[at].float(terms));
    let truth = |condition| Value::Word(terms.word_of(condition));
    Ok(match name {
        Computed::Apply(operator, width) => Value::Word(terms.apply(operator, width, word(0), word(1))),
        Computed::Arithmetic(operation) => Value::Float(terms.arithmetic(operation, float(0), float(1))),
        Computed::Negative => Value::Float(terms.negate(float(0))),
        Computed::Magnitude => Value::Float(terms.magnitude(float(0))),
        Computed::Root => Value::Float(terms.root(float(0))),
        Computed::OfInteger(signed) => Value::Float(terms.of_integer(signed, word(0))),
        Computed::Same(width) => truth(terms.same(width, word(0), word(1))),
        Computed::Below(signed, width) => truth(terms.below(signed, width, word(0), word(1))),
        Computed::Integer(what, kind) => integral(terms, what, kind, &values, facts)?,
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
