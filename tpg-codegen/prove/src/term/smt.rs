//! Terms as text of SMT-LIB 2.6, for solvers that give a second opinion.
//!
//! Floats are `Float32`, where NaN is one value; words have 64 bits, and whole numbers are `Int`. The bits of a NaN are any that a
//! NaN can have.

use super::{Arithmetic, Bool, Float, Node, Operator, Terms, Width, Word, visit_parts};
use Node::*;
use std::collections::BTreeSet;

/// The beginning of every script. SMT-LIB has no `fmod`: of numbers other than 0 it is any function.
const HEAD: &str = "(set-logic ALL)
(declare-fun proper_fmod (Float32 Float32) Float32)
(define-fun fmod ((a Float32) (b Float32)) Float32 (ite
  (or (fp.isNaN a) (fp.isNaN b) (fp.isInfinite a) (fp.isZero b)) (_ NaN 8 24)
  (ite (fp.isZero a) a (proper_fmod a b))))
";

/// Constants, definitions and assertions. Each node of the table is defined once, as `n` with its number.
#[derive(Debug)]
pub struct Script<'t> {
    terms: &'t Terms,
    text: String,
    defined: BTreeSet<u32>,
    /// Floats of which the bits are declared
    bits: BTreeSet<u32>,
}

impl<'t> Script<'t> {
    /// Begins a script with terms of a table.
    #[must_use]
    pub fn new(terms: &'t Terms) -> Self {
        Self { terms, text: HEAD.to_owned(), defined: BTreeSet::new(), bits: BTreeSet::new() }
    }

    /// A truth value.
    pub fn truth(&mut self, term: Bool) -> String {
        self.name(term.0 >> 1);
        literal(term)
    }

    /// A number.
    pub fn number(&mut self, term: Float) -> String {
        self.name(term.0)
    }

    /// A word.
    pub fn word(&mut self, term: Word) -> String {
        self.name(term.0)
    }

    /// Asserts a formula.
    pub fn assert(&mut self, formula: &str) {
        self.text += &format!("(assert {formula})\n");
    }

    /// The script, which asks whether all that is asserted can hold at once.
    #[must_use]
    pub fn finish(self) -> String {
        self.text + "(check-sat)\n"
    }

    /// The name of a node, which is defined after all of its parts: they have lower numbers.
    fn name(&mut self, number: u32) -> String {
        let (mut open, mut missing) = (vec![number], BTreeSet::new());
        while let Some(number) = open.pop() {
            if !self.defined.contains(&number) && missing.insert(number) {
                visit_parts(&self.terms.node_at(number), &mut |part| open.push(part));
            }
        }
        for &number in &missing {
            self.define(number);
        }
        self.defined.append(&mut missing);
        format!("n{number}")
    }

    fn define(&mut self, number: u32) {
        let node = self.terms.node_at(number);
        let whole = self.terms.interval(Float(number));
        let sort = match node {
            True | And(_) | AtMost(..) | IsNegativeZero(_) | IsNegativeNan(_) | Within(..) | Below(..) => "Bool",
            WordIf(..) | Number(_) | Bits(_) | Apply(..) | Element(..) => "(_ BitVec 64)",
            _ if whole.is_some() => "Int",
            _ => "Float32",
        };
        let line = match node {
            Source(_) | Count(_) | Unknown(_) => format!("(declare-const n{number} {sort})\n"),
            _ => format!("(define-fun n{number} () {sort} {})\n", self.meaning(&node)),
        };
        self.text += &line;
        if let (Count(_), Some([low, high])) = (node, whole) {
            self.assert(&format!("(<= {} n{number} {})", integer(low), integer(high)));
        }
    }

    /// The bits of a float.
    fn bits(&mut self, float: Float) -> String {
        let name = format!("b{}", float.0);
        if self.bits.insert(float.0) {
            self.text += &format!("(declare-const {name} (_ BitVec 32))\n");
            self.assert(&format!("(= n{} ((_ to_fp 8 24) {name}))", float.0));
        }
        name
    }

