//! Floats: constants, sources and operations, each rounded once.

use super::rank::{NAN, NEGATIVE_ZERO, is_nan_bits};
use super::whole::MOST;
use super::{Arithmetic, Bool, Float, Node, Terms};
use Arithmetic::*;
use Node::*;

/// Operations go into choices of at most so many values together.
const LIFTED: usize = 8;
/// The bits of 1.
const ONE: u32 = 0x3f80_0000;

impl Terms {
    /// A constant by its bits.
    pub fn constant_bits(&self, bits: u32) -> Float {
        self.float(Constant(if is_nan_bits(bits) { NAN } else { bits }))
    }

    /// A constant.
    pub fn constant(&self, value: f32) -> Float {
        self.constant_bits(value.to_bits())
    }

    /// A value of the state.
    pub fn source(&self, index: u32) -> Float {
        if let Some(&bits) = self.state.as_ref().and_then(|state| state.get(index as usize)) {
            return self.constant_bits(bits);
        }
        self.float(Source(index))
    }

    /// A new value of which nothing is known.
    pub fn unknown(&self) -> Float {
        self.unknowns.set(self.unknowns.get() + 1);
        self.float(Unknown(self.unknowns.get()))
    }

    /// The bits of a constant.
    #[must_use]
    pub fn bits_of(&self, term: Float) -> Option<u32> {
        match self.of_float(term) {
            Constant(bits) => Some(bits),
            _ => None,
        }
    }

    /// `a + b`
    pub fn add(&self, a: Float, b: Float) -> Float {
        self.arithmetic(Add, a, b)
    }

    /// `a - b`
    pub fn subtract(&self, a: Float, b: Float) -> Float {
        self.uses("x - y = x + (-y)");
        self.arithmetic(Add, a, self.negate(b))
    }

    /// `a * b`
    pub fn multiply(&self, a: Float, b: Float) -> Float {
        self.arithmetic(Multiply, a, b)
    }

    /// `a / b`
    pub fn divide(&self, a: Float, b: Float) -> Float {
        self.arithmetic(Divide, a, b)
    }

    /// `fmod(a, b)`
    pub fn remainder(&self, a: Float, b: Float) -> Float {
        self.arithmetic(Remainder, a, b)
    }

    /// `a < b ? a : b`
    pub fn minimum(&self, a: Float, b: Float) -> Float {
        self.choose_float(self.less(a, b), a, b)
    }

    /// `a > b ? a : b`
    pub fn maximum(&self, a: Float, b: Float) -> Float {
        self.choose_float(self.less(b, a), a, b)
    }

    /// `value >= low ? (value > high ? high : value) : value < low ? low : nan`
    pub fn clamp(&self, value: Float, [low, high, nan]: [Float; 3]) -> Float {
        let (reaches, above, below) = (self.less_or_equal(low, value), self.less(high, value), self.less(value, low));
        self.choose_float(reaches, self.choose_float(above, high, value), self.choose_float(below, low, nan))
    }

    /// A choice between two floats.
    pub fn choose_float(&self, condition: Bool, a: Float, b: Float) -> Float {
        let chosen = Float(self.chosen(condition, a.0, b.0, |condition, a, b| FloatIf(condition, Float(a), Float(b))));
        if self.is_whole(a) && !self.is_whole(chosen) {
            self.narrow(chosen, self.interval_under(chosen, &[]).unwrap_or([-MOST, MOST]));
        }
        chosen
    }

    /// A float where facts hold: choices that they decide are made.
    pub(crate) fn given_float(&self, term: Float, facts: &[Bool]) -> Float {
        Float(self.given(term.0, facts))
    }

    /// `-a`
    pub fn negate(&self, a: Float) -> Float {
        match self.of_float(a) {
            Negative(inner) => inner,
            _ if self.is_whole(a) => self.exact(Multiply, a, self.whole(-1)),
            FloatIf(condition, x, y) => self.choose_float(condition, self.negate(x), self.negate(y)),
            Node::Arithmetic(operation @ (Multiply | Divide), x, y) => {
                if let Some(bits) = self.bits_of(x) {
                    self.arithmetic(operation, self.constant_bits(bits ^ NEGATIVE_ZERO), y)
                } else if let Some(bits) = self.bits_of(y) {
                    self.arithmetic(operation, x, self.constant_bits(bits ^ NEGATIVE_ZERO))
                } else {
                    self.float(Negative(a))
                }
            }
            _ => self.float(Negative(a)),
        }
    }