    /// The meaning of a node, given the names of its parts.
    fn meaning(&mut self, node: &Node) -> String {
        match *node {
            True => "true".to_owned(),
            And(ref parts) => call("and", parts.iter().map(|&part| literal(part))),
            AtMost(Float(a), Float(b)) if self.terms.is_whole(Float(a)) => format!("(<= n{a} n{b})"),
            AtMost(Float(a), Float(b)) => format!("(or (fp.isNaN n{a}) (fp.leq n{a} n{b}))"),
            IsNegativeZero(Float(a)) => format!("(= n{a} (_ -zero 8 24))"),
            IsNegativeNan(a) => format!("(and (fp.isNaN n{}) (= ((_ extract 31 31) {}) #b1))", a.0, self.bits(a)),
            Within(Word(a), ref set) => {
                let inside = |&(low, high)| format!("(and (bvule (_ bv{low} 64) n{a}) (bvule n{a} (_ bv{high} 64)))");
                call("or false", set.iter().map(inside))
            }
            Below(signed, width, a, b) => {
                call(if signed { "bvslt" } else { "bvult" }, [a, b].map(|word| operand(width, word)))
            }
            Constant(bits) => format!("((_ to_fp 8 24) #x{bits:08x})"),
            Sum(ref products) => {
                let product = |(factors, by): &(Vec<u32>, i128)| {
                    call("* 1", [integer(*by)].into_iter().chain(factors.iter().map(|factor| format!("n{factor}"))))
                };
                call("+ 0 0", products.iter().map(product))
            }
            // the remainder of `div` is never negative
            Quotient(Float(a), Float(b)) => {
                format!("(ite (= n{b} 0) 0 (ite (<= 0 n{a}) (div n{a} n{b}) (- (div (- n{a}) n{b}))))")
            }
            Shifted(Float(a), by) => format!("(div n{a} {by})"),
            Node::Arithmetic(operation, Float(a), Float(b)) => {
                let function = match operation {
                    Arithmetic::Add => "fp.add RNE",
                    Arithmetic::Multiply => "fp.mul RNE",
                    Arithmetic::Divide => "fp.div RNE",
                    Arithmetic::Remainder => "fmod",
                };
                format!("({function} n{a} n{b})")
            }
            Negative(Float(a)) => format!("(fp.neg n{a})"),
            Magnitude(Float(a)) => format!("(fp.abs n{a})"),
            Root(Float(a)) => format!("(fp.sqrt RNE n{a})"),
            FloatIf(condition, Float(a), Float(b)) | WordIf(condition, Word(a), Word(b)) => {
                format!("(ite {} n{a} n{b})", literal(condition))
            }
            Own(_, _, Float(definition)) => format!("n{definition}"),
            OfBits(word) => format!("((_ to_fp 8 24) {})", operand(Width::W32, word)),
            OfInteger(signed, word) => {
                let function = if signed { "to_fp" } else { "to_fp_unsigned" };
                format!("((_ {function} 8 24) RNE {})", operand(Width::W32, word))
            }
            Number(number) => format!("(_ bv{number} 64)"),
            Bits(float) => format!("(concat #x00000000 {})", self.bits(float)),
            Apply(operator, width, a, b) => {
                let function = match operator {
                    Operator::Add => "bvadd",
                    Operator::Subtract => "bvsub",
                    Operator::Multiply => "bvmul",
                    Operator::And => "bvand",
                    Operator::Or => "bvor",
                    Operator::Xor => "bvxor",
                    Operator::ShiftLeft => "bvshl",
                    Operator::ShiftRight => "bvlshr",
                    Operator::ShiftArithmetic => "bvashr",
                };
                let result = call(function, [a, b].map(|word| operand(width, word)));
                if width == Width::W32 { format!("(concat #x00000000 {result})") } else { result }
            }
            Element(ref table, Word(index)) => {
                let (last, rest) = table.split_last().map_or((0, &[][..]), |(&last, rest)| (last, rest));
                let element = |text: String, (at, value): (usize, &u64)| {
                    format!("(ite (= n{index} (_ bv{at} 64)) (_ bv{value} 64) {text})")
                };
                rest.iter().enumerate().fold(format!("(_ bv{last} 64)"), element)
            }
            // declared
            Source(_) | Count(_) | Unknown(_) => String::new(),
        }
    }
}

fn call(function: &str, arguments: impl IntoIterator<Item = String>) -> String {
    let arguments: String = arguments.into_iter().map(|argument| format!(" {argument}")).collect();
    format!("({function}{arguments})")
}

fn literal(term: Bool) -> String {
    let number = term.0 >> 1;
    if term.0 & 1 == 0 { format!("n{number}") } else { format!("(not n{number})") }
}

fn integer(value: i128) -> String {
    if value < 0 { format!("(- {})", value.unsigned_abs()) } else { value.to_string() }
}

/// A word with the bits of a width.
fn operand(width: Width, word: Word) -> String {
    match width {
        Width::W32 => format!("((_ extract 31 0) n{})", word.0),
        Width::W64 => format!("n{}", word.0),
    }
}

#[cfg(test)]
mod tests;