    /// `|a|`
    pub fn magnitude(&self, a: Float) -> Float {
        let a = self.zero_free(a);
        match self.of_float(a) {
            Magnitude(_) => a,
            _ if self.is_whole(a) => self.choose_float(self.less(a, self.whole(0)), self.negate(a), a),
            _ => self.float(Magnitude(a)),
        }
    }

    /// The square root.
    pub fn root(&self, a: Float) -> Float {
        self.float(Root(a))
    }

    /// A rounded operation.
    pub fn arithmetic(&self, operation: Arithmetic, a: Float, b: Float) -> Float {
        if self.is_whole(a) && self.is_whole(b) {
            return self.exact(operation, a, b);
        }
        if let Some(lifted) = self.lifted(operation, a, b) {
            return lifted;
        }
        let (x, y) = (self.bits_of(a), self.bits_of(b));
        if x.or(y).is_some_and(is_nan_bits) {
            return self.constant_bits(NAN);
        }
        match operation {
            Add => self.sum(a, b),
            Multiply | Divide => self.product(operation, a, b),
            Remainder => self.float(Node::Arithmetic(operation, a, b)),
        }
    }

    /// An operation of choices of few values as a choice of operations.
    fn lifted(&self, operation: Arithmetic, a: Float, b: Float) -> Option<Float> {
        let ((FloatIf(condition, ..), _) | (_, FloatIf(condition, ..))) = (self.of_float(a), self.of_float(b)) else {
            return None;
        };
        let (first, second) = (self.leaves(a.0).len(), self.leaves(b.0).len());
        let same = matches!((self.of_float(a), self.of_float(b)), (FloatIf(x, ..), FloatIf(y, ..)) if x == y);
        if !same && first * second > LIFTED {
            return None;
        }
        let sides = [condition, !condition].map(|side| {
            let inner = |terms: &Self, term| match terms.of_float(term) {
                FloatIf(of, x, y) if of == condition => {
                    terms.given_float(if side == condition { x } else { y }, &[side])
                }
                _ => terms.given_float(term, &[side]),
            };
            (inner(self, a), inner(self, b))
        });
        let [x, y] = sides.map(|(a, b)| self.arithmetic(operation, a, b));
        Some(self.choose_float(condition, x, y))
    }

    fn sum(&self, mut a: Float, mut b: Float) -> Float {
        let nonzero = |bits: Option<u32>| bits.is_some_and(|bits| bits & !NEGATIVE_ZERO != 0);
        let (x, y) = (self.bits_of(a), self.bits_of(b));
        if x == Some(NEGATIVE_ZERO) || y == Some(NEGATIVE_ZERO) {
            self.uses("x + (-0) = x");
            return if x == Some(NEGATIVE_ZERO) { b } else { a };
        }
        // the sign of a zero makes no difference to a sum with what is not zero
        if nonzero(y) {
            a = self.zero_free(a);
        }
        if nonzero(x) {
            b = self.zero_free(b);
        }
        self.commuted(Add, a, b)
    }

    fn commuted(&self, operation: Arithmetic, a: Float, b: Float) -> Float {
        if a > b {
            self.uses("x + y = y + x, x * y = y * x");
        }
        self.float(Node::Arithmetic(operation, a.min(b), a.max(b)))
    }

    fn product(&self, operation: Arithmetic, a: Float, b: Float) -> Float {
        let multiplies = operation == Multiply;
        for (negated, other, first) in [(a, b, true), (b, a, false)] {
            if let Negative(inner) = self.of_float(negated) {
                self.uses("(-x) * y = -(x * y), x / (-y) = -(x / y)");
                let (a, b) = if first { (inner, other) } else { (other, inner) };
                return self.negate(self.arithmetic(operation, a, b));
            }
        }
        if self.bits_of(b) == Some(ONE) || multiplies && self.bits_of(a) == Some(ONE) {
            self.uses("x * 1 = x, x / 1 = x");
            return if self.bits_of(b) == Some(ONE) { a } else { b };
        }
        if multiplies {
            return self.commuted(operation, a, b);
        }
        if let Some(reciprocal) = self.bits_of(b).and_then(exact_reciprocal) {
            self.uses("x / 2^k = x * 2^-k");
            return self.arithmetic(Multiply, a, self.constant_bits(reciprocal));
        }
        self.float(Node::Arithmetic(operation, a, b))
    }

    /// A term that equals another up to the sign of a zero, which comparisons do not see.
    pub fn zero_free(&self, term: Float) -> Float {
        if let Some(&known) = self.zero_free.borrow().get(&term) {
            return known;
        }
        let result = match self.of_float(term) {
            Constant(NEGATIVE_ZERO) => self.constant_bits(0),
            FloatIf(condition, a, b) => self.choose_float(condition, self.zero_free(a), self.zero_free(b)),
            Node::Arithmetic(Add, a, b) => {
                let (a, b) = (self.zero_free(a), self.zero_free(b));
                if self.bits_of(a) == Some(0) || self.bits_of(b) == Some(0) {
                    self.uses("0 + x is x but for the sign of zero");
                    if self.bits_of(a) == Some(0) { b } else { a }
                } else {
                    self.add(a, b)
                }
            }
            Node::Arithmetic(operation, a, b) => self.arithmetic(operation, self.zero_free(a), b),
            _ => term,
        };
        self.zero_free.borrow_mut().insert(term, result);
        self.zero_free.borrow_mut().entry(result).or_insert(result);
        result
    }
}

/// An operation on numbers, rounded once.
pub(super) fn rounded(operation: Arithmetic, a: f32, b: f32) -> f32 {
    match operation {
        Add => a + b,
        Multiply => a * b,
        Divide => a / b,
        Remainder => a % b,
    }
}

/// The reciprocal of a power of two that has an exact one that is normal.
fn exact_reciprocal(bits: u32) -> Option<u32> {
    let exponent = bits >> 23 & 255;
    (bits & 0x007f_ffff == 0 && (1..=253).contains(&exponent)).then(|| bits & NEGATIVE_ZERO | (254 - exponent) << 23)
}

#[cfg(test)]
mod tests {
    use super::Terms;

    #[test]
    fn identities_give_one_node() {
        let terms = Terms::new();
        let (x, y, zero) = (terms.source(0), terms.source(1), terms.constant(0.0));
        assert_eq!(terms.add(x, y), terms.add(y, x));
        let (difference, negated) = (terms.subtract(x, y), terms.negate(y));
        assert_eq!(difference, terms.add(x, negated));
        assert_eq!(terms.subtract(x, zero), x);
        let (eight, eighth) = (terms.constant(8.0), terms.constant(0.125));
        assert_eq!(terms.divide(x, eight), terms.multiply(x, eighth));
        let product = terms.multiply(negated, x);
        let positive = terms.multiply(x, y);
        assert_eq!(product, terms.negate(positive));
    }

    #[test]
    fn a_zero_that_is_added_matters_to_signs_only() {
        let terms = Terms::new();
        let (x, y, zero) = (terms.source(0), terms.source(1), terms.constant(0.0));
        let sum = terms.add(x, zero);
        assert_ne!(sum, x);
        assert_eq!(terms.less(sum, y), terms.less(x, y));
        assert_ne!(terms.divide(y, sum), terms.divide(y, x));
        let five = terms.constant(5.0);
        assert_eq!(terms.add(sum, five), terms.add(x, five));
    }

    #[test]
    fn operations_go_into_small_choices() {
        let terms = Terms::new();
        let (x, y) = (terms.source(0), terms.source(1));
        let (smaller, two) = (terms.minimum(x, y), terms.constant(2.0));
        let (outside, less) = (terms.multiply(smaller, two), terms.less(x, y));
        let (first, second) = (terms.multiply(x, two), terms.multiply(y, two));
        assert_eq!(outside, terms.choose_float(less, first, second));
    }
}
